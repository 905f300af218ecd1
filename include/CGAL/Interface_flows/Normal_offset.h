// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H
#define CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/Corner_rule.h>
#include <CGAL/Interface_flows/internal/corners/Opened_corners_2.h>
#include <CGAL/Interface_flows/internal/corners/Opened_corners_3.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The planes of the facets at a vertex (in the plane, the lines), which move along their normals at
// unit speed.
template <class Vector, int d> class Moving_planes
{
public:
  // \param into_facet a vector from the vertex into the facet
  void add(const Vector& unit_normal, double weight, const Vector& into_facet) {
    static constexpr double same = 1e-8; // squared distance of the normals of coplanar facets
    m_sum = m_sum + weight * unit_normal;
    m_into_facets = m_into_facets + weight / std::sqrt(into_facet.squared_length()) * into_facet;
    const auto end = m_normals.begin() + m_number;
    const bool is_coplanar = std::any_of(m_normals.begin(), end, [&](const Vector& n) {
      return (n - unit_normal).squared_length() < same;
    });
    m_has_face = m_has_face || is_coplanar;
    if (is_coplanar)
      return;
    m_is_polyhedral = m_is_polyhedral && m_number < most;
    if (m_is_polyhedral)
      m_normals[m_number++] = unit_normal;
  }

  // Returns the velocity of the common point of the planes where few planes meet, or of the point
  // with the least sum of squared distances from faces without a common point, as at the corners
  // and edges of a polyhedron. Its length is at most `limit` if the planes move away from the
  // facets. Otherwise, returns the mean normal, or 0 if the normals cancel each other.
  Vector velocity(double limit) const {
    static constexpr double common = .01; // distance of a plane from a common point
    // Largest speed at a vertex without coplanar facets. At the corner of a cube, it is 1.73. A
    // sharper vertex belongs to a rough surface.
    static constexpr double sharpest = d == 3 ? 2 : std::numeric_limits<double>::infinity();
    const double length = std::sqrt(m_sum.squared_length());
    if (!(length > 0))
      return Vector(NULL_VECTOR);
    const Vector mean = m_sum / length;
    if (!m_is_polyhedral)
      return mean;
    Matrix matrix = Matrix::Zero();
    Column sum = Column::Zero();
    for (int k = 0; k < m_number; ++k) {
      Column n;
      for (int i = 0; i < d; ++i)
        n(i) = m_normals[k][i];
      matrix += n * n.transpose();
      sum += n;
    }
    // the solution of least length
    const Column solution = matrix.completeOrthogonalDecomposition().solve(sum);
    Vector v(NULL_VECTOR);
    if constexpr (d == 3)
      v = Vector(solution(0), solution(1), solution(2));
    else
      v = Vector(solution(0), solution(1));
    const double speed = std::sqrt(v.squared_length());
    const bool have_common_point =
        std::all_of(m_normals.begin(), m_normals.begin() + m_number,
                    [&](const Vector& n) { return std::abs(v * n - 1) <= common; });
    if (!m_has_face && (!have_common_point || speed > sharpest))
      return mean;
    static constexpr double inner_limit = 20; // where planes meet at 6 degrees
    const double bound = v * m_into_facets < 0 ? limit : inner_limit;
    return speed > bound ? bound / speed * v : v;
  }

private:
  using Matrix = Eigen::Matrix<double, d, d>;
  using Column = Eigen::Matrix<double, d, 1>;

  static constexpr int most = 4; // planes at a vertex of a polyhedron; on curved surfaces, there
                                 // are about six facets

  std::array<Vector, most> m_normals;
  int m_number = 0;
  bool m_is_polyhedral = true;
  bool m_has_face = false; // whether facets are coplanar
  Vector m_sum = Vector(NULL_VECTOR), m_into_facets = Vector(NULL_VECTOR);
};

// Returns the angle of a triangle at a corner. `double_area` is twice the area of the triangle.
template <class Point>
double angle_at_corner(const std::array<Point, 3>& p, int i, double double_area) {
  return std::atan2(double_area, (p[(i + 1) % 3] - p[i]) * (p[(i + 2) % 3] - p[i]));
}
// Returns the weight of a segment at an end, the same for all segments.
template <class Point> double angle_at_corner(const std::array<Point, 2>&, int, double) {
  return 1;
}

template <class Complex>
using Opened_corners = std::conditional_t<Complex::dimension == 3, Opened_corners_3<Complex>,
                                          Opened_corners_2<Complex>>;

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

A motion along the normals of the interface. Labeled phases grow into the outside, label 0. With a
negative speed they shrink. Vertices without a facet that faces label 0 stay.

Where at most four planes meet, as at the edges and corners of a polyhedron, the planes move along
their normals, and the vertex moves to their common point. Flat faces thus stay flat, and edges and
corners stay sharp (a mitered offset). If flat faces of several facets have no common point, the
vertex moves to the point with the least sum of squared distances from their planes. Where more
planes meet, as on a curved surface, the vertex moves along the mean normal with the speed of the
offset. The mean is weighted by the angles of the facets at the vertex.

If a vertex from which the front moves away would be faster than `miter_limit` times the speed, it
has this velocity in space. A vertex towards which the front moves is at most 20 times as fast as
the front. In the plane, a segment at a right angle to the mean normal cuts off
such a corner.

Corners and edges from which the front moves away can also become round (Huygens' principle). In the
plane, each step then inserts vertices at corners of more than 18 degrees and moves them to the
tangents of an arc around the corner. In space, it inserts rows of vertices beside edges of more
than 60 degrees, which become parts of cylinders, and vertices of the interface become parts of
spheres, unless an edge there is concave or ends. The segments of an arc, and the rows, are about a
hundredth of the mean edge wide or wider, so corners become round at once, unless their sides are
shorter. Corners and edges towards which the front moves stay sharp.

In the plane, `advect_interface()` collapses edges of the interface that become very short, if this
moves only a small volume, see `keeps_volumes()`. So a corner removes the vertices of the segments
that it passes.

\cgalModels{InterfaceVelocity}
*/
struct Normal_offset
{
  double speed; ///< length per unit of time, in the coordinates of the complex
  /// the front at corners from which it moves away
  Corner_rule corners = Corner_rule::miter;
  /// largest ratio of the velocity of a vertex from which the front moves away and the speed, at
  /// least 1
  double miter_limit = 4;

  /// Computes the velocities of all vertices at the given positions, see `InterfaceVelocity`. The
  /// time is linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Point>& positions, double /*t*/,
                  std::vector<typename Complex::Vector>& velocities) const;

  /// Inserts vertices at corners and edges that are opened in a step of the length `dt`.
  /// `advect_interface()` calls this function before the step.
  template <class Complex>
  internal::Opened_corners<Complex>
  open_corners(Complex& dsc, const Interface_snapshot<Complex>& interface_, double dt,
               Deformation_visitor<Complex>& visitor) const;
};

template <class Complex>
void Normal_offset::operator()(const Interface_snapshot<Complex>& interface_,
                               const std::vector<typename Complex::Point>& positions, double /*t*/,
                               std::vector<typename Complex::Vector>& velocities) const {
  using Vector = typename Complex::Vector;
  std::vector<internal::Moving_planes<Vector, Complex::dimension>> planes(positions.size());
  for (const auto& facet : interface_.facets()) {
    if (facet.in_front != 0 && facet.behind != 0)
      continue;
    const auto p = interface_.corners(facet, positions);
    Vector normal = Complex::Space::facet_normal(p);
    const double length = Complex::Space::length(normal);
    if (!(length > 0))
      continue;
    normal = normal / (facet.in_front == 0 ? length : -length);
    for (int i = 0; i < Complex::dimension; ++i) {
      Vector into_facet(NULL_VECTOR);
      for (const auto& corner : p)
        into_facet = into_facet + (corner - p[i]);
      planes[facet.vertices[i]].add(normal, internal::angle_at_corner(p, i, length),
                                    speed < 0 ? -into_facet : into_facet);
    }
  }
  velocities.clear();
  for (const auto& p : planes)
    velocities.push_back(speed * p.velocity(miter_limit));
}

template <class Complex>
internal::Opened_corners<Complex>
Normal_offset::open_corners(Complex& dsc, const Interface_snapshot<Complex>& interface_, double dt,
                            Deformation_visitor<Complex>& visitor) const {
  // The area between an arc and tangents of this angle is less than 1 % of the sector.
  static constexpr double finest = 18 * CGAL_PI / 180;
  const bool are_round = corners == Corner_rule::round;
  if constexpr (Complex::dimension == 3)
    return internal::Opened_corners_3<Complex>(dsc, are_round ? speed : 0, dt, finest, visitor);
  else if (are_round)
    return internal::Opened_corners_2<Complex>(dsc, interface_, speed, dt, finest, finest, visitor);
  else // two vertices, at right angles to the mean normal
    return internal::Opened_corners_2<Complex>(
        dsc, interface_, speed, dt, 2 * std::acos(1 / miter_limit), CGAL_PI / 2, visitor);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H
