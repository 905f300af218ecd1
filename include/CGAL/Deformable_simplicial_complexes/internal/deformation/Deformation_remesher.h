// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORMATION_REMESHER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORMATION_REMESHER_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/Small_angle_remover_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/Small_angle_remover_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Destinations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/neighbor_exchange_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The remeshing of a deformation: Algorithm 3, and the removal of small angles. In 2D, it also
// exchanges neighbors. Cells that an operation creates or changes are appended to `touched`.
template <class Complex> class Deformation_remesher
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Cells = Work_list<Cell_handle>;

  Deformation_remesher(Complex& complex, Deformation_visitor<Complex>& visitor,
                       const Destinations<Complex>& destinations,
                       const Rigid_components<Complex>& rigid_components,
                       const Deformation_options<Complex>& options,
                       const For_each_index& for_each_index)
      : m_complex(complex), m_visitor(visitor), m_destinations(destinations),
        m_for_each_index(for_each_index), m_topology_control(options.topology_control),
        m_energy(options.interface_energy), m_relabeling_threshold(options.relabeling_threshold),
        m_degenerate_cosine(std::cos(options.minimum_facet_angle * (CGAL_PI / 180))),
        m_cavity(complex),
        m_improver(complex, visitor, destinations, options.quality_threshold, for_each_index),
        m_small_angles(complex, visitor, destinations, rigid_components, options.minimum_angle,
                       options.quality_threshold, for_each_index) {}

  Mesh_improver<Complex>& improver() { return m_improver; }

  // Prepares a pass; some vertices have not reached their destinations.
  void begin_pass(unsigned pass) {
    m_improver.begin_pass(pass);
    if constexpr (d == 3)
      find_degenerating_facets();
  }

  // Removes a cell that keeps a vertex from its destination.
  void remove_obstacle(Cell_handle c, bool may_remove_facets, Cells& touched) {
    if constexpr (d == 3) {
      static constexpr double cosine = .94; // the cosine of 20 degrees
      if (may_remove_facets && remove_degenerate_facet(c, cosine, touched))
        return;
    }
    if (may_remove_facets && m_improver.remove_short_edge(c, touched))
      return;
    if (c->quality() < m_relabeling_threshold)
      m_improver.remove_trapped_vertex(c, touched);
  }

  // Removes interface facets in 3D that the pass made degenerate.
  void remove_degenerating_facets([[maybe_unused]] Cells& touched) {
    if constexpr (d == 3)
      for (const Facet_item& item : m_degenerating)
        if (m_complex.is_alive(item.cell, item.time_stamp))
          m_improver.remove_degenerate_facet(item.cell, item.index, m_degenerate_cosine, touched);
  }

  // After the passes in 2D, exchanges neighbors at interface edges that end in moved vertices and
  // are short compared with the edges around them.
  template <class Log>
  void exchange_neighbors([[maybe_unused]] const std::vector<Vertex_handle>& moved,
                          [[maybe_unused]] Log& log) {
    if constexpr (d == 2) {
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
  }

  const std::vector<Neighbor_exchange<Complex>>& exchanges() const { return m_exchanges; }

  Cells cells_with_small_angles() const { return m_small_angles.bad_cells(); }

  // Removes small angles after the passes. `relabel(c, label)` changes the label of a cell if this
  // preserves the topology, and returns whether it did.
  template <class Relabel> void remove_small_angles(const Relabel& relabel) {
    m_small_angles.run(relabel);
  }

  Improvement_report report() const { return m_improver.report() + m_small_angles.report(); }
  std::size_t number_of_relocated() const { return m_small_angles.number_of_relocated(); }

private:
  static constexpr int d = Complex::dimension;
  using Small_angle_remover =
      std::conditional_t<d == 2, Small_angle_remover_2<Complex>, Small_angle_remover_3<Complex>>;

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

  struct Facet_item
  {
    Cell_handle cell;
    std::size_t time_stamp; // used to detect that the cell was replaced
    int index;
  };

  // Collects the interface facets that will have a small angle at their destinations, smaller than
  // before the motion. Facets of regions that move rigidly are thus not collected.
  void find_degenerating_facets() {
    const std::vector<Vertex_handle>& unfinished = m_destinations.unfinished();
    m_degenerating.clear();
    const Vertex_numbers numbers(m_complex, unfinished);
    std::vector<typename Complex::Point> destinations;
    for (std::size_t k = 0; k < unfinished.size(); ++k)
      destinations.push_back(m_destinations.destination(k));
    const auto final = [&](Vertex_handle v) {
      const std::uint32_t number = numbers(v);
      return number != Vertex_numbers::none ? destinations[number] : m_complex.position(v);
    };
    const auto degenerates = [&](Cell_handle c, int i) {
      return is_interface_from(c, i) && will_degenerate({c, i}, final);
    };
    std::vector<Cell_handle> cells = star_union_if(
        m_complex, unfinished,
        [&](Cell_handle c) {
          return degenerates(c, 0) || degenerates(c, 1) || degenerates(c, 2) || degenerates(c, 3);
        },
        m_for_each_index);
    sort_by_time_stamp(cells);
    for (Cell_handle c : cells)
      for (int i = 0; i < 4; ++i)
        if (degenerates(c, i))
          m_degenerating.push_back({c, c->time_stamp(), i});
  }

  // Returns whether a facet lies on the interface and its cell is on the side with the larger
  // label.
  bool is_interface_from(Cell_handle c, int i) const {
    const Cell_handle n = c->neighbor(i);
    return n->subdomain_index() < c->subdomain_index() && !m_complex.is_infinite(n);
  }

  // Returns whether a facet will have a small angle that is clearly smaller than before the motion:
  // a needle of the input that keeps its shape stays. `final` returns destinations of vertices.
  template <class Final>
  bool will_degenerate(const typename Complex::Facet& f, const Final& final) const {
    using Triangle = std::array<typename Complex::Point, 3>;
    const auto v = m_complex.facet_vertices(f);
    const auto cosine_with = [&](const auto& position_of) {
      const auto p = position_of(v[0]);
      return largest_cosine(Triangle{p, m_complex.domain().nearest_image(p, position_of(v[1])),
                                     m_complex.domain().nearest_image(p, position_of(v[2]))});
    };
    const double after = cosine_with(final);
    if (!(after > m_degenerate_cosine))
      return false;
    const bool is_old =
        std::all_of(v.begin(), v.end(), [&](Vertex_handle w) { return m_destinations.had(w); });
    const double before = cosine_with([&](Vertex_handle w) {
      return is_old ? m_destinations.position_before(w) : m_complex.position(w);
    });
    return std::sqrt(1 - after * after) < reduction_of_angles * std::sqrt(1 - before * before);
  }

  // Removes one degenerate interface facet of a cell. Returns whether there was one that could be
  // removed.
  bool remove_degenerate_facet(Cell_handle c, double cosine, Cells& touched) {
    for (int i = 0; i < 4; ++i)
      if (m_improver.remove_degenerate_facet(c, i, cosine, touched))
        return true;
    return false;
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Destinations<Complex>& m_destinations;
  const For_each_index& m_for_each_index;
  const typename Deformation_options<Complex>::Topology_control& m_topology_control;
  const Interface_energy& m_energy;
  double m_relabeling_threshold;
  double m_degenerate_cosine; // cosine of the bound on angles of facets
  Cavity<Complex> m_cavity;
  Mesh_improver<Complex> m_improver;
  Small_angle_remover m_small_angles;
  std::vector<Cell_handle> m_star;
  std::vector<Neighbor_exchange<Complex>> m_exchanges;
  std::vector<Facet_item> m_degenerating;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DEFORMATION_DEFORMATION_REMESHER_H
