// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/run_position.h"

#include "input/translations.h"
#include "motions/motion_list.h"
#include "output/label_titles.h"
#include "output/report_json.h"

namespace dsc {

using DSC::Label_names;

namespace {

std::string text_of(const Json& metadata) {
  return metadata.dump(-1, ' ', false,
                       Json::error_handler_t::replace); // names may contain any bytes
}

using DSC::Mesh_array;
using DSC::Mesh_arrays;

Json json_of(const Mesh_array& array) {
  return {{"name", array.name},
          {"type", array.type},
          {"components", array.components},
          {"values", array.values}};
}

Mesh_array array_of(const Json& json) {
  return {json.at("name"), json.at("type"), json.at("components"),
          json.at("values").get<std::vector<double>>()};
}

} // namespace

Json label_names_json(const Label_names& names) {
  Json result = Json::array();
  for (const auto& [label, name] : names)
    result.push_back({{"label", label}, {"name", name}});
  return result;
}

std::string to_metadata(const Run_position& position, const Step_options& step,
                        const Label_names& names) {
  // Contains nothing that depends on interruptions or the number of threads, so that checkpoints of
  // the same state are equal.
  Json parameters = motion_json(step.motion);
  parameters["grow_domain"] = step.grows_domain;
  parameters["improve_interface"] = step.improves_interface;
  if (step.largest_displacement)
    parameters["largest_displacement"] = *step.largest_displacement;
  parameters["aggressiveness"] = value_or_null(step.aggressiveness);
  parameters["triangles"] = position.start.triangles;
  parameters["segments"] = position.start.segments;
  parameters["repair"] = position.start.repairs;
  if (const std::optional<Distance>& hole = position.start.largest_hole)
    parameters["largest_hole"] = {{"value", hole->value}, {"in_mean_edges", hole->in_mean_edges}};
  parameters["figure"] = static_cast<int>(position.start.figure);
  if (const std::optional<Ball>& ball = position.start.ball)
    parameters["ball"] = {{"center", ball->center}, {"radius", ball->radius}};
  Json result = {{"step", position.step},
                 {"time", position.time},
                 {"input", with_user_names(position.start.inputs)},
                 {"parameters", parameters}};
  if (!names.empty())
    result["labels"] = label_names_json(names);
  return text_of(result);
}

std::string to_metadata(const Label_names& names) {
  return names.empty() ? "" : text_of(Json{{"labels", label_names_json(names)}});
}

std::optional<Saved_run> from_metadata(const std::string& metadata) {
  try {
    const Json json = Json::parse(metadata);
    Saved_run run;
    Run_position& position = run.position;
    position.step = json.at("step");
    position.time = json.at("time");
    position.start.inputs = json.at("input").get<std::vector<std::string>>();
    const Json& parameters = json.at("parameters");
    position.start.triangles = parameters.at("triangles");
    position.start.segments = parameters.at("segments");
    position.start.repairs = parameters.value("repair", false); // missing in older checkpoints
    position.start.figure = static_cast<Figure>(parameters.at("figure").get<int>());
    if (parameters.contains("largest_hole")) {
      const Json& hole = parameters.at("largest_hole");
      position.start.largest_hole = Distance{hole.at("value"), hole.at("in_mean_edges")};
    }
    if (parameters.contains("ball")) {
      const Json& ball = parameters.at("ball");
      position.start.ball = Ball{ball.at("center"), ball.at("radius")};
    }
    run.step.motion = motion_from_json(parameters);
    run.step.grows_domain = parameters.value("grow_domain", false); // missing in older checkpoints
    if (parameters.contains("largest_displacement"))
      run.step.largest_displacement = parameters.at("largest_displacement").get<double>();
    run.step.improves_interface = parameters.at("improve_interface");
    if (const Json& aggressiveness = parameters.at("aggressiveness"); !aggressiveness.is_null())
      run.step.aggressiveness = aggressiveness.get<double>();
    return run;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
}

Label_names label_names_of(const std::string& metadata) {
  Label_names result;
  try {
    const Json json = Json::parse(metadata);
    for (const Json& label : json.at("labels"))
      result.emplace(label.at("label"), label.at("name"));
  } catch (const Json::exception&) { // without names
    return {};
  }
  return result;
}

std::string with_arrays(const std::string& metadata, const Mesh_arrays& arrays) {
  const bool has_usual_name = arrays.labels.name.empty() || arrays.labels.name == "label";
  if (arrays.points.empty() && arrays.cells.empty() && has_usual_name)
    return metadata;
  Json json = {
      {"labels", json_of(arrays.labels)}, {"points", Json::array()}, {"cells", Json::array()}};
  for (const Mesh_array& array : arrays.points)
    json["points"].push_back(json_of(array));
  for (const Mesh_array& array : arrays.cells)
    json["cells"].push_back(json_of(array));
  std::string result = metadata + '\n';
  Json::to_cbor(json, result); // exact, and contains numbers that are not finite
  return result;
}

Mesh_arrays take_arrays(std::string& metadata) {
  Mesh_arrays result;
  const std::size_t end = metadata.find('\n');
  if (end == std::string::npos)
    return result;
  try {
    const Json json = Json::from_cbor(metadata.begin() + std::ptrdiff_t(end) + 1, metadata.end());
    result.labels = array_of(json.at("labels"));
    for (const Json& array : json.at("points"))
      result.points.push_back(array_of(array));
    for (const Json& array : json.at("cells"))
      result.cells.push_back(array_of(array));
    metadata.erase(end);
    return result;
  } catch (const Json::exception&) { // metadata of another program
    return Mesh_arrays();
  }
}

} // namespace dsc
