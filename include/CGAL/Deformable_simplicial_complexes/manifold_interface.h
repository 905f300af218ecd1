// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MANIFOLD_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MANIFOLD_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/internal/topology/Labelled_star.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Manifold_relabeling.h>

#include <vector>

/// \file
/// Where the interface is a manifold, and how it stays one: what the parameter
/// `manifold_interface()` is about.

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Tells whether the interface is manifold at a vertex and its edges: whether for each label there, the
boundary of the union of its closed cells, where that contains the vertex, is a 2-manifold around
it. Triple lines and points where more labels meet are manifold in this sense. Parts of one label
that meet only in the vertex or in one of its edges are not; nor are parts of what a label leaves,
the outside of the domain included.

\param complex is not changed.
\param v a finite vertex.
\return whether the cells around v of each label are connected through facets around v, and so are
        those that are not of it. Only incidences decide.

Quadratic in the star of v.
*/
template <class Complex>
bool is_manifold_at(const Complex& complex, typename Complex::Vertex_handle v) {
  return internal::Labelled_star<Complex>(
             complex, v, [](typename Complex::Cell_handle c) { return c->label(); })
      .is_manifold();
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Finds the vertices at which `is_manifold_at()` does not hold. If there are none, the boundary of
each phase is a closed 2-manifold.

\param complex is not changed.
\return the vertices by increasing time stamp.

n log n in the number of vertices, for stars of bounded size.
*/
template <class Complex>
std::vector<typename Complex::Vertex_handle> non_manifold_vertices(const Complex& complex) {
  std::vector<typename Complex::Vertex_handle> result;
  for (auto v : complex.interface_vertices())
    if (!is_manifold_at(complex, v))
      result.push_back(v);
  return result;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to give a cell another label without pinching the interface. Where the cell alone would do
so at a vertex, cells of its old label around that vertex join it, until the interface is manifold
at all vertices of what is relabeled: between parts of the new label, those of least volume that
connect them through facets; of parts of the old label that are cut off from each other, all but the
one of most volume. A tunnel thus opens between parts that would only touch (section 5 of the paper
suggests it, but leaves it open), and what would hang on a vertex or an edge is torn off.

\param complex is not changed.
\param cell a finite cell.
\param label the new label, different from that of the cell.
\param cells filled with the proposal if there is one: `cell` and others of its label.
\return whether there is a proposal, of at most 60 cells; commit with `complex.relabel(c, label)`
        for each of its cells c. No vertex becomes non-manifold then, and those of the cells are
        manifold, even if they were not before.

Constant time for stars of bounded size, as the number of cells is bounded.
*/
template <class Complex>
bool propose_manifold_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                                 typename Complex::Label label,
                                 std::vector<typename Complex::Cell_handle>& cells) {
  cells.assign(1, cell);
  return internal::Manifold_relabeling<Complex>(complex, cells, label).complete();
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MANIFOLD_INTERFACE_H
