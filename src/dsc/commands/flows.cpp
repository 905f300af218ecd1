// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/start_options.h"
#include "input/Inputs.h"
#include "input/functions_of_points.h"
#include "input/translations.h"
#include "motions/motion.h"
#include "motions/motion_list.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <climits>

namespace dsc {
namespace {

/// A command that moves an interface, as written.
struct Run_command
{
  Run_options run;
  std::string domain;
  Default_start start; ///< without start options
  Start_check* check;  ///< may be null
};

void add_step_options(CLI::App& command, Step_options& step) {
  CLI::Option* improves =
      command.add_flag("--improve-interface", step.improves_interface,
                       "Optimize the triangles of the interface before each step");
  constexpr Number_range at_least_0_below_1 = {
      "0.025", [](double x) { return 0 <= x && x < 1; },
      " is out of range; choose a number from 0 to less than 1"};
  add_value(command, "--aggressiveness", step.aggressiveness, at_least_0_below_1,
            "Amount of smoothing by --improve-interface, from 0 to less than 1 (default: 0.025)")
      ->needs(improves);
  add_value(command, "--largest-displacement", step.largest_displacement, not_negative("0.5"),
            "Divide steps in which a vertex moves farther than this number of edges relative to "
            "its neighbors (default: 0.5); 0 turns off the division");
}

void add_output_options(CLI::App& command, Output_options& options) {
  CLI::Option* output =
      command.add_option("--output", options.folder,
                         "Folder for ParaView files and a checkpoint; created if necessary");
  command
      .add_option("--every", options.every,
                  "Write every N-th step; the last step is always written")
      ->check(CLI::Range(1, INT_MAX))
      ->needs(output)
      ->capture_default_str();
  command
      .add_option("--subdivide", options.subdivisions,
                  "Also write the interface of these steps as a smooth surface (.ply), with this "
                  "number of Loop subdivision steps; only in space")
      ->check(CLI::Range(1, most_subdivisions))
      ->needs(output);
  add_output(command, "--picture", options.picture,
             "Picture of the interface at the end (.png); only in space", "png");
  add_output(command, "--report", options.report, "JSON file with a report of each step", "json");
  command.add_flag("--quiet", options.quiet,
                   "Print only errors and the checkpoint of an interrupted run");
}

/// Adds the options of all commands that move an interface.
void add_common_options(CLI::App& command, Run_command& options) {
  Run_options& run = options.run;
  CLI::Option* paths = add_inputs(command, run.start);
  CLI::Option* resume = add_input(command, "--resume", run.resume,
                                  "Continue the run of a checkpoint instead of reading an INPUT; "
                                  "options of the steps that are not given keep their values");
  resume->excludes(paths);
  command.add_option("--steps", run.steps, "Number of steps of this run")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  add_start_options(command, run.start, options.domain, resume);
  add_step_options(command, run.step);
  run.threads = default_number_of_threads();
  add_threads_option(command, run.threads);
  add_output_options(command, run.output);
}

/// Returns the options of a run after checking them.
/// \throws Usage_error
Run_options checked(const CLI::App& command, const Run_command& options) {
  Run_options run = options.run;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0)
      run.given.insert(option->get_name());
  if (run.output.quiet)
    keep_silent_about_unused();
  for (std::string& input : run.start.inputs)
    input = run.inputs->native(input, run.start.labels, run.start.thresholds);
  if (run.resume.empty()) {
    require_options(run.step.motion, run.given);
    require_effect_of_options(run.step, run.given);
  }
  complete_start(options.domain, options.start, options.check, run);
  return run;
}

/// Adds the command of a motion, with the options of all commands that move an interface.
/// \param motion with the default values of its options
/// \param check checks the conditions of the command; may be null
/// \param exit_code receives the exit code of a run
void add_run_command(CLI::App& app, const Inputs& inputs, const char* description,
                     const Motion& motion, const Default_start& start, Start_check* check,
                     int& exit_code) {
  const auto options = std::make_shared<Run_command>();
  options->run.inputs = &inputs;
  options->run.step.motion = motion;
  options->start = start;
  options->check = check;
  CLI::App* command = app.add_subcommand(command_of(motion), description);
  add_common_options(*command, *options);
  if (start.ball && start.domain_in_plane)
    command->add_flag_callback(
        "--plane", [options = options.get()] { options->start.figure = Figure::disk; },
        "Deform a disk in the unit square; not with an INPUT");
  add_options(*command, options->run.step.motion);
  if (start.ball)
    command->add_flag("--fit", options->start.fits_inputs,
                      "Scale and translate the surfaces into the ball");
  command->callback(
      [command, options, &exit_code] { exit_code = run(checked(*command, *options)); });
}

using Field = Advection::Field;

constexpr double dt_in_unit_cube = .01;

bool is_given(const Run_options& run, const char* option) { return run.given.count(option) > 0; }

void check_rotate(const Run_options& run, bool is_planar) {
  require_space(run, is_planar, {"--axis"});
  if (run.resume.empty() && !is_planar && !is_given(run, "--axis"))
    throw Usage_error("--axis is required; see dsc rotate --help");
}

void check_offset(const Run_options& run, bool is_planar) {
  require_space(run, is_planar, {"--move-faces"});
}

void check_fit(const Run_options& run) {
  if (run.start.inputs.empty() && is_given(run, "--fit"))
    throw Usage_error("--fit needs a surface; give at least one INPUT");
}

void check_enright(const Run_options& run, bool is_planar) {
  check_fit(run);
  if (is_planar)
    throw Usage_error("dsc enright applies only in space; use dsc vortex in the plane");
}

void check_vortex(const Run_options& run, bool is_planar) {
  check_fit(run);
  if (is_given(run, "--plane") && !(run.start.inputs.empty() && run.resume.empty()))
    throw Usage_error("--plane has no effect with an INPUT or --resume; leave it out");
  require_space(run, is_planar, {"--fit"});
}

void check_advect(const Run_options& run, bool) {
  if (is_given(run, "--velocity") && run.resume.empty())
    const Velocity_expressions check(std::get<Advection>(run.step.motion).expressions,
                                     dimension_of(run.start));
}

void check_zalesak(const Run_options& run, bool is_planar) {
  if (run.resume.empty() && !is_planar)
    throw Usage_error("dsc zalesak applies only in the plane; use dsc rotate in space");
}

/// Returns the usual start of a flow in the unit cube.
Default_start start_in_unit_cube(const Ball& ball) {
  Default_start result;
  result.ball = ball;
  result.domain_in_space = {0, 0, 0, 1, 1, 1};
  return result;
}

Default_start start_of_vortex() {
  Default_start result = start_in_unit_cube({{.5, .75, .5}, .15});
  result.domain_in_plane = {0, 0, 0, 1, 1, 0};
  return result;
}

Default_start start_of_zalesak() {
  Default_start result;
  result.figure = Figure::slotted_disk;
  result.domain_in_plane = {0, 0, 0, 100, 100, 0};
  return result;
}

} // namespace

void add_flows(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto add = [&](const char* description, const Motion& motion, const Default_start& start,
                       Start_check* check) {
    add_run_command(app, inputs, description, motion, start, check, exit_code);
  };
  add("Rotate the interface about the center of the domain", Rotation(), {}, check_rotate);
  add("Move the interface along its normals", Offset(), {}, check_offset);
  add("Deform surfaces in the unit cube, or a ball if there is no INPUT, by "
      "the flow of LeVeque and Enright",
      Advection{Field::enright, 1., dt_in_unit_cube}, start_in_unit_cube({{.35, .35, .35}, .15}),
      check_enright);
  add("Deform surfaces in the unit cube, or a ball if there is no INPUT, by a "
      "single vortex about the z axis; in the plane, curves in the unit square or, "
      "with --plane, a disk",
      Advection{Field::vortex, 8., dt_in_unit_cube}, start_of_vortex(), check_vortex);
  add("Move the interface by velocities given as expressions", Advection(), {}, check_advect);
  add("Move the interface by its mean curvature", Curvature_flow(), {}, nullptr);
  add("Rotate curves, or a slotted disk if there is no INPUT, about (50, 50) in "
      "the square from (0, 0) to (100, 100); a full rotation takes the time 628",
      Zalesak(), start_of_zalesak(), check_zalesak);
}

} // namespace dsc
