// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_OVERLAP_VOLUME_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_OVERLAP_VOLUME_3_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Positive iff the corners are positively oriented, up to rounding.
template <class Point> double signed_volume(const std::array<Point, 4>& t) {
  return cross_product(t[1] - t[0], t[2] - t[0]) * (t[3] - t[0]) / 6;
}

// The heights of a point above four planes, each in a unit of its own.
using Heights = std::array<double, 4>;

// A positive tetrahedron, as what is above the planes of its facets.
template <class Point> class Clipping_tetrahedron_3
{
public:
  explicit Clipping_tetrahedron_3(const std::array<Point, 4>& corners)
      : m_corners(corners),
        m_box(corners[0].bbox() + corners[1].bbox() + corners[2].bbox() + corners[3].bbox()) {
    static constexpr int facets[4][3] = {{1, 3, 2}, {2, 3, 0}, {3, 1, 0}, {0, 1, 2}}; // from inside
    for (int k = 0; k < 4; ++k)
      m_normals[k] = cross_product(corners[facets[k][1]] - corners[facets[k][0]],
                                   corners[facets[k][2]] - corners[facets[k][0]]);
  }

  const std::array<Point, 4>& corners() const { return m_corners; }
  const Bbox_3& bbox() const { return m_box; }

  // Finds the heights of four points, unless all are below one of the planes. Returns whether it
  // has.
  bool find_heights(const std::array<Point, 4>& points, std::array<Heights, 4>& heights) const {
    static constexpr double rounding = 1e-15; // there is hardly any volume below such a height
    for (int k = 0; k < 4; ++k) {
      const Point& p = m_corners[(k + 1) % 4]; // in the plane
      double lowest = 0, highest = 0;
      for (int i = 0; i < 4; ++i) {
        const double h = heights[i][k] = m_normals[k] * (points[i] - p);
        lowest = (std::min)(lowest, h);
        highest = (std::max)(highest, h);
      }
      if (highest <= -rounding * lowest)
        return false;
    }
    return true;
  }

private:
  using Vector = decltype(Point() - Point());

  std::array<Point, 4> m_corners;
  std::array<Vector, 4> m_normals;
  Bbox_3 m_box;
};

// The part of the volume of a tetrahedron, given by the heights of its vertices, that is above the
// first few planes. Each plane leaves a tetrahedron or a prism, which is made of three. Their parts
// of the volume and the heights of their vertices follow from the ratios in which edges are cut.
inline double part_above(std::array<Heights, 4> v, int number_of_planes) {
  if (number_of_planes == 0)
    return 1;
  const int k = number_of_planes - 1;
  const auto above =
      std::partition(v.begin(), v.end(), [&](const Heights& h) { return h[k] > 0; }) - v.begin();
  struct Cut
  {
    double ratio; // of the way from above to below
    Heights heights;
  };
  const auto cut = [&](int i, int j) {
    Cut result = {v[i][k] / (v[i][k] - v[j][k]), {}};
    for (int l = 0; l < k; ++l)
      result.heights[l] = v[i][l] + result.ratio * (v[j][l] - v[i][l]);
    return result;
  };
  const auto rest = [&](double part, const Heights& p, const Heights& q, const Heights& r,
                        const Heights& s) {
    return part > 0 ? part * part_above({p, q, r, s}, k) : 0;
  };
  if (above == 0)
    return 0;
  if (above == 1) {
    const Cut a = cut(0, 1), b = cut(0, 2), c = cut(0, 3);
    return rest(a.ratio * b.ratio * c.ratio, v[0], a.heights, b.heights, c.heights);
  }
  if (above == 2) {
    const Cut a = cut(0, 2), b = cut(0, 3), c = cut(1, 2), d = cut(1, 3);
    return rest(a.ratio * b.ratio, v[0], a.heights, b.heights, v[1]) +
           rest((1 - a.ratio) * b.ratio * c.ratio, a.heights, b.heights, v[1], c.heights) +
           rest((1 - b.ratio) * c.ratio * d.ratio, b.heights, v[1], c.heights, d.heights);
  }
  if (above == 3) {
    const Cut a = cut(0, 3), b = cut(1, 3), c = cut(2, 3);
    return rest(a.ratio, v[0], v[1], v[2], a.heights) +
           rest((1 - a.ratio) * b.ratio, v[1], v[2], a.heights, b.heights) +
           rest((1 - a.ratio) * (1 - b.ratio) * c.ratio, v[2], a.heights, b.heights, c.heights);
  }
  return part_above(v, k);
}

// The volume of the intersection, up to rounding: the error is in proportion to the cubes of edges.
template <class Point>
double overlap_volume(const Clipping_tetrahedron_3<Point>& s,
                      const Clipping_tetrahedron_3<Point>& t) {
  std::array<Heights, 4> s_above_t, t_above_s;
  return do_overlap(s.bbox(), t.bbox()) && t.find_heights(s.corners(), s_above_t) &&
                 s.find_heights(t.corners(), t_above_s)
             ? (std::max)(0., signed_volume(s.corners())) * part_above(s_above_t, 4)
             : 0;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_OVERLAP_VOLUME_3_H
