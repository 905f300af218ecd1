// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_REMOVAL_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_REMOVAL_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Sandwich_3.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Search for the best set of sandwiched facets to be removed, by recursion over the edges of the
// set (Shewchuk). Across an edge, either the next facet joins the set, or the edge becomes part of
// the boundary of the set and is connected with the new edge ab.
template <class Complex> class Best_sandwich_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Sandwich = Sandwich_3<Complex>;
  using Sheet = typename Sandwich::Sheet;
  using Directed_edge = typename Sandwich::Directed_edge;
  template <class T> using Small_vector = boost::container::small_vector<T, 16>;

  Best_sandwich_3(const Complex& complex, Cell_handle below, int i)
      : m_complex(complex), m_sandwich(complex, below, i) {}

  // Finds the best set. Returns whether the worst quality rises.
  bool grow() {
    const Sheet& first = m_sandwich.first();
    m_sheets.push_back(first);
    m_tried.push_back(first);
    double after = infinity, before = worst(first);
    for (const Directed_edge& e : m_sandwich.edges_of_first()) {
      const Outcome outcome = across(first, e);
      after = (std::min)(after, outcome.after);
      before = (std::min)(before, outcome.before);
      if (!(after > 0))
        return false;
    }
    return after > before;
  }

  Vertex_handle a() const { return m_sandwich.a(); }
  Vertex_handle b() const { return m_sandwich.b(); }
  const Small_vector<Sheet>& sheets() const { return m_sheets; }
  // Returns the boundary of the set. Each edge gives the new cell (a, b, source, target).
  const Small_vector<Directed_edge>& boundary() const { return m_boundary; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::size_t maximum_number_of_sheets = 50; // as in Stellar; most need at most 5

  // Worst quality of the new cells behind an edge, and of the old cells behind it.
  struct Outcome
  {
    double after, before;
  };

  double worst(const Sheet& f) const { return (std::min)(f.below->quality(), f.above->quality()); }

  double new_quality(const Directed_edge& e) const {
    const std::array<Vertex_handle, 4> v = {a(), b(), e.source, e.target};
    return m_complex.domain().template apply<Complex>(
        m_complex.quality_measure(), [&](int i) { return m_complex.position(v[i]); });
  }

  Outcome across(const Sheet& f, const Directed_edge& e) {
    const double quality = new_quality(e);
    Sheet g;
    Vertex_handle apex;
    if (m_tried.size() < maximum_number_of_sheets && m_sandwich.find_neighbor(f, e, g, apex) &&
        !is_tried(g)) {
      const std::size_t sheets = m_sheets.size(), edges = m_boundary.size();
      m_sheets.push_back(g);
      m_tried.push_back(g);
      const Outcome left = across(g, {e.source, apex});
      const Outcome right = across(g, {apex, e.target});
      const Outcome both = {(std::min)(left.after, right.after),
                            (std::min)({left.before, right.before, worst(g)})};
      if (both.after > (std::min)(both.before, quality))
        return both;
      m_sheets.resize(sheets);
      m_boundary.resize(edges);
    }
    m_boundary.push_back(e);
    return {quality, infinity};
  }

  bool is_tried(const Sheet& g) const {
    return std::any_of(m_tried.begin(), m_tried.end(),
                       [&](const Sheet& s) { return s.below == g.below; });
  }

  const Complex& m_complex;
  Sandwich m_sandwich;
  Small_vector<Sheet> m_sheets;
  // each facet is tried once; otherwise, the search would be exponential
  Small_vector<Sheet> m_tried;
  Small_vector<Directed_edge> m_boundary;
};

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a facet together with neighboring facets that are sandwiched between the same two
vertices a and b (section 3.2.1 of the paper). If there are m facets, their 2m cells are replaced by
m + 2 cells that share the new edge ab. The 2-3 flip is the case m = 1. Shewchuk's recursion finds
the set of facets for which the worst quality rises most. Linear in m.

\param complex the complex; it is not changed
\param cell, i the facet
\param cavity filled with the proposal if there is one
\return whether the two cells of the facet are finite and of one label, the worst quality rises, and
        all new tetrahedra are positively oriented. The interface and the boundary of the domain are
        unchanged.
*/
template <class Complex>
bool propose_multi_face_removal(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                Cavity<Complex>& cavity) {
  const typename Complex::Cell_handle mirror = cell->neighbor(i);
  if (complex.is_infinite(cell) || complex.is_infinite(mirror) || cell->label() != mirror->label())
    return false;
  internal::Best_sandwich_3<Complex> sandwich(complex, cell, i);
  if (!sandwich.grow())
    return false;
  cavity.begin(Proposal_kind::flip);
  for (const auto& sheet : sandwich.sheets()) {
    cavity.remove(sheet.below);
    cavity.remove(sheet.above);
  }
  const auto a = cavity.add(sandwich.a()), b = cavity.add(sandwich.b());
  for (const auto& e : sandwich.boundary())
    cavity.create({a, b, cavity.add(e.source), cavity.add(e.target)}, cell);
  return cavity.quality_after() > cavity.quality_before() && cavity.is_positive();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MULTI_FACE_REMOVAL_3_H
