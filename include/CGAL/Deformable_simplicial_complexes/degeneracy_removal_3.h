// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/geometry/Facet_normals.h>
#include <CGAL/Deformable_simplicial_complexes/multi_face_removal_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// Simplices that are degenerate: edges nearly without length, facets nearly without area and
// tetrahedra nearly without volume ("degeneracy removal", section 3.2.1 of the paper). The paper
// splits an edge and collapses the new vertex into a vertex c beside it. That is to remove the
// edge, its ring being triangulated by a fan around c; edge removal takes the best of all
// triangulations.

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Proposes to remove an edge of a flat cell. An interface that bends around the cell there may do
// so on its other side.
template <class Complex>
bool propose_removal_from_flat_cell(const Complex& complex, typename Complex::Cell_handle cell,
                                    int i, int j, Cavity<Complex>& cavity) {
  bool is_bend = true;
  for (int k = 0; k < 4; ++k)
    is_bend = is_bend && (k == i || k == j || complex.is_interface(std::make_pair(cell, k)));
  return is_bend ? propose_interface_edge_flip(complex, cell, i, j, cavity)
                 : propose_edge_removal(complex, cell, i, j, cavity);
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a facet with a small angle. The longest edge of a *cap* is removed, or flipped if
the facet is on the interface; the shortest edge of a *needle* is collapsed. A facet is a cap if its
largest angle is above 120 degrees and its longest edge 1.03 times as long as the second one. For
the smallest angle of the paper, the latter alone decides, as in the paper.

\param complex is not changed.
\param cell, i a finite facet.
\param cosine only facets with an angle of larger cosine are considered; the paper takes 0.999.
\param minimum_quality no new tetrahedron of a collapse may be worse.
\param cavity filled with the proposal if there is one.
\return whether the facet has a small angle and `propose_edge_removal()`,
        `propose_interface_edge_flip()` or `propose_edge_collapse()` proposes what is said above.
The interface stays as it is, or moves by the volume next to its nearly flat facets.

As these. Section 3.2.1 of the paper, degeneracy removal (b).
*/
template <class Complex>
bool propose_degenerate_facet_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                      int i, double cosine, double minimum_quality,
                                      Cavity<Complex>& cavity) {
  using namespace internal;
  static constexpr double cap_cosine = -.5, cap_ratio = 1.03;
  const std::array<int, 3> v = {(i + 1) % 4, (i + 2) % 4, (i + 3) % 4};
  std::array<double, 3> squared; // lengths of the edges opposite to the three vertices
  for (int k = 0; k < 3; ++k)
    squared[k] = complex.displacement(cell->vertex(v[(k + 2) % 3]), cell->vertex(v[(k + 1) % 3]))
                     .squared_length();
  const int shortest = int(std::min_element(squared.begin(), squared.end()) - squared.begin());
  const int longest = int(std::max_element(squared.begin(), squared.end()) - squared.begin());
  const auto cosine_at = [&](int k) {
    const double p = squared[(k + 1) % 3], q = squared[(k + 2) % 3];
    return (p + q - squared[k]) / (2 * std::sqrt(p * q));
  };
  if (!(cosine_at(shortest) > cosine))
    return false;

  const double second = (std::max)(squared[(longest + 1) % 3], squared[(longest + 2) % 3]);
  const bool is_cap =
      cosine_at(longest) < cap_cosine && squared[longest] > cap_ratio * cap_ratio * second;
  const int opposite = is_cap ? longest : shortest;
  const int a = v[(opposite + 1) % 3], b = v[(opposite + 2) % 3];
  if (!is_cap)
    return propose_collapse_either_way(complex, cell, a, b, minimum_quality, cavity);
  return complex.is_interface(std::make_pair(cell, i))
             ? propose_interface_edge_flip(complex, cell, a, b, cavity)
             : propose_edge_removal(complex, cell, a, b, cavity);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a nearly flat cell, by where the vertex opposite to its largest facet projects
to. Pressed flat, the cell would become

- *three facets* around the vertex if it projects into the largest one: that facet is removed;
- *two facets* if it projects to an edge of the largest one, up to a tenth of the height of the
  facet: that edge is removed;
- *four facets* if it projects beyond an edge: this edge and the one opposite to it in the cell
  cross. One of them is removed, the one that leaves the better worst quality;
- a single one if it projects to a vertex, up to a tenth: the edge between the two is collapsed.

It projects nowhere else, as the facet is the largest one.

\param complex is not changed.
\param cell the cell.
\param threshold only cells of lower quality are considered; the paper takes 0.005. No new
       tetrahedron of a collapse is worse.
\param cavity filled with the proposal if there is one.
\return whether the cell is finite and nearly flat and `propose_multi_face_removal()`,
        `propose_edge_removal()` or `propose_edge_collapse()` proposes what is said above, or, where
        two facets of the cell on the edge are on the interface, `propose_interface_edge_flip()`.
        The interface keeps its topology. It stays as it is, or moves by the cell. Cells that change
        more are `propose_relabeling()`'s to judge.

As these. Section 3.2.1 of the paper, degeneracy removal (a).
*/
template <class Complex>
bool propose_degenerate_tetrahedron_removal(const Complex& complex,
                                            typename Complex::Cell_handle cell, double threshold,
                                            Cavity<Complex>& cavity) {
  using namespace internal;
  static constexpr double at_edge = .1;
  if (complex.is_infinite(cell) || !(cell->quality() < threshold))
    return false;

  const Facet_normals<Complex> normals(complex, cell);
  const int apex = normals.largest();
  // Vertices of the largest facet: the tip is opposite to an edge at or beyond which the apex
  // projects, the base is not.
  int tip = -1, base = -1, number_of_edges = 0;
  for (int i = 0; i < 4; ++i) {
    if (i == apex)
      continue;
    const double coordinate = normals.coordinate_of_projection(apex, i);
    if (coordinate > at_edge) {
      base = i;
    } else {
      tip = i;
      number_of_edges += coordinate >= -at_edge ? 1 : 0;
    }
  }
  if (number_of_edges == 2)
    return propose_collapse_either_way(complex, cell, apex, base, threshold, cavity);
  if (tip < 0)
    return propose_multi_face_removal(complex, cell, apex, cavity);

  std::array<int, 2> edge; // opposite to the tip in the largest facet
  int* end = edge.data();
  for (int i = 0; i < 4; ++i)
    if (i != apex && i != tip)
      *end++ = i;
  const bool proposed = propose_removal_from_flat_cell(complex, cell, edge[0], edge[1], cavity);
  if (number_of_edges == 1)
    return proposed;
  Cavity<Complex> other(complex);
  if (!propose_removal_from_flat_cell(complex, cell, tip, apex, other))
    return proposed;
  if (!proposed || other.quality_after() > cavity.quality_after())
    std::swap(cavity, other);
  return true;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEGENERACY_REMOVAL_3_H
