// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/flow_options.h"
#include "commands/run_command.h"
#include "programs/errors.h"

#include <array>
#include <memory>

namespace dsc {
namespace {

// The usual start of this flow.
const Ball ball_of_enright = {{.35, .35, .35}, .15};
constexpr std::array<double, 6> unit_cube = {0, 0, 0, 1, 1, 1};
constexpr double default_period = 1;

struct Enright_options
{
  Run_command_options run;
  Flow_options flow;
  bool fits = false;
};

Default_start default_start(bool fits) {
  Default_start result;
  result.ball = ball_of_enright;
  result.fits_inputs = fits;
  result.domain_in_space = unit_cube;
  return result;
}

} // namespace

void add_enright(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Enright_options>();
  CLI::App* command =
      add_run_command(app, inputs, "enright",
                      "Deform surfaces in the unit cube, or a ball if there is no INPUT, by "
                      "the flow of LeVeque and Enright",
                      options->run);
  add_flow_options(*command, options->flow);
  command->add_flag("--fit", options->fits, "Scale and translate the surfaces into the ball");
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion =
        read_flow(options->flow, Advection::Field::enright, "", default_period, run.given);
    complete_run_options(
        options->run, default_start(options->fits),
        [&](const Run_options& checked, bool is_planar) {
          if (checked.start.inputs.empty() && options->fits)
            throw Usage_error("--fit needs a surface; give at least one INPUT");
          if (is_planar)
            throw Usage_error("dsc enright applies only in space; use dsc vortex in the plane");
        },
        run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
