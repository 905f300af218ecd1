// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of triangles: area divided by the mean squared edge length, times 4 / sqrt(3). It is
1 for the regular triangle, 0 for a degenerate one, and negative for an inverted one. It is
invariant under similarity transformations.
*/
struct Area_length_ratio_2
{
  /// Returns the quality of pqr.
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point> double operator()(const Point& p, const Point& q, const Point& r) const {
    const double squared =
        (q - p).squared_length() + (r - q).squared_length() + (p - r).squared_length();
    return squared == 0 ? 0 : 2 * std::sqrt(3.) * determinant(q - p, r - p) / squared;
  }
};

// Models of `TetrahedronQualityMeasure_3`: 1 for the regular tetrahedron, 0 for a degenerate one,
// negative for an inverted one, invariant under similarity transformations.

namespace internal {

// Tetrahedron given by the vectors from its first vertex, shared by the measures.
template <class Point> struct Tetrahedron_frame
{
  using Vector = decltype(Point() - Point());

  Tetrahedron_frame(const Point& p, const Point& q, const Point& r, const Point& s)
      : a(q - p), b(r - p), c(s - p), six_volumes(cross_product(a, b) * c) {}

  // Returns the area vectors of the facets opposite to p, q, r, s: outward normals whose length is
  // twice the area.
  std::array<Vector, 4> area_vectors() const {
    return {cross_product(b - a, c - a), cross_product(c, b), cross_product(a, c),
            cross_product(b, a)};
  }

  // Returns the mean squared length of the edges. The sum is written out, since the compiler keeps
  // an array of edges in memory, which takes twice as long.
  double mean_squared_edge() const {
    return (a.squared_length() + (c - b).squared_length() + b.squared_length() +
            (c - a).squared_length() + c.squared_length() + (b - a).squared_length()) /
           6;
  }

  Vector a, b, c;
  double six_volumes;
};

constexpr double sine_of_regular = 0.94280904158206337; // sine of its dihedral angles, sqrt(8) / 3

// Returns the smallest sine of a dihedral angle, divided by that of the regular tetrahedron. Sines
// of obtuse angles are multiplied by a weight. Coordinates are in separate arrays, so that loops
// over them are vectorized: mesh optimization spends much of its time in this function.
template <class Point>
double minimum_sine(const Point& p, const Point& q, const Point& r, const Point& s,
                    double obtuse_weight) {
  const Tetrahedron_frame<Point> t(p, q, r, s);
  const auto &a = t.a, &b = t.b, &c = t.c;
  const auto d = b - a, e = c - a, f = c - b;
  // Area vectors of the facets opposite to p, q, r, s: d x e, c x b, a x c, b x a.
  const double ux[] = {d.x(), c.x(), a.x(), b.x()}, uy[] = {d.y(), c.y(), a.y(), b.y()},
               uz[] = {d.z(), c.z(), a.z(), b.z()}, vx[] = {e.x(), b.x(), c.x(), a.x()},
               vy[] = {e.y(), b.y(), c.y(), a.y()}, vz[] = {e.z(), b.z(), c.z(), a.z()};
  double nx[4], ny[4], nz[4];
  for (int i = 0; i < 4; ++i) {
    nx[i] = uy[i] * vz[i] - uz[i] * vy[i];
    ny[i] = uz[i] * vx[i] - ux[i] * vz[i];
    nz[i] = ux[i] * vy[i] - uy[i] * vx[i];
  }
  // The edges pq, rs, pr, qs, ps, qr. `one` and `other` are the vertices opposite to the two facets
  // at each edge.
  const double x[] = {a.x(), f.x(), b.x(), e.x(), c.x(), d.x()},
               y[] = {a.y(), f.y(), b.y(), e.y(), c.y(), d.y()},
               z[] = {a.z(), f.z(), b.z(), e.z(), c.z(), d.z()};
  static constexpr int one[] = {2, 0, 1, 0, 1, 0}, other[] = {3, 1, 3, 2, 2, 3};
  double squared_edges[6];
  for (int i = 0; i < 6; ++i)
    squared_edges[i] = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
  // Lengths are in units of the longest edge to avoid overflow.
  double unit = 0;
  for (double squared : squared_edges)
    unit = (std::max)(unit, squared);
  if (unit == 0)
    return 0;
  const double per_unit = 1 / unit;
  double squared_areas[4];
  for (int i = 0; i < 4; ++i)
    squared_areas[i] = (nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]) * per_unit * per_unit;
  // Squares of sines divided by the square of six volumes, as fractions, since divisions are slow.
  const double squared_weight = obtuse_weight * obtuse_weight;
  double numerators[6], denominators[6];
  for (int i = 0; i < 6; ++i) {
    const int g = one[i], h = other[i];
    const double cosine = nx[g] * nx[h] + ny[g] * ny[h] + nz[g] * nz[h],
                 squared = squared_edges[i] * per_unit;
    numerators[i] = cosine > 0 ? squared_weight * squared : squared;
    denominators[i] = squared_areas[g] * squared_areas[h];
  }
  double numerator = 1, denominator = 0;
  for (int i = 0; i < 6; ++i) {
    const bool is_less = numerators[i] * denominator < numerator * denominators[i];
    numerator = is_less ? numerators[i] : numerator;
    denominator = is_less ? denominators[i] : denominator;
  }
  if (denominator == 0)
    return 0;
  return t.six_volumes * per_unit / std::sqrt(unit) * std::sqrt(numerator / denominator) /
         sine_of_regular;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of tetrahedra: volume divided by the cube of the root mean square edge length, times
6 sqrt(2) (section 3.2 of the paper, after \cgalCite{cgal:pgh-ctqm-94}). It penalizes slivers and
needles equally, and is smooth.

\cgalModels{TetrahedronQualityMeasure_3}
*/
struct Volume_length_ratio_3
{
  /// Returns the quality of pqrs; 0 if the points are all equal.
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    const internal::Tetrahedron_frame<Point> t(p, q, r, s);
    const double squared = t.mean_squared_edge();
    const double cube = squared * std::sqrt(squared);
    return cube == 0 ? 0 : std::sqrt(2.) * t.six_volumes / cube;
  }

  /// Returns the gradient of the quality with respect to the position of p. \pre the points are not
  /// all equal
  template <class Point>
  auto gradient(const Point& p, const Point& q, const Point& r, const Point& s) const {
    const internal::Tetrahedron_frame<Point> t(p, q, r, s);
    const double squared = t.mean_squared_edge();
    // Gradient of six volumes divided by the cube of the length, by the product rule.
    const auto of_six_volumes = cross_product(t.c - t.a, t.b - t.a);
    const auto of_squared = (t.a + t.b + t.c) / -3;
    return std::sqrt(2.) / (squared * std::sqrt(squared)) *
           (of_six_volumes - 1.5 * t.six_volumes / squared * of_squared);
  }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of tetrahedra: smallest sine of the six dihedral angles, divided by the sine for
the regular tetrahedron. It is low for small and for large angles, and does not depend on the
lengths of edges.

\cgalModels{TetrahedronQualityMeasure_3}
*/
struct Minimum_sine_3
{
  /// Returns the quality of pqrs. \pre the points are not all on a line
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return internal::minimum_sine(p, q, r, s, 1);
  }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of tetrahedra: as `Minimum_sine_3`, with sines of obtuse angles multiplied by 0.7
\cgalCite{cgal:ks-atmi-07}, since angles near 180 degrees do more harm than angles near 0. Use
this measure for meshes that do not move and whose angles are important.

\cgalModels{TetrahedronQualityMeasure_3}
*/
struct Biased_minimum_sine_3
{
  /// Returns the quality of pqrs. \pre the points are not all on a line
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return internal::minimum_sine(p, q, r, s, .7);
  }
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef
Quality measure of tetrahedra: three times the radius of the inscribed sphere, divided by the radius
of the circumscribed sphere.

\cgalModels{TetrahedronQualityMeasure_3}
*/
struct Radius_ratio_3
{
  /// Returns the quality of pqrs.
  /// \tparam Point a point of a kernel whose coordinates are of type `double`
  template <class Point>
  double operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    const internal::Tetrahedron_frame<Point> t(p, q, r, s);
    double area = 0;
    for (const auto& n : t.area_vectors())
      area += std::sqrt(n.squared_length()) / 2;
    // The vector from p to the circumcenter is `center` divided by twice the six volumes. The radii
    // are thus six_volumes / (2 area) and |center| / (2 six_volumes).
    const auto center = t.a.squared_length() * cross_product(t.b, t.c) +
                        t.b.squared_length() * cross_product(t.c, t.a) +
                        t.c.squared_length() * cross_product(t.a, t.b);
    const double radii = area * std::hypot(center.x(), center.y(), center.z());
    return radii == 0 ? 0 : 3 * t.six_volumes * std::abs(t.six_volumes) / radii;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_QUALITY_MEASURES_H
