// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/topology/Trapped_cells.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A function that returns the position to which the flow of the space moves a vertex.
template <class Complex>
using Space_motion =
    std::function<typename Complex::Approximate_point(typename Complex::Vertex_handle)>;

// Returns the flow as a function of vertices. The given flow is a function of points or of
// vertices.
template <class Complex, class Flow>
Space_motion<Complex> space_motion(const Complex& complex, const Flow& flow) {
  if constexpr (std::is_same<Flow, CGAL::internal_np::Param_not_found>::value)
    return {};
  else if constexpr (std::is_invocable<const Flow&, typename Complex::Approximate_point>::value)
    return
        [&complex, flow](typename Complex::Vertex_handle v) { return flow(complex.position(v)); };
  else
    return flow;
}

// The options of `deform_interface()`.
template <class Complex> struct Deformation_options
{
  double quality_threshold, relabeling_threshold;
  double minimum_angle, minimum_facet_angle; // degrees
  bool manifold_interface, collision_order;
  Topology_control<Complex> topology_control;
  Space_motion<Complex> flow; // the flow of the space around the interface; empty if not given
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_OPTIONS_H
