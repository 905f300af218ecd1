// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Grain_run.h"

#include "programs/errors.h"

#include <CGAL/Mesh_files/checkpoint.h>

namespace dsc {

namespace {

/// Reads the grains of a checkpoint. Returns whether all values are in their ranges.
bool read(const Json& json, Grain_run& run) {
  static constexpr std::size_t most = 1000000;
  for (const char* name : {"number", "particles", "seed"})
    if (!json.at(name).is_number_unsigned())
      return false;
  run.number = json.at("number");
  run.particles = json.at("particles");
  run.seed = json.at("seed");
  run.particle_radius = json.at("particle_radius");
  run.edges = json.at("edges");
  run.step = json.at("step");
  run.energy = energy_of_json(json.at("energy"));
  run.is_periodic = json.at("domain") == "torus";
  return json.at("dimension") == run.dimension && (run.is_periodic || json.at("domain") == "box") &&
         run.number > 0 && run.number <= most && run.particles <= most && run.edges > 0 &&
         run.step > 0 && run.particle_radius > 0 &&
         json.at("seed") <= (std::numeric_limits<std::uint32_t>::max)();
}

} // namespace

void read_grains(const std::string& checkpoint, Grain_run& run) {
  run.dimension = CGAL::IO::checkpoint_dimension(checkpoint);
  const std::string metadata = run.dimension == 2
                                   ? CGAL::IO::read_checkpoint<2>(checkpoint).metadata
                                   : CGAL::IO::read_checkpoint<3>(checkpoint).metadata;
  try {
    const Json saved = Json::parse(metadata);
    if (read(saved.at("grains"), run) && saved.at("step").is_number_unsigned() &&
        saved.at("time").is_number() && saved.at("energy_before").is_number())
      return;
  } catch (const Json::exception&) {
  }
  throw Input_error(checkpoint + " contains no grains that can be resumed; give a checkpoint of "
                                 "dsc grains");
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
