// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/continue_steps.h"

#include "motions/motion_json.h"
#include "programs/errors.h"

#include <map>
#include <type_traits>
#include <variant>
#include <vector>

namespace dsc {
namespace {

std::string command_of(const Motion& motion) { return motion_json(motion).at("command"); }

void require_dt_in_period(const Motion& motion) {
  const Advection* advection = std::get_if<Advection>(&motion);
  if (advection && advection->period > 0 && advection->dt > advection->period)
    throw Usage_error("--dt is larger than the period; choose a smaller time step");
}

/// Completes options: an option that is not given keeps its previous value.
class Completion
{
public:
  explicit Completion(const std::set<std::string>& given) : m_given(given) {}

  void complete(const Rotation& before, Rotation& asked) {
    complete("--axis", before.axis, asked.axis);
    complete("--angle", before.degrees, asked.degrees);
  }

  void complete(const Offset& before, Offset& asked) {
    complete("--distance", before.distance, asked.distance);
    complete("--move-faces", before.moves_faces, asked.moves_faces);
    complete("--corners", before.corners, asked.corners);
  }

  void complete(const Advection& before, Advection& asked) {
    complete("--velocity", before.expressions, asked.expressions);
    complete("--period", before.period, asked.period);
    complete("--dt", before.dt, asked.dt);
    complete("--scheme", before.scheme, asked.scheme);
    complete("--tolerance", before.tolerance, asked.tolerance);
  }

  void complete(const Curvature_flow& before, Curvature_flow& asked) {
    complete("--dt", before.dt, asked.dt);
    complete("--keep-volumes", before.keeps_volumes, asked.keeps_volumes);
    complete("--tolerance", before.tolerance, asked.tolerance);
    if (asked.keeps_volumes)
      asked.volumes = before.volumes;
  }

  void complete(const Zalesak& before, Zalesak& asked) { complete("--dt", before.dt, asked.dt); }

  void complete(const Step_options& before, Step_options& asked) {
    std::visit(
        [&](auto& motion) {
          complete(std::get<std::decay_t<decltype(motion)>>(before.motion), motion);
        },
        asked.motion);
    complete("--improve-interface", before.improves_interface, asked.improves_interface);
    complete("--domain", before.grows_domain, asked.grows_domain);
    complete("--largest-displacement", before.largest_displacement, asked.largest_displacement);
    complete("--aggressiveness", before.aggressiveness, asked.aggressiveness);
  }

  const std::vector<std::string>& changed() const { return m_changed; }

private:
  template <class Value> void complete(const char* option, const Value& before, Value& asked) {
    if (m_given.count(option) == 0)
      asked = before;
    else if (!(asked == before))
      m_changed.push_back(option);
  }

  const std::set<std::string>& m_given;
  std::vector<std::string> m_changed;
};

} // namespace

void require_options(const Motion& motion, const std::set<std::string>& given) {
  static const std::map<std::string, std::vector<std::string>> needs = {
      {"rotate", {"--angle"}}, {"offset", {"--distance"}}, {"advect", {"--velocity"}}};
  const std::string command = command_of(motion);
  if (const auto needed = needs.find(command); needed != needs.end())
    for (const std::string& option : needed->second)
      if (given.count(option) == 0)
        throw Usage_error(option + " is required; see dsc " + command + " --help");
  require_dt_in_period(motion);
}

void require_effect_of_options(const Step_options& step, const std::set<std::string>& given) {
  if (step.improves_interface && given.count("--tolerance") > 0)
    throw Usage_error("--tolerance has no effect with --improve-interface; leave one of them out");
}

std::string continue_steps(const Step_options& before, const std::set<std::string>& given,
                           Step_options& asked) {
  const std::string command = command_of(asked.motion), last = command_of(before.motion);
  if (command != last) {
    require_options(asked.motion, given);
    require_effect_of_options(asked, given);
    asked.grows_domain = before.grows_domain; // a property of the domain
    return "the command changes from " + last + " to " + command;
  }
  Completion completion(given);
  completion.complete(before, asked);
  require_dt_in_period(asked.motion);
  require_effect_of_options(asked, given);
  if (completion.changed().empty())
    return "";
  std::string changes;
  for (const std::string& option : completion.changed())
    changes += (changes.empty() ? "" : ", ") + option;
  return changes + noun(completion.changed().size(), " differs", " differ") +
         " from the previous run";
}

} // namespace dsc
