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
const Ball ball_of_vortex = {{.5, .75, .5}, .15};
constexpr std::array<double, 6> domain_of_vortex = {0, 0, 0, 1, 1, 1},
                                unit_square = {0, 0, 0, 1, 1, 0};
constexpr double period_of_vortex = 8;

struct Vortex_options
{
  Run_command_options run;
  Flow_options flow;
  bool fits = false, is_planar = false;
};

Default_start default_start(const Vortex_options& options) {
  Default_start result;
  result.ball = ball_of_vortex;
  result.fits_inputs = options.fits;
  result.figure = options.is_planar ? Figure::disk : Figure::none;
  result.domain_in_space = domain_of_vortex;
  result.domain_in_plane = unit_square;
  return result;
}

} // namespace

void add_vortex(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Vortex_options>();
  CLI::App* command =
      add_run_command(app, inputs, "vortex",
                      "Deform surfaces in the unit cube, or a ball if there is no INPUT, by a "
                      "single vortex about the z axis; in the plane, curves in the unit square or, "
                      "with --plane, a disk",
                      options->run);
  command->add_flag("--plane", options->is_planar,
                    "Deform a disk in the unit square; not with an INPUT");
  add_flow_options(*command, options->flow);
  command->add_flag("--fit", options->fits, "Scale and translate the surfaces into the ball");
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion =
        read_flow(options->flow, Advection::Field::vortex, "", period_of_vortex, run.given);
    complete_run_options(
        options->run, default_start(*options),
        [&](const Run_options& checked, bool is_planar) {
          const bool has_input = !checked.start.inputs.empty();
          if (!has_input && options->fits)
            throw Usage_error("--fit needs a surface; give at least one INPUT");
          if (options->is_planar && (has_input || !checked.resume.empty()))
            throw Usage_error("--plane has no effect with an INPUT or --resume; leave it out");
          require_space(checked, is_planar, {"--fit"});
        },
        run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
