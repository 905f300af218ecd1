// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/run.h"

#include "input/Inputs.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/functions_of_points.h"
#include "input/translations.h"
#include "motions/motion_list.h"
#include "motions/run_balance.h"
#include "motions/run_position.h"
#include "motions/start_distance.h"
#include "motions/tracked_complex.h"
#include "output/label_titles.h"
#include "output/output_folder.h"
#include "output/progress_line.h"
#include "output/report.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"

#include <iostream>

namespace dsc {
namespace {

void print_repairs(const Repairs& repairs) {
  for (const Repair& repair : repairs)
    std::printf("dsc: %s: %s\n", repair.surface.c_str(), what_was_repaired(repair.report).c_str());
}

void print_changes(const Run_position& position, const std::string& changes) {
  std::printf("dsc: resuming at step %u; %s\n", position.step, changes.c_str());
}

/// Builds or reads the complex. A resumed run keeps all options that are not given in `options`.
/// \param changes receives the list of options that the resumed run changes, for messages
std::unique_ptr<Tracked_complex> start_or_resume(Run_options& options, Run_position& position,
                                                 Repairs& repairs, std::string& changes) {
  if (options.resume.empty()) {
    position.start = options.start;
    return options.inputs->start(options, repairs);
  }
  std::string metadata;
  auto complex = options.inputs->resume(options.resume, metadata);
  const std::optional<Saved_run> run = from_metadata(metadata);
  if (!run)
    throw Input_error(options.resume + " contains a complex, but no run to resume; write its "
                                       "interface with dsc convert, and start a new run from it");
  position = run->position;
  changes = continue_steps(run->step, options.given, options.step);
  if (complex->dimension() == 2 && options.given.count("--axis") > 0)
    throw Usage_error("--axis applies only in space; leave it out");
  return complex;
}

/// Returns the time after which a motion returns to its start; 0 if it does not.
double period(const Motion& motion) {
  if (std::holds_alternative<Zalesak>(motion))
    return Zalesak::period;
  const Advection* advection = std::get_if<Advection>(&motion);
  return advection ? advection->period.value_or(0) : 0;
}

/// Returns the distance measurement to the initial surfaces or curves. Returns `nullopt` if the
/// motion does not return to its start, the inputs are of another kind, or they can no longer be
/// read.
std::optional<Start_distance> start_distance(const Run_options& options,
                                             const Run_position& position) {
  const Run_start& start = position.start;
  if (period(options.step.motion) == 0 || input_kind(start) != Input_kind::surfaces ||
      (start.inputs.empty() && !start.ball && start.figure == Figure::none))
    return std::nullopt;
  try {
    return options.inputs->distance_from(start);
  } catch (const std::runtime_error&) { // a run can be resumed without its inputs
    return std::nullopt;
  }
}

bool is_whole_period(double time, double time_step, double period) {
  return std::abs(time - std::round(time / period) * period) < 1e-6 * time_step;
}

/// The steps after which cells were below the quality floor: the number of these steps, the largest
/// number of such cells, and the worst quality.
struct Flat_cells
{
  unsigned steps = 0;
  std::size_t most = 0;
  double quality = 1; ///< worst quality of a cell

  void add(const Step_outcome& outcome, const Tracked_complex& complex) {
    if (outcome.flat_cells == 0)
      return;
    ++steps;
    most = (std::max)(most, outcome.flat_cells);
    quality = (std::min)(quality, complex.worst_quality());
  }
};

void print_flat_cells(const Flat_cells& flat) {
  if (flat.steps > 0)
    std::printf(
        "dsc: cells were below the quality floor after %u %s (at most %zu %s after a step); the "
        "worst quality was %.3g\n",
        flat.steps, noun(flat.steps, "step", "steps"), flat.most, noun(flat.most, "cell", "cells"),
        flat.quality);
}

void print_summary(const Run_position& position, const Statistics& statistics,
                   std::size_t unfinished, double seconds) {
  const bool is_planar = statistics.dimension == 2;
  std::printf("dsc: step %u, time %g: %zu %s, %zu interface %s, %s %.3g to %.4g degrees, worst "
              "quality %.3g; %zu unfinished %s, %.3g s\n",
              position.step, position.time, statistics.cells,
              is_planar ? "triangles" : "tetrahedra", statistics.interface_facets,
              is_planar ? noun(statistics.interface_facets, "segment", "segments")
                        : noun(statistics.interface_facets, "triangle", "triangles"),
              is_planar ? "angles" : "dihedral angles", statistics.min_angle, statistics.max_angle,
              statistics.min_quality, unfinished, noun(unfinished, "vertex", "vertices"), seconds);
}

/// Returns the time in which the fastest vertex moves by a mean edge, or a little less, so that
/// steps end with a period.
double chosen_time_step(const Tracked_complex& complex, const Advection& flow, double time) {
  static constexpr double at_rest = .01; // if nothing moves, any time step will do
  const Velocity_expressions velocity(flow.expressions, complex.dimension());
  double fastest = 0;
  for (const Surface_point& p : complex.interface_points()) {
    const auto [x, y, z] = velocity.at({p.x(), p.y(), p.z()}, time);
    fastest = (std::max)(fastest, std::hypot(x, y, z));
  }
  double result = fastest > 0 ? complex.mean_edge() / fastest : at_rest;
  if (flow.period)
    result = *flow.period / std::ceil(*flow.period / result);
  return result;
}

/// Completes what a motion takes from the complex at the start of a run.
void complete_motion(const Tracked_complex& complex, double time, bool is_quiet, Motion& motion) {
  if (auto* flow = std::get_if<Advection>(&motion); flow && flow->dt == 0) {
    flow->dt = complex.agreed(chosen_time_step(complex, *flow, time));
    if (!is_quiet)
      complex.run_once([&] { std::printf("dsc: the time step is %.4g\n", flow->dt); });
  }
  if (auto* flow = std::get_if<Curvature_flow>(&motion);
      flow && flow->keeps_volumes && flow->volumes.empty())
    for (const Label_statistics& region : complex.statistics().labels)
      flow->volumes.emplace(region.label, region.volume);
}

/// Does a step. A growing domain is enlarged before the interface comes near its boundary. If the
/// step would leave the domain, the domain is enlarged and the step is repeated.
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

/// The steps that were too long for one deformation.
struct Divided_steps
{
  unsigned steps = 0;
  unsigned most = 0; ///< parts of a step

  void add(const Step_outcome& outcome) {
    steps += outcome.parts > 1;
    most = (std::max)(most, outcome.parts);
  }
};

void print_divided(const Divided_steps& divided) {
  if (divided.steps > 0)
    std::printf("dsc: %u %s too long and divided into at most %u parts\n", divided.steps,
                noun(divided.steps, "step was", "steps were"), divided.most);
}

void print_missing(std::size_t facets, const DSC::Thin_part_options& thin_parts) {
  if (facets > 0)
    std::printf("dsc: thin parts of the interface are coarse: about %.2g more %s would resolve "
                "them; use a larger --most-new-facets (now %u)\n",
                static_cast<double>(facets), noun(facets, "facet", "facets"),
                thin_parts.most_new_facets);
}

void print_boundary(std::size_t stopped) {
  if (stopped > 0)
    std::printf(
        "dsc: the interface stopped at the boundary of the domain (%zu %s, counted in each step); "
        "use a larger --domain or --domain grow\n",
        stopped, noun(stopped, "vertex", "vertices"));
}

void print_interruption(const Run_position& position, const std::string& checkpoint,
                        unsigned steps_left) {
  std::cerr << "dsc: interrupted after step " << position.step
            << "; continue with the same options and --resume " << checkpoint;
  if (steps_left > 0)
    std::cerr << " --steps " << steps_left;
  std::cerr << '\n';
}

/// A run: the complex, its position, and the output files and messages.
class Run
{
public:
  explicit Run(const Run_options& options) : m_options(options) {}

  /// Checks whether the output files can be written.
  /// \throws Usage_error, Input_error
  void check_places();

  /// Builds or reads the complex.
  void start();

  /// Writes the initial state, does the steps until the end or an interrupt, and writes the result.
  void do_steps();

  /// Prints the result; after an interrupt, writes it. Returns the exit code.
  int finish();

private:
  void advance();
  void write_files(bool writes_state);
  void write_report();
  std::string metadata() const {
    return to_metadata(m_position, m_options.step, m_complex->label_names);
  }

  Run_options m_options;
  std::optional<Output_folder> m_folder;
  std::unique_ptr<Tracked_complex> m_complex;
  Run_position m_position;
  double m_time_step = 0;
  std::optional<Start_distance> m_from_start; // on one process
  bool m_measures_distance = false;
  std::optional<Report> m_report; // if requested
  unsigned m_done = 0;
  bool m_is_stopped = false; // by an interrupt
  std::size_t m_unfinished = 0, m_stopped_at_boundary = 0;
  double m_seconds = 0;
  Divided_steps m_divided_steps;
  Flat_cells m_flat_cells;
  Run_balance m_balance;
};

void Run::check_places() {
  const Output_options& output = m_options.output;
  if (!output.folder.empty())
    m_folder.emplace(output.folder, output.subdivisions);
  if (!output.picture.empty())
    require_format(output.picture, Use::write, content::picture);
  m_options.inputs->run_once([&] {
    std::vector<std::string> precious = with_user_names(m_options.start.inputs);
    precious.push_back(m_options.resume);
    if (m_folder) {
      m_folder->claim(m_options.resume);
      precious.push_back(m_folder->checkpoint());
    }
    require_place("--report", output.report, precious);
    precious.push_back(output.report);
    require_place("--picture", output.picture, precious);
  });
}

void Run::start() {
  Repairs repairs;
  const Interruptible interruptible(m_options.output.quiet);
  std::string changes;
  m_complex = start_or_resume(m_options, m_position, repairs, changes);
  // Precedes all output, because it may need another program.
  m_complex->run_once([&] { m_from_start = start_distance(m_options, m_position); });
  m_measures_distance = m_complex->agreed(m_from_start.has_value()) > 0;
  if (!m_options.output.quiet) {
    if (!changes.empty())
      print_changes(m_position, changes);
    print_repairs(repairs);
    if (!m_complex->label_names.empty())
      m_complex->run_once([&] {
        std::printf("dsc: names of labels: %s\n", label_titles(m_complex->label_names).c_str());
      });
  }
  if (!m_options.output.quiet && m_options.resume.empty())
    print_missing(m_complex->missing_facets(m_options.start.thin_parts.edge_per_thickness),
                  m_options.start.thin_parts);
  if (!m_options.output.picture.empty() && m_complex->dimension() == 2)
    throw Usage_error(
        "--picture applies only in space; in the plane, use --output to write pictures");
  if (m_options.output.subdivisions > 0 && m_complex->dimension() == 2)
    throw Usage_error("--subdivide applies only in space; leave it out");
  if (m_folder && !m_options.resume.empty())
    m_complex->run_once([&] { m_folder->keep_until(m_position.time); });

  complete_motion(*m_complex, m_position.time, m_options.output.quiet, m_options.step.motion);
  m_time_step = time_step(m_options.step.motion, m_complex->mean_edge());
  if (!(m_position.time + m_time_step > m_position.time))
    throw Input_error("the time step is too small to advance the time " +
                      Json(m_position.time).dump() + " of the run; choose a larger --dt");
  if (!m_options.output.report.empty()) {
    m_report.emplace(m_options, m_position.start, repairs, m_complex->sweep_seconds(),
                     m_complex->label_names);
    m_report->add(m_position, Step_outcome(), m_complex->statistics());
  }
}

// The most precious files come first, because the disk may be full.
void Run::write_files(bool writes_state) {
  if (m_folder && writes_state)
    m_folder->save(*m_complex, m_position, metadata());
  if (m_report)
    m_complex->run_once([&] { m_report->write_now_and_then(); });
  if (m_folder && writes_state)
    m_folder->write(*m_complex, m_position);
}

void Run::advance() {
  Step_outcome outcome = step_with_room(*m_complex, m_options, m_position.time);
  const double time = m_position.time + m_time_step;
  if (m_measures_distance && is_whole_period(time, m_time_step, period(m_options.step.motion))) {
    const std::vector<Surface_point> points = m_complex->interface_points();
    if (m_from_start)
      outcome.distance_to_start = m_from_start->of(points, m_complex->mean_edge());
  }
  m_complex->forget();
  ++m_done;
  ++m_position.step;
  m_position.time = time;
  m_unfinished += outcome.unfinished_vertices;
  m_stopped_at_boundary += outcome.stopped_at_boundary;
  m_divided_steps.add(outcome);
  m_flat_cells.add(outcome, *m_complex);
  m_balance.add(m_position.step, outcome.balances);
  m_seconds += outcome.seconds;
  if (m_report) // statistics take long
    m_report->add(m_position, outcome, m_complex->statistics());
  write_files(m_position.step % m_options.output.every == 0);
}

void Run::do_steps() {
  Progress_line progress(m_options.steps, m_options.output.quiet);
  progress.show(m_done);
  try {
    std::optional<Interruptible> steps(true);
    write_files(true);
    agree_on_interrupts();
    while (m_done < m_options.steps && !interrupted()) {
      advance();
      progress.show(m_done);
      agree_on_interrupts();
    }
    progress.clear();
    if (!interrupted())
      write_files(true);
    m_is_stopped = interrupted();
    steps.reset();
    if (!m_is_stopped) {
      write_report();
      if (!m_options.output.picture.empty())
        m_complex->write(m_options.output.picture);
      if (m_folder)
        m_folder->require(*m_complex);
    }
  } catch (const DSC::Interrupted_error&) {
    m_is_stopped = true;
    m_complex->go_back();
    progress.clear();
    agree_on_interrupts();
  } catch (const std::exception& error) {
    // After an error of any kind in a step, the previous steps are kept. If other processes have no
    // error, this one cannot write with them.
    progress.clear();
    if (!all_processes_fail())
      throw;
    const auto save = [&] {
      m_complex->go_back();
      return m_folder || m_done > 0
                 ? save_run(m_folder, "dsc_failed", *m_complex, m_position, metadata())
                 : std::string();
    };
    throw std::runtime_error(
        message_after_saving(error, m_position.step, save, [&] { write_report(); }));
  }
}

void Run::write_report() {
  if (!m_report)
    return;
  m_report->set_balance(m_balance);
  m_complex->run_once([&] { m_report->write(); });
}

int Run::finish() {
  if (m_is_stopped) {
    print_interruption(m_position,
                       save_run(m_folder, "dsc_interrupted", *m_complex, m_position, metadata()),
                       m_options.steps - m_done);
    write_report();
  }
  if (!m_options.output.quiet) {
    print_divided(m_divided_steps);
    print_boundary(m_stopped_at_boundary);
    for (const std::string& message : m_balance.messages(m_complex->label_names))
      std::printf("dsc: %s\n", message.c_str());
    print_flat_cells(m_flat_cells);
    print_summary(m_position, m_complex->statistics(), m_unfinished, m_seconds);
  }
  return m_is_stopped ? exit_code_of_interrupt : 0;
}

} // namespace

int run(const Run_options& options) {
  Run run(options);
  run.check_places(); // fails before the computation starts
  run.start();
  run.do_steps();
  return run.finish();
}

} // namespace dsc
