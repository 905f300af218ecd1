// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MEAN_CURVATURE_FLOW_3_H
#define CGAL_MEAN_CURVATURE_FLOW_3_H

#include <CGAL/Deformable_simplicial_complexes/Mean_curvature_flow.h>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Mean curvature flow, step by explicit step.
using Mean_curvature_velocity_3 = Deformable_simplicial_complexes::Mean_curvature_velocity;

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Mean curvature flow, semi-implicitly.
using Mean_curvature_flow_3 = Deformable_simplicial_complexes::Mean_curvature_flow;

} // namespace CGAL

#endif // CGAL_MEAN_CURVATURE_FLOW_3_H
