// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_PROPOSAL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_PROPOSAL_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Improvement_report.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Commits a collapse, an insertion or a flip, but no split, tells the visitor and counts.
template <class Complex, class Visitor>
void commit_proposal(Complex& complex, Cavity_3<Complex>& cavity, Visitor& visitor,
                     Improvement_report& report) {
  using Vertex_handle = typename Complex::Vertex_handle;
  if (cavity.vanishing_vertex() != Vertex_handle()) {
    visitor.before_collapse(cavity.vanishing_vertex(), cavity.kept_vertex());
    complex.replace(cavity);
    ++report.collapsed;
  } else if (cavity.vertices().back().handle == Vertex_handle()) {
    complex.replace(cavity);
    ++report.inserted;
    visitor.after_insertion(cavity.vertices().back().handle);
  } else {
    complex.replace(cavity);
    ++report.flipped;
    visitor.after_flip(cavity.created());
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMMIT_PROPOSAL_H
