// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TOPOLOGY_LOG_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TOPOLOGY_LOG_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A record of the topology changes of components in a deformation, and their places.
template <class Complex> class Topology_log
{
public:
  using Label = typename Complex::Label;
  using Cell_handle = typename Complex::Cell_handle;
  using Event = Topology_event<Complex>;
  using Label_change = typename Deformation_report<Complex>::Label_change;

  explicit Topology_log(Complex& complex) : m_complex(complex) {}

  void begin() {
    m_complex.take_component_events();
    for (Label label : m_complex.labels()) {
      Label_change& change = change_of_label(m_labels, label);
      change.volume_before = m_complex.measure(label);
      change.before = m_complex.number_of_components(label);
    }
  }

  // Records a volume that the motion of the interface adds to a label.
  void record_swept(Label label, double volume) {
    change_of_label(m_labels, label).volume_swept += volume;
  }

  // Records that a cell takes another label. With its vertices at their destinations, the cell has
  // a signed volume. If it is negative, parts of the interface overlap there, and the swept volumes
  // count the cell twice.
  void record_relabeling(Label before, Label after, double final_volume) {
    const double overlap = (std::max)(0., -final_volume);
    change_of_label(m_labels, before).volume_of_overlaps += overlap;
    change_of_label(m_labels, after).volume_of_overlaps -= overlap;
  }

  // Records the volume that a label gains by an exchange of neighbors.
  void record_exchange(Label label, double volume) {
    change_of_label(m_labels, label).volume_of_overlaps += volume;
  }

  // Records that a cell is about to take another label, which changes the topology.
  void record(Cell_handle c, Label label) {
    m_changes.push_back({m_complex.domain().canonical(barycenter(m_complex, c)), c, c->time_stamp(),
                         c->subdomain_index(), label, c->component()});
  }

  // Finds the events since the last call and reports them to the visitor. Must be called before
  // cells are replaced: a cell of merged components stores the number of only one of them.
  void find_events(unsigned pass, Deformation_visitor<Complex>& visitor) {
    if (m_changes.empty())
      return;
    const std::size_t known = m_events.size();
    add_events(pass);
    for (std::size_t i = known; i < m_events.size(); ++i)
      visitor.after_topology_event(m_events[i]);
  }

  void report(unsigned passes, Deformation_report<Complex>& report) {
    add_events(passes);
    for (const Event& event : m_events)
      count_event(event, m_labels);
    for (Label label : m_complex.labels())
      change_of_label(m_labels, label);
    for (Label_change& change : m_labels) {
      change.volume_after = m_complex.measure(change.label);
      change.after = m_complex.number_of_components(change.label);
    }
    report.labels = m_labels;
    report.events = m_events;
  }

private:
  // A change of the label of a cell.
  struct Change
  {
    typename Complex::Point where;
    Cell_handle cell;
    std::size_t time_stamp;
    Label from, to;
    std::uint32_t component; // before the change
  };

  void add_events(unsigned pass) {
    for (const Component_event& event : m_complex.take_component_events())
      m_events.push_back({event, place(event), pass});
    m_changes.clear();
  }

  // Returns a point where a cell left or joined one of the components of an event.
  typename Complex::Point place(const Component_event& event) const {
    const auto has = [](const std::vector<Component_event::Component>& components,
                        std::uint32_t number) {
      return std::any_of(
          components.begin(), components.end(),
          [&](const Component_event::Component& item) { return item.component == number; });
    };
    const auto takes_part = [&](const Change& change) {
      return (change.from == event.label && has(event.before, change.component)) ||
             (change.to == event.label && m_complex.is_alive(change.cell, change.time_stamp) &&
              has(event.after, change.cell->component()));
    };
    const auto it = std::find_if(m_changes.begin(), m_changes.end(), takes_part);
    return it != m_changes.end() ? it->where
           : m_changes.empty()   ? CGAL::ORIGIN
                                 : m_changes.front().where;
  }

  Complex& m_complex;
  std::vector<Change> m_changes; // since the last call of find_events()
  std::vector<Event> m_events;
  std::vector<Label_change> m_labels;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_TOPOLOGY_LOG_H
