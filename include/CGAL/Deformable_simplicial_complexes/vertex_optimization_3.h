// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_OPTIMIZATION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_OPTIMIZATION_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/internal/interface/interface_directions_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Star_optimizer.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to move a vertex to a local maximum of the worst quality of its star (optimization-based
smoothing, section 3.2.1 of the paper; Freitag, Jones and Plassmann 1995). This is an order of
magnitude more expensive than `propose_smart_laplacian()`. Linear in the star.

\param complex the complex; it is not changed
\param v a vertex that is not on the boundary of the domain. If the interface around it is flat, it
       stays in the plane. If the facets around it have a line in common, such as a straight edge
       between two planes or a straight triple line, it stays on the line. Other vertices of the
       interface do not move.
\param star the star of v
\param target the proposed position
\return whether there is a proposal; commit with `complex.set_point(v, star, target)`. The interface
        moves by less than a ten-millionth of the displacement of the vertex, which is the tolerance
        of flatness.
*/
template <class Complex>
bool propose_optimal_position(const Complex& complex, typename Complex::Vertex_handle v,
                              const std::vector<typename Complex::Cell_handle>& star,
                              typename Complex::Point_3& target) {
  std::vector<typename Complex::Approximate_vector_3> blocked;
  if (complex.is_boundary(v) ||
      (v->is_interface() && !internal::find_blocked_directions(complex, star, v, blocked)))
    return false;
  const auto from = complex.position(v);
  internal::Star_optimizer<Complex> optimizer(complex, complex.quality_measure(), v, star);
  for (const auto& direction : blocked)
    optimizer.block(direction);
  const auto to = optimizer.run();
  if (to == from)
    return false;
  target = complex.geom_traits().construct_exact_point_3_object()(to);
  return complex.is_positive_star(v, star, target);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_OPTIMIZATION_3_H
