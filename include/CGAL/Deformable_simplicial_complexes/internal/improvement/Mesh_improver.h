// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Vertex_smoother.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/degeneracy_removal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_split.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_insertion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns whether two facets of the cell lie on the interface, so that remeshing cannot change the
// angle between them.
template <class Complex>
bool has_dictated_angle(const Complex& complex, typename Complex::Cell_handle c) {
  int number = 0;
  for (int i = 0; i < Complex::corners; ++i)
    number += complex.is_interface(std::make_pair(c, i));
  return number > 1;
}

// The operations of Algorithm 3. Each operation tries to improve one bad cell and returns whether
// it succeeded. Cells that it creates or changes are appended to `touched`.
template <class Complex> class Mesh_improver
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;
  using Own = Mesh_operations<Complex>;

  // Creates an improver for cells with a quality less than `threshold`. If `is_thorough` is set, it
  // also retriangulates sets of facets and inserts vertices where other operations fail. If
  // `smooths_interface` is set, it also moves interface vertices within their plane or line.
  Mesh_improver(Complex& complex, Deformation_visitor<Complex>& visitor, double threshold,
                const For_each_index& for_each_index, bool is_thorough = false,
                bool smooths_interface = false)
      : m_complex(complex), m_visitor(visitor), m_threshold(threshold), m_is_thorough(is_thorough),
        m_tolerance(complex), m_cavity(complex),
        m_smoother(complex, for_each_index, smooths_interface) {}

  // Creates an improver for a mesh during a deformation.
  Mesh_improver(Complex& complex, Deformation_visitor<Complex>& visitor,
                const Destinations<Complex>& destinations, double threshold,
                const For_each_index& for_each_index)
      : Mesh_improver(complex, visitor, threshold, for_each_index) {
    m_destinations = &destinations;
    m_tolerance = Interface_tolerance<Complex>(complex, m_destinations);
  }

  const Improvement_report& report() const { return m_report; }

  // Prepares the removal of obstacles in a pass. Most vertices arrive in two passes. For others,
  // the interface may change more.
  void begin_pass(unsigned pass) {
    static constexpr unsigned strict = 2; // passes
    static constexpr double factor = 10;
    m_tolerance_factor = pass > strict ? factor : 1;
  }

  // Improves all cells below a threshold. The remaining cells often have neighbors that are only
  // slightly better. Therefore, in `number_of_attempts` further attempts, the cells around the
  // remaining cells are improved to higher thresholds. A cell whose shape smoothing has changed is
  // tried again. There are no further attempts if the number of cells below the threshold has grown
  // much: in a mesh that is squeezed, inserted vertices divide cells that stay flat.
  void improve_all(double threshold, unsigned rounds, int number_of_attempts) {
    static constexpr double higher = 1.1;
    static constexpr std::size_t most_growth = 2, few = 100; // of the number of cells
    m_threshold = threshold;
    m_is_at_rest = true;
    Cells cells;
    for (Cell_handle c : m_complex.finite_cells())
      push_afresh(c, cells);
    const std::size_t most =
        number_of_attempts == 0 ? 0 : few + most_growth * stuck_cells(threshold).size();
    improve(std::move(cells), rounds);
    for (int i = 0; i < number_of_attempts; ++i) {
      const std::vector<Cell_handle> stuck = stuck_cells(threshold);
      if (stuck.empty() || stuck.size() > most)
        break;
      m_threshold = (std::min)(1., higher * m_threshold);
      cells.clear();
      for (Cell_handle c : star_union(m_complex, vertices_of(m_complex, stuck)))
        push_afresh(c, cells);
      improve(std::move(cells), rounds);
    }
  }

  // Improves the given cells below the threshold, then the cells created or changed by this, and so
  // on for at most `rounds` rounds. A round first reconnects cells. It then moves the vertices of
  // the remaining cells. The other operations follow for cells that smoothing does not improve. A
  // cell that improves only slightly is marked as a failure, because further attempts would have
  // little effect.
  void improve(Cells cells, unsigned rounds) {
    Cells touched;
    std::vector<Stuck_cell> stuck;
    for (unsigned round = 0; round < rounds && !cells.empty(); ++round) {
      cells.sort();
      touched.clear();
      stuck.clear();
      for (const auto& item : cells) {
        Progress_scope::check();
        if (m_complex.is_alive(item.cell, item.time_stamp) && is_bad(item.cell) &&
            !reconnect(item.cell, touched))
          stuck.push_back({item, item.cell->quality()});
      }
      smooth(stuck, touched);
      m_first_created = none;
      for (const Stuck_cell& s : stuck) {
        Progress_scope::check();
        if (m_complex.is_alive(s.item.cell, s.item.time_stamp))
          improve_after_smoothing(s.item.cell, s.quality, touched);
      }
      std::swap(cells, touched);
    }
  }

  // Returns whether a cell is below the threshold and has no recorded failure.
  bool is_bad(Cell_handle c) const {
    return c->quality() < m_threshold && !is_exhausted(c, to_improve_quality);
  }

  bool reconnect(Cell_handle c, Cells& touched) {
    const auto accept = [&] { return !covers_interface(); };
    return Own::propose_reconnection(m_complex, c, m_is_thorough, m_cavity, accept) &&
           commit(touched);
  }

  bool collapse(Cell_handle c, Cells& touched) {
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = 0; j < Complex::corners; ++j)
        if (i != j && !c->vertex(i)->is_interface() && collapse_edge(c, i, j, touched))
          return true;
    return false;
  }

  // Splits the longest edge of a cell if it is long and its ends cannot move freely (Algorithm 3,
  // line 1).
  bool split(Cell_handle c, Cells& touched) {
    int a = 0, b = 1;
    double longest = 0;
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j) {
        const double length = m_complex.displacement(c->vertex(i), c->vertex(j)).squared_length();
        if (length > longest) {
          longest = length;
          a = i;
          b = j;
        }
      }
    const Vertex_handle v = c->vertex(a), w = c->vertex(b);
    const auto is_tied = [&](Vertex_handle u) {
      return u->is_interface() || m_complex.is_boundary(u);
    };
    if (!is_tied(v) || !is_tied(w) || Own::is_interface_edge(m_complex, c, a, b) ||
        !is_long(v, w, longest))
      return false;
    return split_edge(c, a, b, touched);
  }

  // Inserts a vertex into a cell. Surrounding cells that this improves are replaced, too.
  bool insert(Cell_handle c, Cells& touched) {
    return propose_vertex_insertion(m_complex, c, m_cavity) && commit(touched);
  }

  // Removes an interface facet in 3D that has an angle below a bound, if this improves the
  // surrounding cells. `cosine` is the cosine of the bound. Returns whether the facet was removed.
  bool remove_degenerate_facet(Cell_handle c, int i, double cosine, Cells& touched) {
    const double quality = better * c->quality();
    if (!m_complex.is_interface(std::make_pair(c, i)) ||
        !propose_degenerate_facet_removal(m_complex, c, i, cosine, quality, m_cavity))
      return false;
    const Vertex_handle vanishing = m_cavity.vanishing_vertex(), kept = m_cavity.kept_vertex();
    if (vanishing != Vertex_handle() && covers_interface() &&
        (!propose_edge_collapse(m_complex, c, c->index(kept), c->index(vanishing), quality,
                                m_cavity) ||
         covers_interface()))
      return false;
    if (!m_tolerance.allows(m_cavity, m_tolerance_factor))
      return false;
    m_tolerance.record();
    return commit(touched);
  }

  // Collapses an interface edge that is short compared with the edges around it. Cells around it
  // may stay as flat as before.
  bool remove_short_edge(Cell_handle c, Cells& touched) {
    static constexpr double shortest = .2; // maximum length, relative to the edges around it
    const double bound = shortest * local_edge_length<Complex>(m_complex, {c});
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j)
        if (Own::is_interface_edge(m_complex, c, i, j) &&
            propose_degenerate_edge_removal(m_complex, c, i, j, bound, 0, m_cavity) &&
            m_tolerance.allows(m_cavity, m_tolerance_factor)) {
          m_tolerance.record();
          return commit(touched);
        }
    return false;
  }

  // Collapses a free vertex of a flat cell into an interface vertex. Cells around it may stay as
  // flat as before, but only the interface constrains them afterwards.
  bool remove_trapped_vertex(Cell_handle c, Cells& touched) {
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = 0; j < Complex::corners; ++j)
        if (!c->vertex(i)->is_interface() && c->vertex(j)->is_interface() &&
            propose_edge_collapse(m_complex, c, i, j, 0, m_cavity))
          return commit(touched);
    return false;
  }

  // Changes a cell that keeps the interface from moving rigidly: splits an edge between free
  // vertices, collapses the only free vertex into the interface, or splits an edge between both.
  bool open_obstructing_cell(Cell_handle c, Cells& touched) {
    return split_edge_with(c, 2, touched) || remove_trapped_vertex(c, touched) ||
           split_edge_with(c, 1, touched);
  }

private:
  // Splits an edge of a cell with the given number of free ends. Returns whether an edge was split.
  bool split_edge_with(Cell_handle c, int number_of_free_ends, Cells& touched) {
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j)
        if (!c->vertex(i)->is_interface() + !c->vertex(j)->is_interface() == number_of_free_ends &&
            split_edge(c, i, j, touched))
          return true;
    return false;
  }

  // Splits an edge in the middle, unless the new vertex could not move. Returns whether it did.
  bool split_edge(Cell_handle c, int i, int j, Cells& touched) {
    const Vertex_handle v = c->vertex(i), w = c->vertex(j);
    if (!propose_edge_split(m_complex, c, i, j, .5, m_cavity) ||
        (m_cavity.vertices().back().boundary_class & Boundary_class::fixed) != 0)
      return false;
    commit_split(m_complex, m_cavity, v, w, m_visitor, m_report);
    touch_created(touched);
    return true;
  }

  // A cell that could not be reconnected, and its quality.
  struct Stuck_cell
  {
    typename Cells::Item item;
    double quality;
  };

  // Moves the vertices of the stuck cells that are still in the complex, each vertex at most once.
  void smooth(const std::vector<Stuck_cell>& stuck, Cells& touched) {
    std::vector<Cell_handle> cells;
    for (const Stuck_cell& s : stuck)
      if (m_complex.is_alive(s.item.cell, s.item.time_stamp))
        cells.push_back(s.item.cell);
    m_smoother.run(
        cells, [&](Cell_handle c) { return is_bad(c); },
        [&](Vertex_handle v, const std::vector<Cell_handle>& star, const auto& target) {
          m_qualities.clear();
          for (Cell_handle d : star)
            m_qualities.push_back(d->quality());
          smooth_vertex(m_complex, v, star, target, m_visitor);
          ++m_report.smoothed;
          // Only cells whose shape has changed are tried again.
          for (std::size_t k = 0; k < star.size(); ++k) {
            if (!is_essential_change(m_qualities[k], star[k]->quality()))
              continue;
            if (m_is_at_rest)
              clear_exhausted(star[k], to_improve_quality);
            touch(star[k], touched);
          }
        });
  }

  // Tries the other operations on a cell. `before` is its quality before its vertices were moved.
  void improve_after_smoothing(Cell_handle c, double before, Cells& touched) {
    if (!is_bad(c) || is_essential_change(before, c->quality()))
      return; // an essential change is followed by another round
    if (!(c->quality() > before)) {
      if (collapse(c, touched) || split(c, touched))
        return;
      if (m_is_thorough && has_new_neighbor(c)) { // the next round smooths it first
        touched.push(c);
        return;
      }
      if (m_is_thorough && insert(c, touched))
        return;
    }
    set_exhausted(c, to_improve_quality);
  }

  // Returns whether a neighbor of a cell was created after the vertices were moved in this round.
  bool has_new_neighbor(Cell_handle c) const {
    for (int i = 0; i < Complex::corners; ++i)
      if (c->neighbor(i)->time_stamp() >= m_first_created)
        return true;
    return false;
  }

  // Returns whether an edge is long compared with the interface edges at its ends. If neither end
  // has interface edges, it is compared with the mean interface edge of the input.
  bool is_long(Vertex_handle v, Vertex_handle w, double squared_length) const {
    static constexpr double long_edge = 4; // minimum ratio of the lengths
    const double here = local_edge_length(m_complex, v), there = local_edge_length(m_complex, w);
    const double length = here + there == 0 ? m_complex.mean_interface_edge()
                                            : (here + there) / (here * there == 0 ? 1 : 2);
    return length > 0 && squared_length > long_edge * long_edge * length * length;
  }

  // Returns the quality of a cell with its vertices at their destinations.
  double final_quality(const std::array<Vertex_handle, Complex::corners>& v) const {
    return m_complex.domain().template apply<Complex>(m_complex.quality_measure(), [&](int i) {
      return m_destinations ? m_destinations->final_position(v[i]) : m_complex.position(v[i]);
    });
  }

  // Returns whether a planned cell is flat and has two interface facets when its vertices are at
  // their destinations. Such a cell would obstruct the motion until it is relabeled, and relabeling
  // it would change the interface unnecessarily.
  bool covers_interface() const {
    const auto& vertices = m_cavity.vertices();
    return std::any_of(m_cavity.planned().begin(), m_cavity.planned().end(), [&](const auto& t) {
      std::array<Vertex_handle, Complex::corners> v;
      for (int i = 0; i < Complex::corners; ++i) {
        v[i] = vertices[t.vertices[i]].handle;
        if (!v[i]->is_interface())
          return false;
      }
      return std::abs(final_quality(v)) < flat && number_of_interface_facets(v) > 1;
    });
  }

  // Returns the cells that remain below `bound`.
  std::vector<Cell_handle> stuck_cells(double bound) const {
    std::vector<Cell_handle> result;
    for (Cell_handle c : m_complex.finite_cells())
      if (c->quality() < bound && !has_dictated_angle(m_complex, c))
        result.push_back(c);
    return result;
  }

  // Adds a cell below the threshold. Clears a recorded failure of the cell first.
  void push_afresh(Cell_handle c, Cells& cells) {
    clear_exhausted(c, to_improve_quality);
    if (!m_complex.is_infinite(c) && is_bad(c))
      cells.push(c);
  }

  // Returns the number of facets of a planned cell that lie on the interface.
  int number_of_interface_facets(
      const std::array<Vertex_handle, Complex::corners>& vertices) const {
    int result = 0;
    for (Cell_handle c : m_cavity.removed())
      for (int i = 0; i < Complex::corners; ++i) {
        const std::pair<Cell_handle, int> facet(c, i);
        if (!m_complex.is_interface(facet))
          continue;
        const auto corners = m_complex.facet_vertices(facet);
        result += std::all_of(corners.begin(), corners.end(), [&](Vertex_handle v) {
          return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
        });
      }
    return result;
  }

  // Collapses vertex i of a cell into vertex j if this improves the surrounding cells.
  bool collapse_edge(Cell_handle c, int i, int j, Cells& touched) {
    return propose_edge_collapse(m_complex, c, i, j, better * c->quality(), m_cavity) &&
           !covers_interface() && commit(touched);
  }

  bool commit(Cells& touched) {
    commit_proposal(m_complex, m_cavity, m_visitor, m_report);
    touch_created(touched);
    return true;
  }

  void touch_created(Cells& touched) {
    if (m_first_created == none)
      m_first_created = m_cavity.created().front()->time_stamp();
    for (Cell_handle c : m_cavity.created())
      touch(c, touched);
  }

  void touch(Cell_handle c, Cells& touched) {
    if (!m_complex.is_infinite(c) && is_bad(c))
      touched.push(c);
  }

  static constexpr std::size_t none = std::size_t(-1); // no time stamp
  static constexpr double flat = 1e-9;                 // a quality that is zero up to rounding
  // minimum quality after a collapse, relative to the quality of the cell
  static constexpr double better = 1.1;

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Destinations<Complex>* m_destinations = nullptr;
  double m_threshold;
  bool m_is_thorough, m_is_at_rest = false;
  double m_tolerance_factor = 1; // of the volumes that the removal of obstacles may move
  Interface_tolerance<Complex> m_tolerance;
  Cavity<Complex> m_cavity;
  Vertex_smoother<Complex> m_smoother;
  std::vector<double> m_qualities;    // of the cells of a star
  std::size_t m_first_created = none; // time stamp after the motion of vertices in a round
  Improvement_report m_report;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_H
