// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_OVERLAP_VOLUME_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_OVERLAP_VOLUME_3_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Positive iff pqrs is positively oriented, up to rounding.
template <class Point>
double signed_volume(const Point& p, const Point& q, const Point& r, const Point& s) {
  return cross_product(q - p, r - p) * (s - p) / 6;
}

template <class Point> double signed_volume(const std::array<Point, 4>& t) {
  return signed_volume(t[0], t[1], t[2], t[3]);
}

// The volume of what the first `number_of_cuts` facets of `clip`, a positive tetrahedron, leave of
// t: each cuts t at its plane, and what is left is cut further in one or three tetrahedra.
template <class Point>
double clipped_volume(const std::array<Point, 4>& t, const std::array<Point, 4>& clip,
                      int number_of_cuts) {
  if (number_of_cuts == 0)
    return std::abs(signed_volume(t));
  --number_of_cuts;
  std::array<std::pair<double, Point>, 4> p; // above the plane of the facet, highest first
  for (int i = 0; i < 4; ++i) {
    auto moved = clip;
    moved[number_of_cuts] = t[i];
    p[i] = {signed_volume(moved), t[i]};
  }
  std::sort(p.begin(), p.end(), [](const auto& a, const auto& b) { return a.first > b.first; });

  const auto rest = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
    return clipped_volume(std::array<Point, 4>{a, b, c, d}, clip, number_of_cuts);
  };
  const auto cut = [&](int above, int below) { // where an edge meets the plane
    const auto& [h, a] = p[above];
    const auto& [k, b] = p[below];
    return a + h / (h - k) * (b - a);
  };
  const auto prism = [&](const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    return rest(a[0], a[1], a[2], b[0]) + rest(a[1], a[2], b[0], b[1]) +
           rest(a[2], b[0], b[1], b[2]);
  };
  const auto number_above =
      std::count_if(p.begin(), p.end(), [](const auto& vertex) { return vertex.first > 0; });
  switch (number_above) {
  case 0:
    return 0;
  case 1:
    return rest(p[0].second, cut(0, 1), cut(0, 2), cut(0, 3));
  case 2:
    return prism({p[0].second, cut(0, 2), cut(0, 3)}, {p[1].second, cut(1, 2), cut(1, 3)});
  case 3:
    return prism({p[0].second, p[1].second, p[2].second}, {cut(0, 3), cut(1, 3), cut(2, 3)});
  default:
    return clipped_volume(t, clip, number_of_cuts);
  }
}

// The volume of the intersection of two positive tetrahedra, up to rounding: the error is in
// proportion to the cubes of their edges.
template <class Point>
double overlap_volume(const std::array<Point, 4>& s, const std::array<Point, 4>& t) {
  const auto box = [](const std::array<Point, 4>& p) {
    return p[0].bbox() + p[1].bbox() + p[2].bbox() + p[3].bbox();
  };
  return do_overlap(box(s), box(t)) ? clipped_volume(s, t, 4) : 0;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_OVERLAP_VOLUME_3_H
