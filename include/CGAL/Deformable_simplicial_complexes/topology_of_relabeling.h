// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_OF_RELABELING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_OF_RELABELING_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Faces that a cell shares with a set of other cells. A face is given by the set of its vertices,
// as bits.
template <int corners> class Trace_on_cell
{
public:
  static constexpr unsigned whole = (1u << corners) - 1; // the cell itself

  void add(unsigned vertices) { m_has[vertices] = true; }

  void add(const Trace_on_cell& other) {
    for (unsigned s = 1; s < whole; ++s)
      m_has[s] = m_has[s] || other.m_has[s];
  }

  // Returns whether the trace, completed with the faces of its simplices, is contractible. The test
  // is that it is connected and has the Euler characteristic 1. On a sphere, this excludes loops
  // and the whole sphere.
  bool is_contractible() const {
    std::array<bool, whole> has = m_has;
    for (unsigned s = whole - 1; s > 0; --s)
      for (unsigned t = s + 1; t < whole; ++t)
        has[s] = has[s] || (has[t] && (s & t) == s);
    int characteristic = 0;
    std::array<unsigned, corners> component; // vertices connected with each vertex
    unsigned vertices = 0;
    for (int i = 0; i < corners; ++i) {
      component[i] = 1u << i;
      vertices |= has[1u << i] ? 1u << i : 0u;
    }
    for (unsigned s = 1; s < whole; ++s)
      if (has[s]) {
        characteristic += dimension(s) % 2 == 1 ? -1 : 1;
        unsigned joined = 0;
        for (int i = 0; i < corners; ++i)
          joined |= (s >> i & 1) != 0 ? component[i] : 0;
        for (int i = 0; i < corners; ++i)
          if ((joined >> i & 1) != 0)
            component[i] = joined;
      }
    if (characteristic != 1)
      return false;
    for (int i = 0; i < corners; ++i)
      if ((vertices >> i & 1) != 0 && component[i] != vertices)
        return false;
    return true;
  }

private:
  static int dimension(unsigned vertices) {
    int result = -1;
    for (int i = 0; i < corners; ++i)
      result += int(vertices >> i & 1);
    return result;
  }

  std::array<bool, whole> m_has = {}; // for each proper face of the cell
};

// Returns whether relabeling a cell keeps the topology, see relabeling_keeps_topology(), with
// labels given by a function.
template <class Complex, class LabelOf>
bool keeps_topology(const Complex& complex, typename Complex::Cell_handle cell,
                    typename Complex::Label label, const LabelOf& label_of) {
  enum { of_old, of_new, of_all_but_old, of_all_but_new };
  std::array<Trace_on_cell<Complex::corners>, 4> traces;
  Trace_on_cell<Complex::corners> outside;
  std::vector<typename Complex::Cell_handle> star;
  for (int i = 0; i < Complex::corners; ++i) {
    complex.star(cell->vertex(i), star);
    for (auto c : star) {
      if (c == cell)
        continue;
      unsigned common = 0;
      for (int j = 0; j < Complex::corners; ++j)
        common |= c->has_vertex(cell->vertex(j)) ? 1u << j : 0;
      if (complex.is_infinite(c)) {
        outside.add(common);
        continue;
      }
      traces[label_of(c) == label_of(cell) ? of_old : of_all_but_old].add(common);
      traces[label_of(c) == label ? of_new : of_all_but_new].add(common);
    }
  }
  return std::all_of(traces.begin(), traces.end(), [&](auto& trace) {
    if (!trace.is_contractible())
      return false;
    trace.add(outside);
    return trace.is_contractible();
  });
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether giving a cell another label keeps the topology of the two labels, both for the union
of their closed cells and for its interior. The topology of the interface then also stays. All Betti
numbers stay the same; other labels are not affected. Linear in the stars of the vertices of the
cell.

Four sets change: the cell leaves the closed cells of its old label and joins those of the new
label; it joins the closed complement of the old label and leaves that of the new label. A set keeps
its homotopy type if the set without the cell meets the boundary of the cell in a contractible set.
This is the criterion for simple points in digital topology, applied to simplices. At the boundary
of the domain, the same must hold for the sets together with the outside.

\param complex the complex; it is not changed
\param cell a finite cell
\param label the new label, different from that of the cell
\return whether the topology stays. The result depends only on incidences. Changes that cancel each
        other count as changes, such as one part that is cut off while another one joins.
*/
template <class Complex>
bool relabeling_keeps_topology(const Complex& complex, typename Complex::Cell_handle cell,
                               typename Complex::Label label) {
  return internal::keeps_topology(complex, cell, label,
                                  [](typename Complex::Cell_handle c) { return c->label(); });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether several cells can get another label one after the other, so that each step keeps the
topology as defined above. Quadratic in the number of cells if the given order is valid, otherwise
cubic.

\param complex the complex; it is not changed
\param cells finite cells, each once
\param label the new label, different from those of the cells
\return whether an order was found. The search is greedy, without backtracking, so that it misses an
        order in rare cases; the result is then false although the topology would stay.
*/
template <class Complex>
bool relabeling_keeps_topology(const Complex& complex,
                               std::vector<typename Complex::Cell_handle> cells,
                               typename Complex::Label label) {
  using Cell_handle = typename Complex::Cell_handle;
  for (auto next = cells.begin(); next != cells.end(); ++next) {
    const auto label_of = [&](Cell_handle c) {
      return std::find(cells.begin(), next, c) != next ? label : c->label();
    };
    const auto keeping = std::find_if(next, cells.end(), [&](Cell_handle c) {
      return internal::keeps_topology(complex, c, label, label_of);
    });
    if (keeping == cells.end())
      return false;
    std::iter_swap(next, keeping);
  }
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_TOPOLOGY_OF_RELABELING_H
