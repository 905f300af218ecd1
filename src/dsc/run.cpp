// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "continue_steps.h"
#include "errors.h"
#include "files.h"
#include "interrupt.h"
#include "option_values.h"
#include "output_folder.h"
#include "progress_line.h"
#include "report.h"
#include "run_position.h"
#include "start_complex.h"
#include "start_curves.h"
#include "start_distance.h"
#include "surface.h"
#include "tracked_complex.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dsc {
namespace {

void print_repairs(const std::vector<std::string>& inputs, const Repairs& repairs) {
  for (std::size_t i = 0; i < repairs.size(); ++i)
    std::printf("dsc: %s: %s\n", inputs[i].c_str(), what_was_repaired(repairs[i]).c_str());
}

void print_changes(const Run_position& position, const std::string& changes) {
  std::printf("dsc: goes on from step %u with %s\n", position.step, changes.c_str());
}

/// Builds or reads the complex; a run that is resumed goes on as before where `options` do not say
/// how.
std::unique_ptr<Tracked_complex> start(Run_options& options, Run_position& position,
                                       Repairs& repairs) {
  if (options.resume.empty()) {
    position.start = options.start;
    return start_complex(options, repairs);
  }
  std::string metadata;
  auto complex = track_checkpoint(options.resume, metadata);
  const std::optional<Saved_run> run = from_metadata(metadata);
  if (!run)
    throw Input_error(options.resume +
                      " holds a complex, but no run that could be resumed; write its "
                      "interface with dsc convert, and start from that");
  position = run->position;
  const std::string changes = continue_steps(run->step, options.given, options.step);
  if (complex->dimension() == 2 && options.given.count("--axis") > 0)
    throw Usage_error("--axis has no meaning in the plane; leave it out");
  if (!options.quiet && !changes.empty())
    print_changes(position, changes);
  return complex;
}

/// The time after which everything is back; 0 if there is none.
double period(const Motion& motion) {
  if (std::holds_alternative<Zalesak>(motion))
    return Zalesak::period;
  const Advection* advection = std::get_if<Advection>(&motion);
  return advection ? advection->period : 0;
}

/// Measures from the surfaces that a run started from, if its motion brings them back and they are
/// still there.
std::optional<Start_distance> start_distance(const Run_options& options,
                                             const Run_position& position) {
  const Run_start& start = position.start;
  if (period(options.step.motion) == 0 || input_kind(start) != Input_kind::surfaces ||
      (start.inputs.empty() && !start.ball && start.figure == Figure::none))
    return std::nullopt;
  try {
    return dimension_of(start) == 2
               ? std::optional<Start_distance>(std::in_place, start_curves(start))
               : std::optional<Start_distance>(std::in_place, start_surfaces(start));
  } catch (const std::runtime_error&) { // a run can be resumed without its inputs
    return std::nullopt;
  }
}

bool is_whole_period(double time, double time_step, double period) {
  return std::abs(time - std::round(time / period) * period) < 1e-6 * time_step;
}

/// What remained below the floor of quality after steps, in all and in the worst one.
struct Flat_cells
{
  unsigned steps = 0;
  std::size_t most = 0;
  double quality = 1; ///< the worst

  void add(const Step_outcome& outcome, const Statistics& statistics) {
    steps += outcome.flat_cells > 0;
    most = std::max(most, outcome.flat_cells);
    quality = std::min(quality, statistics.min_quality);
  }
};

void print_flat_cells(const Flat_cells& flat) {
  if (flat.steps > 0)
    std::printf(
        "dsc: after %u steps cells were flatter than they should be, %zu at most; the worst "
        "quality of any cell was %.3g\n",
        flat.steps, flat.most, flat.quality);
}

void print_summary(const Run_position& position, const Statistics& statistics,
                   std::size_t unfinished, double seconds) {
  const bool is_planar = statistics.dimension == 2;
  std::printf("dsc: step %u, time %g: %zu %s, %zu interface %s, %s %.3g to %.4g degrees, worst "
              "quality %.3g; %zu unfinished vertices, %.3g s\n",
              position.step, position.time, statistics.cells,
              is_planar ? "triangles" : "tetrahedra", statistics.interface_facets,
              is_planar ? "segments" : "triangles", is_planar ? "angles" : "dihedral angles",
              statistics.min_angle, statistics.max_angle, statistics.min_quality, unfinished,
              seconds);
}

/// Does a step. A domain that may grow does so before the interface comes near its boundary, and
/// where the step would leave it: the step is then repeated.
Step_outcome step_with_room(Tracked_complex& complex, const Run_options& options, double time) {
  complex.keep();
  while (options.step.grows_domain && !complex.has_room())
    complex.grow_domain();
  Step_outcome outcome = complex.advance(options.step, time, options.threads);
  while (options.step.grows_domain && outcome.stopped_at_boundary > 0) {
    complex.go_back();
    complex.grow_domain();
    complex.keep();
    outcome = complex.advance(options.step, time, options.threads);
  }
  return outcome;
}

void print_boundary(std::size_t stopped) {
  if (stopped > 0)
    std::printf(
        "dsc: the interface reached the boundary of the domain and stopped there (%zu times "
        "a vertex); use a larger --domain, or --domain grow, to let it move on\n",
        stopped);
}

void print_interruption(const Run_position& position, const std::string& checkpoint,
                        unsigned steps_left) {
  std::cerr << "dsc: interrupted after step " << position.step
            << "; continue with the same options and --resume " << checkpoint;
  if (steps_left > 0)
    std::cerr << " --steps " << steps_left;
  std::cerr << '\n';
}

} // namespace

int execute(const Run_options& asked) {
  Run_options options = asked;

  // What cannot work is refused before anything is computed.
  std::optional<Output_folder> folder;
  if (!options.output.empty())
    folder.emplace(options.output, options.resume, options.subdivisions);
  std::vector<std::string> precious = options.start.inputs;
  precious.push_back(options.resume);
  if (folder)
    precious.push_back(folder->checkpoint());
  require_place("--report", options.report, precious);
  precious.push_back(options.report);
  if (!options.picture.empty())
    require_extension(options.picture, {"png"});
  require_place("--picture", options.picture, precious);

  Run_position position;
  Repairs repairs;
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  const std::unique_ptr<Tracked_complex> tracked = start(options, position, repairs);
  if (!options.quiet)
    print_repairs(options.start.inputs, repairs);
  Tracked_complex& complex = *tracked;
  if (!options.picture.empty() && complex.dimension() == 2)
    throw Usage_error("--picture is for runs in space; in the plane, --output writes pictures");
  if (folder && !options.resume.empty())
    folder->keep_until(position.time);

  const double time_step = complex.time_step(options.step.motion);
  if (!(position.time + time_step > position.time))
    throw Input_error("a step is too short for the time " + Json(position.time).dump() +
                      " of the run; choose a longer --dt");
  const std::optional<Start_distance> from_start = start_distance(options, position);
  Report report(options, position.start, repairs, complex.sweep_seconds());
  Statistics statistics = complex.statistics();
  report.add(position, Step_outcome(), statistics);
  const auto write_files = [&] {
    if (folder)
      folder->write(complex, position, to_metadata(position, options.step));
  };
  write_files();
  interruptible.reset();

  unsigned done = 0;
  std::size_t unfinished = 0, stopped_at_boundary = 0;
  double seconds = 0;
  Flat_cells flat_cells;
  Progress_line progress(options.steps, options.quiet);
  progress.show(done);
  const auto advance = [&] {
    Step_outcome outcome = step_with_room(complex, options, position.time);
    const double time = position.time + time_step;
    if (from_start && is_whole_period(time, time_step, period(options.step.motion)))
      outcome.distance_to_start = from_start->of(complex.interface_points(), complex.mean_edge());
    statistics = complex.statistics();
    complex.forget();
    ++done;
    ++position.step;
    position.time = time;
    unfinished += outcome.unfinished_vertices;
    stopped_at_boundary += outcome.stopped_at_boundary;
    flat_cells.add(outcome, statistics);
    seconds += outcome.seconds;
    report.add(position, outcome, statistics);
    if (position.step % options.every == 0)
      write_files();
  };
  try {
    const Interruptible steps(true);
    while (done < options.steps && !interrupted()) {
      advance();
      progress.show(done);
    }
  } catch (const CGAL::Deformable_simplicial_complexes::Interrupted_error&) {
    complex.go_back();
  } catch (...) {
    // A step that cannot be done, for whatever reason. Those before it are worth keeping.
    progress.clear();
    complex.go_back();
    write_files();
    report.write();
    throw;
  }
  progress.clear();
  write_files();

  const bool stopped = interrupted();
  if (stopped) {
    std::string checkpoint = unused_name("dsc_interrupted", ".dsc");
    if (folder)
      checkpoint = folder->checkpoint();
    else
      complex.write_checkpoint(checkpoint, to_metadata(position, options.step));
    print_interruption(position, checkpoint, options.steps - done);
  }
  report.write();
  if (!options.picture.empty())
    complex.write(options.picture);
  if (!options.quiet) {
    print_boundary(stopped_at_boundary);
    print_flat_cells(flat_cells);
    print_summary(position, statistics, unfinished, seconds);
  }
  return stopped ? exit_code_of_interrupt : 0;
}

} // namespace dsc
