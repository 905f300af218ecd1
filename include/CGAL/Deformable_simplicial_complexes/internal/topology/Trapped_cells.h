// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Contacts.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/motion/Rigid_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Manifold_relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Topology_log.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <unordered_set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Relabels cells that are trapped between parts of the interface. Cells that keep the topology are
// relabeled first, followed by their neighbors. A cell that changes the topology is relabeled only
// when no other cell is left; then cells that keep the topology are relabeled again. So two
// components that meet merge from one place, instead of touching in many places. If the interface
// must stay manifold, other cells are relabeled together with a cell, or the cell keeps its label.
template <class Complex> class Trapped_cells
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;
  using Topology_control = typename Deformation_options<Complex>::Topology_control;

  Trapped_cells(Complex& complex, Deformation_visitor<Complex>& visitor,
                const Destinations<Complex>& destinations, const Contacts<Complex>& contacts,
                const Rigid_components<Complex>& rigid_components,
                const Deformation_options<Complex>& options)
      : m_complex(complex), m_visitor(visitor), m_contacts(contacts),
        m_rigid_components(rigid_components), m_tolerance(complex, &destinations),
        m_topology_control(options.topology_control), m_energy(options.interface_energy),
        m_manifold_interface(options.manifold_interface), m_log(complex) {}

  Topology_log<Complex>& log() { return m_log; }
  std::size_t number_of_relabeled() const { return m_relabeled; }

  // Relabels cells among the given cells and the cells around them, if they are trapped, below a
  // threshold of quality, and closed by the motion, where they are below `final_threshold`. If the
  // topology stays, it is enough that they are small and do not move rigidly. Each cell is
  // relabeled at most once, except in components that are cut off and vanish.
  void relabel(const std::vector<Cell_handle>& cells, double threshold, double final_threshold) {
    m_final_threshold = final_threshold;
    m_done.clear();
    std::vector<Cell_handle> front = cells;
    spread(front, threshold);
    std::vector<Cell_handle> proposed;
    for (Cell_handle c : cells) {
      Progress_scope::check();
      Label label;
      if (!propose(c, threshold, false, proposed, label) ||
          relabeling_keeps_topology(m_complex, proposed, label) || !may_change_topology(c, label))
        continue;
      record(proposed, label);
      relabel(proposed, label);
      front.clear();
      add_neighbors(proposed, front);
      // components that were cut off where parts of the interface meet
      remove_small_components(front, [this](const std::vector<Cell_handle>& component) {
        return m_contacts.is_thin(component) || m_contacts.vanishes(component);
      });
      spread(front, threshold);
    }
  }

  // Gives small components of the cells that the motion makes vanish the label of the surrounding
  // phase.
  void remove_vanishing_components(const std::vector<Cell_handle>& cells) {
    remove_small_components(cells, [this](const std::vector<Cell_handle>& component) {
      return m_contacts.vanishes(component);
    });
  }

  // Relabels a cell of any shape if this keeps the topology. Each cell is relabeled at most once
  // after a call of relabel(). Returns whether the cell was relabeled.
  bool relabel_if_topology_stays(Cell_handle c, Label label) {
    std::vector<Cell_handle> cells(1, c);
    if (is_done(c) || m_complex.is_constrained(c) ||
        !relabeling_keeps_topology(m_complex, c, label) || !complete(cells, label) ||
        cells.size() > 1)
      return false;
    relabel(cells, label);
    return true;
  }

private:
  // Gives small components of the cells for which `is_to_go(component)` is true the label of the
  // surrounding phase.
  template <class Is_to_go>
  void remove_small_components(const std::vector<Cell_handle>& cells, const Is_to_go& is_to_go) {
    std::vector<Cell_handle> component;
    std::unordered_set<std::size_t> large; // cells of components known not to be small
    for (Cell_handle c : cells) {
      Progress_scope::check();
      if (is_small_component(c, component, large) && is_to_go(component)) {
        const Label label = surrounding_label(component);
        if (label == c->subdomain_index() || !complete(component, label) ||
            std::any_of(component.begin(), component.end(),
                        [&](Cell_handle d) { return m_complex.is_constrained(d); }) ||
            !may_change_topology(c, label))
          continue;
        record(component, label);
        relabel(component, label);
        large.clear(); // a component may have lost cells
      }
    }
  }

  // Finds the component of a cell. Returns whether its volume is small relative to the interface
  // edges around it, and it has few cells or fits within an edge length. Otherwise the time stamps
  // of the visited cells are added to `large`, so that they are not visited again.
  bool is_small_component(Cell_handle seed, std::vector<Cell_handle>& component,
                          std::unordered_set<std::size_t>& large) const {
    static constexpr std::size_t few = 30;
    const auto center = seed->vertex(0);
    const double edge = local_edge_length<Complex>(m_complex, {seed});
    bool is_small = true, is_near = true;
    component.assign(1, seed);
    for (std::size_t i = 0; i < component.size() && is_small; ++i) {
      const Cell_handle c = component[i];
      for (int k = 0; k < Complex::corners; ++k)
        is_near =
            is_near && Complex::Space::length(m_complex.displacement(center, c->vertex(k))) < edge;
      is_small = (component.size() <= few || is_near) && large.count(c->time_stamp()) == 0 &&
                 !m_complex.is_constrained(c);
      for (int k = 0; k < Complex::corners; ++k) {
        const Cell_handle n = c->neighbor(k);
        if (!m_complex.is_infinite(n) && n->subdomain_index() == c->subdomain_index() &&
            std::find(component.begin(), component.end(), n) == component.end())
          component.push_back(n);
      }
    }
    is_small = is_small && volume(component) < small_volume(component);
    for (std::size_t i = 0; i < component.size() && !is_small; ++i)
      large.insert(component[i]->time_stamp());
    return is_small;
  }

  // Returns the volume of a regular cell whose edge length is the local edge length at the cells.
  double small_volume(const std::vector<Cell_handle>& cells) const {
    return Complex::Space::regular_measure(local_edge_length(m_complex, cells));
  }

  double volume(const std::vector<Cell_handle>& cells) const {
    double sum = 0;
    for (Cell_handle c : cells)
      sum += m_complex.measure(c);
    return sum;
  }

  // Returns the label that decreases the energy of the interface most if a component gets it, among
  // its neighbors; the label of the component if it has no neighbors.
  Label surrounding_label(const std::vector<Cell_handle>& component) const {
    boost::container::flat_map<Label, double> areas;
    for (Cell_handle c : component)
      for (int i = 0; i < Complex::corners; ++i)
        if (m_complex.is_interface(std::make_pair(c, i)))
          areas[c->neighbor(i)->subdomain_index()] += m_complex.measure(std::make_pair(c, i));
    Label result = component.front()->subdomain_index();
    double least = std::numeric_limits<double>::infinity();
    for (const auto& candidate : areas) {
      const double energy = m_energy.of_boundary(candidate.first, areas);
      if (energy < least) {
        least = energy;
        result = candidate.first;
      }
    }
    return result;
  }

  // Relabels cells that keep the topology, and then the cells around them.
  void spread(std::vector<Cell_handle>& front, double threshold) {
    std::vector<Cell_handle> proposed;
    for (std::size_t i = 0; i < front.size(); ++i) {
      Label label;
      if (propose(front[i], threshold, true, proposed, label) &&
          relabeling_keeps_topology(m_complex, proposed, label)) {
        m_tolerance.record();
        relabel(proposed, label);
        add_neighbors(proposed, front);
      }
    }
  }

  // Finds the cells to be relabeled together with a trapped cell, which comes first, and their new
  // label. Returns false if the cell must not be relabeled.
  // \param may_be_small whether a small cell need not be closed by the motion
  bool propose(Cell_handle c, double threshold, bool may_be_small, std::vector<Cell_handle>& cells,
               Label& label) {
    m_tolerance.forget();
    if (is_done(c) || m_complex.is_constrained(c) ||
        !propose_relabeling(m_complex, c, threshold, label, m_energy) ||
        m_rigid_components.moves_rigidly(c) ||
        !(m_contacts.closes(c, m_final_threshold) || (may_be_small && is_small(c, label))))
      return false;
    cells.assign(1, c);
    return complete(cells, label) && volume(cells) - volume({c}) < small_volume({c}) &&
           std::none_of(cells.begin(), cells.end(),
                        [&](Cell_handle d) { return is_done(d) || m_complex.is_constrained(d); });
  }

  // Returns whether a cell passes a small part of the volume around it to a label.
  bool is_small(Cell_handle c, Label label) {
    for (int i = 0; i < Complex::corners; ++i)
      if (!m_complex.is_infinite(c->neighbor(i)) && c->neighbor(i)->subdomain_index() == label)
        return m_tolerance.allows_relabeling({c, i});
    return false;
  }

  // Appends the cells that must also be relabeled to keep the interface manifold, independent of
  // their quality. Returns whether this is possible.
  bool complete(std::vector<Cell_handle>& cells, Label label) const {
    return !m_manifold_interface ||
           Manifold_relabeling<Complex>(m_complex, cells, label).complete();
  }

  bool is_done(Cell_handle c) const { return m_done.count(c->time_stamp()) != 0; }

  void add_neighbors(const std::vector<Cell_handle>& cells, std::vector<Cell_handle>& front) const {
    for (Cell_handle c : cells)
      for (int i = 0; i < Complex::corners; ++i)
        if (!m_complex.is_infinite(c->neighbor(i)))
          front.push_back(c->neighbor(i));
  }

  void record(const std::vector<Cell_handle>& cells, Label label) {
    for (Cell_handle c : cells)
      m_log.record(c, label);
  }

  bool may_change_topology(Cell_handle c, Label label) const {
    return !m_topology_control || m_topology_control(m_complex, c, label);
  }

  // Relabels cells of one label. The visitor is called after all cells have the new label.
  void relabel(const std::vector<Cell_handle>& cells, Label label) {
    const Label before = cells.front()->subdomain_index();
    for (Cell_handle c : cells) {
      m_log.record_relabeling(before, label, m_contacts.final_volume(c));
      m_complex.relabel(c, label);
      m_done.insert(c->time_stamp());
    }
    m_relabeled += cells.size();
    for (Cell_handle c : cells)
      m_visitor.after_relabel(c, before);
  }

  Complex& m_complex;
  Deformation_visitor<Complex>& m_visitor;
  const Contacts<Complex>& m_contacts;
  const Rigid_components<Complex>& m_rigid_components;
  Interface_tolerance<Complex> m_tolerance;
  const Topology_control& m_topology_control;
  const Interface_energy& m_energy;
  bool m_manifold_interface;
  Topology_log<Complex> m_log;
  std::unordered_set<std::size_t> m_done; // time stamps of relabeled cells
  double m_final_threshold = 0;           // bound on the quality at the destinations
  std::size_t m_relabeled = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H
