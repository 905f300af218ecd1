// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FINAL_QUALITY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FINAL_QUALITY_H

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The quality of a tetrahedron when the vertices on the way have arrived at their destinations.
template <class Complex>
double final_quality(const Complex& complex,
                     const std::array<typename Complex::Vertex_handle, 4>& vertices) {
  return complex.quality_measure()(
      complex.final_position(vertices[0]), complex.final_position(vertices[1]),
      complex.final_position(vertices[2]), complex.final_position(vertices[3]));
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FINAL_QUALITY_H
