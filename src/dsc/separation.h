// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SEPARATION_H
#define DSC_SEPARATION_H

#include "cell_regions.h"
#include "mesh_content.h"

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dsc {

/// A partition of the cells into regions. Edges, triangles and vertices that must not change lie
/// between regions, or on the boundary of the domain. If labels are replaced by regions, mesh
/// improvement preserves these simplices as it preserves the interface.
///
/// The cells of a region have the same label and the same values in all arrays of integers, and no
/// listed triangle is between them. If a simplex is still inside a region, for example a triangle
/// that ends inside the region, a cell around it becomes a separate region.
template <class Complex> class Separation
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;

  Separation(const Complex& complex, const Mesh_content& content)
      : m_complex(complex), m_cells(complex.cells()), m_row(complex.cell_id_bound()),
        m_listed(complex.cell_id_bound(), 0), m_is_alone(complex.cell_id_bound(), false) {
    for (std::size_t i = 0; i < m_cells.size(); ++i)
      m_row[m_cells[i]->id()] = i;
    for (const Mesh_array& array : content.arrays.cells)
      if (array.is_integer())
        m_categories.push_back(&array);
    const std::vector<Vertex_handle> vertices = complex.vertices();
    for (const auto& triangle : content.entities.triangles)
      mark(handles(vertices, triangle.vertices));

    const Cell_regions<Complex> coarse = regions();
    for (const auto& triangle : content.entities.triangles)
      hold(handles(vertices, triangle.vertices), coarse);
    for (const auto& edge : content.entities.edges)
      hold(handles(vertices, edge.vertices), coarse);
    for (const auto* list : {&content.entities.corners, &content.entities.required_vertices})
      for (const std::size_t v : *list)
        hold(std::array<Vertex_handle, 1>{vertices[v]}, coarse);
    tell_results(regions());
  }

  /// Returns whether a simplex lies on the boundary of the domain only, and not between regions.
  bool needs_boundary() const { return m_needs_boundary; }

  /// Returns the region of each cell, by increasing time stamp.
  const std::vector<int>& region_of_row() const { return m_region_of_row; }

  /// Returns, for each region, the index of one of its cells by increasing time stamp.
  const std::vector<std::size_t>& row_of_region() const { return m_row_of_region; }

private:
  Cell_regions<Complex> regions() const {
    return Cell_regions<Complex>(m_complex, [&](Cell_handle c, int i) {
      const Cell_handle n = c->neighbor(i);
      return c->label() != n->label() || (m_listed[c->id()] >> i & 1) != 0 || m_is_alone[c->id()] ||
             m_is_alone[n->id()] ||
             std::any_of(m_categories.begin(), m_categories.end(),
                         [&](const Mesh_array* array) { return differs(*array, c, n); });
    });
  }

  bool differs(const Mesh_array& array, Cell_handle a, Cell_handle b) const {
    const std::size_t i = m_row[a->id()] * array.components, j = m_row[b->id()] * array.components;
    for (std::size_t k = 0; k < array.components; ++k)
      if (array.values[i + k] != array.values[j + k])
        return true;
    return false;
  }

  void mark(const std::array<Vertex_handle, 3>& triangle) {
    CGAL::Deformable_simplicial_complexes::Progress_scope::check();
    for (const Cell_handle c : cells_around(m_complex, triangle)) {
      int sum = 6; // sum of the indices of all four vertices
      for (const Vertex_handle v : triangle)
        sum -= c->index(v);
      m_listed[c->id()] |= static_cast<std::uint8_t>(1 << sum);
    }
  }

  template <std::size_t n>
  void hold(const std::array<Vertex_handle, n>& simplex, const Cell_regions<Complex>& coarse) {
    CGAL::Deformable_simplicial_complexes::Progress_scope::check();
    auto around = cells_around(m_complex, simplex);
    const auto inside = std::partition(around.begin(), around.end(),
                                       [&](Cell_handle c) { return m_complex.is_infinite(c); });
    const auto lies_between = [&](Cell_handle c) {
      const auto first = (*inside)->id();
      return c->id() != first && (m_is_alone[c->id()] || m_is_alone[first] ||
                                  coarse.of_cell[c->id()] != coarse.of_cell[first]);
    };
    if (std::any_of(inside, around.end(), lies_between))
      return;
    if (inside != around.begin()) {
      m_needs_boundary = true;
      return;
    }
    // Separates the cell of best quality, because cells of low quality must be improved.
    const auto best = std::min_element(inside, around.end(), [](Cell_handle a, Cell_handle b) {
      return std::make_pair(-a->quality(), a->time_stamp()) <
             std::make_pair(-b->quality(), b->time_stamp());
    });
    m_is_alone[(*best)->id()] = true;
  }

  void tell_results(const Cell_regions<Complex>& fine) {
    m_row_of_region.resize(static_cast<std::size_t>(fine.number));
    for (std::size_t i = m_cells.size(); i-- > 0;) {
      m_row_of_region[static_cast<std::size_t>(fine.of_cell[m_cells[i]->id()])] = i;
      m_region_of_row.push_back(fine.of_cell[m_cells[i]->id()]);
    }
    std::reverse(m_region_of_row.begin(), m_region_of_row.end());
  }

  const Complex& m_complex;
  std::vector<Cell_handle> m_cells;
  std::vector<std::size_t> m_row;              // row of each cell, by id
  std::vector<const Mesh_array*> m_categories; // arrays of integers
  std::vector<std::uint8_t> m_listed;          // bits of the facets that are listed triangles
  std::vector<bool> m_is_alone;                // cells that are separate regions
  std::vector<int> m_region_of_row;
  std::vector<std::size_t> m_row_of_region;
  bool m_needs_boundary = false;
};

} // namespace dsc

#endif // DSC_SEPARATION_H
