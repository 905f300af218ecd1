// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "commands/run_command.h"
#include "input/velocity_expressions.h"
#include "programs/errors.h"

#include <string>
#include <variant>

namespace dsc {
namespace {

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
