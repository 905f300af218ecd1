// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPONENT_TRACKER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPONENT_TRACKER_H

#include <CGAL/Deformable_simplicial_complex_3/Component_change.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Connected components of labels. Each cell carries the number of its component; a cell that
// replaces others inherits it. After a change that may have altered components they are numbered
// anew, and the pairs (old number, new number) met on the way tell what merged, split or vanished.
class Component_tracker
{
public:
  using Number = std::uint32_t;

  // The components may have changed.
  void invalidate() { m_is_known = false; }

  template <class Triangulation>
  std::size_t number_of_components(const Triangulation& triangulation, int label) {
    number(triangulation);
    return std::size_t(std::count(m_labels.begin(), m_labels.end(), label));
  }

  // What happened since the last call.
  template <class Triangulation>
  std::vector<Component_change> take_changes(const Triangulation& triangulation) {
    number(triangulation);
    std::vector<std::size_t> targets(m_reference_labels.size()), sources(m_labels.size());
    for (const auto& origin : m_origins) {
      ++targets[origin.first];
      ++sources[origin.second];
    }
    std::vector<Component_change> changes;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      Component_change& change = of_label(changes, m_reference_labels[i]);
      ++change.before;
      targets[i] == 0 ? ++change.vanished : change.split += targets[i] - 1;
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
      Component_change& change = of_label(changes, m_labels[i]);
      ++change.after;
      sources[i] == 0 ? ++change.appeared : change.merged += sources[i] - 1;
    }
    take_reference();
    return changes;
  }

  // Forgets the past: the components of now are the first ones.
  template <class Triangulation> void reset(const Triangulation& triangulation) {
    m_is_known = false;
    number(triangulation);
    take_reference();
  }

private:
  using Origin = std::pair<Number, Number>;

  static Component_change& of_label(std::vector<Component_change>& changes, int label) {
    auto it = std::lower_bound(
        changes.begin(), changes.end(), label,
        [](const Component_change& change, int bound) { return change.label < bound; });
    if (it == changes.end() || it->label != label)
      it = changes.insert(it, Component_change{label});
    return *it;
  }

  static void sort_unique(std::vector<Origin>& origins) {
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  }

  void take_reference() {
    m_reference_labels = m_labels;
    m_origins.clear();
    for (Number i = 0; i < m_labels.size(); ++i)
      m_origins.emplace_back(i, i);
  }

  template <class Triangulation> void number(const Triangulation& triangulation) {
    if (m_is_known)
      return;
    using Cell_handle = typename Triangulation::Cell_handle;
    // New numbers begin above the old ones; cells that were never numbered have number 0.
    const Number first = (std::max)(Number(1), Number(m_labels.size()));
    const std::vector<int> labels_before = std::move(m_labels);
    m_labels.clear();
    std::vector<Origin> origins;
    std::vector<Cell_handle> front;
    for (Cell_handle seed : triangulation.finite_cell_handles()) {
      if (seed->component() >= first)
        continue;
      const Number component = Number(m_labels.size());
      m_labels.push_back(seed->label());
      const auto visit = [&](Cell_handle c) {
        const Origin origin(c->component(), component);
        // A cell that changed its label without a neighbor to join comes from no component of it.
        const bool has_origin =
            origin.first < labels_before.size() && labels_before[origin.first] == c->label();
        if (has_origin && (origins.empty() || origins.back() != origin))
          origins.push_back(origin);
        c->set_component(first + component);
        front.push_back(c);
      };
      visit(seed);
      while (!front.empty()) {
        const Cell_handle c = front.back();
        front.pop_back();
        for (int i = 0; i < 4; ++i) {
          const Cell_handle n = c->neighbor(i);
          if (n->label() == c->label() && n->component() < first && !triangulation.is_infinite(n))
            visit(n);
        }
      }
    }
    for (Cell_handle c : triangulation.finite_cell_handles())
      c->set_component(c->component() - first);
    sort_unique(origins);

    // The changes before this numbering and those in it compose.
    std::vector<Origin> composed;
    for (const Origin& before : m_origins) {
      auto now = std::lower_bound(origins.begin(), origins.end(), Origin(before.second, 0));
      for (; now != origins.end() && now->first == before.second; ++now)
        composed.emplace_back(before.first, now->second);
    }
    sort_unique(composed);
    m_origins = std::move(composed);
    m_is_known = true;
  }

  std::vector<int> m_labels;           // of the components of now, by number
  std::vector<int> m_reference_labels; // of the components when changes were last taken
  std::vector<Origin> m_origins;       // (number in the reference, number now)
  bool m_is_known = true;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_COMPONENT_TRACKER_H
