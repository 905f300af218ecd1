// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_LIQUID_FLOW_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_LIQUID_FLOW_H

#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The mesh of the liquids, and the positions and the motion of its vertices.
template <class Complex> struct Liquid_flow
{
  Fluid_mesh<Complex> mesh;
  Vectors_3 positions, velocities, accelerations;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_MESH_LIQUID_FLOW_H
