// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_RETRIANGULATION_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_RETRIANGULATION_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Polygon_triangulation_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Sandwich_3.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The connected set of all facets sandwiched between the two apices of a given facet.
template <class Complex> class Whole_sandwich_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Sandwich = Sandwich_3<Complex>;
  using Sheet = typename Sandwich::Sheet;
  using Directed_edge = typename Sandwich::Directed_edge;
  using Cavity = Deformable_simplicial_complexes::Cavity<Complex>;
  using Index = typename Cavity::Index;

  Whole_sandwich_3(const Complex& complex, Cell_handle below, int i)
      : m_sandwich(complex, below, i) {}

  // Finds the facets. Returns whether there are at least two, and they form a disk with all
  // vertices on its boundary.
  bool grow() {
    m_sheets.push_back(m_sandwich.first());
    for (const Directed_edge& e : m_sandwich.edges_of_first())
      m_open.push_back({m_sandwich.first(), e});
    while (!m_open.empty()) {
      const auto [f, e] = m_open.back();
      m_open.pop_back();
      Sheet g;
      Vertex_handle apex;
      if (!m_sandwich.find_neighbor(f, e, g, apex)) {
        m_boundary.push_back(e);
      } else if (!contains(g)) {
        if (m_sheets.size() == maximum_number_of_sheets)
          return false;
        m_sheets.push_back(g);
        m_open.push_back({g, {e.source, apex}});
        m_open.push_back({g, {apex, e.target}});
      }
    }
    // The facets are part of the link of a, which is a sphere. One simple loop thus bounds a disk,
    // and Euler's formula tells whether there are vertices in its interior.
    return m_sheets.size() > 1 && m_boundary.size() == m_sheets.size() + 2 && find_loop();
  }

  // Plans the best triangulation of the loop in place of the facets. Returns false if the worst
  // quality would not rise.
  bool retriangulate(Cavity& cavity) const {
    // The vertices of the loop are added first, so that their indices are their positions in the
    // loop.
    for (Vertex_handle v : m_loop)
      cavity.add(v);
    const Index a = cavity.add(m_sandwich.a()), b = cavity.add(m_sandwich.b());
    double before = std::numeric_limits<double>::infinity();
    for (const Sheet& s : m_sheets) {
      cavity.remove(s.below);
      cavity.remove(s.above);
      // Qualities are computed with the vertex order of the new tetrahedra, so that a difference by
      // rounding does not count as an improvement.
      std::array<Index, 3> t;
      const int apex = s.below->index(m_sandwich.a());
      for (int k = 0; k < 3; ++k)
        t[k] = cavity.add(s.below->vertex((apex + 1 + k) % 4));
      std::sort(t.begin(), t.end());
      before = (std::min)(
          {before, cavity.quality({t[0], t[1], t[2], b}), cavity.quality({t[1], t[0], t[2], a})});
    }
    return Polygon_triangulation_3<Complex>(cavity, a, b)
        .create(
            m_loop.size(), [](std::size_t k) { return Index(k); },
            (std::max)(before, cavity.quality_before()), m_sandwich.first().below);
  }

private:
  static constexpr std::size_t maximum_number_of_sheets =
      Polygon_triangulation_3<Complex>::maximum_number_of_vertices - 2;

  bool contains(const Sheet& g) const {
    return std::any_of(m_sheets.begin(), m_sheets.end(),
                       [&](const Sheet& s) { return s.below == g.below; });
  }

  // Chains the edges of the boundary. Returns whether they form one simple loop.
  bool find_loop() {
    Vertex_handle v = m_boundary.front().source;
    do {
      m_loop.push_back(v);
      v = std::find_if(m_boundary.begin(), m_boundary.end(), [&](const Directed_edge& e) {
            return e.source == v;
          })->target;
    } while (v != m_loop.front() && m_loop.size() < m_boundary.size());
    return v == m_loop.front() && m_loop.size() == m_boundary.size();
  }

  struct Edge_of_sheet
  {
    Sheet sheet;
    Directed_edge edge;
  };

  template <class T> using Small_vector = boost::container::small_vector<T, 16>;
  Sandwich m_sandwich;
  Small_vector<Sheet> m_sheets;
  Small_vector<Edge_of_sheet> m_open;
  Small_vector<Directed_edge> m_boundary;
  Small_vector<Vertex_handle> m_loop; // counterclockwise seen from b
};

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to retriangulate the facets that are sandwiched between the same two vertices as a given
facet. The set is the largest one that is connected through edges inside one label. Its m facets are
replaced by the triangulation of its boundary loop that maximizes the worst quality (Klincsek's
dynamic program), so that 2m cells become 2m others. The operation combines multi-face removal and
removal of the new edge, and does not require that the mesh improves in between (Misztal,
Baerentzen, Anton and Erleben 2009). Cubic in m.

\param complex the complex; it is not changed
\param cell, i the facet
\param cavity filled with the proposal if there is one
\return whether the proposal is valid: the two cells of the facet are finite and of one label, and
        the set is a disk without inner vertices with at most 50 facets. The worst quality rises,
        and all new tetrahedra are positively oriented. The interface and the boundary of the domain
        are unchanged.
*/
template <class Complex>
bool propose_multi_face_retriangulation(const Complex& complex, typename Complex::Cell_handle cell,
                                        int i, Cavity<Complex>& cavity) {
  const typename Complex::Cell_handle mirror = cell->neighbor(i);
  if (complex.is_infinite(cell) || complex.is_infinite(mirror) || cell->label() != mirror->label())
    return false;
  internal::Whole_sandwich_3<Complex> sandwich(complex, cell, i);
  if (!sandwich.grow())
    return false;
  cavity.begin(Proposal_kind::flip);
  return sandwich.retriangulate(cavity) && cavity.is_positive();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_RETRIANGULATION_3_H
