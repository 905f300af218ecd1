// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_SOURCES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_SOURCES_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/fluid_vectors.h>
#include <CGAL/Mesh_support/Error.h>

#include <functional>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The sources of a fluid.
struct Fluid_sources
{
  // A region whose liquid gains a given volume in a unit of time.
  struct Flux
  {
    std::function<bool(const Eigen::Vector3d&)> is_in;
    std::function<double(double)> at; // by time
  };

  std::function<double(const Eigen::Vector3d&, double)> divergence; // can be empty
  std::vector<Flux> fluxes;
};

// Returns the volume that each cell of a mesh gains in a unit of time. The result is empty without
// sources.
// \throws Error if a divergence is not finite, or too large for a step of length dt
template <class Mesh>
std::vector<double> gains_of_cells(const Fluid_sources& sources, const Mesh& mesh,
                                   const Vectors_3& positions, double time, double dt) {
  const std::size_t n = mesh.cells.size();
  if (!sources.divergence && sources.fluxes.empty())
    return {};
  std::vector<double> divergences(n, 0), volumes;
  Vectors_3 middles;
  for (std::size_t k = 0; k < n; ++k) {
    volumes.push_back(volume(mesh.corners_at(mesh.cells[k].vertices, positions)));
    middles.push_back(mesh.barycenter(k, positions));
    if (sources.divergence)
      divergences[k] = sources.divergence(middles[k], time);
  }
  for (const auto& flux : sources.fluxes) {
    std::vector<std::size_t> inside;
    double whole = 0;
    for (std::size_t k = 0; k < n; ++k)
      if (flux.is_in(middles[k])) {
        inside.push_back(k);
        whole += volumes[k];
      }
    const double total = flux.at(time);
    for (std::size_t k : inside)
      divergences[k] += total / whole;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (!(std::abs(divergences[k]) * dt < 1))
      throw Error("the divergence of a source is not finite, or the absolute value of its product "
                  "with the time step is 1 or more: use a shorter time step or a larger source");
    divergences[k] *= volumes[k];
  }
  return divergences;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_SOURCES_H
