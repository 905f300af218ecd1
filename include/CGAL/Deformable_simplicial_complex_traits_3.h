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
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Point where a ray leaves the star of its source, see
/// `DeformableSimplicialComplexTraits_3::Link_intersection_3`.
struct Star_exit_3
{
  std::size_t facet; ///< index of the link facet that the ray meets; the first one on a tie
  /// dimension of the link simplex that the ray meets: 2 for the interior of the facet, 1 for an
  /// edge, 0 for a vertex
  int dimension;
  double parameter; ///< t0 of `p + t0 (q - p)`; less than 1 iff the segment leaves the star
};

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

  /*!
  Function object that finds the facet of the link of a vertex through which a ray leaves the star.

  The star is given by its link facets. Each one is a triple (a, b, c) with (p, a, b, c) positively
  oriented. The star is star-shaped about p, so that exactly one link simplex meets the ray. Only
  orientation predicates decide which simplex it is, and its dimension. See section 3.1 of the paper
  and line 4 of its Algorithm 2.
  */
  class Link_intersection_3
  {
  public:
    /// Constructs the function object, with a copy of the traits.
    explicit Link_intersection_3(const Deformable_simplicial_complex_traits_3& traits)
        : m_traits(traits) {}

    /// Returns the link facet through which the ray from p to q leaves the star. Linear in the
    /// number of facets.
    /// \param p source of the ray, inside its star
    /// \param q another point, `q != p`
    /// \param facets range of `std::array<Point_3, 3>`. If p is on the boundary of the domain, its
    ///        finite link is open. The facet index is then `facets.size()` for a ray that points
    ///        outside.
    template <class Facets>
    Star_exit_3 operator()(const Point_3& p, const Point_3& q, const Facets& facets) const {
      const auto orientation = m_traits.orientation_3_object();
      std::size_t index = 0;
      for (const std::array<Point_3, 3>& f : facets) {
        // q lies in the cone over the facet iff q is on the negative side of none of the three
        // sides of the cone.
        const Orientation sides[3] = {orientation(p, f[0], f[1], q), orientation(p, f[1], f[2], q),
                                      orientation(p, f[2], f[0], q)};
        int dimension = 2;
        bool in_cone = true;
        for (Orientation side : sides) {
          in_cone = in_cone && side != NEGATIVE;
          dimension -= side == COPLANAR ? 1 : 0;
        }
        if (in_cone)
          return {index, dimension, parameter(p, q, f)};
        ++index;
      }
      return {index, 2, 0.};
    }

  private:
    double parameter(const Point_3& p, const Point_3& q, const std::array<Point_3, 3>& f) const {
      const auto approximate = m_traits.construct_approximate_point_3_object();
      const auto volume = m_traits.compute_approximate_volume_3_object();
      const Approximate_point_3 a = approximate(f[0]), b = approximate(f[1]), c = approximate(f[2]);
      const double at_p = volume(c, b, a, approximate(p)), at_q = volume(c, b, a, approximate(q));
      return at_p / (at_p - at_q);
    }

    Deformable_simplicial_complex_traits_3 m_traits;
  };

  /// Returns a function object.
  Construct_approximate_point_3 construct_approximate_point_3_object() const { return {}; }
  /// Returns a function object.
  Construct_exact_point_3 construct_exact_point_3_object() const { return {}; }
  /// Returns a function object.
  Compute_approximate_volume_3 compute_approximate_volume_3_object() const { return {}; }
  /// Returns a function object.
  Link_intersection_3 link_intersection_3_object() const { return Link_intersection_3(*this); }
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H
