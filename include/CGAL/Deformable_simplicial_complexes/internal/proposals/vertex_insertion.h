// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_INSERTION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_INSERTION_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Star_optimizer.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The best set of cells around a seed to be replaced by the star of a point p. The facets of the
// set are visible from p, and the worst quality of the cells that they form with p is highest.
//
// Consider a set that contains the present one and is better. It must contain the cell behind the
// worst facet of the present set. The cells behind the worst facets are therefore absorbed one
// after the other. Each of the sets is part of the best set until the best set is reached. No
// search is needed, nor the graph cut of Klingner and Shewchuk. The cell behind a blocked facet
// cannot be absorbed: it has another label, is outside or too far away, or would enclose a vertex.
// A blocked facet bounds all sets that contain the present one, so that only the worst of the other
// facets matters.
template <class Complex> class Star_shaped_set
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Complex::Point;
  using Planned = Cavity<Complex>;
  using Index = typename Planned::Index;

  // Constructs the search. `cavity` is used to number the vertices.
  Star_shaped_set(const Complex& complex, const Point& p, Planned& cavity)
      : m_complex(complex), m_cavity(cavity), m_p(cavity.add(p, Boundary_class::inside)) {}

  // Finds the best set of finite cells that contains the seed. Returns whether there is one.
  bool grow(Cell_handle seed) {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::size_t best_size = 0;
    std::pair<double, double> best(-infinity,
                                   -infinity); // of all facets, and of those not blocked
    absorb(seed, 0);
    for (;;) {
      Facet* worst = nullptr; // of the facets that are not blocked
      double open = infinity, blocked = infinity;
      for (Facet& f : m_facets) {
        if (f.quality >= (std::max)(open, blocked))
          continue;
        if (!may_be_passed(f, seed)) {
          blocked = (std::min)(blocked, f.quality);
        } else if (f.quality < open) {
          open = f.quality;
          worst = &f;
        }
      }
      const std::pair<double, double> now((std::min)(open, blocked), open);
      if (now > best) {
        best = now;
        best_size = m_cells.size();
      }
      if (!worst || blocked < best.first || m_cells.size() == maximum_size)
        break;
      absorb(worst->cell->neighbor(worst->index), worst->depth + 1);
    }
    m_cells.resize(best.first > -infinity ? best_size : 0);
    return !m_cells.empty();
  }

  const auto& cells() const { return m_cells; }

  // Calls visit(cell, index) for each facet of the boundary of the set.
  template <class Visit> void for_each_facet(const Visit& visit) const {
    for (Cell_handle c : m_cells)
      for (int i = 0; i < Complex::corners; ++i)
        if (!contains(c->neighbor(i)))
          visit(c, i);
  }

private:
  static constexpr std::size_t maximum_size = 64;
  static constexpr int maximum_depth = 6; // as in Stellar

  struct Facet
  {
    Cell_handle cell;
    int index;
    int depth;                                // steps from the seed to the cell
    typename Planned::Indices with_new_point; // cell with p in place of its vertex
    double quality;                           // -infinity if p is not inside, exactly
  };

  bool contains(Cell_handle c) const {
    return std::find(m_cells.begin(), m_cells.end(), c) != m_cells.end();
  }

  bool may_be_passed(const Facet& f, Cell_handle seed) const {
    const Cell_handle next = f.cell->neighbor(f.index);
    return f.depth < maximum_depth && !m_complex.is_infinite(next) &&
           next->subdomain_index() == seed->subdomain_index() && !encloses_vertex(next);
  }

  // Returns whether a vertex would have all its cells in the set if the cell joined it.
  bool encloses_vertex(Cell_handle c) const {
    for (int i = 0; i < Complex::corners; ++i) {
      bool is_open = false;
      for (int j = 0; j < Complex::corners; ++j)
        is_open = is_open || (j != i && !contains(c->neighbor(j)));
      for (const Facet& f : m_facets)
        is_open = is_open || (f.cell->neighbor(f.index) != c && f.cell->has_vertex(c->vertex(i)) &&
                              f.cell->vertex(f.index) != c->vertex(i));
      if (!is_open)
        return true;
    }
    return false;
  }

  void absorb(Cell_handle c, int depth) {
    m_cells.push_back(c);
    typename Planned::Indices vertices;
    for (int i = 0; i < Complex::corners; ++i)
      vertices[i] = m_cavity.add(c->vertex(i));
    for (int i = 0; i < Complex::corners; ++i) {
      const Cell_handle n = c->neighbor(i);
      const auto known = std::find_if(m_facets.begin(), m_facets.end(), [&](const Facet& f) {
        return f.cell == n && n->neighbor(f.index) == c;
      });
      if (known != m_facets.end()) {
        m_facets.erase(known);
        continue;
      }
      typename Planned::Indices t = vertices;
      t[i] = m_p;
      m_facets.push_back({c, i, depth, t, quality(t)});
    }
  }

  double quality(const typename Planned::Indices& t) const {
    return m_cavity.is_positive(t) ? m_cavity.quality(t) : -std::numeric_limits<double>::infinity();
  }

  const Complex& m_complex;
  Planned& m_cavity;
  Index m_p;
  boost::container::small_vector<Cell_handle, 16> m_cells; // in the order of absorption
  boost::container::small_vector<Facet, 40> m_facets;      // of the boundary of the set
};

// Fills a cavity with the best set for a vertex at p. Then moves the vertex and p to a local
// maximum of the worst quality of its star. Returns whether there is a set.
template <class Complex>
bool fill_with_star(const Complex& complex, typename Complex::Cell_handle seed,
                    typename Complex::Point& p, Cavity<Complex>& cavity) {
  using Cell_handle = typename Complex::Cell_handle;
  using Index = typename Cavity<Complex>::Index;
  cavity.begin(Proposal_kind::insertion);
  Star_shaped_set<Complex> set(complex, p, cavity);
  if (!set.grow(seed))
    return false;

  Star_optimizer<Complex> optimizer(complex.quality_measure(), p);
  set.for_each_facet([&](Cell_handle c, int i) {
    std::array<typename Complex::Point, Complex::corners> points;
    for (int k = 0; k < Complex::corners; ++k)
      points[k] = k == i ? p : complex.position_near(p, c->vertex(k));
    optimizer.add(points, i);
  });
  p = optimizer.run();

  cavity.begin(Proposal_kind::insertion);
  for (Cell_handle c : set.cells())
    cavity.remove(c);
  const Index inserted = cavity.add(p, Boundary_class::inside);
  set.for_each_facet([&](Cell_handle c, int i) {
    typename Cavity<Complex>::Indices t;
    for (int k = 0; k < Complex::corners; ++k)
      t[k] = k == i ? inserted : cavity.add(c->vertex(k));
    cavity.create(t, c);
  });
  return true;
}

} // namespace internal

template <class Complex>
bool propose_vertex_insertion(const Complex& complex, typename Complex::Cell_handle cell,
                              Deformable_simplicial_complexes::Cavity<Complex>& cavity) {
  static constexpr int maximum_number_of_rounds = 3;
  if (complex.is_infinite(cell))
    return false;
  auto p = internal::barycenter(complex, cell);

  double best = -std::numeric_limits<double>::infinity();
  Deformable_simplicial_complexes::Cavity<Complex> trial(complex);
  for (int round = 0; round < maximum_number_of_rounds; ++round) {
    if (!internal::fill_with_star(complex, cell, p, trial) || !(trial.quality_after() > best))
      break;
    best = trial.quality_after();
    std::swap(cavity, trial);
  }
  return best > cavity.quality_before() && cavity.is_positive();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_VERTEX_INSERTION_H
