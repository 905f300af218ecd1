// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>

namespace CGAL::Deformable_simplicial_complexes {

// Mesh optimization changes a complex only by the functions of this header, so its visitor receives
// all changes.

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits a cavity by `Complex::replace()`, and calls a visitor before and after the replacement. The
functions below also call the functions of the visitor for each kind of proposal. n log n in the
size of the cavity, plus the costs of `Complex::replace()` for components.

\param complex the complex
\param cavity the proposal
\param visitor the visitor
\pre See `Complex::replace()`.
\throws Stale_proposal_error if the complex has changed since the cavity was begun; the complex is
        then unchanged, but `before_replacement()` was called. If a function of the visitor throws
        before the replacement, the complex is unchanged. If one throws after the replacement, the
        complex is valid.
*/
template <class Complex>
void replace_cavity(Complex& complex, Cavity<Complex>& cavity,
                    Deformation_visitor<Complex>& visitor) {
  visitor.before_replacement(cavity);
  complex.replace(cavity);
  visitor.after_replacement(cavity);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves a vertex to a target by `Complex::set_point()`, and calls a visitor before and after the
motion. Linear in the star.

\param complex the complex
\param v a finite vertex
\param star the star of `v`
\param target the target, which is rounded
\param visitor the visitor. If it throws before the motion, the complex is unchanged. If it throws
       after the motion, the complex is valid.
\pre `complex.is_positive_star(v, star, target)`
*/
template <class Complex>
void smooth_vertex(Complex& complex, typename Complex::Vertex_handle v,
                   const std::vector<typename Complex::Cell_handle>& star,
                   const typename Complex::Point& target, Deformation_visitor<Complex>& visitor) {
  visitor.before_smoothing(v, star, target);
  complex.set_point(v, star, target);
  visitor.after_smoothing(v, star);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Updates the spacing of a vertex into which a vertex of the interface was collapsed. The spacing
becomes the mean length of the edges of the interface at the vertex if this is greater. A smaller
length does not count, because the interface can have shrunk. A vertex without spacing stays so.
Linear in the star. `commit_proposal()` calls this function.
*/
template <class Complex>
void coarsen_spacing(const Complex& complex, typename Complex::Vertex_handle kept) {
  if (kept->spacing() > 0)
    internal::Simplex_access::set_spacing(
        kept, (std::max)(kept->spacing(), float(complex.interface_edge_length(kept))));
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits the split of an edge, calls the visitor, and counts the split in a report. If the edge is on
the interface, its ends and the new vertex get a new spacing.

\param complex the complex
\param cavity a proposal of `propose_edge_split()` for the edge; the new vertex is its last one
\param v, w the ends of the edge
\param visitor the visitor; `after_split()` is called last
\param report `report.split` is increased after the replacement
\pre `cavity.kind()` is `Proposal_kind::split`.
\throws Stale_proposal_error as `replace_cavity()`
*/
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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits a collapse, an insertion or a flip, calls the visitor, and counts the operation in a report.

\param complex the complex
\param cavity the proposal
\param visitor the visitor; `before_collapse()` is called first, `after_insertion()` or
       `after_flip()` is called last
\param report the number of operations of this kind is increased after the replacement
\pre `cavity.kind()` is `Proposal_kind::collapse`, `insertion` or `flip`. Use `commit_split()` for a
     split, and `replace_cavity()` for any other replacement.
\throws Stale_proposal_error as `replace_cavity()`
*/
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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether a proposal moves only a small volume from one label to another, as the operations of
`deform_interface()` do. The bound is three percent of the volume that each label has in the cells
around the operation. It is smaller where a label is thin relative to the edges of the interface.
Linear in the number of these cells.

\param complex the complex
\param cavity a proposal that collapses an edge or, in space, flips an edge of the interface. For
       other proposals, the function returns `true` without a test.
*/
template <class Complex> bool keeps_volumes(const Complex& complex, const Cavity<Complex>& cavity) {
  return internal::Interface_tolerance<Complex>(complex).allows(cavity);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMMIT_PROPOSAL_H
