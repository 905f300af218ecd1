// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SMALL_ANGLE_REMOVER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SMALL_ANGLE_REMOVER_3_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_collapse_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Star_optimizer_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Work_list.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/swept_volume_3.h>
#include <CGAL/Deformable_simplicial_complex_3/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/multi_face_retriangulation_3.h>
#include <CGAL/Deformable_simplicial_complex_3/quality_measures_3.h>
#include <CGAL/Deformable_simplicial_complex_3/vertex_insertion_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Removes cells with a dihedral angle below a bound or above its supplement, by whatever raises the
// smallest sine of an angle most. What changes the interface comes last, and changes it by little.
template <class Complex, class Visitor> class Small_angle_remover_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;
  using Cells = Work_list<Cell_handle>;

  // The angle is in degrees. Only cells below the quality are looked at.
  Small_angle_remover_3(Complex& complex, Visitor& visitor, double angle, double quality_threshold)
      : m_complex(complex), m_visitor(visitor), m_bound(std::sin(angle * CGAL_PI / 180) / regular),
        m_quality_threshold(quality_threshold), m_cavity(complex), m_best(complex) {}

  const Improvement_report& report() const { return m_report; }
  std::size_t number_of_relocated() const { return m_relocated; }

  // Remembers where a vertex of the interface is before it moves.
  void remember(Vertex_handle v) { m_before.emplace(v->time_stamp(), m_complex.position(v)); }

  bool is_bad(Cell_handle c) const { return sine(c) < m_bound && !is_rigid(c); }

  std::vector<Cell_handle> bad_cells() const {
    std::vector<Cell_handle> result;
    for (Cell_handle c : m_complex.triangulation().finite_cell_handles())
      if (c->quality() < m_quality_threshold && is_bad(c))
        result.push_back(c);
    return result;
  }

  // relabel(c, label) gives a cell another label if that keeps the topology, and says whether it
  // did.
  template <class Relabel> void run(const Relabel& relabel) {
    static constexpr unsigned rounds = 10;
    static constexpr int attempts = 6;
    static constexpr double higher = 1.3;
    Cells stuck;
    const auto work = [&](Cell_handle c, Cells& touched) {
      if (is_bad(c) && !improve(c, relabel, touched))
        stuck.push(c);
    };
    Cells cells;
    for (Cell_handle c : bad_cells())
      cells.push(c);
    work_in_rounds(m_complex, std::move(cells), rounds, work);
    // Those that stay are often held by neighbors that are but a little better.
    const double bound = m_bound;
    for (int i = 1; i <= attempts && !stuck.empty(); ++i) {
      m_bound = bound;
      cells = stars_of_bad(stuck);
      stuck.clear();
      m_bound = bound * std::pow(higher, i);
      work_in_rounds(m_complex, std::move(cells), rounds, work);
    }
    m_bound = bound;
  }

private:
  using Position = typename Complex::Approximate_point_3;

  // The smallest sine of a dihedral angle, over that of the regular tetrahedron.
  double sine(Cell_handle c) const {
    const auto p = [&](int i) { return m_complex.position(c->vertex(i)); };
    return m_sine(p(0), p(1), p(2), p(3));
  }

  // Whether a cell has edges between vertices of the interface, all as long as before the motion:
  // what moves as a whole keeps its interface.
  bool is_rigid(Cell_handle c) const {
    static constexpr double same = 1e-6;
    bool has_edge = false;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const Vertex_handle v = c->vertex(i), w = c->vertex(j);
        if (!v->is_interface() || !w->is_interface())
          continue;
        has_edge = true;
        const double before = (position_before(v) - position_before(w)).squared_length(),
                     now = (m_complex.position(v) - m_complex.position(w)).squared_length();
        if (std::abs(now - before) > same * before)
          return false;
      }
    return has_edge;
  }

  Position position_before(Vertex_handle v) const {
    const auto known = m_before.find(v->time_stamp());
    return known == m_before.end() ? m_complex.position(v) : known->second;
  }

  bool has_moved(Vertex_handle v) const { return m_before.count(v->time_stamp()) != 0; }

  // The cells around those that are still there and bad.
  Cells stars_of_bad(const Cells& cells) const {
    Cells result;
    std::vector<Cell_handle> star;
    for (const auto& item : cells) {
      if (!m_complex.is_alive(item.cell, item.time_stamp) || !is_bad(item.cell))
        continue;
      for (int i = 0; i < 4; ++i) {
        m_complex.star(item.cell->vertex(i), star);
        for (Cell_handle c : star)
          if (!m_complex.is_infinite(c))
            result.push(c);
      }
    }
    return result;
  }

  template <class Relabel> bool improve(Cell_handle c, const Relabel& relabel, Cells& touched) {
    find_best_proposal(c);
    if (m_best_sine < m_bound && relabel_fold(c, relabel, touched))
      return true;
    if (!m_best.removed().empty()) {
      commit_proposal(m_complex, m_best, m_visitor, m_report);
      touch(m_best.created(), touched);
      return true;
    }
    return move_vertex(
               c, [](Vertex_handle v) { return !v->is_interface(); }, touched) ||
           move_vertex(
               c, [&](Vertex_handle v) { return v->is_interface() && has_moved(v); }, touched);
  }

  // Leaves the best proposal in m_best, which is empty if there is none.
  void find_best_proposal(Cell_handle c) {
    m_best.clear();
    m_best_sine = better * sine(c);
    for (int i = 0; i < 4; ++i)
      consider(propose_multi_face_removal(m_complex, c, i, m_cavity));
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        consider(propose_edge_removal(m_complex, c, i, j, m_cavity));
    for (int i = 0; i < 4 && m_best_sine < m_bound; ++i)
      consider(propose_multi_face_retriangulation(m_complex, c, i, m_cavity));
    if (m_best_sine < m_bound)
      consider_collapses(c, false);
    if (m_best_sine < m_bound)
      consider(propose_vertex_insertion(m_complex, c, m_cavity));
    if (m_best_sine < m_bound) {
      consider_interface_flips(c);
      consider_collapses(c, true);
    }
  }

  void consider_interface_flips(Cell_handle c) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        consider(m_complex.is_interface(typename Complex::Edge(c, i, j)) &&
                 propose_interface_edge_flip(m_complex, c, i, j, m_cavity));
  }

  // Of vertices of the interface that have moved, or of those off it.
  void consider_collapses(Cell_handle c, bool of_interface) {
    static constexpr double least = .1; // of the cube of a mean edge
    const double edge = m_complex.mean_interface_edge();
    for (int i = 0; i < 4; ++i) {
      const Vertex_handle v = c->vertex(i);
      if (v->is_interface() != of_interface || (of_interface && !has_moved(v)))
        continue;
      for (int j = 0; j < 4; ++j)
        consider(j != i && propose_edge_collapse(m_complex, c, i, j, 0, m_cavity) &&
                 (!of_interface || swept_volume(m_complex, m_cavity) < least * edge * edge * edge));
    }
  }

  // Keeps the proposal in m_cavity, if there is one, if it is the best so far.
  void consider(bool is_proposed) {
    if (!is_proposed)
      return;
    double before = std::numeric_limits<double>::infinity(), after = before;
    for (Cell_handle c : m_cavity.removed())
      if (!m_complex.is_infinite(c))
        before = (std::min)(before, sine(c));
    for (const auto& t : m_cavity.tetrahedra()) {
      const auto vertex = [&](int i) { return m_cavity.vertices()[t.vertices[i]]; };
      if (t.quality < std::numeric_limits<double>::infinity()) // all vertices are finite
        after = (std::min)(after, m_sine(vertex(0).position, vertex(1).position, vertex(2).position,
                                         vertex(3).position));
    }
    if (after > better * before && after > m_best_sine) {
      m_best_sine = after;
      std::swap(m_best, m_cavity);
    }
  }

  // Gives a cell that lies in a fold of the interface to the phase beyond, if the area hardly
  // grows.
  template <class Relabel>
  bool relabel_fold(Cell_handle c, const Relabel& relabel, Cells& touched) {
    static constexpr double growth = 1.05;
    for (int i = 0; i < 4; ++i) {
      if (!m_complex.is_interface(std::make_pair(c, i)))
        continue;
      const Label label = c->neighbor(i)->label();
      double before = 0, after = 0;
      bool is_inside = true;
      for (int k = 0; k < 4; ++k) {
        is_inside = is_inside && !m_complex.is_infinite(c->neighbor(k));
        const Label other = c->neighbor(k)->label();
        const double area = m_complex.area(std::make_pair(c, k));
        before += other == label ? area : 0;
        after += other == c->label() ? area : 0;
      }
      if (!is_inside || !(after < growth * before) || !relabel(c, label))
        continue;
      touched.push(c);
      for (int k = 0; k < 4; ++k)
        touched.push(c->neighbor(k));
      return true;
    }
    return false;
  }

  // Moves one of the vertices for which may_move(v) to where the angles around it are best: the one
  // for which they become best. A vertex of the interface goes a short way at the most.
  template <class MayMove>
  bool move_vertex(Cell_handle c, const MayMove& may_move, Cells& touched) {
    static constexpr double better_star = 1.05, longest_way = .05; // of a mean edge
    double best = better_star * sine(c);
    Vertex_handle moving;
    typename Complex::Point_3 target;
    for (int i = 0; i < 4; ++i) {
      const Vertex_handle v = c->vertex(i);
      if (m_complex.is_boundary(v) || !may_move(v))
        continue;
      m_complex.star(v, m_star);
      const Position from = m_complex.position(v);
      Star_optimizer_3<Complex, Minimum_sine_3> optimizer(m_sine, from);
      for (Cell_handle d : m_star) {
        std::array<Position, 4> points;
        for (int k = 0; k < 4; ++k)
          points[k] = m_complex.position(d->vertex(k));
        optimizer.add(points, d->index(v));
      }
      auto way = optimizer.run() - from;
      const double length = std::sqrt(way.squared_length()),
                   bound = longest_way * m_complex.mean_interface_edge();
      if (v->is_interface() && length > bound)
        way = bound / length * way;
      const auto p = m_complex.geom_traits().construct_exact_point_3_object()(from + way);
      const double after = worst_sine(v, from + way);
      if (after > best && after > better_star * worst_sine(v, from) &&
          m_complex.is_positive_star(v, m_star, p)) {
        best = after;
        moving = v;
        target = p;
      }
    }
    if (moving == Vertex_handle())
      return false;
    m_complex.star(moving, m_star);
    m_complex.set_point(moving, m_star, target);
    ++(moving->is_interface() ? m_relocated : m_report.smoothed);
    touch(m_star, touched);
    return true;
  }

  // Of the star m_star if its vertex were at p.
  double worst_sine(Vertex_handle v, const Position& p) const {
    double worst = std::numeric_limits<double>::infinity();
    for (Cell_handle c : m_star) {
      const auto point = [&](int i) {
        return c->vertex(i) == v ? p : m_complex.position(c->vertex(i));
      };
      worst = (std::min)(worst, m_sine(point(0), point(1), point(2), point(3)));
    }
    return worst;
  }

  void touch(const std::vector<Cell_handle>& cells, Cells& touched) const {
    for (Cell_handle c : cells)
      if (!m_complex.is_infinite(c))
        touched.push(c);
  }

  static constexpr double regular = 0.94280904158206337; // sine of the angle of a regular one
  static constexpr double better = 1.1;                  // factor that makes a change worth it

  Complex& m_complex;
  Visitor& m_visitor;
  Minimum_sine_3 m_sine;
  double m_bound, m_quality_threshold;
  Cavity_3<Complex> m_cavity, m_best;
  double m_best_sine = 0;
  std::unordered_map<std::size_t, Position> m_before; // of vertices that moved, by time stamp
  std::vector<Cell_handle> m_star;
  Improvement_report m_report;
  std::size_t m_relocated = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SMALL_ANGLE_REMOVER_3_H
