// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_REMESHER_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_REMESHER_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Changed_facets.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Interface_remeshing/Interface_improvement_options.h>
#include <CGAL/Interface_remeshing/internal/interface/curved_midpoint.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Failed_collapses.h>
#include <CGAL/Interface_remeshing/junction_split_2.h>
#include <CGAL/Interface_remeshing/null_space_smoothing_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The passes of improve_interface().
template <class Complex> class Interface_remesher
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Fan = Interface_fan<Complex>;

  Interface_remesher(Complex& complex, Deformation_visitor<Complex>& visitor,
                     const Interface_improvement_options<Complex>& options)
      : m_complex(complex), m_visitor(visitor), m_options(options),
        m_unit(target_edge_length(complex, options.sizing_field)),
        m_improver(complex, visitor, options.quality_threshold, m_sequential), m_tolerance(complex),
        m_cavity(complex) {}

  Improvement_report report() const { return m_report + m_improver.report(); }

  void split_long_edges() {
    static constexpr unsigned rounds = 10; // each round halves long edges
    work_in_rounds(m_complex, cells_at_interface(), rounds,
                   [&](Cell_handle c, Work_list<Cell_handle>& touched) {
                     const auto [i, j] = longest_edge(c);
                     if (i != j && split(c, i, j))
                       push_finite(m_complex, m_cavity.created(), touched);
                   });
  }

  void collapse_short_edges() {
    Failed_collapses<Complex> failed;
    for_each_interface_edge([&](Cell_handle c, int i, int j) {
      if (!(length(c->vertex(i), c->vertex(j)) < m_options.interface_collapse_length))
        return false;
      for (const auto& [vanishing, kept] : {std::make_pair(i, j), std::make_pair(j, i)}) {
        if (failed.contains(c->vertex(vanishing), c->vertex(kept)))
          continue;
        if (propose_collapse(c, vanishing, kept) && !makes_long_edge()) {
          commit();
          failed.update(m_cavity.created());
          return true;
        }
        failed.add(c->vertex(vanishing), c->vertex(kept));
      }
      return false;
    });
  }

  void smooth_vertices() {
    if (m_options.aggressiveness == 0)
      return;
    typename Complex::Point target;
    for (Vertex_handle v : m_complex.interface_vertices()) {
      Progress_scope::check();
      const Fan fan = this->fan(v);
      if (!null_space_position(m_complex, fan, m_star, m_options.aggressiveness,
                               radians(m_options.feature_angle), m_options.quality_threshold,
                               target) ||
          !m_tolerance.allows_motion(v, m_star, target))
        continue;
      smooth_vertex(m_complex, v, m_star, target, m_visitor);
      ++m_report.smoothed;
      for (Cell_handle c : m_star)
        touch(c);
    }
  }

  // Improves the cells around all changes.
  void improve_cells() {
    m_improver.improve(std::move(m_touched), 3);
    m_touched.clear();
  }

  // Replaces interface facets without moving vertices: flips edges between facets, and removes
  // small facet angles. The vertices of a curve can be connected in one way only.
  void reconnect() {
    if constexpr (Complex::dimension == 3) {
      flip_edges();
      remove_small_angles();
    }
  }

  // Splits each junction of more than three phases into several junctions of three. There is no
  // such operation in space.
  void split_junctions() {
    if constexpr (Complex::dimension == 2)
      for (auto v : m_complex.interface_vertices()) {
        Progress_scope::check();
        while (propose_junction_split(m_complex, v, m_cavity, m_options.interface_energy)) {
          commit();
          const auto other = m_cavity.vertices().back().handle;
          for (auto junction : {v, other})
            Simplex_access::set_spacing(junction, float(m_complex.interface_edge_length(junction)));
        }
      }
  }

private:
  static double radians(double degrees) { return degrees * (CGAL_PI / 180); }

  // Returns the cells behind the interface facets.
  Work_list<Cell_handle> cells_at_interface() const {
    Work_list<Cell_handle> cells;
    for (const auto& facet : m_complex.interface_facets())
      cells.push(facet.first);
    return cells;
  }

  // Calls `work` for the interface edges of each cell that can change, until `work` has changed the
  // cell.
  template <class Work> void for_each_interface_edge(const Work& work) {
    work_in_rounds(m_complex, cells_at_interface(), 1, [&](Cell_handle c, Work_list<Cell_handle>&) {
      for (int i = 0; i <= Complex::dimension; ++i)
        for (int j = i + 1; j <= Complex::dimension; ++j)
          if (can_change(c, i, j) && work(c, i, j))
            return;
    });
  }

  // Proposes to collapse vertex i into vertex j. Returns `nullopt` if the collapse would remove
  // features, sweep too much volume, or create a facet that is degenerate or worse than `good` and
  // than all facets before.
  std::optional<Changed_facets> propose_collapse(Cell_handle c, int i, int j) {
    static constexpr double good = .5;   // quality of facets
    static constexpr double worst = .05; // least quality of a cell created by a collapse
    if (m_complex.has_constrained_end(c, i, j))
      return std::nullopt;
    const Fan fan = this->fan(c->vertex(i));
    if (!fan.is_disk() || !fan.keeps_features(radians(m_options.feature_angle), c->vertex(j)))
      return std::nullopt;
    const auto change = facets_changed_by_collapse(m_complex, fan, c->vertex(j));
    if (!(change.worst_after > 0 && change.worst_after >= (std::min)(good, change.worst_before)) ||
        !is_small(change, c, i, j) || !propose_edge_collapse(m_complex, c, i, j, worst, m_cavity) ||
        !m_tolerance.allows(m_cavity))
      return std::nullopt;
    return change;
  }

  bool is_small(const Changed_facets& change, Cell_handle c, int i, int j) const {
    const auto p = m_complex.position(c->vertex(i));
    const double unit = m_unit(midpoint(p, m_complex.position_near(p, c->vertex(j))));
    double bound = m_options.swept_volume;
    for (int k = 0; k < Complex::dimension; ++k)
      bound *= unit;
    return change.swept_volume <= bound;
  }

  bool commit() {
    commit_proposal(m_complex, m_cavity, m_visitor, m_report);
    touch_created();
    return true;
  }

  void flip_edges() {
    for_each_interface_edge([&](Cell_handle c, int i, int j) {
      const Interface_edge_3<Complex> edge(m_complex, c, i, j);
      return edge.is_in_sheet() && edge.violates_delaunay_criterion() &&
             edge.bend() < radians(m_options.flip_angle) &&
             propose_interface_edge_flip(m_complex, c, i, j, m_cavity,
                                         m_options.quality_threshold) &&
             m_tolerance.allows(m_cavity) && commit();
    });
  }

  // Removes small angles of facets. An edge of the facet is flipped or collapsed, whichever sweeps
  // the smaller volume, if this improves the worst of the changed facets.
  void remove_small_angles() {
    work_in_rounds(m_complex, cells_at_interface(), 1, [&](Cell_handle c, Work_list<Cell_handle>&) {
      for (int k = 0; k < 4; ++k)
        if (m_complex.is_interface(typename Complex::Facet(c, k)) && has_small_angle(c, k) &&
            remove_small_angle(c, k))
          return;
    });
  }

  bool has_small_angle(Cell_handle c, int k) const {
    const auto v = m_complex.facet_vertices({c, k});
    const auto p = m_complex.position(v[0]);
    return smallest_angle(std::array<typename Complex::Point_3, 3>{
               p, m_complex.position_near(p, v[1]), m_complex.position_near(p, v[2])}) <
           radians(m_options.minimum_facet_angle);
  }

  bool remove_small_angle(Cell_handle c, int k) {
    Cavity<Complex> best(m_complex);
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::optional<Changed_facets>& change) {
      if (!change || !(change->worst_after > change->worst_before) ||
          !(change->swept_volume < least))
        return;
      least = change->swept_volume;
      std::swap(best, m_cavity);
    };
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j && i != k && j != k) {
          consider(propose_collapse(c, i, j));
          if (i < j)
            consider(propose_flip(c, i, j));
        }
    std::swap(best, m_cavity);
    return least < std::numeric_limits<double>::infinity() && commit();
  }

  std::optional<Changed_facets> propose_flip(Cell_handle c, int i, int j) {
    if (m_complex.has_constrained_end(c, i, j))
      return std::nullopt;
    const Interface_edge_3<Complex> edge(m_complex, c, i, j);
    if (!edge.is_in_sheet() || edge.bend() > radians(m_options.feature_angle))
      return std::nullopt;
    const auto change = facets_changed_by_flip(edge);
    if (!is_small(change, c, i, j) || !propose_interface_edge_flip(m_complex, c, i, j, m_cavity) ||
        !m_tolerance.allows(m_cavity))
      return std::nullopt;
    return change;
  }

  // Returns the fan of a vertex, and stores the star of the vertex in `m_star`.
  Fan fan(Vertex_handle v) {
    m_complex.star(v, m_star);
    return Fan(m_complex, v, m_star);
  }

  // Returns whether the edge belongs to an interface facet of the cell, and its ends are not
  // constrained.
  bool can_change(Cell_handle c, int i, int j) const {
    if (m_complex.has_constrained_end(c, i, j))
      return false;
    for (int k = 0; k <= Complex::dimension; ++k)
      if (k != i && k != j && m_complex.is_interface(typename Complex::Facet(c, k)))
        return true;
    return false;
  }

  // Returns the length of an edge in units of its target edge length.
  double length(Vertex_handle v, Vertex_handle w) {
    const auto edge = m_complex.displacement(v, w);
    return std::sqrt(edge.squared_length()) / size(v, w, m_complex.position(v) + .5 * edge);
  }

  // Returns the target edge length at the midpoint of an edge. It is stored with the midpoint,
  // because an edge is measured several times and a sizing field can take long.
  double size(Vertex_handle v, Vertex_handle w, const typename Complex::Point& middle) {
    if (!m_unit.is_sizing_field())
      return m_unit(middle);
    const auto [size, is_new] = m_sizes.try_emplace(std::uint64_t(v->id()) << 32 | w->id());
    if (is_new || size->second.first != middle)
      size->second = {middle, m_unit(middle)};
    return size->second.second;
  }

  // Returns the interface edge of the cell that exceeds the split threshold most; twice the same
  // vertex if there is none.
  std::pair<int, int> longest_edge(Cell_handle c) {
    std::pair<int, int> result(0, 0);
    double longest = m_options.interface_split_length;
    for (int i = 0; i <= Complex::dimension; ++i)
      for (int j = i + 1; j <= Complex::dimension; ++j) {
        if (!can_change(c, i, j))
          continue;
        const double edge = length(c->vertex(i), c->vertex(j));
        if (edge > longest) {
          longest = edge;
          result = {i, j};
        }
      }
    return result;
  }

  bool split(Cell_handle c, int i, int j) {
    const auto curved = m_options.curved_splits ? curved_middle(c, i, j) : std::nullopt;
    if (!(curved && propose_edge_split(m_complex, c, i, j, *curved, m_cavity)) &&
        !propose_edge_split(m_complex, c, i, j, .5, m_cavity))
      return false;
    commit_split(m_complex, m_cavity, c->vertex(i), c->vertex(j), m_visitor, m_report);
    touch_created();
    return true;
  }

  // Returns the midpoint of an interface edge on the smooth surface. Returns `nullopt` where the
  // interface is not a single smooth sheet, has a feature, or both ends are on the boundary of the
  // domain.
  std::optional<typename Complex::Point> curved_middle(Cell_handle c, int i, int j) {
    if (m_complex.is_boundary(c->vertex(i)) && m_complex.is_boundary(c->vertex(j)))
      return std::nullopt;
    const Fan a = fan(c->vertex(i)), b = fan(c->vertex(j));
    const auto is_smooth = [&](const Fan& fan) {
      return fan.is_disk() && fan.rank_by_features(radians(m_options.feature_angle)) == 1;
    };
    if (!is_smooth(a) || !is_smooth(b))
      return std::nullopt;
    return curved_midpoint(m_complex, a, b);
  }

  // Returns whether the planned collapse creates an edge that would be split. In the plane, long
  // edges are accepted if the split threshold is at least twice the collapse threshold: the halves
  // of a long edge are then not collapsed again, and vertices near junctions can be removed.
  bool makes_long_edge() {
    if (Complex::dimension == 2 &&
        m_options.interface_split_length >= 2 * m_options.interface_collapse_length)
      return false;
    const Vertex_handle kept = m_cavity.kept_vertex();
    return std::any_of(m_cavity.vertices().begin(), m_cavity.vertices().end(), [&](const auto& v) {
      return v.handle != kept && v.handle != m_cavity.vanishing_vertex() &&
             v.handle->is_interface() && length(v.handle, kept) > m_options.interface_split_length;
    });
  }

  void touch_created() {
    for (Cell_handle c : m_cavity.created())
      touch(c);
  }

  void touch(Cell_handle c) {
    if (!m_complex.is_infinite(c) && m_improver.is_bad(c))
      m_touched.push(c);
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Interface_improvement_options<Complex>& m_options;
  Edge_unit<Complex> m_unit;
  // midpoints of edges and target edge lengths there, by the ids of the vertices
  std::unordered_map<std::uint64_t, std::pair<typename Complex::Point, double>> m_sizes;
  For_each_index m_sequential;
  Mesh_improver<Complex> m_improver;
  Interface_tolerance<Complex> m_tolerance;
  Cavity<Complex> m_cavity;
  std::vector<Cell_handle> m_star;
  Work_list<Cell_handle> m_touched;
  Improvement_report m_report;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_INTERFACE_REMESHER_H
