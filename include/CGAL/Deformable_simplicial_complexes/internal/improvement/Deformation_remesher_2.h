// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_2_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Small_angle_remover_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/neighbor_exchange_2.h>

#include <boost/container/flat_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The remeshing of a deformation in 2D: Algorithm 3, and the removal of short edges, trapped free
// vertices and small angles.
template <class Complex> class Deformation_remesher_2
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;

  Deformation_remesher_2(Complex& complex, Any_visitor<Complex>& visitor,
                         const Destinations<Complex>& destinations,
                         const Rigid_components<Complex>& rigid_components,
                         const Deformation_options<Complex>& options,
                         const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor), m_topology_control(options.topology_control),
        m_energy(options.interface_energy), m_relabeling_threshold(options.relabeling_threshold),
        m_cavity(complex),
        m_improver(complex, visitor, destinations, options.quality_threshold, for_each_index),
        m_small_angles(complex, visitor, rigid_components, options.minimum_angle,
                       options.quality_threshold, for_each_index) {}

  void begin_pass(unsigned pass) { m_improver.begin_pass(pass); }
  bool is_bad(Cell_handle c) const { return m_improver.is_bad(c); }

  void remove_obstacle(Cell_handle c, bool may_remove_facets, Cells& touched) {
    if (may_remove_facets && m_improver.remove_short_edge(c, touched))
      return;
    if (c->quality() < m_relabeling_threshold)
      m_improver.remove_trapped_vertex(c, touched);
  }

  void remove_degenerating_facets(Cells&) {}

  void improve(Cells cells) {
    static constexpr unsigned rounds = 3;
    m_improver.improve(std::move(cells), rounds);
  }

  // Exchanges neighbors at interface edges that end in moved vertices and are short compared with
  // the edges around them.
  template <class Log> void exchange_neighbors(const std::vector<Vertex_handle>& moved, Log& log) {
    static constexpr unsigned junction = 3; // minimum number of interface edges at a junction
    for (Vertex_handle v : moved) {
      if (v->interface_degree() < junction)
        continue;
      m_complex.star(v, m_star);
      for (Cell_handle c : m_star) {
        if (m_complex.is_infinite(c))
          continue;
        const int i = (c->index(v) + 2) % 3; // the edge from `v` with the cell on its left
        const Vertex_handle w = c->vertex((i + 2) % 3);
        if ((w->interface_degree() >= junction || m_complex.is_boundary(w)) &&
            exchange_neighbors(c, i, log))
          break;
      }
    }
  }

  const std::vector<Neighbor_exchange<Complex>>& exchanges() const { return m_exchanges; }

  Cells cells_with_small_angles() const { return m_small_angles.bad_cells(); }
  template <class Relabel> void remove_small_angles(const Relabel&) { m_small_angles.run(); }

  Improvement_report report() const { return m_improver.report() + m_small_angles.report(); }
  std::size_t number_of_relocated() const { return 0; }

private:
  template <class Log> bool exchange_neighbors(Cell_handle c, int i, Log& log) {
    // maximum length of an exchanged edge, relative to the edges around it
    static constexpr double longest = .5;
    const auto exchange = propose_neighbor_exchange(m_complex, c, i, longest, m_cavity, m_energy);
    if (!exchange)
      return false;
    for (Cell_handle side : {c, c->neighbor(i)})
      for (auto label : exchange->joined)
        if (m_topology_control && !m_topology_control(m_complex, side, label))
          return false;
    log.record(c, exchange->joined[0]);
    const auto labels = {exchange->parted[0], exchange->parted[1], exchange->joined[0],
                         exchange->joined[1]};
    boost::container::flat_map<typename Complex::Label, double> areas;
    for (auto label : labels)
      areas.emplace(label, m_complex.measure(label));
    replace_cavity(m_complex, m_cavity, m_visitor);
    for (const auto& [label, area] : areas)
      log.record_exchange(label, m_complex.measure(label) - area);
    m_visitor.after_flip(m_cavity.created());
    m_exchanges.push_back(*exchange);
    return true;
  }

  Complex& m_complex;
  Any_visitor<Complex>& m_visitor;
  const typename Deformation_options<Complex>::Topology_control& m_topology_control;
  const Interface_energy& m_energy;
  double m_relabeling_threshold;
  Cavity<Complex> m_cavity;
  Mesh_improver<Complex> m_improver;
  Small_angle_remover_2<Complex> m_small_angles;
  std::vector<Cell_handle> m_star;
  std::vector<Neighbor_exchange<Complex>> m_exchanges;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_DEFORMATION_REMESHER_2_H
