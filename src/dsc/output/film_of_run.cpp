// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/film_of_run.h"

#include "film.h"
#include "input/files.h"
#include "output/collection.h"
#include "output/frame_of_vtu.h"
#include "output/label_titles.h"
#include "output/report_json.h"
#include "programs/errors.h"

#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

namespace dsc {
namespace {

namespace fs = std::filesystem;

/// Returns the files of the states of a run.
/// \throws Input_error if there are none
std::vector<Moment> states_of(const std::string& run, bool is_surface) {
  std::error_code error;
  if (is_surface && !fs::is_directory(run, error))
    throw Input_error("--surface needs the folder of a run; '" + run + "' is a file");
  if (extension(run) == "vtu")
    return {{0, run}};
  const std::string collection =
      fs::is_directory(run, error)
          ? (fs::path(run) / (is_surface ? "interface.pvd" : "volume.pvd")).string()
          : run;
  std::vector<Moment> result = moments_of_collection(collection);
  if (result.empty())
    throw Input_error("there are no states of a run in '" + collection +
                      "'; name the folder of a run with --output, a collection (.pvd) or a mesh "
                      "(.vtu)");
  return result;
}

/// Returns the steps of a report.
std::vector<Json> steps_of_report(const std::string& path) {
  if (path.empty())
    return {};
  std::ifstream in(path);
  const Json report = Json::parse(in, nullptr, false);
  if (!report.is_object() || !report.contains("steps") || !report["steps"].is_array())
    throw Input_error("'" + path +
                      "' is not a report of a run; name a file that was written with --report");
  std::vector<Json> result;
  for (const Json& step : report["steps"])
    if (step.is_object() && step.contains("time") && step["time"].is_number())
      result.push_back(step);
  return result;
}

/// Returns the step of a report at the given time, or null.
const Json* step_at(double time, const std::vector<Json>& steps) {
  const auto step = std::find_if(steps.begin(), steps.end(), [&](const Json& other) {
    return other["time"].get<double>() == time;
  });
  return step == steps.end() ? nullptr : &*step;
}

/// Returns the number of the step in the name of a file of a run, such as volume_000010.vtu.
std::optional<std::int64_t> step_of_file(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
  if (digits == stem.size() || stem.size() - digits > 18)
    return {};
  return std::stoll(stem.substr(digits));
}

/// Adds the numbers of a step of a report that charts show.
void add_series(const Json& step, bool is_surface, Film& film) {
  static constexpr const char* names[][2] = {{"energy", "energy"},
                                             {"grains", "number of grains"},
                                             {"kinetic_energy", "kinetic energy"},
                                             {"surface_energy", "surface energy"},
                                             {"potential_energy", "potential energy"},
                                             {"unfinished_vertices", "unfinished vertices"},
                                             {"min_quality", "smallest quality"}};
  for (const auto& [key, name] : names)
    if (step.contains(key) && step[key].is_number())
      film.add_to_series(name, step[key].get<double>());
  if (is_surface && step.contains("labels") && step["labels"].is_array())
    for (const Json& label : step["labels"])
      for (const char* measure : {"volume", "area"})
        if (label.is_object() && label.contains("label") && label.contains(measure) &&
            label[measure].is_number())
          film.add_to_series(std::string(measure) + " of label " + label["label"].dump(),
                             label[measure].get<double>());
}

/// Adds the events of the steps of a report.
void add_events(const std::vector<Json>& steps, Film& film) {
  for (const Json& step : steps)
    if (step.contains("events") && step["events"].is_array())
      for (const Json& event : step["events"])
        if (event.is_object() && event.contains("kind") && event["kind"].is_string() &&
            event.contains("label"))
          film.add_event(step["time"].get<double>(), "label " + event["label"].dump() +
                                                         ": components " +
                                                         event["kind"].get<std::string>());
}

/// \throws Input_error if a report is given and none of its steps is at the time of a state
void require_steps(const Film_options& options, const std::vector<Moment>& states,
                   const std::vector<Json>& steps) {
  if (!options.report.empty() &&
      std::none_of(states.begin(), states.end(),
                   [&](const Moment& state) { return step_at(state.first, steps) != nullptr; }))
    throw Input_error("'" + options.report + "' has no step at the time of a state of '" +
                      options.run + "'; name the report of this run");
}

} // namespace

std::string film_of_run(const Film_options& options) {
  const std::vector<Moment> states = states_of(options.run, options.is_surface);
  const std::vector<Json> steps = steps_of_report(options.report);
  require_steps(options, states, steps);
  std::optional<Film> film;
  std::vector<Read_frame> waiting; // first states without cells, which have no dimension
  std::set<int> labels;
  Label_names names;
  std::vector<int> left_out;
  const auto add = [&](const Read_frame& read) {
    film->add(read.frame);
    for (const auto& [label, name] : read.label_names)
      film->set_name(label, name);
    if (const Json* step = step_at(read.frame.time, steps))
      add_series(*step, options.is_surface, *film);
  };
  Film::Content content = Film::Content::cells;
  int dimension = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i % options.every != 0 && i + 1 < states.size())
      continue;
    CGAL::Deformable_simplicial_complexes::Progress_scope::check();
    const auto& [time, file] = states[i];
    Read_frame read = frame_of_vtu(file);
    for (const auto& pair : read.frame.labels)
      labels.insert(pair.begin(), pair.begin() + (read.content == Film::Content::cells ? 1 : 2));
    names.insert(read.label_names.begin(), read.label_names.end());
    left_out = labels_of("--without", options.without, names);
    leave_out(left_out, read);
    read.frame.time = time;
    read.frame.step = step_of_file(file).value_or(std::int64_t(i));
    const bool is_empty = read.frame.simplices.empty();
    if (!film && is_empty) {
      waiting.push_back(std::move(read));
      continue;
    }
    if (!film) {
      dimension = read.dimension;
      content = read.content;
      film.emplace(fs::path(options.run).lexically_normal().string(), dimension, content);
      film->hide(0);
      for (const Read_frame& earlier : waiting)
        add(earlier);
    }
    if (!is_empty && (read.dimension != dimension || read.content != content))
      throw Input_error("'" + file +
                        "' is of another kind than the first state; name the collection "
                        "of a single run");
    add(read);
  }
  for (const int label : left_out)
    if (labels.count(label) == 0)
      throw Input_error("no state has the label " + std::to_string(label) +
                        "; correct the option --without");
  if (!film)
    throw Input_error("the states of '" + options.run + "' have no cells or facets to show");
  add_events(steps, *film);
  return film->html();
}

} // namespace dsc
