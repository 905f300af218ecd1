// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SWEPT_VOLUME_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SWEPT_VOLUME_H

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the volume that a facet sweeps on the side of its normal if its corners move along
// straight lines; in the plane, the area. Gauss' rule with two points is exact, because the
// velocity is constant and the area vector is a quadratic function of time.
template <class Complex>
double swept_volume(const std::array<typename Complex::Point, Complex::dimension>& before,
                    const std::array<typename Complex::Point, Complex::dimension>& after) {
  static constexpr int d = Complex::dimension;
  typename Complex::Vector sum = after[0] - before[0];
  for (int i = 1; i < d; ++i)
    sum = sum + (after[i] - before[i]);
  double result = 0;
  for (const double t : {.5 - std::sqrt(1. / 12), .5 + std::sqrt(1. / 12)}) {
    auto corners = before;
    for (int i = 0; i < d; ++i)
      corners[i] = before[i] + t * (after[i] - before[i]);
    result += sum * Complex::Space::facet_normal(corners);
  }
  static constexpr int factorial = d - 1; // (d - 1)! in both dimensions
  return result / (2 * d * factorial);
}

// Calls `add(label, volume)` with the volumes that labels gain if the vertices of the given cells
// move along straight lines to `after(v)`.
template <class Complex, class After, class Add>
void add_swept_volumes(const Complex& complex,
                       const std::vector<typename Complex::Cell_handle>& cells, const After& after,
                       const Add& add) {
  for (auto c : cells)
    for (int i = 0; i < Complex::corners; ++i) {
      const auto n = c->neighbor(i);
      if (complex.is_infinite(c) || complex.is_infinite(n) ||
          c->subdomain_index() <= n->subdomain_index())
        continue; // each facet of the interface once
      std::array<typename Complex::Point, Complex::dimension> from, to;
      for (int k = 0; k < Complex::dimension; ++k) {
        const auto v = c->vertex(Complex::Space::facet_vertices[i][k]);
        from[k] = k == 0 ? complex.position(v) : complex.position_near(from[0], v);
        to[k] = complex.domain().nearest_image(from[k], after(v));
      }
      const double volume = swept_volume<Complex>(from, to);
      add(c->subdomain_index(), volume);
      add(n->subdomain_index(), -volume);
    }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_SWEPT_VOLUME_H
