// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_MANIFOLD_RELABELING_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_MANIFOLD_RELABELING_H

#include <boost/container/flat_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The cells around a vertex with their labels, or with proposed labels. Each cell corresponds to a
// simplex of the link of the vertex, which is a sphere.
template <class Complex> class Labeled_star
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = std::optional<typename Complex::Label>; // no label outside the domain

  static constexpr std::size_t none = std::size_t(-1);

  // Sets of cells that are connected through facets.
  struct Components
  {
    std::vector<std::size_t> of_cell; // number of the set of each cell; `none` if it is in no set
    std::size_t number = 0;
  };

  // `label_of(c)` is the label of a finite cell. Takes time O(n log n) in the number of cells.
  template <class LabelOf>
  Labeled_star(const Complex& complex, Vertex_handle v, const LabelOf& label_of) {
    complex.star(v, m_cells);
    using Place = std::pair<std::size_t, std::size_t>; // time stamp and index of a cell
    std::vector<Place> places;
    for (std::size_t i = 0; i < m_cells.size(); ++i)
      places.emplace_back(m_cells[i]->time_stamp(), i);
    std::sort(places.begin(), places.end());
    const auto index = [&](Cell_handle c) {
      return std::lower_bound(places.begin(), places.end(), Place(c->time_stamp(), 0))->second;
    };
    for (Cell_handle c : m_cells) {
      m_labels.push_back(complex.is_infinite(c) ? Label() : Label(label_of(c)));
      std::array<std::size_t, Complex::dimension> neighbors = {};
      auto out = neighbors.begin();
      for (int k = 0; k < Complex::corners; ++k)
        if (c->vertex(k) != v)
          *out++ = index(c->neighbor(k));
      m_neighbors.push_back(neighbors);
    }
  }

  std::size_t size() const { return m_cells.size(); }
  Cell_handle cell(std::size_t i) const { return m_cells[i]; }
  const Label& label(std::size_t i) const { return m_labels[i]; }
  const std::array<std::size_t, Complex::dimension>& neighbors(std::size_t i) const {
    return m_neighbors[i];
  }

  // Returns the connected sets of the cells whose labels fulfill a condition, numbered in the order
  // of the star.
  template <class Condition> Components components(const Condition& holds) const {
    Components result;
    result.of_cell.assign(size(), none);
    std::vector<std::size_t> front;
    const auto visit = [&](std::size_t i) {
      if (result.of_cell[i] != none || !holds(m_labels[i]))
        return;
      result.of_cell[i] = result.number;
      front.push_back(i);
    };
    for (std::size_t seed = 0; seed < size(); ++seed) {
      visit(seed);
      if (front.empty())
        continue;
      while (!front.empty()) {
        const std::size_t i = front.back();
        front.pop_back();
        for (std::size_t n : m_neighbors[i])
          visit(n);
      }
      ++result.number;
    }
    return result;
  }

  // Returns whether the cells of each label, and the cells of all other labels, are connected. On a
  // sphere, both sets are then disks, and their common boundary is a sphere of one dimension less:
  // in space, a closed curve that passes no vertex twice.
  bool is_manifold() const {
    std::vector<Label> labels = m_labels;
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return std::all_of(labels.begin(), labels.end(), [&](const Label& label) {
      return components([&](const Label& other) { return other == label; }).number <= 1 &&
             components([&](const Label& other) { return other != label; }).number <= 1;
    });
  }

private:
  std::vector<Cell_handle> m_cells;
  std::vector<Label> m_labels;
  std::vector<std::array<std::size_t, Complex::dimension>> m_neighbors;
};

// A relabeling of cells of one label that keeps the interface manifold. Where the new interface
// would be pinched at a vertex, more cells of the old label around the vertex are relabeled: this
// opens a tunnel between components that touch in the vertex only.
template <class Complex> class Manifold_relabeling
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;

  // `cells` are finite cells of one label. The additional cells are appended to them.
  Manifold_relabeling(const Complex& complex, std::vector<Cell_handle>& cells, Label label)
      : m_complex(complex), m_cells(cells), m_old(cells.front()->subdomain_index()), m_new(label) {
    for (Cell_handle c : cells)
      enlist(c);
  }

  // Appends cells until the interface would be manifold at all vertices of the cells. Returns false
  // if too many cells would be necessary, or it is impossible.
  bool complete() {
    static constexpr std::size_t few = 60;
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
      const Vertex_handle v = m_vertices[i];
      if (std::find(m_vertices.begin() + std::ptrdiff_t(i) + 1, m_vertices.end(), v) !=
          m_vertices.end())
        continue; // visited later
      const Star star(m_complex, v, [&](Cell_handle c) {
        return m_time_stamps.count(c->time_stamp()) != 0 ? m_new : c->subdomain_index();
      });
      if (star.is_manifold())
        continue;
      const std::size_t before = m_cells.size();
      widen(star);
      if (m_cells.size() == before || m_cells.size() > few)
        return false;
    }
    return true;
  }

private:
  using Star = Labeled_star<Complex>;
  using Components = typename Star::Components;

  void enlist(Cell_handle c) {
    m_time_stamps.insert(c->time_stamp());
    for (int i = 0; i < Complex::corners; ++i)
      m_vertices.push_back(c->vertex(i));
  }

  void add(Cell_handle c) {
    m_cells.push_back(c);
    enlist(c);
  }

  // Repairs one defect of a star, if this is possible with cells of the old label.
  void widen(const Star& star) {
    using Label_or_none = typename Star::Label;
    const auto is_old = [&](const Label_or_none& label) { return label == m_old; };
    const auto is_new = [&](const Label_or_none& label) { return label == m_new; };
    const Components joined = star.components(is_new), left = star.components(is_old);
    const Components others =
        star.components([&](const Label_or_none& label) { return !is_new(label); });
    if (joined.number > 1)
      join(star, joined);
    else if (left.number > 1)
      absorb(star, left, largest(star, left));
    else if (others.number > 1)
      absorb(star, left, Star::none);
    else // the cells of the old label may surround those of the new label
      join(star, star.components([&](const Label_or_none& label) { return !is_old(label); }));
  }

  // Adds the cells of the old label with the smallest volume that connect the first set of
  // `components` to another one. Adds none if there is no path. Uses Dijkstra's algorithm.
  void join(const Star& star, const Components& components) {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> distances(star.size(), infinity);
    std::vector<std::size_t> previous(star.size(), Star::none);
    std::vector<bool> is_done(star.size());
    for (std::size_t i = 0; i < star.size(); ++i)
      if (components.of_cell[i] == 0)
        distances[i] = 0;
    for (;;) {
      std::size_t nearest = Star::none;
      for (std::size_t i = 0; i < star.size(); ++i)
        if (!is_done[i] && distances[i] < infinity &&
            (nearest == Star::none || distances[i] < distances[nearest]))
          nearest = i;
      if (nearest == Star::none)
        return;
      const bool is_between = components.of_cell[nearest] == Star::none;
      if (!is_between && components.of_cell[nearest] != 0) {
        for (std::size_t i = previous[nearest]; components.of_cell[i] == Star::none;
             i = previous[i])
          add(star.cell(i));
        return;
      }
      is_done[nearest] = true;
      for (std::size_t n : star.neighbors(nearest)) {
        const bool is_old = star.label(n) == m_old;
        if (!is_old && components.of_cell[n] == Star::none)
          continue;
        const double distance = distances[nearest] + (is_old ? volume(star.cell(n)) : 0);
        if (distance < distances[n]) {
          distances[n] = distance;
          previous[n] = nearest;
        }
      }
    }
  }

  // Adds all sets except one.
  void absorb(const Star& star, const Components& components, std::size_t kept) {
    for (std::size_t i = 0; i < star.size(); ++i)
      if (components.of_cell[i] != Star::none && components.of_cell[i] != kept)
        add(star.cell(i));
  }

  // Returns the set with the largest volume.
  std::size_t largest(const Star& star, const Components& components) const {
    std::vector<double> volumes(components.number);
    for (std::size_t i = 0; i < star.size(); ++i)
      if (components.of_cell[i] != Star::none)
        volumes[components.of_cell[i]] += volume(star.cell(i));
    return std::size_t(std::max_element(volumes.begin(), volumes.end()) - volumes.begin());
  }

  // Returns the volume of a cell; never negative, in spite of rounding.
  double volume(Cell_handle c) const { return (std::max)(0., m_complex.measure(c)); }

  const Complex& m_complex;
  std::vector<Cell_handle>& m_cells;
  Label m_old, m_new;
  boost::container::flat_set<std::size_t> m_time_stamps; // time stamps of the cells
  std::vector<Vertex_handle> m_vertices; // vertices of the cells, in the order of visits
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_MANIFOLD_RELABELING_H
