// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_INTERFACE_IMPROVER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_INTERFACE_IMPROVER_3_H

#include <CGAL/Deformable_simplicial_complex_3/edge_collapse_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complex_3/edge_split_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_improver_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/Interface_edge_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/Interface_fan_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/changed_facets_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface/curved_midpoint_3.h>
#include <CGAL/Deformable_simplicial_complex_3/null_space_smoothing_3.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What improve_interface() is asked for.
struct Interface_thresholds
{
  double aggressiveness;
  double split, collapse;   // in edge units
  double swept_volume;      // in cubes of edge units
  double flip_angle;        // between the normals of two facets, in radians
  double feature_angle;     // between the normals of two facets, in radians
  double smallest_angle;    // of a facet, in radians
  double quality_threshold; // of tetrahedra
  bool splits_curved;
};

inline void check_interface_thresholds(const Interface_thresholds& t) {
  if (!(t.aggressiveness >= 0 && t.aggressiveness < 1))
    throw Error("the aggressiveness is out of range: use 0 to less than 1");
  if (!(t.split > 0))
    throw Error("a length from which edges are split is out of range: use more than 0");
  if (!(t.collapse >= 0))
    throw Error("a length up to which edges are collapsed is out of range: use 0 or more");
  if (!(t.swept_volume >= 0))
    throw Error("the volume that the interface may sweep is out of range: use 0 or more");
  check_threshold(t.quality_threshold);
}

// The passes over the interface, in the order in which improve_interface() takes them.
template <class Complex> class Interface_improver_3
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // Lengths of edges are measured by `unit`.
  Interface_improver_3(Complex& complex, Any_visitor<Complex>& visitor,
                       const Interface_thresholds& thresholds, const Edge_unit<Complex>& unit)
      : m_complex(complex), m_visitor(visitor), m_thresholds(thresholds), m_unit(unit),
        m_improver(complex, visitor, thresholds.quality_threshold), m_cavity(complex) {}

  Improvement_report report() const { return m_report + m_improver.report(); }

  void split_long_edges() {
    static constexpr unsigned rounds = 10; // each halves what is too long
    work_in_rounds(m_complex, cells_at_interface(), rounds,
                   [&](Cell_handle c, Work_list<Cell_handle>& touched) {
                     const auto [i, j] = longest_edge(c);
                     if (i != j && split(c, i, j))
                       push_finite(m_complex, m_cavity.created(), touched);
                   });
  }

  void collapse_short_edges() {
    for_each_interface_edge([&](Cell_handle c, int i, int j) {
      if (!(length(c->vertex(i), c->vertex(j)) < m_thresholds.collapse))
        return false;
      for (const auto& [vanishing, kept] : {std::make_pair(i, j), std::make_pair(j, i)})
        if (propose_collapse(c, vanishing, kept) && !makes_long_edge())
          return commit();
      return false;
    });
  }

  // Flips or collapses an edge of a facet with a small angle, whichever sweeps least, if that makes
  // the worst of the facets it changes better.
  void remove_small_angles() {
    work_in_rounds(m_complex, cells_at_interface(), 1, [&](Cell_handle c, Work_list<Cell_handle>&) {
      for (int k = 0; k < 4; ++k)
        if (m_complex.is_interface(typename Complex::Facet(c, k)) && has_small_angle(c, k) &&
            remove_small_angle(c, k))
          return;
    });
  }

  void flip_edges() {
    for_each_interface_edge([&](Cell_handle c, int i, int j) {
      const Interface_edge_3<Complex> edge(m_complex, c, i, j);
      return edge.is_in_sheet() && edge.violates_delaunay_criterion() &&
             edge.bend() < m_thresholds.flip_angle &&
             propose_interface_edge_flip(m_complex, c, i, j, m_cavity,
                                         m_thresholds.quality_threshold) &&
             commit();
    });
  }

  void smooth_vertices() {
    if (m_thresholds.aggressiveness == 0)
      return;
    typename Complex::Point_3 target;
    for (Vertex_handle v : m_complex.interface_vertices()) {
      m_complex.star(v, m_star);
      if (!propose_null_space_position(m_complex, v, m_star, m_thresholds.aggressiveness,
                                       m_thresholds.feature_angle, m_thresholds.quality_threshold,
                                       target))
        continue;
      smooth_vertex(m_complex, v, m_star, target, m_visitor);
      ++m_report.smoothed;
      for (Cell_handle c : m_star)
        touch(c);
    }
  }

  // Brings the tetrahedra around all that has changed back to quality.
  void improve_tetrahedra() {
    m_improver.improve(std::move(m_touched), 3);
    m_touched.clear();
  }

private:
  // The cells behind the facets of the interface.
  Work_list<Cell_handle> cells_at_interface() const {
    Work_list<Cell_handle> cells;
    for (const auto& facet : m_complex.interface_facets())
      cells.push(facet.first);
    return cells;
  }

  // Calls `work` for the edges of the interface until it has changed the cell.
  template <class Work> void for_each_interface_edge(const Work& work) {
    work_in_rounds(m_complex, cells_at_interface(), 1, [&](Cell_handle c, Work_list<Cell_handle>&) {
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          if (is_interface_edge(c, i, j) && work(c, i, j))
            return;
    });
  }

  // Whether the edge belongs to a facet of the cell that is on the interface.
  bool is_interface_edge(Cell_handle c, int i, int j) const {
    for (int k = 0; k < 4; ++k)
      if (k != i && k != j && m_complex.is_interface(typename Complex::Facet(c, k)))
        return true;
    return false;
  }

  double length(Vertex_handle v, Vertex_handle w) const {
    return length_in_units(m_complex, v, w, m_unit);
  }

  // The edge of the interface that exceeds its threshold most; twice the same vertex if none does.
  std::pair<int, int> longest_edge(Cell_handle c) const {
    std::pair<int, int> result(0, 0);
    double longest = m_thresholds.split;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        if (!is_interface_edge(c, i, j))
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
    const auto curved = m_thresholds.splits_curved ? curved_middle(c, i, j) : std::nullopt;
    if (!(curved && propose_edge_split(m_complex, c, i, j, *curved, m_cavity)) &&
        !propose_edge_split(m_complex, c, i, j, .5, m_cavity))
      return false;
    commit_split(m_complex, m_cavity, c->vertex(i), c->vertex(j), m_visitor, m_report);
    touch_created();
    return true;
  }

  // Nothing where the interface is not a single smooth sheet, has a feature, or touches the
  // boundary of the domain.
  std::optional<typename Complex::Approximate_point_3> curved_middle(Cell_handle c, int i, int j) {
    if (m_complex.is_boundary(c->vertex(i)) && m_complex.is_boundary(c->vertex(j)))
      return std::nullopt;
    m_complex.star(c->vertex(i), m_star);
    const Interface_fan_3<Complex> a(m_complex, c->vertex(i), m_star);
    m_complex.star(c->vertex(j), m_star);
    const Interface_fan_3<Complex> b(m_complex, c->vertex(j), m_star);
    if (!a.is_disk() || !b.is_disk() ||
        !a.neighbors_along_features(m_thresholds.feature_angle).empty() ||
        !b.neighbors_along_features(m_thresholds.feature_angle).empty())
      return std::nullopt;
    return curved_midpoint(m_complex, a, b);
  }

  bool has_small_angle(Cell_handle c, int k) const {
    const auto v = m_complex.facet_vertices({c, k});
    const auto p = m_complex.position(v[0]);
    return smallest_angle(std::array<typename Complex::Approximate_point_3, 3>{
               p, m_complex.position_near(p, v[1]), m_complex.position_near(p, v[2])}) <
           m_thresholds.smallest_angle;
  }

  bool remove_small_angle(Cell_handle c, int k) {
    Cavity_3<Complex> best(m_complex);
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::optional<Changed_facets_3>& change) {
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

  // Whether no feature goes with the center of a disk: that it is in a smooth sheet, or that it
  // goes along a straight feature.
  bool keeps_features(const Interface_fan_3<Complex>& disk, Vertex_handle kept) const {
    const double angle = m_thresholds.feature_angle;
    const int rank = disk.rank_by_features(angle);
    const auto neighbors = disk.neighbors_along_features(angle);
    return rank == 1 || (rank == 2 && (kept == neighbors[0] || kept == neighbors[1]));
  }

  // Proposes to collapse vertex i into vertex j if little of the interface moves, and no facet
  // comes to be bad that was not.
  std::optional<Changed_facets_3> propose_collapse(Cell_handle c, int i, int j) {
    static constexpr double good = .5;   // quality of facets
    static constexpr double worst = .05; // quality of a cell that a collapse may make
    m_complex.star(c->vertex(i), m_star);
    const Interface_fan_3<Complex> fan(m_complex, c->vertex(i), m_star);
    if (!fan.is_disk() || !keeps_features(fan, c->vertex(j)))
      return std::nullopt;
    const auto change = facets_changed_by_collapse(m_complex, fan, c->vertex(j));
    if (!(change.worst_after > 0 && change.worst_after >= (std::min)(good, change.worst_before)) ||
        !is_small(change, c, i, j) || !propose_edge_collapse(m_complex, c, i, j, worst, m_cavity))
      return std::nullopt;
    return change;
  }

  std::optional<Changed_facets_3> propose_flip(Cell_handle c, int i, int j) {
    const Interface_edge_3<Complex> edge(m_complex, c, i, j);
    if (!edge.is_in_sheet() || edge.bend() > m_thresholds.feature_angle)
      return std::nullopt;
    const auto change = facets_changed_by_flip(edge);
    if (!is_small(change, c, i, j) || !propose_interface_edge_flip(m_complex, c, i, j, m_cavity))
      return std::nullopt;
    return change;
  }

  bool is_small(const Changed_facets_3& change, Cell_handle c, int i, int j) const {
    const auto p = m_complex.position(c->vertex(i));
    const double unit = m_unit(midpoint(p, m_complex.position_near(p, c->vertex(j))));
    return change.swept_volume <= m_thresholds.swept_volume * unit * unit * unit;
  }

  bool makes_long_edge() const {
    const Vertex_handle kept = m_cavity.kept_vertex();
    return std::any_of(m_cavity.vertices().begin(), m_cavity.vertices().end(), [&](const auto& v) {
      return v.handle != kept && v.handle != m_cavity.vanishing_vertex() &&
             v.handle->is_interface() && length(v.handle, kept) > m_thresholds.split;
    });
  }

  bool commit() {
    commit_proposal(m_complex, m_cavity, m_visitor, m_report);
    touch_created();
    return true;
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
  Any_visitor<Complex>& m_visitor;
  Interface_thresholds m_thresholds;
  Edge_unit<Complex> m_unit;
  Mesh_improver_3<Complex> m_improver;
  Cavity_3<Complex> m_cavity;
  std::vector<Cell_handle> m_star;
  Work_list<Cell_handle> m_touched;
  Improvement_report m_report;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REMESHING_INTERFACE_IMPROVER_3_H
