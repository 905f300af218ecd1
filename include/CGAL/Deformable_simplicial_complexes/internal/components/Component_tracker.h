// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_COMPONENT_TRACKER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_COMPONENT_TRACKER_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/components/Doubted_connections.h>
#include <CGAL/Deformable_simplicial_complexes/internal/components/kept_components.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <iterator>
#include <mutex>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The connected components of labels and their volumes. Each cell stores the number of its
// component; a cell that replaces others inherits the number. After a change that may have altered
// components, they are renumbered in the order of their oldest cells. The old and the new numbers
// of cells then determine which components merged, split or vanished.
template <class Cell_handle> class Component_tracker
{
public:
  using Number = std::uint32_t;

  // Records that components may have changed. Their volumes become those before the first
  // connection that is not confirmed: volumes that were added since then can belong to a part that
  // was cut off, and events report volumes before the change.
  void invalidate() {
    if (!m_doubts.empty())
      m_components.swap(m_before_doubts);
    m_doubts.clear();
    m_is_known = false;
    m_is_counted = false;
  }

  // Updates the state before a cell gets another label. Components are unchanged if two conditions
  // hold. First, there are finite neighbors with the new label, and they belong to one component.
  // Second, the neighbors with the old label stay connected around the cell. If a local search does
  // not find this connection, it is checked later. Nothing changes if memory is exhausted.
  template <class Complex>
  void prepare_relabeling(const Complex& complex, Cell_handle c, int label) {
    if (!m_is_known || !m_doubts.empty())
      m_is_counted = false;
    if (!m_is_known)
      return;
    std::vector<Cell_handle> left, joined;
    for (int i = 0; i < Complex::corners; ++i)
      if (const Cell_handle n = c->neighbor(i); !complex.is_infinite(n)) {
        if (n->subdomain_index() == c->subdomain_index())
          left.push_back(n);
        else if (n->subdomain_index() == label)
          joined.push_back(n);
      }
    const bool joins_one =
        !joined.empty() && std::all_of(joined.begin(), joined.end(), [&](auto n) {
          return n->component() == joined.front()->component();
        });
    if (!joins_one || !leaves_one(complex, c, left))
      invalidate();
  }

  // Checks the connections that are not confirmed yet, and so determines whether components have
  // changed. Must be called before cells are replaced.
  template <class Complex> void settle(const Complex& complex) {
    if (m_doubts.empty())
      return;
    if (!m_doubts.are_dispelled(complex)) {
      invalidate();
      return;
    }
    m_counts = counts_of(m_components);
    m_is_counted = true;
    m_doubts.clear();
  }

  // Returns whether components have not changed since they were numbered.
  // \pre `settle()` was called.
  bool is_known() const { return m_is_known; }

  // Adds to the volume of a component, in the units of `Label_totals`.
  void add_volume(Number component, std::int64_t units) {
    if (m_is_known)
      m_components[component].volume += units;
  }

  // Renumbers components if they may have changed. `totals` defines the unit of volumes, in which
  // sums are exact. Nothing changes if memory is exhausted.
  template <class Complex> void update(const Complex& complex, const Label_totals& totals) {
    const std::lock_guard<std::mutex> lock(m_guard.mutex);
    settle(complex);
    if (m_is_known)
      return;
    Numbering now = number(complex, totals);
    std::vector<Component_event> events = compare(now, totals);
    std::vector<Origin> lineage = prolonged_lineage(now.origins);
    std::vector<Count> counts = counts_of(now.components);
    m_events.insert(m_events.end(), std::make_move_iterator(events.begin()),
                    std::make_move_iterator(events.end()));
    // No exception is thrown from here on.
    for (auto c : complex.finite_cells())
      Simplex_access::set_component(c, now.of_cell[c->id()]);
    m_components.swap(now.components);
    m_lineage.swap(lineage);
    m_counts.swap(counts);
    m_is_known = m_is_counted = true;
  }

  // Clears events and lineage: the current components become the first ones.
  // \pre No cell has a number.
  template <class Complex> void reset(const Complex& complex, const Label_totals& totals) {
    invalidate();
    m_components.clear();
    update(complex, totals);
    m_events.clear();
    begin_lineage();
  }

  // Gives the components the numbers that their cells had earlier. Returns false if these numbers
  // do not fit the components.
  // \pre `is_known()`
  template <class Complex>
  bool renumber(const Complex& complex, const std::vector<Cell_handle>& cells,
                const std::vector<Number>& numbers) {
    const std::size_t n = m_components.size();
    std::vector<Number> former(n, Number(n)); // `n` means none
    std::vector<Component> components(n);
    std::vector<bool> is_taken(n, false);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (complex.is_infinite(cells[i]))
        continue;
      const Number now = cells[i]->component();
      if (former[now] == n && numbers[i] < n && !is_taken[numbers[i]]) {
        former[now] = numbers[i];
        is_taken[numbers[i]] = true;
        components[numbers[i]] = m_components[now];
      }
      if (former[now] != numbers[i] || numbers[i] >= n)
        return false;
      Simplex_access::set_component(cells[i], numbers[i]);
    }
    m_components = std::move(components);
    begin_lineage();
    return true;
  }

  // Returns the current number of components of a label, even if they are not numbered. This query
  // changes no component number.
  template <class Complex>
  std::size_t number_of_components(const Complex& complex, int label) const {
    const std::lock_guard<std::mutex> lock(m_guard.mutex);
    if (!m_is_counted)
      count(complex);
    const auto it = std::lower_bound(m_counts.begin(), m_counts.end(), label, is_below);
    return it != m_counts.end() && it->label == label ? it->number : 0;
  }

  // Returns the events found by the updates since the last call.
  std::vector<Component_event> take_events() {
    std::vector<Component_event> result;
    result.swap(m_events);
    return result;
  }

  // Returns sorted pairs (number at the last call, current number) of components that have cells in
  // common.
  std::vector<std::pair<Number, Number>> take_lineage() {
    std::vector<Origin> result;
    result.swap(m_lineage);
    begin_lineage();
    return result;
  }

  // Returns whether numbers and volumes are correct, by an independent traversal. Returns true if
  // they are not known or if a connection is not confirmed.
  template <class Complex> bool is_right(const Complex& complex, const Label_totals& totals) const {
    const std::lock_guard<std::mutex> lock(m_guard.mutex);
    if (!m_is_known || !m_doubts.are_dispelled(complex))
      return true;
    std::vector<bool> is_found(m_components.size(), false);
    Marks marks = cell_marks(complex);
    for (Cell_handle seed : complex.finite_cells()) {
      if (marks.has(seed))
        continue;
      const Number i = seed->component();
      if (i >= m_components.size() || is_found[i] ||
          m_components[i].label != seed->subdomain_index())
        return false;
      is_found[i] = true;
      std::int64_t volume = 0;
      for (Cell_handle c : component_of(complex, seed, marks)) {
        Progress_scope::check();
        volume += totals.units(complex.measure(c));
        if (c->component() != i)
          return false;
      }
      if (volume != m_components[i].volume)
        return false;
    }
    return std::find(is_found.begin(), is_found.end(), false) == is_found.end();
  }

private:
  struct Component
  {
    int label;
    std::int64_t volume; // the current volume, or the last one before components changed
  };
  using Origin = std::pair<Number, Number>;

  // Returns whether the component of `c` stays connected without `c`, as far as known. `left`
  // contains the neighbors of `c` in the component. Records connections that are not confirmed.
  template <class Complex>
  bool leaves_one(const Complex& complex, Cell_handle c, const std::vector<Cell_handle>& left) {
    // With more doubts, a traversal of all cells is as fast.
    static constexpr std::size_t most = 64;
    if (m_doubts.size() > most)
      return false;
    if (m_doubts.has(c))
      return m_doubts.replace(c, left);
    if (left.empty())
      return false;
    if (are_connected_nearby(
            complex, left, [&](auto v) { return c->has_vertex(v); }, c))
      return true;
    if (m_doubts.empty())
      m_before_doubts = m_components;
    m_doubts.add_group(left);
    m_is_counted = false;
    return true;
  }

  void begin_lineage() {
    m_lineage.clear();
    for (Number i = 0; i < m_components.size(); ++i)
      m_lineage.emplace_back(i, i);
  }

  // Returns `m_lineage` composed with `origins`.
  // \pre The origins are sorted.
  std::vector<Origin> prolonged_lineage(const std::vector<Origin>& origins) const {
    std::vector<Origin> result;
    for (const auto& [then, before] : m_lineage)
      for (auto o = std::lower_bound(origins.begin(), origins.end(), Origin(before, 0));
           o != origins.end() && o->first == before; ++o)
        result.emplace_back(then, o->second);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // A mutex for values that concurrent queries compute once. Each copy of the tracker has a mutex
  // of its own.
  struct Guard
  {
    Guard() = default;
    Guard(const Guard&) noexcept {}
    Guard& operator=(const Guard&) noexcept { return *this; }
    std::mutex mutex;
  };

  struct Count
  {
    int label;
    std::size_t number;
  };

  static bool is_below(const Count& count, int label) { return count.label < label; }

  // Increments the count of a label. The counts are sorted by label.
  static void add_one(std::vector<Count>& counts, int label) {
    auto it = std::lower_bound(counts.begin(), counts.end(), label, is_below);
    if (it == counts.end() || it->label != label)
      it = counts.insert(it, {label, 0});
    ++it->number;
  }

  static std::vector<Count> counts_of(const std::vector<Component>& components) {
    std::vector<Count> result;
    for (const Component& component : components)
      add_one(result, component.label);
    return result;
  }

  // Returns and marks the cells that are connected with `seed` through cells of the same label.
  template <class Complex>
  static std::vector<Cell_handle> component_of(const Complex& complex, Cell_handle seed,
                                               Marks& marks) {
    std::vector<Cell_handle> result;
    marks.add(seed, result);
    for (std::size_t next = 0; next < result.size(); ++next)
      for (int i = 0; i < Complex::corners; ++i)
        if (const Cell_handle n = result[next]->neighbor(i);
            n->subdomain_index() == seed->subdomain_index() && !complex.is_infinite(n))
          marks.add(n, result);
    return result;
  }

  template <class Complex> void count(const Complex& complex) const {
    m_counts.clear();
    Marks marks = cell_marks(complex);
    for (Cell_handle seed : complex.finite_cells())
      if (!marks.has(seed)) {
        add_one(m_counts, seed->subdomain_index());
        component_of(complex, seed, marks);
      }
    m_is_counted = true;
  }

  // The current components, in the order of their oldest cells.
  struct Numbering
  {
    std::vector<Component> components;
    std::vector<Number> of_cell; // by id
    std::vector<Origin> origins; // sorted
  };

  template <class Complex>
  Numbering number(const Complex& complex, const Label_totals& totals) const {
    static constexpr Number none = Number(-1);
    Numbering result;
    std::vector<Number>& of_cell = result.of_cell;
    of_cell.resize(complex.cell_id_bound(), none);
    std::vector<Origin>& origins = result.origins;
    // in the order of the container, which may differ for equal complexes
    std::vector<Component> found;
    // the smallest time stamp of a cell of each component
    std::vector<std::pair<std::size_t, Number>> oldest;
    std::vector<Cell_handle> front;
    for (Cell_handle seed : complex.finite_cells()) {
      if (of_cell[seed->id()] != none)
        continue;
      const Number component = Number(found.size());
      oldest.emplace_back(seed->time_stamp(), component);
      std::int64_t volume = 0;
      const auto visit = [&](Cell_handle c) {
        const Origin origin(c->component(), component);
        // A cell that changed its label without a neighbor to join has no component of this label
        // as its origin.
        const bool has_origin = origin.first < m_components.size() &&
                                m_components[origin.first].label == c->subdomain_index();
        if (has_origin && (origins.empty() || origins.back() != origin))
          origins.push_back(origin);
        oldest.back().first = (std::min)(oldest.back().first, c->time_stamp());
        volume += totals.units(complex.measure(c));
        of_cell[c->id()] = component;
        front.push_back(c);
      };
      visit(seed);
      while (!front.empty()) {
        const Cell_handle c = front.back();
        front.pop_back();
        for (int i = 0; i < Complex::corners; ++i) {
          const Cell_handle n = c->neighbor(i);
          if (n->subdomain_index() == c->subdomain_index() && of_cell[n->id()] == none &&
              !complex.is_infinite(n))
            visit(n);
        }
      }
      found.push_back({seed->subdomain_index(), volume});
    }
    std::sort(oldest.begin(), oldest.end());
    std::vector<Number> rank(found.size());
    for (const auto& [time_stamp, component] : oldest) {
      rank[component] = Number(result.components.size());
      result.components.push_back(found[component]);
    }
    for (Number& component : of_cell)
      component = component == none ? none : rank[component];
    for (Origin& origin : origins)
      origin.second = rank[origin.second];
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return result;
  }

  // Returns the events. Each event belongs to a set of old and new components that are connected by
  // origins.
  std::vector<Component_event> compare(const Numbering& numbering,
                                       const Label_totals& totals) const {
    const std::vector<Component>&before = m_components, &now = numbering.components;
    std::vector<Component_event> result;
    std::vector<std::vector<Number>> targets(before.size()), sources(now.size());
    for (const Origin& origin : numbering.origins) {
      targets[origin.first].push_back(origin.second);
      sources[origin.second].push_back(origin.first);
    }
    std::vector<bool> is_seen_before(before.size()), is_seen_now(now.size());
    const auto with_volume = [&](const std::vector<Component>& components, Number i) {
      return Component_event::Component{i, totals.volume_of(components[i].volume)};
    };
    std::vector<Number> olds, news;
    const auto see = [](std::vector<bool>& is_seen, std::vector<Number>& list, Number i) {
      if (!is_seen[i])
        list.push_back(i);
      is_seen[i] = true;
    };
    const auto add_event = [&](Component_event::Kind kind, int label) {
      Component_event event{kind, label, {}, {}};
      for (Number i : olds)
        event.before.push_back(with_volume(before, i));
      for (Number i : news)
        event.after.push_back(with_volume(now, i));
      result.push_back(std::move(event));
    };
    using Kind = Component_event::Kind;
    for (Number i = 0; i < before.size(); ++i) {
      if (is_seen_before[i])
        continue;
      olds.clear();
      news.clear();
      see(is_seen_before, olds, i);
      for (std::size_t o = 0, n = 0; o < olds.size() || n < news.size();) {
        for (; o < olds.size(); ++o)
          for (Number target : targets[olds[o]])
            see(is_seen_now, news, target);
        for (; n < news.size(); ++n)
          for (Number source : sources[news[n]])
            see(is_seen_before, olds, source);
      }
      std::sort(olds.begin(), olds.end());
      std::sort(news.begin(), news.end());
      const int label = before[i].label;
      if (news.empty())
        add_event(Kind::vanished, label);
      if (olds.size() > 1)
        add_event(Kind::merged, label);
      if (news.size() > 1)
        add_event(Kind::split, label);
    }
    olds.clear();
    for (Number i = 0; i < now.size(); ++i)
      if (!is_seen_now[i]) {
        news.assign(1, i);
        add_event(Kind::appeared, now[i].label);
      }
    return result;
  }

  std::vector<Component> m_components; // by number
  std::vector<Component_event> m_events;
  std::vector<Origin> m_lineage; // since the last call of `take_lineage()`
  bool m_is_known = true;
  Doubted_connections<Cell_handle> m_doubts; // connections that are not confirmed yet
  std::vector<Component> m_before_doubts;
  mutable std::vector<Count> m_counts; // by label
  mutable bool m_is_counted = false;
  mutable Guard m_guard;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPONENTS_COMPONENT_TRACKER_H
