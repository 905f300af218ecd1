// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVE_SHORTENING_FLOW_2_H
#define CGAL_CURVE_SHORTENING_FLOW_2_H

#include <CGAL/Deformable_simplicial_complexes/Mean_curvature_flow.h>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Curve shortening flow, step by explicit step: as in space, the velocity is the curvature, so that
/// times are squares of lengths. See `Deformable_simplicial_complexes::Mean_curvature_velocity`.
using Curve_shortening_velocity_2 = Deformable_simplicial_complexes::Mean_curvature_velocity;

/// \ingroup PkgDeformableSimplicialComplex3Ref
/// Curve shortening flow, semi-implicitly, with areas kept if wanted. See
/// `Deformable_simplicial_complexes::Mean_curvature_flow`.
using Curve_shortening_flow_2 = Deformable_simplicial_complexes::Mean_curvature_flow;

} // namespace CGAL

#endif // CGAL_CURVE_SHORTENING_FLOW_2_H
