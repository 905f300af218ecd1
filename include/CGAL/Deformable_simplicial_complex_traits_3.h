// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exact predicates and floating-point measures of a deformable simplicial complex in space, on any
CGAL kernel. All decisions are exact if the kernel's predicates are exact. The measures (volume,
length, quality) are computed with points of `CGAL::Simple_cartesian<double>`.

A complex stores only points whose coordinates are doubles. For these points, the conversions
between the two types of points are exact. Lazy numbers need this restriction: if a lazy number is
not a double, its `to_double()` depends on how far the number has been evaluated.

\tparam Kernel_ a CGAL kernel with exact predicates.

\cgalModels `DeformableSimplicialComplexTraits_3`
*/
template <class Kernel_ = Exact_predicates_inexact_constructions_kernel>
class Deformable_simplicial_complex_traits_3 : public Kernel_
{
public:
  using Kernel = Kernel_;                   ///< the kernel of the predicates
  using Point_3 = typename Kernel::Point_3; ///< the type of point used by predicates

  using Approximate_kernel = Simple_cartesian<double>;       ///< the kernel of the measures
  using Approximate_point_3 = Approximate_kernel::Point_3;   ///< the type of point used by measures
  using Approximate_vector_3 = Approximate_kernel::Vector_3; ///< differences of these points

  /// Function object that returns a nearby point with double coordinates.
  struct Construct_approximate_point_3
  {
    /// Returns p with coordinates converted by `to_double()`; coordinates that are doubles stay the
    /// same.
    Approximate_point_3 operator()(const Point_3& p) const {
      return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
    }
  };

  /// Function object that returns the exact point with given double coordinates.
  struct Construct_exact_point_3
  {
    /// Returns the point with the same coordinates as p.
    Point_3 operator()(const Approximate_point_3& p) const { return Point_3(p.x(), p.y(), p.z()); }
  };

  /// Function object that computes the signed volume of a tetrahedron. Up to rounding, the volume
  /// is positive if and only if the vertices are positively oriented.
  struct Compute_approximate_volume_3
  {
    /// Returns the signed volume of pqrs.
    double operator()(const Approximate_point_3& p, const Approximate_point_3& q,
                      const Approximate_point_3& r, const Approximate_point_3& s) const {
      return cross_product(q - p, r - p) * (s - p) / 6;
    }
  };

  /// Returns a function object.
  Construct_approximate_point_3 construct_approximate_point_3_object() const { return {}; }
  /// Returns a function object.
  Construct_exact_point_3 construct_exact_point_3_object() const { return {}; }
  /// Returns a function object.
  Compute_approximate_volume_3 compute_approximate_volume_3_object() const { return {}; }
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H
