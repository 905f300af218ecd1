// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_COMMIT_PROPOSAL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_COMMIT_PROPOSAL_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>

namespace CGAL::Deformable_simplicial_complexes {

// Mesh optimization changes a complex only by the functions of this header, so its visitor receives
// all changes.

template <class Complex>
void replace_cavity(Complex& complex, Cavity<Complex>& cavity,
                    Deformation_visitor<Complex>& visitor) {
  visitor.before_replacement(cavity);
  complex.replace(cavity);
  visitor.after_replacement(cavity);
}

template <class Complex>
void smooth_vertex(Complex& complex, typename Complex::Vertex_handle v,
                   const std::vector<typename Complex::Cell_handle>& star,
                   const typename Complex::Point& target, Deformation_visitor<Complex>& visitor) {
  visitor.before_smoothing(v, star, target);
  complex.set_point(v, star, target);
  visitor.after_smoothing(v, star);
}

template <class Complex>
void coarsen_spacing(const Complex& complex, typename Complex::Vertex_handle kept) {
  if (kept->spacing() > 0)
    internal::Simplex_access::set_spacing(
        kept, (std::max)(kept->spacing(), float(complex.interface_edge_length(kept))));
}

template <class Complex>
void commit_split(Complex& complex, Cavity<Complex>& cavity, typename Complex::Vertex_handle v,
                  typename Complex::Vertex_handle w, Deformation_visitor<Complex>& visitor,
                  Improvement_report& report) {
  CGAL_precondition(cavity.kind() == Proposal_kind::split);
  replace_cavity(complex, cavity, visitor);
  ++report.split;
  const auto middle = cavity.vertices().back().handle;
  if (middle->is_interface())
    for (auto refined : {v, middle, w})
      internal::Simplex_access::set_spacing(refined, float(complex.interface_edge_length(refined)));
  visitor.after_split(middle, v, w);
}

template <class Complex>
void commit_proposal(Complex& complex, Cavity<Complex>& cavity,
                     Deformation_visitor<Complex>& visitor, Improvement_report& report) {
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
    CGAL_error_msg("use commit_split() for a split, and replace_cavity() for a replacement");
  }
}

template <class Complex> bool keeps_volumes(const Complex& complex, const Cavity<Complex>& cavity) {
  return internal::Interface_tolerance<Complex>(complex).allows(cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_COMMIT_PROPOSAL_H
