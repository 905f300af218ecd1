// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Changed_facets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Star_optimizer.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_insertion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_smoothing.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Mesh_support/For_each_index.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A motion must reduce a small angle to less than this part before the interface changes to remove
// it. So needles of the input that keep their shape stay.
inline constexpr double reduction_of_angles = .9;

// A function object that removes cells with a dihedral angle below a bound, or above its
// supplement. For each cell, it chooses the operation that maximizes the smallest sine of a
// dihedral angle. Operations that change the interface are tried last, and their changes of the
// interface are bounded.
template <class Complex> class Small_angle_remover_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;
  using Cells = Work_list<Cell_handle>;

  // Creates a remover. `angle` is the bound in degrees.
  Small_angle_remover_3(Complex& complex, Deformation_visitor<Complex>& visitor,
                        const Destinations<Complex>& destinations,
                        const Rigid_components<Complex>& rigid_components, double angle,
                        double quality_threshold, const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor), m_destinations(destinations),
        m_rigid_components(rigid_components), m_for_each_index(for_each_index),
        m_target(std::sin(angle * CGAL_PI / 180) / sine_of_regular), m_bound(m_target),
        m_quality_threshold(quality_threshold), m_tolerance(complex, nullptr, true),
        m_cavity(complex), m_best(complex) {}

  const Improvement_report& report() const { return m_report; }
  std::size_t number_of_relocated() const { return m_homes.size(); }

  // Returns whether a cell has small angles, did not move rigidly, and has no recorded failure. A
  // recorded failure is ignored if the interface may change for the cell, because the allowed
  // change varies.
  bool is_bad(Cell_handle c) const {
    return sine(c) < m_bound && !m_rigid_components.has_moved_as_a_whole(c) &&
           !(is_exhausted(c, to_remove_small_angles) && !may_change_interface(c));
  }

  // Returns the bad cells below the quality threshold, see `Rigid_components::cells_not_stayed()`.
  Cells bad_cells() const {
    return m_rigid_components.cells_not_stayed(
        m_quality_threshold, [&](Cell_handle c) { return is_bad(c); }, m_for_each_index);
  }

  // Removes small angles. `relabel(c, label)` changes the label of a cell if this preserves the
  // topology, and returns whether it did.
  template <class Relabel> void run(const Relabel& relabel) {
    static constexpr unsigned rounds = 10;
    static constexpr int attempts = 6;
    static constexpr double higher = 1.3;
    std::size_t improved = 0;
    const auto work = [&](Cell_handle c, Cells& touched) {
      if (!is_bad(c))
        return;
      if (improve(c, relabel, touched))
        ++improved;
      else
        set_exhausted(c, to_remove_small_angles);
    };
    Cells cells = bad_cells();
    m_handled = cells;
    work_in_rounds(m_complex, std::move(cells), rounds, work);
    // The remaining cells often have neighbors that are only slightly better; these are improved,
    // too.
    for (int i = 1; i <= attempts; ++i) {
      cells = stars_of_stuck();
      if (cells.empty())
        break;
      const std::size_t before = improved;
      m_bound = m_target * std::pow(higher, i);
      work_in_rounds(m_complex, std::move(cells), rounds, work);
      m_bound = m_target;
      if (improved == before)
        break;
    }
    keep_from_improvement();
  }

private:
  using Position = typename Complex::Point_3;

  // Returns the smallest sine of a dihedral angle of a cell with given corners, relative to the
  // sine for the regular tetrahedron.
  template <class Corner> double sine_of(const Corner& corner) const {
    // Negative values are caused only by rounding.
    return (std::max)(0., m_complex.domain().template apply<Complex>(m_sine, corner));
  }

  double sine(Cell_handle c) const {
    return sine_of([&](int i) { return m_complex.position(c->vertex(i)); });
  }

  // Returns whether a cell has small angles that are not determined by a region of the interface
  // that did not move or moved rigidly.
  bool is_to_be_removed(Cell_handle c) const {
    return sine(c) < m_bound && !m_rigid_components.has_stayed(c) &&
           !m_rigid_components.touches_rigid_component(c);
  }

  // Returns whether the interface may change to improve a cell. Flat cells that were as flat before
  // the motion are kept.
  bool may_change_interface(Cell_handle c) const {
    return touches_interface(c) && is_to_be_removed(c) &&
           sine(c) < reduction_of_angles * sine_of([&](int i) {
                       return m_destinations.position_before(c->vertex(i));
                     });
  }

  static bool touches_interface(Cell_handle c) {
    return c->vertex(0)->is_interface() || c->vertex(1)->is_interface() ||
           c->vertex(2)->is_interface() || c->vertex(3)->is_interface();
  }

  // Returns the cells around all processed cells whose small angles remain.
  Cells stars_of_stuck() {
    std::vector<Cell_handle> stuck;
    m_handled.sort();
    for (const auto& item : m_handled)
      if (m_complex.is_alive(item.cell, item.time_stamp) && is_to_be_removed(item.cell))
        stuck.push_back(item.cell);
    Cells result;
    for (Cell_handle c : star_union(m_complex, vertices_of(m_complex, stuck)))
      result.push(c);
    return result;
  }

  // Improves a cell. Returns whether an operation was applied.
  template <class Relabel> bool improve(Cell_handle c, const Relabel& relabel, Cells& touched) {
    const auto is_free = [](Vertex_handle v) { return !v->is_interface(); };
    const bool may_change = may_change_interface(c);
    find_best_proposal(c);
    if (!is_enough() && move_vertex(c, is_free, m_bound, touched))
      return true;
    if (!is_enough() && may_change) {
      consider_interface_flips(c);
      consider_collapses(c, true);
      if (!is_enough() && relabel_fold(c, relabel, touched))
        return true;
    }
    if (!m_best.removed().empty()) {
      if (m_tolerance.allows(m_best, slack()))
        m_tolerance.record();
      commit_proposal(m_complex, m_best, m_visitor, m_report);
      touch(m_best.created(), touched);
      return true;
    }
    return move_vertex(c, is_free, 0, touched) ||
           (may_change &&
            move_vertex(
                c, [&](Vertex_handle v) { return m_rigid_components.has_moved(v); }, 0, touched));
  }

  // Returns whether the best proposal leaves no angle below the bound.
  bool is_enough() const { return m_best_sine >= m_bound; }

  // Stores the best proposal that preserves the interface in `m_best`, which is empty if there is
  // none.
  void find_best_proposal(Cell_handle c) {
    m_best.clear();
    m_best_sine = 0;
    m_least_sine = better * sine(c);
    for (int i = 0; i < 4; ++i)
      consider(propose_multi_face_removal(m_complex, c, i, m_cavity));
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        consider(propose_edge_removal(m_complex, c, i, j, m_cavity));
    for (int i = 0; i < 4 && !is_enough(); ++i)
      consider(propose_multi_face_retriangulation(m_complex, c, i, m_cavity));
    if (!is_enough())
      consider_collapses(c, false);
    if (!is_enough())
      consider(propose_vertex_insertion(m_complex, c, m_cavity));
  }

  void consider_interface_flips(Cell_handle c) {
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        consider(m_complex.is_interface(typename Complex::Edge(c, i, j)) &&
                 propose_interface_edge_flip(m_complex, c, i, j, m_cavity) &&
                 m_tolerance.allows(m_cavity, slack()) &&
                 is_little(facets_changed_by_flip(Interface_edge_3<Complex>(m_complex, c, i, j)),
                           c->vertex(i), c->vertex(j)));
  }

  // Considers collapses of vertices: of moved interface vertices if `of_interface` is set, or else
  // of free vertices.
  void consider_collapses(Cell_handle c, bool of_interface) {
    for (int i = 0; i < 4; ++i) {
      const Vertex_handle v = c->vertex(i);
      if (v->is_interface() != of_interface || (of_interface && !m_rigid_components.has_moved(v)))
        continue;
      for (int j = 0; j < 4; ++j)
        consider(j != i && propose_edge_collapse(m_complex, c, i, j, 0, m_cavity) &&
                 m_tolerance.allows(m_cavity, slack()) &&
                 (!of_interface ||
                  is_little(facets_changed_by_collapse(m_complex, fan(v), c->vertex(j)), v, v)));
    }
  }

  Interface_fan_3<Complex> fan(Vertex_handle v) {
    m_complex.star(v, m_star);
    return Interface_fan_3<Complex>(m_complex, v, m_star);
  }

  // Returns whether a change of the interface at two vertices is small enough.
  bool is_little(const Changed_facets& change, Vertex_handle v, Vertex_handle w) const {
    // maximum swept volume, relative to the cube of the edge length
    static constexpr double little = .1;
    const double edge = (local_edge_length(m_complex, v) + local_edge_length(m_complex, w)) / 2;
    return change.swept_volume < slack() * little * edge * edge * edge;
  }

  // Returns the factor for changes of the interface; it is larger in attempts to improve remaining
  // cells.
  double slack() const { return m_bound / m_target; }

  // Stores the proposal in `m_cavity` as the best one, if it is better than the best proposal so
  // far. The quality must be preserved as well, because dihedral angles do not detect needles.
  void consider(bool is_proposed) {
    if (!is_proposed || !m_cavity.keeps_quality())
      return;
    double before = std::numeric_limits<double>::infinity(), after = before;
    for (Cell_handle c : m_cavity.removed())
      if (!m_complex.is_infinite(c))
        before = (std::min)(before, sine(c));
    for (const auto& t : m_cavity.tetrahedra()) {
      const auto p = [&](int i) { return m_cavity.vertices()[t.vertices[i]].position; };
      if (t.quality < std::numeric_limits<double>::infinity()) // all vertices are finite
        after = (std::min)(after, sine_of(p));
    }
    if (after > better * before && after > m_least_sine && after > m_best_sine) {
      m_best_sine = after;
      std::swap(m_best, m_cavity);
    }
  }

  // Gives a cell in a fold of the interface the label of the other side, if the area of the
  // interface increases only slightly.
  template <class Relabel>
  bool relabel_fold(Cell_handle c, const Relabel& relabel, Cells& touched) {
    static constexpr double growth = 1.05;
    for (int i = 0; i < 4; ++i) {
      if (!m_complex.is_interface(std::make_pair(c, i)))
        continue;
      const Label label = c->neighbor(i)->subdomain_index();
      double before = 0, after = 0;
      bool is_inside = true;
      for (int k = 0; k < 4; ++k) {
        is_inside = is_inside && !m_complex.is_infinite(c->neighbor(k));
        const Label other = c->neighbor(k)->subdomain_index();
        const double area = m_complex.area(std::make_pair(c, k));
        before += other == label ? area : 0;
        after += other == c->subdomain_index() ? area : 0;
      }
      if (!is_inside || !(after < growth * before) ||
          !m_tolerance.allows_relabeling(std::make_pair(c, i)) || !relabel(c, label))
        continue;
      m_tolerance.record();
      touch({c, c->neighbor(0), c->neighbor(1), c->neighbor(2), c->neighbor(3)}, touched);
      return true;
    }
    return false;
  }

  // Moves one of the vertices with `may_move(v)` to the position that maximizes the smallest sine
  // of an angle around it. It chooses the vertex for which this sine is largest, if the sine
  // exceeds `bound`. The total displacement of an interface vertex from its initial position is
  // bounded.
  template <class MayMove>
  bool move_vertex(Cell_handle c, const MayMove& may_move, double bound, Cells& touched) {
    static constexpr double better_star = 1.05;
    double best = (std::max)(bound, better_star * sine(c));
    Vertex_handle moving;
    Position target = m_complex.position(c->vertex(0));
    for (int i = 0; i < 4; ++i) {
      const Vertex_handle v = c->vertex(i);
      if (m_complex.is_boundary(v) || !may_move(v))
        continue;
      m_complex.star(v, m_star);
      const Position from = m_complex.position(v);
      Star_optimizer<Complex, Minimum_sine_3> optimizer(m_complex, m_sine, v, m_star);
      const Position to = v->is_interface() ? near_home(v, optimizer.run()) : optimizer.run();
      const double after = worst_sine(v, to);
      if (after > best && after > better_star * worst_sine(v, from) &&
          m_complex.is_admissible_star(v, m_star, to) &&
          m_tolerance.allows_motion(v, m_star, to, slack())) {
        best = after;
        moving = v;
        target = to;
      }
    }
    if (moving == Vertex_handle())
      return false;
    if (moving->is_interface())
      m_homes.emplace(moving->time_stamp(), m_complex.position(moving));
    else
      ++m_report.smoothed;
    m_complex.star(moving, m_star);
    if (m_tolerance.allows_motion(moving, m_star, target, slack()))
      m_tolerance.record();
    smooth_vertex(m_complex, moving, m_star, target, m_visitor);
    touch(m_star, touched);
    return true;
  }

  // Returns the point on the segment from the initial position of a vertex to p that is closest to
  // p within the bound on the displacement.
  Position near_home(Vertex_handle v, const Position& p) const {
    static constexpr double longest_displacement = .05; // relative to the edge length
    const auto known = m_homes.find(v->time_stamp());
    const Position home = m_complex.domain().nearest_image(
        p, known == m_homes.end() ? m_complex.position(v) : known->second);
    const auto displacement = p - home;
    const double length = std::sqrt(displacement.squared_length()),
                 bound = slack() * longest_displacement * local_edge_length(m_complex, v);
    return length > bound ? home + bound / length * displacement : p;
  }

  // Returns the smallest sine in the star `m_star` if its vertex is moved to p.
  double worst_sine(Vertex_handle v, const Position& p) const {
    return (std::max)(0., star_quality(m_complex, m_sine, v, m_star, p, 0));
  }

  // Prevents improvement of the quality from reverting the changes, before the cells change again.
  void keep_from_improvement() {
    for (const auto& item : m_changed)
      if (m_complex.is_alive(item.cell, item.time_stamp))
        set_exhausted(item.cell, to_improve_quality);
  }

  void touch(const std::vector<Cell_handle>& cells, Cells& touched) {
    push_finite(m_complex, cells, m_changed);
    for (Cell_handle c : cells)
      if (!m_complex.is_infinite(c) && is_bad(c)) {
        touched.push(c);
        m_handled.push(c);
      }
  }

  static constexpr double better = 1.1; // minimum factor of an improvement

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Destinations<Complex>& m_destinations;
  const Rigid_components<Complex>& m_rigid_components;
  const For_each_index& m_for_each_index;
  Minimum_sine_3 m_sine;
  double m_target, m_bound; // `m_bound` may be larger than `m_target` around remaining cells
  double m_quality_threshold;
  Interface_tolerance<Complex> m_tolerance;
  Cavity<Complex> m_cavity, m_best;
  double m_best_sine = 0, m_least_sine = 0;
  // initial positions of relocated vertices, by time stamp
  boost::container::flat_map<std::size_t, Position> m_homes;
  Cells m_handled, m_changed;
  std::vector<Cell_handle> m_star;
  Improvement_report m_report;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_SMALL_ANGLE_REMOVER_3_H
