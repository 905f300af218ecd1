// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_PASSED_EDGES_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_PASSED_EDGES_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Collapses edges of the interface that a step would reverse or make very short, if the collapse
// moves only a small volume, see `keeps_volumes()`. So a corner of a front removes the vertices of
// the flat faces that it passes.
template <class Complex> class Passed_edges
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Points = std::vector<typename Complex::Point>;

  // \param destinations of the vertices of the interface in the step
  Passed_edges(Complex& dsc, const Interface_snapshot<Complex>& interface_,
               const Points& destinations, Deformation_visitor<Complex>& visitor)
      : m_dsc(dsc), m_interface(interface_), m_destinations(destinations), m_visitor(visitor),
        m_cavity(dsc), m_neighbors(destinations.size()), m_is_removed(destinations.size(), false) {}

  void collapse() {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (const auto& facet : m_interface.facets())
      for (const std::size_t i : facet.vertices)
        for (const std::size_t j : facet.vertices)
          if (i < j)
            edges.emplace_back(i, j);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [i, j] : edges) {
      m_neighbors[i].push_back(j);
      m_neighbors[j].push_back(i);
    }
    for (std::size_t next = 0; next < edges.size(); ++next) { // collapses append edges
      const auto [i, j] = edges[next];
      if (m_is_removed[i] || m_is_removed[j])
        continue;
      const auto before = m_dsc.displacement(m_interface.vertices[i], m_interface.vertices[j]);
      const auto after = m_interface.domain.nearest_image(m_destinations[i], m_destinations[j]) -
                         m_destinations[i];
      const double along = before * after, squared = before.squared_length();
      if (!is_passed(i, j, along, squared))
        continue;
      if (!collapse_either_way(i, j)) {
        if (along < 0)
          m_reversed.push_back({i, j, squared / (squared - along)});
        continue;
      }
      const std::size_t removed = m_is_removed[i] ? i : j, kept = m_is_removed[i] ? j : i;
      for (const std::size_t k : m_neighbors[removed])
        if (k != kept) {
          m_neighbors[kept].push_back(k);
          m_neighbors[k].push_back(kept);
          edges.emplace_back(kept, k);
        }
    }
  }

  // Returns the number of collapses.
  std::size_t collapsed() const { return m_report.collapsed; }

  // Returns the part of the step after which the first of the other edges is reversed, at most 1.
  double until() const {
    double result = 1;
    for (const Reversed& edge : m_reversed)
      if (!m_is_removed[edge.i] && !m_is_removed[edge.j])
        result = (std::min)(result, edge.until);
    return result;
  }

private:
  // An edge that could not be collapsed.
  struct Reversed
  {
    std::size_t i, j;
    double until; // part of the step
  };

  bool is_passed(std::size_t i, std::size_t j, double along, double squared) const {
    static constexpr double shrinking = .9; // length after the step, relative to the length before
    // Length after the step, relative to the spacing. A deformation removes edges of this length
    // before vertices reach their destinations, and thus less precisely.
    static constexpr double shortest = .25;
    const double spacing =
        (std::min)(m_interface.vertices[i]->spacing(), m_interface.vertices[j]->spacing());
    return along < shrinking * squared && along < shortest * spacing * std::sqrt(squared);
  }

  // Collapses an edge, if possible in the direction in which the interface sweeps less.
  bool collapse_either_way(std::size_t i, std::size_t j) {
    const Vertex_handle v = m_interface.vertices[i], w = m_interface.vertices[j];
    if (volume_swept_by_collapse(m_dsc, w, v) < volume_swept_by_collapse(m_dsc, v, w))
      std::swap(i, j);
    return collapse(i, j) || collapse(j, i);
  }

  // Collapses the vertex i into the vertex j.
  bool collapse(std::size_t i, std::size_t j) {
    const Vertex_handle v = m_interface.vertices[i], w = m_interface.vertices[j];
    m_star.clear();
    m_dsc.star(v, m_star);
    const auto cell =
        std::find_if(m_star.begin(), m_star.end(), [&](auto c) { return c->has_vertex(w); });
    if (cell == m_star.end() ||
        !propose_edge_collapse(m_dsc, *cell, (*cell)->index(v), (*cell)->index(w), 0, m_cavity) ||
        !keeps_volumes(m_dsc, m_cavity))
      return false;
    commit_proposal(m_dsc, m_cavity, m_visitor, m_report);
    m_is_removed[i] = true;
    return true;
  }

  Complex& m_dsc;
  const Interface_snapshot<Complex>& m_interface;
  const Points& m_destinations;
  Deformation_visitor<Complex>& m_visitor;
  Cavity<Complex> m_cavity;
  std::vector<std::vector<std::size_t>> m_neighbors;
  std::vector<char> m_is_removed;
  std::vector<typename Complex::Cell_handle> m_star;
  Improvement_report m_report;
  std::vector<Reversed> m_reversed;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CORNERS_PASSED_EDGES_H
