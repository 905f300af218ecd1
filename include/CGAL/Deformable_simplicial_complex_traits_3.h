// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>

namespace CGAL {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Where a ray leaves the star of its source, see
/// `DeformableSimplicialComplexTraits_3::Link_intersection_3`.
struct Star_exit_3
{
  std::size_t facet; ///< index of the link facet that the ray meets, the first one on a tie
  int dimension;     ///< 2: through the inside of the facet, 1: through an edge, 0: a vertex
  double parameter;  ///< t0 of `p + t0 (q - p)`: below 1 iff the segment leaves the star
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exact predicates and floating point measures of a deformable simplicial complex, on any CGAL kernel.
What decides is exact if the kernel's predicates are; what measures (volume, length, quality) is
computed on points of `CGAL::Simple_cartesian<double>`. A complex stores points with coordinates
that are doubles only, for which the conversions between the two kinds of points are exact. That
matters for lazy numbers: `to_double()` of one that is no double depends on how far it has been
evaluated.

\tparam Kernel_ a CGAL kernel with exact predicates.

\cgalModels `DeformableSimplicialComplexTraits_3`
*/
template <class Kernel_ = Exact_predicates_inexact_constructions_kernel>
class Deformable_simplicial_complex_traits_3 : public Kernel_
{
public:
  using Kernel = Kernel_;                   ///< the kernel whose predicates decide
  using Point_3 = typename Kernel::Point_3; ///< the points that predicates see

  using Approximate_kernel = Simple_cartesian<double>;       ///< the kernel that measures
  using Approximate_point_3 = Approximate_kernel::Point_3;   ///< the points that are measured
  using Approximate_vector_3 = Approximate_kernel::Vector_3; ///< the differences of those points

  /// A nearby point with double coordinates.
  struct Construct_approximate_point_3
  {
    /// returns p with coordinates converted by `to_double()`: the same ones if they are doubles.
    Approximate_point_3 operator()(const Point_3& p) const {
      return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
    }
  };

  /// The exact point that has these double coordinates.
  struct Construct_exact_point_3
  {
    /// returns p with the same coordinates.
    Point_3 operator()(const Approximate_point_3& p) const { return Point_3(p.x(), p.y(), p.z()); }
  };

  /// Signed volume of a tetrahedron, positive iff its vertices are positively oriented,
  /// up to rounding.
  struct Compute_approximate_volume_3
  {
    /// returns the signed volume of pqrs.
    double operator()(const Approximate_point_3& p, const Approximate_point_3& q,
                      const Approximate_point_3& r, const Approximate_point_3& s) const {
      return cross_product(q - p, r - p) * (s - p) / 6;
    }
  };

  /*!
  The facet of the link of a vertex through which a ray leaves the star.

  The star is given by its link facets, each a triple (a, b, c) with (p, a, b, c) positively
  oriented. It is star-shaped about p, so that exactly one link simplex meets the ray; which one,
  and of what dimension, is decided by orientations alone. See section 3.1 of the paper and line 4
  of its Algorithm 2.
  */
  class Link_intersection_3
  {
  public:
    /// constructs the function object, with a copy of the traits that it decides with.
    explicit Link_intersection_3(const Deformable_simplicial_complex_traits_3& traits)
        : m_traits(traits) {}

    /// \param p source of the ray, inside its star; \param q another point, `q != p`.
    /// \param facets range of `std::array<Point_3, 3>`. If p is on the boundary of the domain, its
    ///        finite link is open: the facet index is `facets.size()` for a ray that points
    ///        outside.
    /// Linear in the number of facets.
    template <class Facets>
    Star_exit_3 operator()(const Point_3& p, const Point_3& q, const Facets& facets) const {
      const auto orientation = m_traits.orientation_3_object();
      std::size_t index = 0;
      for (const std::array<Point_3, 3>& f : facets) {
        // q lies in the cone over the facet iff none of its three sides has q behind it.
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

  /// returns a function object.
  Construct_approximate_point_3 construct_approximate_point_3_object() const { return {}; }
  /// returns a function object.
  Construct_exact_point_3 construct_exact_point_3_object() const { return {}; }
  /// returns a function object.
  Compute_approximate_volume_3 compute_approximate_volume_3_object() const { return {}; }
  /// returns a function object.
  Link_intersection_3 link_intersection_3_object() const { return Link_intersection_3(*this); }
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_TRAITS_3_H
