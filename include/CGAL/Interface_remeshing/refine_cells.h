// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_REFINE_CELLS_H
#define CGAL_INTERFACE_REMESHING_REFINE_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <tuple>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

// An edge of a cell, with a total order: by length, then by the time stamps of its ends.
template <class Complex> struct Cell_edge
{
  typename Complex::Cell_handle cell;
  int i, j;
  std::tuple<double, std::size_t, std::size_t> rank;
};

template <class Complex>
Cell_edge<Complex> longest_edge(const Complex& complex, typename Complex::Cell_handle cell) {
  Cell_edge<Complex> result = {cell, 0, 1, {-1, 0, 0}};
  for (int i = 0; i < Complex::corners; ++i)
    for (int j = i + 1; j < Complex::corners; ++j) {
      const auto v = cell->vertex(i), w = cell->vertex(j);
      // The vector must not depend on the cell.
      const bool in_order = v->time_stamp() < w->time_stamp();
      const auto a = in_order ? v : w, b = in_order ? w : v;
      const std::tuple<double, std::size_t, std::size_t> rank(
          complex.displacement(a, b).squared_length(), a->time_stamp(), b->time_stamp());
      if (rank > result.rank)
        result = {cell, i, j, rank};
    }
  return result;
}

// Returns the edge that must be split before a cell can be bisected: the longest edge of the cell
// or, as long as a cell at this edge has a longer one, that edge.
template <class Complex>
Cell_edge<Complex> terminal_edge(const Complex& complex, typename Complex::Cell_handle cell) {
  std::vector<typename Complex::Cell_handle> around;
  auto result = longest_edge(complex, cell);
  for (bool is_terminal = false; !is_terminal;) { // ends, because the rank increases
    is_terminal = true;
    around.clear();
    Complex::Space::cells_around_edge(complex.triangulation(), result.cell, result.i, result.j,
                                      around);
    for (auto c : around)
      if (!complex.is_infinite(c))
        if (const auto other = longest_edge(complex, c); other.rank > result.rank) {
          result = other;
          is_terminal = false;
        }
  }
  return result;
}

// Splits the terminal edge of a cell in the middle. Returns whether the split is admissible.
template <class Complex>
bool split_terminal_edge(Complex& complex, typename Complex::Cell_handle cell,
                         Cavity<Complex>& cavity, Deformation_visitor<Complex>& visitor,
                         Improvement_report& report) {
  const auto edge = terminal_edge(complex, cell);
  const auto v = edge.cell->vertex(edge.i), w = edge.cell->vertex(edge.j);
  if (!propose_edge_split(complex, edge.cell, edge.i, edge.j, .5, cavity))
    return false;
  commit_split(complex, cavity, v, w, visitor, report);
  return true;
}

// Bisects cells until the edges at a vertex are short enough. Returns the number of splits. Linear
// in the number of cells at the vertex and at split edges.
template <class Complex>
std::size_t refine_around(Complex& complex, typename Complex::Vertex_handle vertex, double longest,
                          Deformation_visitor<Complex>& visitor) {
  static constexpr std::size_t most = 1000; // splits; a hundred halve an edge thirty times
  const auto is_coarse = [&](typename Complex::Cell_handle c) {
    if (complex.is_infinite(c))
      return false;
    for (int i = 0; i < Complex::corners; ++i)
      if (Complex::Space::length(complex.displacement(vertex, c->vertex(i))) > longest)
        return true;
    return false;
  };
  Cavity<Complex> cavity(complex);
  Improvement_report report;
  std::vector<typename Complex::Cell_handle> star;
  while (report.split < most) {
    star.clear();
    complex.star(vertex, star);
    const auto cell = std::find_if(star.begin(), star.end(), is_coarse);
    if (cell == star.end() || !split_terminal_edge(complex, *cell, cavity, visitor, report))
      break;
  }
  return report.split;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Bisects selected cells at the midpoints of their longest edges. If a cell at such an edge has a
longer edge, that one is split first, and so on, so that cells keep their shape (longest-edge
bisection). The interface moves only by the rounding of midpoints, and labels stay. A cell stays if
a split would violate `Complex::keeps_quality()`. Use `control_detail()` to coarsen cells.

n log n in the number of cells, plus the cells around split edges. Usually, a few splits are needed
for each selected cell.

\param complex the complex
\param selects `selects(c)` returns whether a finite cell is to be bisected. It is called once for
       each cell that exists at the beginning, unless the cell was divided before.
\param visitor visitor of the changes; none if null
\return the number of splits
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`. After an exception,
        also one of `selects` or of the visitor, the complex is valid.

Source: M.-C. Rivara, *New longest-edge algorithms for the refinement and/or improvement of
unstructured triangulations*, 1997.
*/
template <class Complex, class Selects>
std::size_t refine_cells(Complex& complex, const Selects& selects,
                         Deformation_visitor<Complex>* visitor = nullptr) {
  Deformation_visitor<Complex> none;
  Cavity<Complex> cavity(complex);
  Improvement_report report;
  std::vector<std::pair<typename Complex::Cell_handle, std::size_t>> cells;
  for (auto c : complex.cells())
    cells.emplace_back(c, c->time_stamp());
  for (const auto& [cell, time_stamp] : cells) {
    Progress_scope::check();
    if (!complex.is_alive(cell, time_stamp) || !selects(cell))
      continue;
    while (complex.is_alive(cell, time_stamp))
      if (!internal::split_terminal_edge(complex, cell, cavity, visitor ? *visitor : none, report))
        break;
  }
  return report.split;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_REFINE_CELLS_H
