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

/// Reads a checkpoint that `read_grains()` accepts into a complex, and returns its state.
template <class Complex> Grain_state restore_grains(const std::string& path, Complex& complex) {
  const auto checkpoint = CGAL::IO::read_checkpoint<Complex::dimension>(path);
  const Json json = Json::parse(checkpoint.metadata);
  complex.restore(checkpoint.state);
  Grain_state result;
  result.time = json.at("time");
  result.step = json.at("step");
  result.energy_before = json.at("energy_before");
  return result;
}

} // namespace dsc

#endif // DSC_GRAIN_CHECKPOINT_H
