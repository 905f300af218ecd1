// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/run_command.h"
#include "programs/errors.h"
#include "programs/option_values.h"

#include <array>
#include <memory>
#include <string>

namespace dsc {
namespace {

struct Rotate_options
{
  Run_command_options run;
  std::string axis, angle; ///< as written
};

/// Checks the axis: a rotation in space needs an axis, a rotation in the plane has none.
void check_axis(const Run_options& run, bool is_planar) {
  require_space(run, is_planar, {"--axis"});
  if (run.resume.empty() && !is_planar && run.given.count("--axis") == 0)
    throw Usage_error("--axis is required; see dsc rotate --help");
}

} // namespace

void add_rotate(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Rotate_options>();
  CLI::App* command = add_run_command(
      app, inputs, "rotate", "Rotate the interface about the center of the domain", options->run);
  command->add_option("--axis", options->axis,
                      "Direction of the axis, like 0,0,1; required for a new run in space");
  command->add_option("--angle", options->angle,
                      "Angle per step in degrees; required for a new run");
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion = Rotation{run.given.count("--axis") > 0 ? parse_axis(options->axis)
                                                             : std::array<double, 3>(),
                               run.given.count("--angle") > 0 ? parse_angle(options->angle) : 0};
    complete_run_options(options->run, {}, check_axis, run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
