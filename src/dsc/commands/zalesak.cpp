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

constexpr std::array<double, 6> square = {0, 0, 0, 100, 100, 0};
constexpr double dt_of_zalesak = 1;

struct Zalesak_options
{
  Run_command_options run;
  std::string dt; ///< as written
};

Default_start default_start() {
  Default_start result;
  result.figure = Figure::slotted_disk;
  result.domain_in_plane = square;
  return result;
}

void require_plane(const Run_options& run, bool is_planar) {
  if (run.resume.empty() && !is_planar)
    throw Usage_error("dsc zalesak applies only in the plane; use dsc rotate in space");
}

} // namespace

void add_zalesak(CLI::App& app, const Inputs& inputs, int& exit_code) {
  const auto options = std::make_shared<Zalesak_options>();
  CLI::App* command =
      add_run_command(app, inputs, "zalesak",
                      "Rotate curves, or a slotted disk if there is no INPUT, about (50, 50) in "
                      "the square from (0, 0) to (100, 100); a full rotation takes the time 628",
                      options->run);
  command->add_option("--dt", options->dt, "Time step (default: 1)");
  command->callback([command, options, &exit_code] {
    Run_options run = begin_run_options(*command, options->run);
    run.step.motion =
        Zalesak{run.given.count("--dt") > 0 ? parse_positive(options->dt, "--dt") : dt_of_zalesak};
    complete_run_options(options->run, default_start(), require_plane, run);
    exit_code = dsc::run(run);
  });
}

} // namespace dsc
