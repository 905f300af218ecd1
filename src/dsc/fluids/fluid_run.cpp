// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_run.h"

#include "fluids/fluid_processes.h"
#include "fluids/fluid_start.h"
#include "motions/run_position.h"
#include "output/report_json.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc {
namespace {

namespace parameters = CGAL::parameters;

/// Calls f(name, value, is_required) for each field of a state. Earlier checkpoints lack the
/// others.
template <class State, class Function> void for_each_field(State& state, const Function& f) {
  f("time", state.time, true);
  f("steps", state.steps, true);
  f("damped_steps", state.damped_steps, true);
  f("knows_accelerations", state.knows_accelerations, true);
  f("motion", state.motion, true);
  f("deviations", state.deviations, false);
  f("volumes", state.volumes, true);
  f("pressures_and_volumes_of_gases", state.gases, true);
  f("bodies", state.bodies, false);
  f("field", state.field, false);
}

Json state_json(const DSC::Fluid_state& state) {
  Json result;
  for_each_field(state, [&](const char* name, const auto& value, bool) { result[name] = value; });
  return result;
}

DSC::Fluid_state state_of(const Json& json) {
  DSC::Fluid_state result;
  for_each_field(result, [&](const char* name, auto& value, bool is_required) {
    if (is_required || json.contains(name))
      value = json.at(name).get<std::decay_t<decltype(value)>>();
  });
  return result;
}

} // namespace

template <int dimension>
Fluid_run<dimension> start_fluid(const Fluid_scene& scene, const std::string& folder,
                                 unsigned threads, bool quiet, bool uses_petsc) {
  using Run = Fluid_run<dimension>;
  require_files(scene, folder);
  Run run;
  run.scene = scene;
  read_meshes(folder, run.scene);
  run.complex = std::make_unique<typename Run::Tracked>(
      start_of_scene<typename Run::Complex>(run.scene, folder));
  run.complex->label_names = run.scene.names;
  require_effect(run.scene, run.complex->complex);
  run.fluid = fluid_of_scene(run.scene, run.complex->complex);
  require_outside_of_solids(run.scene, *run.fluid);
  if (uses_petsc)
    use_petsc(run.fluid->solver());
  if (run.scene.relaxation_steps > 0) {
    const double velocity =
        run.fluid->relax(run.scene.relaxation_step, unsigned(run.scene.relaxation_steps),
                         parameters::number_of_threads(threads));
    if (!quiet)
      std::printf("dsc: the relaxation ended with the largest velocity %.3g\n", velocity);
  }
  set_velocities(run.scene, *run.fluid);
  return run;
}

template <int dimension>
Fluid_run<dimension> resume_fluid(const std::string& path, const std::string& folder,
                                  bool uses_petsc) {
  using Run = Fluid_run<dimension>;
  const auto checkpoint = CGAL::IO::read_checkpoint<dimension>(path);
  Run run;
  try {
    const Json json = Json::parse(checkpoint.metadata);
    run.scene = read_scene(json.at("scene"));
    if (run.scene.dimension != dimension)
      throw Input_error(path + " contains a complex and a scene of different dimensions; write a "
                               "checkpoint again");
    read_meshes(folder, run.scene);
    run.complex = std::make_unique<typename Run::Tracked>();
    run.complex->complex.restore(checkpoint.state);
    run.complex->label_names = run.scene.names;
    run.fluid = fluid_of_scene(run.scene, run.complex->complex);
    run.fluid->restore(state_of(json.at("fluid")));
    set_time(run.scene, run.fluid->time(), *run.fluid);
    if (uses_petsc)
      use_petsc(run.fluid->solver());
  } catch (const Json::exception&) {
    throw Input_error(path + " contains a complex, but no fluid to resume; give a checkpoint of "
                             "dsc fluid");
  }
  return run;
}

template <int dimension> double Fluid_run<dimension>::next_step(double end) const {
  const double left = end - fluid->time();
  double dt = scene.time_step;
  if (scene.cfl > 0)
    dt = (std::min)(dt, fluid->largest_step(scene.cfl));
  // Avoids a tiny last step.
  static constexpr double almost = 1e-9;
  return dt * (1 + almost) >= left ? left : dt * 2 <= left ? dt : left / 2;
}

template <int dimension> std::string Fluid_run<dimension>::metadata() const {
  Json result = {{"scene", scene.json}, {"fluid", state_json(fluid->state())}};
  if (!scene.names.empty())
    result["labels"] = label_names_json(scene.names);
  return result.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template struct Fluid_run<2>;
template struct Fluid_run<3>;
template Fluid_run<2> start_fluid(const Fluid_scene&, const std::string&, unsigned, bool, bool);
template Fluid_run<3> start_fluid(const Fluid_scene&, const std::string&, unsigned, bool, bool);
template Fluid_run<2> resume_fluid(const std::string&, const std::string&, bool);
template Fluid_run<3> resume_fluid(const std::string&, const std::string&, bool);

} // namespace dsc
