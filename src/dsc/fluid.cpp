// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "errors.h"
#include "files.h"
#include "fluid_report.h"
#include "fluid_scene.h"
#include "fluid_start.h"
#include "interrupt.h"
#include "output_folder.h"
#include "progress_line.h"
#include "report_json.h"

#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint_3.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

Json state_json(const Fluid::State& state) {
  return {{"time", state.time},
          {"steps", state.steps},
          {"damped_steps", state.damped_steps},
          {"knows_accelerations", state.knows_accelerations},
          {"motion", state.motion},
          {"volumes", state.volumes},
          {"pressures_and_volumes_of_gases", state.gases}};
}

Fluid::State state_of(const Json& json) {
  Fluid::State state;
  state.time = json.at("time");
  state.steps = json.at("steps");
  state.damped_steps = json.at("damped_steps");
  state.knows_accelerations = json.at("knows_accelerations");
  state.motion = json.at("motion").get<decltype(state.motion)>();
  state.volumes = json.at("volumes").get<std::vector<std::pair<std::uint32_t, double>>>();
  state.gases = json.at("pressures_and_volumes_of_gases").get<decltype(state.gases)>();
  return state;
}

std::string metadata(const Fluid_scene& scene, const Fluid& fluid) {
  return Json{{"scene", scene.json}, {"fluid", state_json(fluid.state())}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
}

/// A run of a scene: its complex, and the fluid in it.
struct Run
{
  Fluid_scene scene;
  std::unique_ptr<Tracked_complex_3> complex;
  std::unique_ptr<Fluid> fluid;
};

Run start(const Fluid_options& options) {
  Run run;
  run.scene = find_scene(options.scene);
  require_files(run.scene, options.data);
  run.complex = std::make_unique<Tracked_complex_3>(start_of_scene(run.scene, options.data));
  require_effect(run.scene, run.complex->complex);
  run.fluid = fluid_of_scene(run.scene, options.data, run.complex->complex);
  require_outside_of_solids(run.scene, *run.fluid);
  if (run.scene.relaxation_steps > 0) {
    const double velocity =
        run.fluid->relax(run.scene.relaxation_step, unsigned(run.scene.relaxation_steps),
                         parameters::number_of_threads(options.threads));
    if (!options.quiet)
      std::printf("dsc: relaxed until vertices went with %.3g\n", velocity);
  }
  set_velocities(run.scene, *run.fluid);
  return run;
}

Run resume(const Fluid_options& options) {
  const CGAL::IO::Checkpoint_3 checkpoint = CGAL::IO::read_checkpoint(options.resume);
  Run run;
  try {
    const Json json = Json::parse(checkpoint.metadata);
    run.scene = read_scene(json.at("scene"));
    run.complex = std::make_unique<Tracked_complex_3>();
    run.complex->complex.restore(checkpoint.state);
    run.fluid = fluid_of_scene(run.scene, options.data, run.complex->complex);
    run.fluid->restore(state_of(json.at("fluid")));
  } catch (const Json::exception&) {
    throw Input_error(options.resume + " holds a complex, but no fluid that could go on");
  }
  return run;
}

double next_step(const Run& run, double end) {
  const double time = run.fluid->time(), left = end - time;
  double dt = run.scene.time_step;
  if (run.scene.cfl > 0)
    dt = std::min(dt, run.fluid->largest_step(run.scene.cfl));
  // No tiny step in the end.
  static constexpr double almost = 1e-9;
  return dt * (1 + almost) >= left ? left : dt * 2 <= left ? dt : left / 2;
}

void print_summary(const Run& run, unsigned steps, const Repetitions& repetitions, double seconds) {
  const Fluid::Balance balance = run.fluid->balance();
  std::printf(
      "dsc: %s; %u steps, time %g: %zu vertices, %zu interface triangles, volume %.10g, energy "
      "%.6g%s; %.3g s\n",
      run.scene.title.c_str(), steps, run.fluid->time(), run.complex->complex.number_of_vertices(),
      run.complex->complex.interface_facets().size(), balance.volume, balance.energy(),
      repetitions.text().c_str(), seconds);
}

} // namespace

int execute(const Fluid_options& options) {
  if (options.lists) {
    for (const auto& [name, title] : scene_names())
      std::printf("%-16s%s\n", name.c_str(), title.c_str());
    return 0;
  }
  if (options.prints) {
    std::printf("%s\n", find_scene(options.scene).json.dump(2).c_str());
    return 0;
  }
  std::optional<Output_folder> folder;
  if (!options.output.empty())
    folder.emplace(options.output, options.resume, options.subdivisions);
  require_place("--report", options.report, {options.resume, options.scene});
  require_place("--picture", options.picture, {options.resume, options.scene, options.report});

  const auto begin = Clock::now();
  std::optional<Interruptible> interruptible(std::in_place, options.quiet);
  Run run = options.resume.empty() ? start(options) : resume(options);
  Fluid& fluid = *run.fluid;
  run.complex->velocity_at = [&fluid](Complex::Vertex_handle v) { return fluid.velocity(v); };
  run.complex->pressure_at = [&fluid](Complex::Vertex_handle v) { return fluid.pressure(v); };
  const double end = options.end > 0 ? options.end : run.scene.end;
  if (!(end > fluid.time()))
    throw Usage_error("the end " + Json(end).dump() + " is not after the time " +
                      Json(fluid.time()).dump() + " of the checkpoint; choose a later --end");
  if (folder && !options.resume.empty())
    folder->keep_until(fluid.time());
  Json steps = Json::array();
  Repetitions repetitions;
  const auto first = unsigned(fluid.state().steps);
  unsigned done = 0;
  steps.push_back(step_json(fluid, run.scene, first, std::nullopt));
  const auto write_files = [&] {
    if (folder) {
      Run_position position;
      position.step = first + done;
      position.time = fluid.time();
      folder->write(*run.complex, position, metadata(run.scene, fluid));
    }
  };
  // The name of the last checkpoint, which is written if there is no folder with one.
  const auto checkpoint = [&](const char* name) {
    if (folder)
      return folder->checkpoint();
    const std::string result = unused_name(name, ".dsc");
    run.complex->write_checkpoint(result, metadata(run.scene, fluid));
    return result;
  };
  const auto write_report = [&] {
    if (!options.report.empty())
      write_json(options.report,
                 {{"scene", run.scene.json}, {"repeated", repetitions.json()}, {"steps", steps}});
  };
  write_files();
  interruptible.reset();
  static constexpr unsigned parts = 100; // of the time
  Progress_line progress(parts, options.quiet, "percent");
  const double start_time = fluid.time();
  const auto np = parameters::number_of_threads(options.threads)
                      .implicitness(run.scene.implicitness)
                      .interface_tolerance(run.scene.interface_tolerance)
                      .adaptation_interval(unsigned(run.scene.adaptation_interval));
  try {
    const Interruptible scope(true);
    while (fluid.time() < end && (options.steps == 0 || done < options.steps) && !interrupted()) {
      const Fluid::Report report = fluid.advance(next_step(run, end), np); // whole or not at all
      ++done;
      steps.push_back(step_json(fluid, run.scene, first + done, report));
      repetitions.add(report);
      if (fluid.volumes().empty())
        throw std::runtime_error("no liquid is left after the step " +
                                 std::to_string(first + done) +
                                 ": edges may be too long for it, or steps");
      progress.show(unsigned(parts * (fluid.time() - start_time) / (end - start_time)));
      if ((first + done) % options.every == 0)
        write_files();
    }
  } catch (const CGAL::Deformable_simplicial_complexes::Interrupted_error&) {
  } catch (const CGAL::Deformable_simplicial_complexes::Fluid_step_error& error) {
    progress.clear();
    write_files();
    write_report();
    throw std::runtime_error(std::string(error.what()) + "; the step before is kept in " +
                             checkpoint("dsc_failed"));
  } catch (...) {
    progress.clear();
    write_files();
    write_report();
    throw;
  }
  progress.clear();
  write_files();
  write_report();
  if (!options.picture.empty())
    run.complex->write(options.picture);
  if (interrupted()) {
    std::cerr << "dsc: interrupted after step " << first + done
              << "; continue with dsc fluid --resume " << checkpoint("dsc_interrupted") << '\n';
  }
  if (!options.quiet)
    print_summary(run, done, repetitions, seconds_since(begin));
  return interrupted() ? exit_code_of_interrupt : 0;
}

} // namespace dsc
