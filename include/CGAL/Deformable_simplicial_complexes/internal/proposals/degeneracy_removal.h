// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_DEGENERACY_REMOVAL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_DEGENERACY_REMOVAL_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/relabeling.h>

namespace CGAL::Deformable_simplicial_complexes {

template <class Complex>
bool propose_cap_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                      Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  const auto other = cell->neighbor(i);
  if (complex.is_infinite(other) || other->subdomain_index() == cell->subdomain_index() ||
      !cell->vertex(i)->is_interface() ||
      !relabeling_keeps_topology(complex, cell, other->subdomain_index()))
    return false;
  internal::plan_flip(cell, i, other, cavity);
  return cavity.quality_after() > cavity.quality_before() && cavity.is_positive();
}

template <class Complex>
bool propose_degenerate_triangle_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                         double cosine, double minimum_quality,
                                         Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  if (complex.is_infinite(cell))
    return false;
  std::array<double, 3> squared; // of the lengths of the edges opposite to the three vertices
  for (int i = 0; i < 3; ++i)
    squared[i] =
        complex.displacement(cell->vertex((i + 1) % 3), cell->vertex((i + 2) % 3)).squared_length();
  const int shortest = int(std::min_element(squared.begin(), squared.end()) - squared.begin()),
            longest = int(std::max_element(squared.begin(), squared.end()) - squared.begin());
  const auto cosine_at = [&](int i) {
    const double p = squared[(i + 1) % 3], q = squared[(i + 2) % 3];
    return (p + q - squared[i]) / (2 * std::sqrt(p * q));
  };
  if (!(cosine_at(shortest) > cosine))
    return false;
  return (cosine_at(longest) < 0 && (propose_edge_flip(complex, cell, longest, cavity) ||
                                     propose_cap_flip(complex, cell, longest, cavity))) ||
         internal::propose_collapse_either_way(complex, cell, (shortest + 1) % 3,
                                               (shortest + 2) % 3, minimum_quality, cavity);
}

// Degenerate simplices: edges of almost zero length, facets of almost zero area, and tetrahedra of
// almost zero volume ("degeneracy removal", section 3.2.1 of the paper). The paper splits an edge
// and collapses the new vertex into a vertex c of the ring. This is edge removal with a fan around
// c as the triangulation of the ring. Edge removal uses the best of all triangulations instead.

namespace internal {

// Proposes to remove an edge of a flat cell. If the interface bends around the cell at the edge, it
// may be moved to the other side of the cell.
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

template <class Complex>
bool propose_degenerate_facet_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                      int i, double cosine, double minimum_quality,
                                      Cavity<Complex>& cavity) {
  using namespace internal;
  static constexpr double cap_cosine = -.5, cap_ratio = 1.03;
  const std::array<int, 3> v = {(i + 1) % 4, (i + 2) % 4, (i + 3) % 4};
  std::array<double, 3> squared; // of the lengths of the edges opposite to the three vertices
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
  // Vertices of the largest facet: the apex projects to or beyond the edge opposite to the tip, but
  // not to or beyond the edge opposite to the base.
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

  std::array<int, 2> edge; // edge of the largest facet opposite to the tip
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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_DEGENERACY_REMOVAL_H
