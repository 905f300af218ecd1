// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exact predicates and floating-point measures of a deformable simplicial complex in the plane. The
class `Deformable_simplicial_complex_traits_3` is the counterpart in space.

\tparam Kernel_ a CGAL kernel with exact predicates.

\cgalModels `DeformableSimplicialComplexTraits_2`
*/
template <class Kernel_ = Exact_predicates_inexact_constructions_kernel>
class Deformable_simplicial_complex_traits_2 : public Kernel_
{
public:
  using Kernel = Kernel_;                   ///< the kernel of the predicates
  using Point_2 = typename Kernel::Point_2; ///< the type of point used by predicates

  using Approximate_kernel = Simple_cartesian<double>;       ///< the kernel of the measures
  using Approximate_point_2 = Approximate_kernel::Point_2;   ///< the type of point used by measures
  using Approximate_vector_2 = Approximate_kernel::Vector_2; ///< differences of these points

  /// Function object that returns the nearest point with double coordinates.
  struct Construct_approximate_point_2
  {
    /// Returns p with coordinates converted by `to_double()`.
    Approximate_point_2 operator()(const Point_2& p) const {
      return {to_double(p.x()), to_double(p.y())};
    }
  };

  /// Function object that returns the exact point with given double coordinates.
  struct Construct_exact_point_2
  {
    /// Returns the point with the same coordinates as p.
    Point_2 operator()(const Approximate_point_2& p) const { return Point_2(p.x(), p.y()); }
  };

  /// Function object that computes the signed area of a triangle. Up to rounding, the area is
  /// positive if and only if the vertices are in counterclockwise order.
  struct Compute_approximate_area_2
  {
    /// Returns the signed area of pqr.
    double operator()(const Approximate_point_2& p, const Approximate_point_2& q,
                      const Approximate_point_2& r) const {
      return determinant(q - p, r - p) / 2;
    }
  };

  /// Returns a function object.
  Construct_approximate_point_2 construct_approximate_point_2_object() const { return {}; }
  /// Returns a function object.
  Construct_exact_point_2 construct_exact_point_2_object() const { return {}; }
  /// Returns a function object.
  Compute_approximate_area_2 compute_approximate_area_2_object() const { return {}; }
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_2_H
