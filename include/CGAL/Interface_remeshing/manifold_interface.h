// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_MANIFOLD_INTERFACE_H
#define CGAL_INTERFACE_REMESHING_MANIFOLD_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/internal/topology/Manifold_relabeling.h>

/// \file
/// Tests whether the interface is manifold, and relabeling that keeps it manifold, as used
/// with the parameter `manifold_interface()`.

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Returns whether the interface is manifold at a vertex and its edges. This means: for each label
around the vertex, the boundary of the union of its closed cells is a manifold around the vertex, if
it contains the vertex. Lines and points where three or more labels meet are manifold in this sense.
Parts of one label that share only the vertex or one of its edges are not. The same holds for the
complement of a label, which includes the outside of the domain. Quadratic in the star of v.

\param complex the complex; it is not changed
\param v a finite vertex
\return whether, for each label, the cells around v with the label are connected through facets
        around v, and so are the cells without the label. The result depends only on incidences.
*/
template <class Complex>
bool is_manifold_at(const Complex& complex, typename Complex::Vertex_handle v) {
  return internal::Labeled_star<Complex>(
             complex, v, [](typename Complex::Cell_handle c) { return c->subdomain_index(); })
      .is_manifold();
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the vertices at which `is_manifold_at()` does not hold. If there is none, the boundary of
each phase is a closed manifold. n log n in the number of vertices, for stars of bounded size.

\param complex the complex; it is not changed
\return the vertices, by increasing time stamp
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
\ingroup PkgInterfaceRemeshingRef

Proposes to give a cell another label while the interface stays manifold. If relabeling the cell
alone would make the interface non-manifold at a vertex, other cells of the old label around the
vertex are added. This is repeated until the interface is manifold at all vertices of the relabeled
cells. If parts of the new label are not connected, the cells of least volume that connect them
through facets are added. If parts of the old label are cut off from each other, all of them except
the one of largest volume are added. A tunnel thus opens between parts that would only touch, and
parts that would be connected only by a vertex or an edge are cut off. Section 5 of the paper
suggests such an operation without details.

Constant time for stars of bounded size, since the number of cells is bounded.

\param complex the complex; it is not changed
\param cell a finite cell
\param label the new label, different from that of the cell
\param cells filled with the proposal if there is one: `cell` and other cells of its label
\return whether there is a proposal with at most 60 cells; commit it with `complex.relabel(c,
        label)` for each cell c. No vertex becomes non-manifold then, and all vertices of the cells
        are manifold, even if they were not before.
*/
template <class Complex>
bool propose_manifold_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                                 typename Complex::Label label,
                                 std::vector<typename Complex::Cell_handle>& cells) {
  cells.assign(1, cell);
  return internal::Manifold_relabeling<Complex>(complex, cells, label).complete();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_MANIFOLD_INTERFACE_H
