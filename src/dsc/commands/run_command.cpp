// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/run_command.h"

#include "input/Inputs.h"
#include "input/unused.h"
#include "motions/continue_steps.h"
#include "programs/option_values.h"

#include <climits>

namespace dsc {

void add_improvement_options(CLI::App& command, Interface_improvement_options& options) {
  CLI::Option* improves =
      command.add_flag("--improve-interface", options.improves_interface,
                       "Optimize the triangles of the interface before each step");
  command
      .add_option(
          "--aggressiveness", options.aggressiveness,
          "Amount of smoothing by --improve-interface, from 0 to less than 1 (default: 0.025)")
      ->needs(improves);
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
  command.add_option("--picture", options.picture,
                     "Picture of the interface at the end (.png); only in space");
  command.add_option("--report", options.report, "JSON file with a report of each step");
  command.add_flag("--quiet", options.quiet,
                   "Print only errors and the checkpoint of an interrupted run");
}

CLI::App* add_run_command(CLI::App& app, const Inputs& inputs, const std::string& name,
                          const std::string& description, Run_command_options& options) {
  options.inputs = &inputs;
  CLI::App* command = app.add_subcommand(name, description);
  CLI::Option* paths = add_inputs(*command, options.start);
  CLI::Option* resume = command->add_option("--resume", options.resume,
                                            "Continue the run of a checkpoint instead of reading "
                                            "an INPUT; options of the steps that are not given "
                                            "keep their values");
  resume->excludes(paths);
  command->add_option("--steps", options.steps, "Number of steps of this run")
      ->check(CLI::Range(1, INT_MAX))
      ->capture_default_str();
  add_start_options(*command, options.start, resume);
  add_improvement_options(*command, options.improvement);
  command->add_option(
      "--largest-displacement", options.largest_displacement,
      "Divide steps in which a vertex moves farther than this number of edges relative to its "
      "neighbors (default: 0.5); 0 turns off the division");
  add_threads_option(*command, options.threads);
  add_output_options(*command, options.output);
  return command;
}

Run_options begin_run_options(const CLI::App& command, const Run_command_options& options) {
  Run_options run;
  run.inputs = options.inputs;
  run.step.improves_interface = options.improvement.improves_interface;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0)
      run.given.insert(option->get_name());
  run.start = options.start.start;
  if (options.output.quiet)
    keep_silent_about_unused();
  for (std::string& input : run.start.inputs)
    input = run.inputs->native(input, run.start.labels, run.start.thresholds);
  run.resume = options.resume;
  run.steps = options.steps;
  run.threads = options.threads;
  run.output = options.output;
  return run;
}

void complete_run_options(const Run_command_options& options, const Default_start& defaults,
                          const Start_check& check, Run_options& run) {
  const bool is_planar = set_default_figure(run, defaults);
  read_domain(options.start, is_planar, run);
  if (run.given.count("--aggressiveness") > 0)
    run.step.aggressiveness = parse_aggressiveness(options.improvement.aggressiveness);
  if (run.given.count("--largest-displacement") > 0)
    run.step.largest_displacement =
        parse_not_negative(options.largest_displacement, "--largest-displacement", "0.5");
  if (run.resume.empty()) {
    require_options(run.step.motion, run.given);
    require_effect_of_options(run.step, run.given);
  }
  complete_start(options.start, defaults, is_planar, check, run);
}

} // namespace dsc
