// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SET_TENSIONS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SET_TENSIONS_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Sets the surface tensions of facets for a field, which is given by vertex of the mesh. The
// tension of a facet is the tension at the mean of its vertices. Functions of users determine
// tensions.
// \throws Error if a tension is negative or not finite
template <class Complex>
void set_tensions(Fluid_mesh<Complex>& mesh, const Fluid_properties& properties,
                  const std::vector<double>& field) {
  for (auto& facet : mesh.facets) {
    double mean = 0;
    for (auto v : facet.vertices)
      mean += field[v] / Complex::dimension;
    facet.tension = properties.surface_tension(facet.label_behind, facet.label_in_front, mean);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_SET_TENSIONS_H
