// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/local_edge_length.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Manifold_relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/internal/topology/Topology_log.h>
#include <CGAL/Deformable_simplicial_complexes/relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/topology_of_relabeling.h>

#include <boost/container/flat_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The user's answer to whether a cell may take a label that changes the topology.
template <class Complex>
using Topology_control =
    std::function<bool(const Complex&, typename Complex::Cell_handle, typename Complex::Label)>;

// Relabels cells that are trapped between parts of the interface. Those that keep the topology go
// first, and draw their neighbors along; one that changes it is relabeled when nothing else is left
// to do, and then again first those that keep it. So two parts that meet grow together from one
// place, instead of touching in many. Where the interface is to be manifold, a cell takes others
// along with it, or keeps its label.
template <class Complex> class Trapped_cells
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;

  Trapped_cells(Complex& complex, Any_visitor<Complex>& visitor,
                const Topology_control<Complex>& topology_control, bool manifold_interface)
      : m_complex(complex), m_visitor(visitor), m_topology_control(topology_control),
        m_manifold_interface(manifold_interface), m_log(complex) {}

  Topology_log<Complex>& log() { return m_log; }
  std::size_t number_of_relabeled() const { return m_relabeled; }

  // Relabels those of the cells, and of those around, that are trapped, below the threshold, and
  // flat, as is_flat(c) says. Each joins another phase only once, but for what is cut off and too
  // small to stay.
  template <class Is_flat>
  void relabel(const std::vector<Cell_handle>& cells, double threshold, const Is_flat& is_flat) {
    m_done.clear();
    std::vector<Cell_handle> front = cells;
    spread(front, threshold, is_flat);
    std::vector<Cell_handle> proposed;
    for (Cell_handle c : cells) {
      Progress_scope::check();
      Label label;
      if (!propose(c, threshold, is_flat, proposed, label) ||
          relabeling_keeps_topology(m_complex, proposed, label) ||
          !m_topology_control(m_complex, c, label))
        continue;
      record(proposed, label);
      relabel(proposed, label);
      front.clear();
      add_neighbors(proposed, front);
      remove_small_components(front); // what has just been cut off
      spread(front, threshold, is_flat);
    }
  }

  // Gives components that are too small to be moved, those of the cells, to the phases around them.
  void remove_small_components(const std::vector<Cell_handle>& cells) {
    std::vector<Cell_handle> component;
    std::unordered_set<std::size_t> large; // cells of components that are known not to be small
    for (Cell_handle c : cells) {
      Progress_scope::check();
      if (is_small_component(c, component, large)) {
        const Label label = surrounding_label(component);
        if (label == c->label() || !complete(component, label) ||
            !m_topology_control(m_complex, c, label))
          continue;
        record(component, label);
        relabel(component, label);
        large.clear(); // a component may have lost cells
      }
    }
  }

  // Relabels a cell whatever its shape, if that keeps the topology; once after each relabel().
  bool relabel_if_topology_stays(Cell_handle c, Label label) {
    std::vector<Cell_handle> cells(1, c);
    if (is_done(c) || !relabeling_keeps_topology(m_complex, c, label) || !complete(cells, label) ||
        cells.size() > 1)
      return false;
    relabel(cells, label);
    return true;
  }

private:
  // Finds the component of a cell if it is small for the interface around it, and has few cells or
  // lies within an edge. If not, the cells that were met join those in `large`, by time stamps, so
  // that none of them is looked at again.
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
      is_small = (component.size() <= few || is_near) && large.count(c->time_stamp()) == 0;
      for (int k = 0; k < Complex::corners; ++k) {
        const Cell_handle n = c->neighbor(k);
        if (!m_complex.is_infinite(n) && n->label() == c->label() &&
            std::find(component.begin(), component.end(), n) == component.end())
          component.push_back(n);
      }
    }
    is_small = is_small && volume(component) < small_volume(component);
    for (std::size_t i = 0; i < component.size() && !is_small; ++i)
      large.insert(component[i]->time_stamp());
    return is_small;
  }

  // That of a regular cell whose edges are as long as those of the interface at some cells.
  double small_volume(const std::vector<Cell_handle>& cells) const {
    return Complex::Space::regular_measure(local_edge_length(m_complex, cells));
  }

  double volume(const std::vector<Cell_handle>& cells) const {
    double sum = 0;
    for (Cell_handle c : cells)
      sum += m_complex.measure(c);
    return sum;
  }

  // The label that shares most area with a component; its own if it has no neighbors.
  Label surrounding_label(const std::vector<Cell_handle>& component) const {
    boost::container::flat_map<Label, double> areas;
    for (Cell_handle c : component)
      for (int i = 0; i < Complex::corners; ++i)
        if (m_complex.is_interface(std::make_pair(c, i)))
          areas[c->neighbor(i)->label()] += m_complex.measure(std::make_pair(c, i));
    const auto largest =
        std::max_element(areas.begin(), areas.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return largest == areas.end() ? component.front()->label() : largest->first;
  }

  // Relabels cells that keep the topology, and those around them.
  template <class Is_flat>
  void spread(std::vector<Cell_handle>& front, double threshold, const Is_flat& is_flat) {
    std::vector<Cell_handle> proposed;
    for (std::size_t i = 0; i < front.size(); ++i) {
      Label label;
      if (propose(front[i], threshold, is_flat, proposed, label) &&
          relabeling_keeps_topology(m_complex, proposed, label)) {
        relabel(proposed, label);
        add_neighbors(proposed, front);
      }
    }
  }

  // Finds the cells to be relabeled with a trapped one, which comes first, and their new label.
  template <class Is_flat>
  bool propose(Cell_handle c, double threshold, const Is_flat& is_flat,
               std::vector<Cell_handle>& cells, Label& label) const {
    if (is_done(c) || !propose_relabeling(m_complex, c, threshold, label) || !is_flat(c))
      return false;
    cells.assign(1, c);
    return complete(cells, label) && volume(cells) - volume({c}) < small_volume({c}) &&
           std::none_of(cells.begin(), cells.end(), [&](Cell_handle d) { return is_done(d); });
  }

  // Appends what else must be relabeled for the sake of a manifold interface, whatever its quality.
  // Returns whether that is possible.
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

  // Cells of one label. The visitor is told when all of them have the new one.
  void relabel(const std::vector<Cell_handle>& cells, Label label) {
    const Label before = cells.front()->label();
    for (Cell_handle c : cells) {
      m_complex.relabel(c, label);
      m_done.insert(c->time_stamp());
    }
    m_relabeled += cells.size();
    for (Cell_handle c : cells)
      m_visitor.after_relabel(c, before);
  }

  Complex& m_complex;
  Any_visitor<Complex>& m_visitor;
  const Topology_control<Complex>& m_topology_control;
  bool m_manifold_interface;
  Topology_log<Complex> m_log;
  std::unordered_set<std::size_t> m_done; // by time stamp
  std::size_t m_relabeled = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TRAPPED_CELLS_H
