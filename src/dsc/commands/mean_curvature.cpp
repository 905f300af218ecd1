// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/flow_options.h"
#include "commands/run_command.h"
#include "programs/option_values.h"

#include <memory>
#include <string>

namespace dsc {
namespace {

struct Mean_curvature_options
{
  Run_command_options run;
  std::string dt; ///< as written
  bool keeps_volumes = false;
  Tolerance_option tolerance;
};

} // namespace

void add_mean_curvature(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Mean_curvature_options>();
  CLI::App* command = add_run_command(app, inputs, "mean-curvature",
                                      "Move the interface by its mean curvature", options->run);
  command->add_option(
      "--dt", options->dt,
      "Time step, in squares of the length unit of the input (default: square of the "
      "mean interface edge of the input)");
  command->add_flag("--keep-volumes", options->keeps_volumes,
                    "Preserve the volume of each label except 0");
  add_tolerance_option(*command, options->tolerance);
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion =
        Curvature_flow{run.given.count("--dt") > 0 ? parse_positive(options->dt, "--dt") : 0,
                       options->keeps_volumes, read_tolerance(options->tolerance, run.given)};
    complete_run_options(options->run, {}, nullptr, run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
