// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_OVERLAP_MEASURE_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_OVERLAP_MEASURE_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the area of a triangle or the volume of a tetrahedron. It is positive iff the corners are
// positively oriented, up to rounding.
template <class Space> double signed_measure(const std::array<typename Space::Point, 3>& t) {
  return Space::frame(t).parallelotope / 2;
}
template <class Space> double signed_measure(const std::array<typename Space::Point, 4>& t) {
  return Space::frame(t).parallelotope / 6;
}

// Signed distances of a point to n lines (2D) or planes (3D), one scale each.
template <std::size_t n> using Signed_distances = std::array<double, n>;

// A positively oriented triangle or tetrahedron, represented as the intersection of the half-spaces
// of its facets.
template <class Space> class Clipping_simplex
{
public:
  static constexpr int n = Space::dimension + 1;
  using Corners = std::array<typename Space::Point, n>;

  explicit Clipping_simplex(const Corners& corners)
      : m_corners(corners), m_box(corners[0].bbox()), m_normals(Space::frame(corners).normals) {
    for (int i = 1; i < n; ++i)
      m_box = m_box + corners[i].bbox();
  }

  const Corners& corners() const { return m_corners; }
  const auto& bbox() const { return m_box; }

  // Computes the signed distances of the corners of another simplex to all facets; they are
  // positive inside. Returns false if all corners lie outside one of the facets; the distances are
  // incomplete then.
  bool find_signed_distances(const Corners& points,
                             std::array<Signed_distances<n>, n>& distances) const {
    // ratio of distances below which the overlap is negligible
    static constexpr double rounding = 1e-15;
    for (int k = 0; k < n; ++k) {
      const auto& p = m_corners[(k + 1) % n]; // in the facet
      double lowest = 0, highest = 0;
      for (int i = 0; i < n; ++i) {
        const double h = distances[i][k] = m_normals[k] * (p - points[i]);
        lowest = (std::min)(lowest, h);
        highest = (std::max)(highest, h);
      }
      if (highest <= -rounding * lowest)
        return false;
    }
    return true;
  }

private:
  Corners m_corners;
  decltype(m_corners[0].bbox()) m_box;
  std::array<typename Space::Vector, n> m_normals; // outward
};

// The intersection of an edge of a simplex with the line or plane of facet k. The edge is given by
// the signed distances of its vertices. `ratio` is the fraction of the edge from the vertex `above`
// to the intersection.
template <std::size_t n> struct Cut
{
  double ratio;
  Signed_distances<n> distances; // signed distances to the facets before k

  Cut(const Signed_distances<n>& above, const Signed_distances<n>& below, int k)
      : ratio(above[k] / (above[k] - below[k])), distances() {
    for (int l = 0; l < k; ++l)
      distances[l] = above[l] + ratio * (below[l] - above[l]);
  }
};

template <std::size_t n>
double part_above(std::array<Signed_distances<n>, n> v, int number_of_facets);

template <std::size_t n>
double part_of(double part, const std::array<Signed_distances<n>, n>& v, int number_of_facets) {
  return part > 0 ? part * part_above(v, number_of_facets) : 0;
}

// Returns the fraction of a triangle inside facet k, if its first `above` vertices lie inside. This
// part is a triangle, or a quadrilateral that is divided into two triangles.
inline double part_above(const std::array<Signed_distances<3>, 3>& v, int k, std::ptrdiff_t above) {
  const auto cut = [&](int i, int j) { return Cut<3>(v[i], v[j], k); };
  if (above == 1) {
    const auto a = cut(0, 1), b = cut(0, 2);
    return part_of<3>(a.ratio * b.ratio, {v[0], a.distances, b.distances}, k);
  }
  const auto a = cut(0, 2), b = cut(1, 2);
  return part_of<3>(a.ratio, {v[0], v[1], a.distances}, k) +
         part_of<3>((1 - a.ratio) * b.ratio, {v[1], a.distances, b.distances}, k);
}

// Returns the fraction of a tetrahedron inside facet k, if its first `above` vertices lie inside.
// This part is a tetrahedron, or a prism that is divided into three tetrahedra.
inline double part_above(const std::array<Signed_distances<4>, 4>& v, int k, std::ptrdiff_t above) {
  const auto cut = [&](int i, int j) { return Cut<4>(v[i], v[j], k); };
  if (above == 1) {
    const auto a = cut(0, 1), b = cut(0, 2), c = cut(0, 3);
    return part_of<4>(a.ratio * b.ratio * c.ratio, {v[0], a.distances, b.distances, c.distances},
                      k);
  }
  if (above == 2) {
    const auto a = cut(0, 2), b = cut(0, 3), c = cut(1, 2), d = cut(1, 3);
    return part_of<4>(a.ratio * b.ratio, {v[0], a.distances, b.distances, v[1]}, k) +
           part_of<4>((1 - a.ratio) * b.ratio * c.ratio,
                      {a.distances, b.distances, v[1], c.distances}, k) +
           part_of<4>((1 - b.ratio) * c.ratio * d.ratio,
                      {b.distances, v[1], c.distances, d.distances}, k);
  }
  const auto a = cut(0, 3), b = cut(1, 3), c = cut(2, 3);
  return part_of<4>(a.ratio, {v[0], v[1], v[2], a.distances}, k) +
         part_of<4>((1 - a.ratio) * b.ratio, {v[1], v[2], a.distances, b.distances}, k) +
         part_of<4>((1 - a.ratio) * (1 - b.ratio) * c.ratio,
                    {v[2], a.distances, b.distances, c.distances}, k);
}

// Returns the fraction of a simplex inside the first `number_of_facets` facets. The simplex is
// given by the signed distances of its vertices. Sub-simplices and their signed distances follow
// from the ratios in which edges are cut.
template <std::size_t n>
double part_above(std::array<Signed_distances<n>, n> v, int number_of_facets) {
  if (number_of_facets == 0)
    return 1;
  const int k = number_of_facets - 1;
  const auto above =
      std::partition(v.begin(), v.end(), [&](const Signed_distances<n>& h) { return h[k] > 0; }) -
      v.begin();
  if (above == 0)
    return 0;
  return above == std::ptrdiff_t(n) ? part_above(v, k) : part_above(v, k, above);
}

// Returns the measure of the intersection of two simplices, up to rounding. The error is
// proportional to powers of edge lengths.
template <class Space>
double overlap_measure(const Clipping_simplex<Space>& s, const Clipping_simplex<Space>& t) {
  static constexpr int n = Space::dimension + 1;
  std::array<Signed_distances<n>, n> s_above_t, t_above_s;
  return do_overlap(s.bbox(), t.bbox()) && t.find_signed_distances(s.corners(), s_above_t) &&
                 s.find_signed_distances(t.corners(), t_above_s)
             ? (std::max)(0., signed_measure<Space>(s.corners())) * part_above(s_above_t, n)
             : 0;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_OVERLAP_MEASURE_H
