// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_COLLAPSE_OR_FLIP_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_COLLAPSE_OR_FLIP_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Improvement_report.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Commits a cavity that creates no vertex, tells the visitor and counts.
template <class Complex, class Visitor>
void commit_collapse_or_flip(Complex& complex, Cavity_3<Complex>& cavity, Visitor& visitor,
                             Improvement_report& report) {
  if (cavity.vanishing_vertex() != typename Complex::Vertex_handle()) {
    visitor.before_collapse(cavity.vanishing_vertex(), cavity.kept_vertex());
    complex.replace(cavity);
    ++report.collapsed;
  } else {
    complex.replace(cavity);
    ++report.flipped;
    visitor.after_flip(cavity.created());
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_COLLAPSE_OR_FLIP_H
