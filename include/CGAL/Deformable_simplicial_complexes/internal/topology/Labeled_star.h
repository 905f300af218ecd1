// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABELED_STAR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABELED_STAR_H

#include <algorithm>
#include <array>
#include <cstddef>
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABELED_STAR_H
