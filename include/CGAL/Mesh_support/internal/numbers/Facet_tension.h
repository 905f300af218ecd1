// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_FACET_TENSION_H
#define CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_FACET_TENSION_H

#include <array>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

// Forces by which a facet of the interface reduces its measure, the length in the plane or the area
// in space. The specializations for 2 and 3 exist.
//
// Edge `k` of the facet has the ends `(i, j)`, which are entry `k` of
// `Complex::Space::facet_edges`. The force of the edge is `weights[k]` times the vector from corner
// `i` to corner `j`. This force acts on corner `i`, and the opposite force acts on corner `j`. The
// sum of the forces at a corner is the negative gradient of the measure. A facet of measure 0 has
// only zero weights and shares.
//
// The time is constant, and no function throws.
//
// \tparam d dimension of the complex, 2 or 3
template <int d> struct Facet_tension;

// The forces of an edge in the plane.
template <> struct Facet_tension<2>
{
  std::array<double, 1> weights; // the inverse of the length
  std::array<double, 2> shares;  // half of the length for each end

  // Computes the forces of the edge with the ends `p`.
  // \param p ends as seen from one of them: on a torus, images next to each other

  template <class Point> explicit Facet_tension(const std::array<Point, 2>& p) {
    const double length = std::sqrt((p[1] - p[0]).squared_length());
    weights = {length > 0 ? 1 / length : 0};
    shares = {length / 2, length / 2};
  }
};

// The forces of a triangle in space.
template <> struct Facet_tension<3>
{
  std::array<double, 3> weights; // half of the cotangents of the angles opposite to the edges
  std::array<double, 3> shares;  // mixed area of each corner; they sum up to the area

  // Computes the forces of the triangle with the corners `p`. The weights are those of the
  // cotangent formula. The shares are the mixed areas of M. Meyer, M. Desbrun, P. Schröder and A.
  // H. Barr, *Discrete differential-geometry operators for triangulated 2-manifolds*, section 3:
  // Voronoi areas, but half of the area for an obtuse corner and a quarter for each other corner.
  // \param p corners as seen from one of them: on a torus, images next to each other
  template <class Point> explicit Facet_tension(const std::array<Point, 3>& p) {
    const double doubled_area = std::sqrt(cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
    std::array<double, 3> parts; // half of the triangle of an edge and the circumcenter
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_FACET_TENSION_H
