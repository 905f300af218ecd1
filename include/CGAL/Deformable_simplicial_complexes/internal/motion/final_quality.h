// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FINAL_QUALITY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FINAL_QUALITY_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The quality of a cell when the vertices on the way have arrived at their destinations.
template <class Complex>
double
final_quality(const Complex& complex,
              const std::array<typename Complex::Vertex_handle, Complex::corners>& vertices) {
  return apply_to_corners<Complex::corners>(
      complex.quality_measure(), [&](int i) { return complex.final_position(vertices[i]); });
}

// The same of a cell of the complex.
template <class Complex>
double final_quality(const Complex& complex, typename Complex::Cell_handle c) {
  return complex.quality(
      c, [&](typename Complex::Vertex_handle v) { return complex.final_position(v); });
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_FINAL_QUALITY_H
