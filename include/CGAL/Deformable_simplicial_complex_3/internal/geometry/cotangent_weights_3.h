// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_COTANGENT_WEIGHTS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_COTANGENT_WEIGHTS_3_H

#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What a triangle adds to the gradient of the area and to the areas of its corners.
struct Cotangent_weights_3
{
  std::array<double, 3> halved_cotangents; // of the angles, for the opposite edges
  std::array<double, 3> mixed_areas;       // of the corners; their sum is the area

  // Meyer, Desbrun, Schröder, Barr, Discrete differential-geometry operators for triangulated
  // 2-manifolds, section 3: Voronoi areas, but halves and quarters in obtuse triangles. All is zero
  // in a triangle without area.
  template <class Point> explicit Cotangent_weights_3(const std::array<Point, 3>& p) {
    const double doubled_area = std::sqrt(cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
    std::array<double, 3> squared_edges, dots;
    int obtuse = -1;
    for (int i = 0; i < 3; ++i) {
      const auto a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
      squared_edges[i] = (b - a).squared_length();
      dots[i] = a * b;
      halved_cotangents[i] = doubled_area > 0 ? dots[i] / (2 * doubled_area) : 0;
      if (dots[i] < 0)
        obtuse = i;
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      mixed_areas[i] = obtuse < 0 ? (squared_edges[j] * halved_cotangents[j] +
                                     squared_edges[k] * halved_cotangents[k]) /
                                        4
                                  : doubled_area / (obtuse == i ? 4 : 8);
    }
  }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_GEOMETRY_COTANGENT_WEIGHTS_3_H
