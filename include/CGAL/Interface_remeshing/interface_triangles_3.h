// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERFACE_TRIANGLES_3_H
#define CGAL_INTERFACE_REMESHING_INTERFACE_TRIANGLES_3_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>

#include <tuple>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the corners of a triangle of a snapshot as seen from the first corner: on a torus, the
nearest images. Constant time.

\param triangle a triangle of the snapshot
\param domain the domain of the snapshot
\param positions of the vertices, in the order of the snapshot
*/
template <class Triangle, class Domain, class Point>
std::array<Point, 3> corners(const Triangle& triangle, const Domain& domain,
                             const std::vector<Point>& positions) {
  const Point& p = positions[triangle.vertices[0]];
  return {p, domain.nearest_image(p, positions[triangle.vertices[1]]),
          domain.nearest_image(p, positions[triangle.vertices[2]])};
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the sign of the motion of a triangle along its normal when phases grow into the outside,
which has label 0.

\return 1 if label 0 is in front, -1 if label 0 is behind, and 0 if neither label is 0
*/
template <class Triangle> double sign_of_growth(const Triangle& triangle) {
  return triangle.in_front == 0 ? 1 : triangle.behind == 0 ? -1 : 0;
}

/*!
\ingroup PkgInterfaceRemeshingRef

A triangle of a snapshot with its normal and its angles.

\tparam Vector a vector in space
*/
template <class Vector> struct Weighted_triangle
{
  std::size_t index;            ///< index of the triangle in the snapshot
  Vector unit_normal;           ///< normal towards the front, of length 1
  std::array<double, 3> angles; ///< angles at the corners, in radians; as weights, they do not
                                ///< depend on the triangulation of a flat face
};

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the triangles of a snapshot that have a positive area, in its order. Linear in the size of
the interface.

\tparam Complex a deformable simplicial complex in space
\param interface_ the snapshot
\param positions of the vertices, in the order of the snapshot
*/
template <class Complex>
std::vector<Weighted_triangle<typename Complex::Vector_3>>
weighted_triangles(const Interface_snapshot<Complex>& interface_,
                   const std::vector<typename Complex::Point_3>& positions) {
  std::vector<Weighted_triangle<typename Complex::Vector_3>> result;
  for (std::size_t i = 0; i < interface_.facets().size(); ++i) {
    const auto p = corners(interface_.facets()[i], interface_.domain, positions);
    const auto normal = internal::area_vector(p);
    const double area = std::sqrt(normal.squared_length());
    const auto angle = [&](int j) {
      return std::atan2(2 * area, (p[(j + 1) % 3] - p[j]) * (p[(j + 2) % 3] - p[j]));
    };
    if (area > 0)
      result.push_back({i, normal / area, {angle(0), angle(1), angle(2)}});
  }
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the normals of the vertices of a snapshot: the means of the normals of the incident
triangles, weighted by the angles. Each normal points from the larger label to the smaller label.
Its length is 1, or 0 where normals cancel each other. Linear in the size of the interface.

\tparam Complex a deformable simplicial complex in space
\param interface_ the snapshot
\param positions of the vertices, in the order of the snapshot
\return the normals, in the order of the snapshot
*/
template <class Complex>
std::vector<typename Complex::Vector_3>
vertex_normals(const Interface_snapshot<Complex>& interface_,
               const std::vector<typename Complex::Point_3>& positions) {
  using Vector = typename Complex::Vector_3;
  std::vector<Vector> result(positions.size(), Vector(0, 0, 0));
  for (const auto& triangle : weighted_triangles(interface_, positions))
    for (int i = 0; i < 3; ++i) {
      Vector& normal = result[interface_.facets()[triangle.index].vertices[i]];
      normal = normal + triangle.angles[i] * triangle.unit_normal;
    }
  static constexpr double rounding = 1e-9; // of sums of angles
  for (Vector& normal : result) {
    const double length = std::sqrt(normal.squared_length());
    normal = length > rounding ? normal / length : Vector(0, 0, 0);
  }
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns for each vertex of a snapshot whether it is the end of a sharp edge, where the normals of
two triangles differ by more than an angle. If more than two triangles share an edge, only triangles
that follow each other in the snapshot are compared there. n log n in the size of the interface.

\tparam Complex a deformable simplicial complex in space
\param interface_ the snapshot
\param positions of the vertices, in the order of the snapshot
\param angle the angle, in radians
\return 1 or 0 for each vertex, in the order of the snapshot
*/
template <class Complex>
std::vector<char> vertices_on_features(const Interface_snapshot<Complex>& interface_,
                                       const std::vector<typename Complex::Point_3>& positions,
                                       double angle) {
  struct Side
  {
    std::array<std::size_t, 2> edge;
    std::size_t triangle;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < interface_.facets().size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto& v = interface_.facets()[t].vertices;
      const auto [a, b] = std::minmax(v[i], v[(i + 1) % 3]);
      sides.push_back({{a, b}, t});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tie(s.edge, s.triangle) < std::tie(t.edge, t.triangle);
  });
  const auto normal = [&](const Side& side) {
    return internal::area_vector(
        corners(interface_.facets()[side.triangle], interface_.domain, positions));
  };
  std::vector<char> result(positions.size(), false);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i - 1].edge == sides[i].edge &&
        internal::angle_between(normal(sides[i - 1]), normal(sides[i])) > angle)
      for (std::size_t v : sides[i].edge)
        result[v] = true;
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_INTERFACE_TRIANGLES_3_H
