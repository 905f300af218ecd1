// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/flow_options.h"
#include "commands/run_command.h"
#include "input/velocity_expressions.h"

#include <memory>
#include <string>

namespace dsc {
namespace {

constexpr double no_period = 0;

struct Advect_options
{
  Run_command_options run;
  std::string velocity; ///< as written
  Flow_options flow;
};

} // namespace

void add_advect(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Advect_options>();
  CLI::App* command = add_run_command(
      app, inputs, "advect", "Move the interface by velocities given as expressions", options->run);
  command->add_option(
      "--velocity", options->velocity,
      "Velocity in the coordinates of the input: three expressions in x, y, z and t "
      "like '-y,x,sin(pi*t)'; in the plane, two expressions in x, y and t; "
      "required for a new run");
  add_flow_options(*command, options->flow);
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    if (run.given.count("--velocity") > 0 && run.resume.empty())
      const Velocity_expressions check(options->velocity, dimension_of(run.start));
    run.step.motion = read_flow(options->flow, Advection::Field::expressions, options->velocity,
                                no_period, run.given);
    complete_run_options(options->run, {}, nullptr, run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
