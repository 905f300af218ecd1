// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/continue_steps.h"

#include "motions/motion_list.h"
#include "programs/errors.h"

#include <map>
#include <variant>
#include <vector>

namespace dsc {
namespace {

void require_dt_in_period(const Motion& motion) {
  const Advection* advection = std::get_if<Advection>(&motion);
  if (advection && advection->period && advection->dt > *advection->period)
    throw Usage_error("--dt is larger than the period; choose a smaller time step");
}

} // namespace

void require_options(const Motion& motion, const std::set<std::string>& given) {
  static const std::map<std::string, std::string> needs = {
      {"rotate", "--angle"}, {"offset", "--distance"}, {"advect", "--velocity"}};
  const std::string command = command_of(motion);
  if (const auto needed = needs.find(command);
      needed != needs.end() && given.count(needed->second) == 0)
    throw Usage_error(needed->second + " is required; see dsc " + command + " --help");
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
  const std::vector<std::string> changed = keep_options(before, given, asked);
  require_dt_in_period(asked.motion);
  require_effect_of_options(asked, given);
  if (changed.empty())
    return "";
  std::string changes;
  for (const std::string& option : changed)
    changes += (changes.empty() ? "" : ", ") + option;
  return changes + noun(changed.size(), " differs", " differ") + " from the previous run";
}

} // namespace dsc
