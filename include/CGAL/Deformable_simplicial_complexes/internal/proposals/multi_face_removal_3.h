// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_MULTI_FACE_REMOVAL_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_MULTI_FACE_REMOVAL_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Polygon_triangulation_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// A set of facets that are sandwiched between two vertices a and b: each facet has a cell with a
// below it and a cell with b above it. The first facet determines a and b. Derived classes find the
// set.
template <class Complex> class Sandwich_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;

  struct Sheet
  {
    Cell_handle below, above; // the cells at a facet
  };
  struct Directed_edge
  {
    Vertex_handle source, target; // the facet is on the left, seen from b
  };

  template <class T> using Small_vector = boost::container::small_vector<T, 16>;

  Sandwich_3(const Complex& complex, Cell_handle below, int i)
      : m_complex(complex), m_first{below, below->neighbor(i)}, m_a(below->vertex(i)),
        m_b(m_first.above->vertex(m_first.above->index(below))) {}

  Vertex_handle a() const { return m_a; }
  Vertex_handle b() const { return m_b; }
  const Small_vector<Sheet>& sheets() const { return m_sheets; }
  // Returns the boundary of the set.
  const Small_vector<Directed_edge>& boundary() const { return m_boundary; }

protected:
  // Returns whether the cells at the first facet are finite and of one label.
  bool is_inside_label() const {
    return !m_complex.is_infinite(m_first.below) && !m_complex.is_infinite(m_first.above) &&
           m_first.below->subdomain_index() == m_first.above->subdomain_index();
  }

  std::array<Directed_edge, 3> edges_of_first() const {
    const auto v = m_complex.facet_vertices({m_first.below, m_first.below->index(m_a)});
    return {{{v[0], v[1]}, {v[1], v[2]}, {v[2], v[0]}}};
  }

  // Finds the sandwiched facet g on the other side of the edge e of f. It exists if the four cells
  // around e are the two cells of f and the two cells of g, all with the same label. `apex` becomes
  // the third vertex of g.
  bool find_neighbor(const Sheet& f, const Directed_edge& e, Sheet& g, Vertex_handle& apex) const {
    const auto opposite = [&](Cell_handle c, Vertex_handle tip) {
      return 6 - c->index(e.source) - c->index(e.target) - c->index(tip);
    };
    const int below = opposite(f.below, m_a), above = opposite(f.above, m_b);
    g = {f.below->neighbor(below), f.above->neighbor(above)};
    if (m_complex.is_infinite(g.below) || m_complex.is_infinite(g.above) ||
        g.below->subdomain_index() != f.below->subdomain_index() ||
        g.above->subdomain_index() != f.below->subdomain_index())
      return false;
    const int below_tip = opposite(g.below, m_a);
    apex = g.below->vertex(below_tip);
    return apex != m_b && g.below->neighbor(g.below->index(m_a)) == g.above;
  }

  static bool contains(const Small_vector<Sheet>& sheets, const Sheet& g) {
    return std::any_of(sheets.begin(), sheets.end(),
                       [&](const Sheet& s) { return s.below == g.below; });
  }

  const Complex& m_complex;
  Sheet m_first;
  Vertex_handle m_a, m_b;
  Small_vector<Sheet> m_sheets;
  Small_vector<Directed_edge> m_boundary;
};

// Search for the best set of sandwiched facets to be removed, by recursion over the edges of the
// set (Shewchuk). Across an edge, either the next facet joins the set, or the edge becomes part of
// the boundary of the set and is connected with the new edge ab. Each edge of the boundary thus
// gives the new cell (a, b, source, target).
template <class Complex> class Best_sandwich_3 : public Sandwich_3<Complex>
{
  using Base = Sandwich_3<Complex>;

public:
  using Base::Base;
  using typename Base::Directed_edge;
  using typename Base::Sheet;
  using typename Base::Vertex_handle;

  // Finds the best set. Returns whether the worst quality rises.
  bool grow() {
    if (!this->is_inside_label())
      return false;
    const Sheet& first = this->m_first;
    m_sheets.push_back(first);
    m_tried.push_back(first);
    double after = infinity, before = worst(first);
    for (const Directed_edge& e : this->edges_of_first()) {
      const Outcome outcome = across(first, e);
      after = (std::min)(after, outcome.after);
      before = (std::min)(before, outcome.before);
      if (!(after > 0))
        return false;
    }
    return after > before;
  }

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
    const std::array<Vertex_handle, 4> v = {this->m_a, this->m_b, e.source, e.target};
    return this->m_complex.domain().template apply<Complex>(
        this->m_complex.quality_measure(), [&](int i) { return this->m_complex.position(v[i]); });
  }

  Outcome across(const Sheet& f, const Directed_edge& e) {
    const double quality = new_quality(e);
    Sheet g;
    Vertex_handle apex;
    if (m_tried.size() < maximum_number_of_sheets && this->find_neighbor(f, e, g, apex) &&
        !Base::contains(m_tried, g)) {
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

  using Base::m_boundary;
  using Base::m_sheets;
  // each facet is tried once; otherwise, the search would be exponential
  typename Base::template Small_vector<Sheet> m_tried;
};

} // namespace internal

template <class Complex>
bool propose_multi_face_removal(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                Cavity<Complex>& cavity) {
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

namespace internal {

// The connected set of all facets sandwiched between the two apices of a given facet.
template <class Complex> class Whole_sandwich_3 : public Sandwich_3<Complex>
{
  using Base = Sandwich_3<Complex>;

public:
  using Base::Base;
  using typename Base::Directed_edge;
  using typename Base::Sheet;
  using typename Base::Vertex_handle;
  using Cavity = Deformable_simplicial_complexes::Cavity<Complex>;
  using Index = typename Cavity::Index;

  // Finds the facets. Returns whether there are at least two, and they form a disk with all
  // vertices on its boundary.
  bool grow() {
    if (!this->is_inside_label())
      return false;
    m_sheets.push_back(this->m_first);
    for (const Directed_edge& e : this->edges_of_first())
      m_open.push_back({this->m_first, e});
    while (!m_open.empty()) {
      const auto [f, e] = m_open.back();
      m_open.pop_back();
      Sheet g;
      Vertex_handle apex;
      if (!this->find_neighbor(f, e, g, apex)) {
        m_boundary.push_back(e);
      } else if (!Base::contains(m_sheets, g)) {
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
    const Index a = cavity.add(this->m_a), b = cavity.add(this->m_b);
    double before = std::numeric_limits<double>::infinity();
    for (const Sheet& s : m_sheets) {
      cavity.remove(s.below);
      cavity.remove(s.above);
      // Qualities are computed with the vertex order of the new tetrahedra, so that a difference by
      // rounding does not count as an improvement.
      std::array<Index, 3> t;
      const int apex = s.below->index(this->m_a);
      for (int k = 0; k < 3; ++k)
        t[k] = cavity.add(s.below->vertex((apex + 1 + k) % 4));
      std::sort(t.begin(), t.end());
      before = (std::min)(
          {before, cavity.quality({t[0], t[1], t[2], b}), cavity.quality({t[1], t[0], t[2], a})});
    }
    return Polygon_triangulation_3<Complex>(cavity, a, b)
        .create(
            m_loop.size(), [](std::size_t k) { return Index(k); },
            (std::max)(before, cavity.quality_before()), this->m_first.below);
  }

private:
  static constexpr std::size_t maximum_number_of_sheets =
      Polygon_triangulation_3<Complex>::maximum_number_of_vertices - 2;

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

  using Base::m_boundary;
  using Base::m_sheets;
  typename Base::template Small_vector<Edge_of_sheet> m_open;
  typename Base::template Small_vector<Vertex_handle> m_loop; // counterclockwise seen from b
};

} // namespace internal

template <class Complex>
bool propose_multi_face_retriangulation(const Complex& complex, typename Complex::Cell_handle cell,
                                        int i, Cavity<Complex>& cavity) {
  internal::Whole_sandwich_3<Complex> sandwich(complex, cell, i);
  if (!sandwich.grow())
    return false;
  cavity.begin(Proposal_kind::flip);
  return sandwich.retriangulate(cavity) && cavity.is_positive();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_MULTI_FACE_REMOVAL_3_H
