// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_GRAIN_CHECKPOINT_H
#define DSC_GRAIN_CHECKPOINT_H

#include "Grain_run.h"

#include <CGAL/Mesh_files/checkpoint.h>

#include <string>

namespace dsc {

/// Writes a checkpoint of a run.
template <class Complex>
void write_grains(const std::string& path, const Grain_run& run, const Complex& complex,
                  const Grain_state& state) {
  CGAL::IO::write_checkpoint(path, complex.state(),
                             Json{{"grains", to_json(run)},
                                  {"time", state.time},
                                  {"step", state.step},
                                  {"energy_before", state.energy_before}}
                                 .dump());
}

/// The complex and the state of a checkpoint.
template <int d> struct Saved_grains
{
  CGAL::Deformable_simplicial_complexes::State<d> complex;
  Grain_state state;
};

/// Reads a checkpoint that `read_grains()` accepts.
template <int d> Saved_grains<d> read_saved_grains(const std::string& path) {
  const auto checkpoint = CGAL::IO::read_checkpoint<d>(path);
  const Json json = Json::parse(checkpoint.metadata);
  Saved_grains<d> result{checkpoint.state, {}};
  result.state.time = json.at("time");
  result.state.step = json.at("step");
  result.state.energy_before = json.at("energy_before");
  return result;
}

} // namespace dsc

#endif // DSC_GRAIN_CHECKPOINT_H
