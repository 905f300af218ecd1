// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/motion_list.h"

#include "programs/add_value.h"
#include "programs/errors.h"

#include <type_traits>

namespace dsc {
namespace {

// Forms of values in the command line: a flag, and a text. Other forms are functions that read a
// value from a text, and maps from names to values.
struct Flag
{
};
struct Words
{
  bool is_option; // false if the command has no such option; files contain it nevertheless
};

const auto& schemes_without_tolerance() {
  static const auto schemes = [] {
    auto result = integration_schemes();
    result.erase("adaptive");
    return result;
  }();
  return schemes;
}

// Each function calls another one with the name of each option of a motion, the member that stores
// it, its form, and its text in the help.

template <class Visit> void for_each_option(const Rotation&, const Visit& visit) {
  visit("--axis", &Rotation::axis, parse_axis,
        "Direction of the axis, like 0,0,1; required for a new run in space");
  visit("--angle", &Rotation::degrees, Number_range{"7.2"},
        "Angle per step in degrees; required for a new run");
}

template <class Visit> void for_each_option(const Offset&, const Visit& visit) {
  visit("--distance", &Offset::distance, Length_range{{"0.1 or 0.25e"}},
        "Distance per step, positive outwards; 0.25e is a quarter of the mean "
        "interface edge of the input; required for a new run");
  visit("--move-faces", &Offset::moves_faces, Flag(),
        "Move flat faces as a whole: edges that the motion opens become round, others stay sharp");
  visit("--corners", &Offset::corners, corner_rules(),
        "Corners and edges from which the interface moves away: sharp (miter), or "
        "arcs, cylinders and spheres (round)");
}

constexpr char text_of_tolerance[] =
    "Tolerance of interface edges to the smooth interface, in mean edges of the input "
    "(default: 0.04, in the plane 0.005); 0 turns off the adaptation of the "
    "interface to its curvature";

template <class Visit> void for_each_option(const Advection& flow, const Visit& visit) {
  visit("--velocity", &Advection::expressions, Words{flow.field == Advection::Field::expressions},
        "Velocity in the coordinates of the input: three expressions in x, y, z and t "
        "like '-y,x,sin(pi*t)'; in the plane, two expressions in x, y and t; "
        "required for a new run");
  visit("--period", &Advection::period, positive,
        "Multiply velocities by cos(pi t / PERIOD), so that the interface returns after the "
        "period");
  visit("--dt", &Advection::dt, positive,
        "Time step (default: the fastest vertex moves by a mean edge at the start; for "
        "enright and vortex 0.01). The report contains the distance to the initial "
        "interface for each step that ends with a period");
  visit("--scheme", &Advection::scheme, schemes_without_tolerance(), "Integration scheme");
  visit("--tolerance", &Advection::tolerance, not_negative("0.04"), text_of_tolerance);
}

template <class Visit> void for_each_option(const Curvature_flow&, const Visit& visit) {
  visit("--dt", &Curvature_flow::dt, positive,
        "Time step, in squares of the length unit of the input (default: square of the "
        "mean interface edge of the input)");
  visit("--keep-volumes", &Curvature_flow::keeps_volumes, Flag(),
        "Preserve the volume of each label except 0");
  visit("--tolerance", &Curvature_flow::tolerance, not_negative("0.04"), text_of_tolerance);
}

template <class Visit> void for_each_option(const Zalesak&, const Visit& visit) {
  visit("--dt", &Zalesak::dt, positive, "Time step (default: 1)");
}

// Calls a function with each option: its name, its value, its form and its text.
template <class Any_motion, class Visit>
void visit_options(Any_motion& motion, const Visit& visit) {
  std::visit(
      [&](auto& m) {
        for_each_option(m, [&](const char* name, auto member, const auto& form, const char* text) {
          visit(name, m.*member, form, text);
        });
      },
      motion);
}

template <class Value, class Form>
void add_option(CLI::App& command, const char* name, Value& value, const Form& form,
                const char* text) {
  add_value(command, name, value, form, text);
}

void add_option(CLI::App& command, const char* name, bool& value, Flag, const char* text) {
  command.add_flag(name, value, text);
}

void add_option(CLI::App& command, const char* name, std::string& value, Words words,
                const char* text) {
  if (words.is_option)
    command.add_option(name, value, text);
}

// The key of an option in JSON.
std::string key_of(const std::string& name) {
  std::string result = name.substr(2);
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}

template <class Value, class Form>
void write_option(Json& json, const std::string& key, const Value& value, const Form&) {
  json[key] = value;
}

template <class Form>
void write_option(Json& json, const std::string& key, const std::optional<double>& value,
                  const Form&) {
  json[key] = value_or_null(value);
}

void write_option(Json& json, const std::string& key, const std::string& value, Words) {
  json[key] = value_or_null(value);
}

template <class Value>
void write_option(Json& json, const std::string& key, const Value& value,
                  const std::map<std::string, Value>& names) {
  json[key] = name_of(names, value);
}

const char* const mean_edge = "mean interface edge";

void write_option(Json& json, const std::string& key, const Distance& value, const Length_range&) {
  json[key] = value.value;
  json["unit"] = value.in_mean_edges ? mean_edge : "input";
}

template <class Value, class Form>
void read_option(const Json& json, const std::string& key, Value& value, const Form&) {
  value = json.at(key).get<Value>();
}

template <class Form>
void read_option(const Json& json, const std::string& key, std::optional<double>& value,
                 const Form&) {
  if (json.contains(key) && !json.at(key).is_null()) // missing in older checkpoints
    value = json.at(key).get<double>();
}

void read_option(const Json& json, const std::string& key, std::string& value, Words) {
  value = value_of<std::string>(json.at(key));
}

template <class Value>
void read_option(const Json& json, const std::string& key, Value& value,
                 const std::map<std::string, Value>& names) {
  if (json.contains(key)) // missing in older checkpoints
    value = names.at(json.at(key));
}

void read_option(const Json& json, const std::string& key, Distance& value, const Length_range&) {
  value = {json.at(key), json.at("unit") == mean_edge};
}

const std::array<Motion, 7> motions = {{Rotation(), Offset(), Advection{Advection::Field::enright},
                                        Advection{Advection::Field::vortex}, Advection(),
                                        Curvature_flow(), Zalesak()}};

/// Replaces each option that is not given by its value before. Returns the names of the given
/// options that differ from before. Both motions must have the same command.
std::vector<std::string> keep_options(const Step_options& before,
                                      const std::set<std::string>& given, Step_options& asked) {
  std::vector<std::string> changed;
  const auto keep = [&](const char* option, const auto& last, auto& value) {
    if (given.count(option) == 0)
      value = last;
    else if (!(value == last))
      changed.push_back(option);
  };
  std::visit(
      [&](auto& m) {
        const auto& last = std::get<std::decay_t<decltype(m)>>(before.motion);
        for_each_option(m, [&](const char* option, auto member, const auto&, const char*) {
          keep(option, last.*member, m.*member);
        });
      },
      asked.motion);
  if (auto* const flow = std::get_if<Curvature_flow>(&asked.motion); flow && flow->keeps_volumes)
    flow->volumes = std::get<Curvature_flow>(before.motion).volumes;
  keep("--improve-interface", before.improves_interface, asked.improves_interface);
  keep("--domain", before.grows_domain, asked.grows_domain);
  keep("--largest-displacement", before.largest_displacement, asked.largest_displacement);
  keep("--aggressiveness", before.aggressiveness, asked.aggressiveness);
  return changed;
}

void require_dt_in_period(const Motion& motion) {
  const Advection* advection = std::get_if<Advection>(&motion);
  if (advection && advection->period && advection->dt > *advection->period)
    throw Usage_error("--dt is larger than the period; choose a smaller time step");
}

} // namespace

std::string command_of(const Motion& motion) {
  if (const auto* const advection = std::get_if<Advection>(&motion))
    return std::array{"enright", "vortex", "advect"}[static_cast<std::size_t>(advection->field)];
  return std::array{"rotate", "offset", "", "mean-curvature", "zalesak"}[motion.index()];
}

void add_options(CLI::App& command, Motion& motion) {
  visit_options(motion, [&](const char* name, auto& value, const auto& form, const char* text) {
    add_option(command, name, value, form, text);
  });
}

Json motion_json(const Motion& motion) {
  Json result = {{"command", command_of(motion)}};
  visit_options(motion, [&](const char* name, const auto& value, const auto& form, const char*) {
    write_option(result, key_of(name), value, form);
  });
  if (const auto* const flow = std::get_if<Curvature_flow>(&motion))
    for (const auto& [label, volume] : flow->volumes)
      result["volumes"].push_back({{"label", label}, {"volume", volume}});
  return result;
}

Motion motion_from_json(const Json& json) {
  const std::string command = json.at("command");
  const auto found = std::find_if(motions.begin(), motions.end(),
                                  [&](const Motion& m) { return command_of(m) == command; });
  if (found == motions.end())
    throw std::out_of_range("unknown command " + command);
  Motion result = *found;
  visit_options(result, [&](const char* name, auto& value, const auto& form, const char*) {
    read_option(json, key_of(name), value, form);
  });
  if (auto* const flow = std::get_if<Curvature_flow>(&result);
      flow != nullptr && json.contains("volumes")) // older checkpoints have none
    for (const Json& entry : json.at("volumes"))
      flow->volumes.emplace(entry.at("label"), entry.at("volume"));
  return result;
}

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
