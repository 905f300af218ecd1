// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_run.h"

#include "errors.h"
#include "grain_checkpoint.h"

#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint_2.h>

namespace dsc {

void read_grains(const std::string& checkpoint, Grain_run& run) {
  run.dimension = CGAL::IO::checkpoint_dimension(checkpoint);
  const std::string metadata = run.dimension == 2 ? read_checkpoint_of<2>(checkpoint).metadata
                                                  : read_checkpoint_of<3>(checkpoint).metadata;
  try {
    const Json saved = Json::parse(metadata), json = saved.at("grains");
    if (!saved.at("time").is_number() || !saved.at("step").is_number_unsigned())
      throw Input_error(checkpoint + " is damaged; give another checkpoint of dsc grains");
    run.is_periodic = json.at("domain") == "torus";
    run.number = json.at("number");
    run.energy = energy_of_json(json.at("energy"));
    run.particles = json.at("particles");
    run.particle_radius = json.at("particle_radius");
    run.edges = json.at("edges");
    run.step = json.at("step");
    run.seed = json.at("seed");
  } catch (const Json::exception&) {
    throw Input_error(checkpoint + " contains a complex, but no grains to resume; give a "
                                   "checkpoint of dsc grains");
  }
}

Json to_json(const Grain_run& run) {
  return {{"dimension", run.dimension},
          {"domain", run.is_periodic ? "torus" : "box"},
          {"number", run.number},
          {"energy", to_json(run.energy)},
          {"particles", run.particles},
          {"particle_radius", run.particle_radius},
          {"edges", run.edges},
          {"step", run.step},
          {"seed", run.seed}};
}

Grain_result grow_grains(const Grain_run& run, const std::function<void(const Grain_state&)>& on) {
  return (run.dimension == 2 ? grow_grains_2 : grow_grains_3)(run, on);
}

} // namespace dsc
