// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_PATCH_IMPROVER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_PATCH_IMPROVER_3_H

#include <CGAL/Deformable_simplicial_complex_3/edge_collapse_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_split_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_improver_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/remeshing/Patch_3.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Patch_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Improves cells where no single operation helps any more: the surroundings of such a cell are
// copied, disturbed and improved again and again, and replaced whole once they have become better.
template <class Complex> class Patch_improver<Complex, 3>
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Vector = typename Complex::Approximate_vector_3;

  // Each improvement of a copy takes a number of rounds at the most.
  Patch_improver(Complex& complex, Any_visitor<Complex>& visitor, double threshold, unsigned rounds)
      : m_complex(complex), m_visitor(visitor), m_threshold(threshold),
        m_rounds((std::min)(rounds, 5u)), m_cavity(complex),
        m_copy(complex.geom_traits(), complex.quality_measure()), m_copy_cavity(m_copy) {}

  const Improvement_report& report() const { return m_report; }

  // Improves the surroundings of all cells below the threshold, worst ones first, in several
  // passes: large and small ones in turn; at first for what they lack to the threshold all in all,
  // then above all for what the worst ones lack.
  void run() {
    static constexpr int passes = 4;
    m_complex.update_components(); // a patch keeps the numbers of its parts
    for (double emphasis : {1., 3.}) {
      m_emphasis = emphasis;
      for (int pass = 0; pass < passes; ++pass)
        for (const Item& item : bad_cells())
          if (m_complex.is_alive(item.cell, item.time_stamp))
            improve_around(item.cell, pass % 2 == 0 ? 2 : 1);
    }
  }

private:
  struct Item
  {
    double quality;
    std::size_t time_stamp;
    Cell_handle cell;
  };

  std::vector<Item> bad_cells() const {
    std::vector<Item> result;
    for (Cell_handle c : m_complex.triangulation().finite_cell_handles())
      if (is_bad(m_complex, c))
        result.push_back({c->quality(), c->time_stamp(), c});
    std::sort(result.begin(), result.end(), [](const Item& a, const Item& b) {
      return std::make_pair(a.quality, a.time_stamp) < std::make_pair(b.quality, b.time_stamp);
    });
    return result;
  }

  bool is_bad(const Complex& complex, Cell_handle c) const {
    return c->quality() < m_threshold && !has_dictated_angle(complex, c);
  }

  // Improves a patch around the cell, or where that is no ball, around one of its vertices.
  void improve_around(Cell_handle c, int rings) {
    bool is_ball = improve_patch(cells_around({c}, rings));
    for (int i = 0; i < 4 && !is_ball; ++i) {
      const std::vector<Vertex_handle> center(1, c->vertex(i));
      is_ball = improve_patch(cells_around(sorted_star_union(m_complex, center), rings - 1));
    }
  }

  // Returns whether the cells are a ball: others are left as they are.
  bool improve_patch(const std::vector<Cell_handle>& cells) {
    static constexpr int tries = 10, attempts = 1;
    static constexpr double less = 1 - 1e-6; // than what rounding does
    Patch_3<Complex> patch(m_complex, cells);
    Any_visitor<Complex> nobody;
    double best = deficit(cells);
    const double worst = worst_quality(cells);
    bool is_better = false;
    for (int i = 0; i < tries; ++i) {
      if (!patch.copy_to(m_copy))
        return false;
      if (i > 0)
        disturb();
      Mesh_improver_3<Complex> improver(m_copy, nobody, m_threshold, true);
      improver.improve_all(m_threshold, m_rounds, attempts);
      const auto copied = m_copy.cells();
      const double now = deficit(copied);
      if (!(now < less * best) || worst_quality(copied) < worst)
        continue;
      best = now;
      is_better = true;
      patch.take(m_copy);
      if (std::none_of(copied.begin(), copied.end(),
                       [&](Cell_handle d) { return is_bad(m_copy, d); }))
        break;
    }
    if (is_better)
      commit(patch);
    return true;
  }

  // The cells and those around them, in a number of steps.
  std::vector<Cell_handle> cells_around(std::vector<Cell_handle> cells, int rings) const {
    for (int i = 0; i < rings; ++i)
      cells = sorted_star_union(m_complex, vertices_of(m_complex, cells));
    return cells;
  }

  // What cells lack to the threshold, the worst ones with an emphasis.
  double deficit(const std::vector<Cell_handle>& cells) const {
    double result = 0;
    for (Cell_handle c : cells)
      result += std::pow((std::max)(0., m_threshold - c->quality()), m_emphasis);
    return result;
  }

  static double worst_quality(const std::vector<Cell_handle>& cells) {
    double result = std::numeric_limits<double>::infinity();
    for (Cell_handle c : cells)
      result = (std::min)(result, c->quality());
    return result;
  }

  // One or two changes of the copy, for better or worse.
  void disturb() {
    const int changes = m_random.get_int(1, 3);
    for (int i = 0; i < changes; ++i)
      switch (m_random.get_int(0, 3)) {
      case 0:
        change_edge([&](Cell_handle c, int a, int b) {
          return !c->vertex(a)->is_interface() &&
                 propose_edge_collapse(m_copy, c, a, b, 0, m_copy_cavity);
        });
        break;
      case 1:
        change_edge([&](Cell_handle c, int a, int b) {
          return !m_copy.is_interface(typename Complex::Edge(c, a, b)) &&
                 propose_edge_split(m_copy, c, a, b, .5, m_copy_cavity) &&
                 m_copy_cavity.vertices().back().boundary_class == Boundary_class::inside;
        });
        break;
      default:
        move_vertices();
      }
  }

  template <class Propose> void change_edge(const Propose& propose) {
    static constexpr int tries = 8;
    const auto cells = m_copy.cells();
    for (int i = 0; i < tries; ++i) {
      const Cell_handle c = cells[m_random.get_int(0, int(cells.size()))];
      const int a = m_random.get_int(0, 4), b = (a + m_random.get_int(1, 4)) % 4;
      if (propose(c, a, b)) {
        m_copy.replace(m_copy_cavity);
        return;
      }
    }
  }

  // All free ones, by a part of their shortest edges.
  void move_vertices() {
    static constexpr double farthest = .4, nearest = .02;
    const auto exact = m_copy.geom_traits().construct_exact_point_3_object();
    for (Vertex_handle v : m_copy.vertices()) {
      if (v->is_interface() || m_copy.is_boundary(v))
        continue;
      m_copy.star(v, m_star);
      const auto p = m_copy.position(v);
      double shortest = std::numeric_limits<double>::infinity(); // squared
      for (Cell_handle c : m_star)
        for (int i = 0; i < 4; ++i)
          if (c->vertex(i) != v)
            shortest = (std::min)(shortest, (m_copy.position(c->vertex(i)) - p).squared_length());
      for (double part = farthest; part > nearest; part /= 2) {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        const auto q = exact(p + part * std::sqrt(shortest) * Vector(x, y, z));
        if (m_copy.is_positive_star(v, m_star, q)) {
          m_copy.set_point(v, m_star, q);
          break;
        }
      }
    }
  }

  double coordinate() { return m_random.get_double(-1, 1); }

  void commit(const Patch_3<Complex>& patch) {
    patch.propose(m_cavity);
    std::vector<bool> stays(m_cavity.vertices().size(), false), is_new(stays);
    for (const auto& t : m_cavity.tetrahedra())
      for (auto i : t.vertices)
        stays[i] = true;
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const auto& v = m_cavity.vertices()[i];
      if (v.handle == Vertex_handle()) {
        is_new[i] = true;
        ++m_report.inserted;
      } else if (!stays[i]) {
        m_visitor.before_collapse(v.handle, nearest_that_stays(v.handle, stays));
        ++m_report.collapsed;
      } else if (!is_unmoved(v)) {
        ++m_report.smoothed;
      }
    }
    replace_cavity(m_complex, m_cavity, m_visitor);
    for (std::size_t i = 0; i < is_new.size(); ++i)
      if (is_new[i])
        m_visitor.after_insertion(m_cavity.vertices()[i].handle);
    ++m_report.flipped;
    m_visitor.after_flip(m_cavity.created());
  }

  static bool is_unmoved(const typename Cavity_3<Complex>::Vertex& v) {
    return v.handle->point() == v.point;
  }

  Vertex_handle nearest_that_stays(Vertex_handle v, const std::vector<bool>& stays) const {
    Vertex_handle result;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const Vertex_handle w = m_cavity.vertices()[i].handle;
      if (!stays[i] || w == Vertex_handle() || !is_unmoved(m_cavity.vertices()[i]))
        continue;
      const double distance = (m_complex.position(w) - m_complex.position(v)).squared_length();
      if (distance < least) {
        least = distance;
        result = w;
      }
    }
    return result;
  }

  Complex& m_complex;
  Any_visitor<Complex>& m_visitor;
  double m_threshold, m_emphasis = 1;
  unsigned m_rounds;
  Cavity_3<Complex> m_cavity;
  Complex m_copy;
  Cavity_3<Complex> m_copy_cavity;
  Random m_random = Random(0);
  std::vector<Cell_handle> m_star;
  Improvement_report m_report;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_PATCH_IMPROVER_3_H
