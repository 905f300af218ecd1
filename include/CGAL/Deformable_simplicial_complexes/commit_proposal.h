// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// What improves the mesh of the user changes it by these functions only. The visitor is told of
// each change before, when nothing has changed yet if it throws, and after.

template <class Complex>
void replace_cavity(Complex& complex, Cavity<Complex>& cavity, Any_visitor<Complex>& visitor) {
  visitor.before_replacement(cavity);
  complex.replace(cavity);
  visitor.after_replacement(cavity);
}

template <class Complex>
void smooth_vertex(Complex& complex, typename Complex::Vertex_handle v,
                   const std::vector<typename Complex::Cell_handle>& star,
                   const typename Complex::Point& target, Any_visitor<Complex>& visitor) {
  visitor.before_smoothing(v, star, target);
  complex.set_point(v, star, target);
  visitor.after_smoothing(v, star);
}

// The spacing where a vertex of the interface was collapsed into this one: not less than before, as
// the interface may have shrunk.
template <class Complex>
void coarsen_spacing(const Complex& complex, typename Complex::Vertex_handle kept) {
  if (kept->spacing() > 0)
    kept->set_spacing((std::max)(kept->spacing(), float(complex.interface_edge_length(kept))));
}

// Commits the split of the edge between v and w and counts it.
template <class Complex>
void commit_split(Complex& complex, Cavity<Complex>& cavity, typename Complex::Vertex_handle v,
                  typename Complex::Vertex_handle w, Any_visitor<Complex>& visitor,
                  Improvement_report& report) {
  CGAL_precondition(cavity.kind() == Proposal_kind::split);
  replace_cavity(complex, cavity, visitor);
  ++report.split;
  const auto middle = cavity.vertices().back().handle;
  if (middle->is_interface())
    for (auto refined : {v, middle, w})
      refined->set_spacing(float(complex.interface_edge_length(refined)));
  visitor.after_split(middle, v, w);
}

// Commits a collapse, an insertion or a flip and counts it.
template <class Complex>
void commit_proposal(Complex& complex, Cavity<Complex>& cavity, Any_visitor<Complex>& visitor,
                     Improvement_report& report) {
  switch (cavity.kind()) {
  case Proposal_kind::collapse: {
    const bool is_of_interface = cavity.vanishing_vertex()->is_interface();
    visitor.before_collapse(cavity.vanishing_vertex(), cavity.kept_vertex());
    replace_cavity(complex, cavity, visitor);
    ++report.collapsed;
    if (is_of_interface)
      coarsen_spacing(complex, cavity.kept_vertex());
    break;
  }
  case Proposal_kind::insertion:
    replace_cavity(complex, cavity, visitor);
    ++report.inserted;
    visitor.after_insertion(cavity.vertices().back().handle);
    break;
  case Proposal_kind::flip:
    replace_cavity(complex, cavity, visitor);
    ++report.flipped;
    visitor.after_flip(cavity.created());
    break;
  case Proposal_kind::split:
  case Proposal_kind::replacement:
    CGAL_error_msg("commits of these kinds tell more than their proposals");
  }
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H
