// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FACET_TENSION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FACET_TENSION_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// How a facet of the interface contracts: along its edges `facet_edges` of the space, by
// `weights` times their vectors, which sum up to the negative gradient of what it measures. To each
// corner belongs a share of that. All is zero in a facet without measure.
template <int d> struct Facet_tension;

template <> struct Facet_tension<2>
{
  std::array<double, 1> weights;
  std::array<double, 2> shares;

  template <class Point> explicit Facet_tension(const std::array<Point, 2>& p) {
    const double length = std::sqrt((p[1] - p[0]).squared_length());
    weights = {length > 0 ? 1 / length : 0};
    shares = {length / 2, length / 2};
  }
};

template <> struct Facet_tension<3>
{
  std::array<double, 3> weights; // halved cotangents of the angles opposite to the edges
  std::array<double, 3> shares;  // mixed areas

  // Meyer, Desbrun, Schröder, Barr, Discrete differential-geometry operators for triangulated
  // 2-manifolds, section 3: Voronoi areas, but halves and quarters in obtuse triangles.
  template <class Point> explicit Facet_tension(const std::array<Point, 3>& p) {
    const double doubled_area = std::sqrt(cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
    std::array<double, 3> parts; // of the area, on each edge as seen from the center
    int obtuse = -1;
    for (int i = 0; i < 3; ++i) {
      const int apex = (i + 2) % 3; // opposite to edge i
      const auto a = p[i] - p[apex], b = p[(i + 1) % 3] - p[apex];
      weights[i] = doubled_area > 0 ? a * b / (2 * doubled_area) : 0;
      parts[i] = (b - a).squared_length() * weights[i] / 4;
      if (a * b < 0)
        obtuse = apex;
    }
    for (int i = 0; i < 3; ++i)
      shares[i] = obtuse < 0 ? parts[i] + parts[(i + 2) % 3] : doubled_area / (obtuse == i ? 4 : 8);
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FACET_TENSION_H
