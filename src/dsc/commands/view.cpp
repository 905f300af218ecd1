// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "film.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/translations.h"
#include "output/frame_of_vtu.h"
#include "output/label_titles.h"
#include "output/output_folder.h"
#include "output/report_json.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/standard_streams.h"

#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <climits>
#include <fstream>
#include <iostream>
#include <set>

namespace dsc {
namespace {

struct View_options
{
  std::string run;                  ///< folder of a run, collection (.pvd) or mesh (.vtu)
  std::string report;               ///< report of the run (.json); none if empty
  unsigned every = 1;               ///< only every N-th state, and the last one
  std::vector<std::string> without; ///< labels, or their names, whose cells are left out
  bool is_surface = false;          ///< whether only the interface is shown
  std::string output;
  bool quiet = false;
};

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
void require_steps(const View_options& options, const std::vector<Moment>& states,
                   const std::vector<Json>& steps) {
  if (!options.report.empty() &&
      std::none_of(states.begin(), states.end(),
                   [&](const Moment& state) { return step_at(state.first, steps) != nullptr; }))
    throw Input_error("'" + options.report + "' has no step at the time of a state of '" +
                      options.run + "'; name the report of this run");
}

/// Returns a film of the states of a run as an HTML file.
/// \throws Input_error if the run has no states or a label to be left out does not occur, or the
///         report is not one of this program
/// \throws Usage_error if a name of a label to be left out is unknown
/// \throws DSC::File_error if a file cannot be read
std::string film_of_run(const View_options& options) {
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
    DSC::Progress_scope::check();
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
      film.emplace(with_user_names(fs::path(options.run).lexically_normal().string()), dimension,
                   content);
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

int execute(const View_options& options) {
  require_place("--output", options.output, {options.run, options.report});
  const Interruptible interruptible(options.quiet);
  const std::string html = film_of_run(options);
  DSC::replace_file(options.output, [&](std::ostream& out) { out << html; });
  if (!options.quiet && with_user_names(options.output) == options.output) // a file
    std::cout << "dsc: wrote " << options.output << " (" << (html.size() + 999) / 1000
              << " kB); open it in a browser\n";
  return 0;
}

} // namespace

void add_view(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<View_options>();
  CLI::App* command =
      app.add_subcommand("view", "Write the states of a run as a page for a browser");
  add_input(*command, "RUN", options->run,
            "Folder of a run (its --output), collection (.pvd) or mesh (.vtu; - for standard "
            "input)")
      ->required();
  add_output(*command, "-o,--output", options->output, "Page (.html; - for standard output)",
             "html")
      ->required();
  add_input(*command, "--report", options->report,
            "Report of the run (its --report), for charts and events");
  command->add_option("--every", options->every, "Show every N-th state and the last one")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  command
      ->add_option("--without", options->without,
                   "Labels, by number or name, whose cells are left out, like 1,shell")
      ->allow_extra_args(false);
  command->add_flag("--surface", options->is_surface,
                    "Show the interface only; the page is smaller");
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([options, &exit_code] {
    require_format(options->output, Use::write, content::page);
    exit_code = execute(*options);
  });
}

} // namespace dsc
