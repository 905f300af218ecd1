// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H

// Member functions of `Labeled_complex`: access, labels, interface and measures.

#include <CGAL/Deformable_simplicial_complexes/Labeled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/sort_by_time_stamp.h>

#define CGAL_DSC_TEMPLATE template <class Derived, class Space, class Quality, class Domain>
#define CGAL_DSC_CLASS Labeled_complex<Derived, Space, Quality, Domain>

namespace CGAL::Deformable_simplicial_complexes {

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::number_of_cells() const -> size_type {
  size_type n = 0;
  for (const auto& total : m_totals.totals())
    n += total.cells;
  return n;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::flat_cells() const -> std::vector<Cell_handle> {
  if (m_number_of_flat_cells == 0)
    return {};
  return internal::by_time_stamp<Cell_handle>(
      finite_cells(), [](Cell_handle c) { return c->quality() < quality_floor; });
}

CGAL_DSC_TEMPLATE
template <class Condition>
auto CGAL_DSC_CLASS::finite_cells_if(const Condition& condition,
                                     const For_each_index& for_each_index) const
    -> std::vector<Cell_handle> {
  static constexpr size_type block_size = 1024; // ids; enough work for a thread
  static constexpr size_type worthwhile = 8;    // blocks from which threads are used
  std::vector<std::vector<Cell_handle>> found((cell_id_bound() + block_size - 1) / block_size);
  for_each_index(
      found.size(),
      [&](size_type block) {
        const size_type end = (std::min)(cell_id_bound(), (block + 1) * block_size);
        for (size_type id = block * block_size; id < end; ++id)
          if (const Cell_handle c = m_numbers.cell(id);
              c != Cell_handle() && !is_infinite(c) && condition(c))
            found[block].push_back(c);
      },
      worthwhile);
  std::vector<Cell_handle> result;
  for (const auto& cells : found)
    result.insert(result.end(), cells.begin(), cells.end());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::vertices() const -> std::vector<Vertex_handle> {
  return internal::by_time_stamp<Vertex_handle>(
      finite_vertices(), [](Vertex_handle) { return true; }, number_of_vertices());
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::cells() const -> std::vector<Cell_handle> {
  return internal::by_time_stamp<Cell_handle>(
      finite_cells(), [](Cell_handle) { return true; }, number_of_cells());
}

CGAL_DSC_TEMPLATE
void CGAL_DSC_CLASS::star(Vertex_handle v, std::vector<Cell_handle>& star) const {
  star.clear();
  internal::Marks marks(cell_id_bound());
  marks.add(v->cell(), star);
  for (size_type i = 0; i < star.size(); ++i) {
    const Cell_handle c = star[i];
    for (int j = 0; j < corners; ++j)
      if (c->vertex(j) != v)
        marks.add(c->neighbor(j), star);
  }
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::interface_edge_length(Vertex_handle v) const {
  if (!v->is_interface())
    return 0;
  std::vector<Cell_handle> star;
  this->star(v, star);
  double sum = 0;
  size_type number = 0;
  for (Cell_handle c : star) {
    if (is_infinite(c))
      continue;
    const int apex = c->index(v);
    for (int facet = 0; facet < corners; ++facet)
      if (facet != apex && is_interface(Facet(c, facet)))
        for (int i = 0; i < corners; ++i)
          if (i != apex && i != facet) {
            sum += Space::length(displacement(v, c->vertex(i)));
            ++number;
          }
  }
  return sum / double(number);
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::labels() const -> std::vector<Label> {
  std::vector<Label> result;
  for (const auto& total : m_totals.totals())
    if (total.cells > 0)
      result.push_back(total.label);
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_vertices() const -> std::vector<Vertex_handle> {
  return internal::by_time_stamp<Vertex_handle>(finite_vertices(),
                                                [](Vertex_handle v) { return v->is_interface(); });
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets(const For_each_index& for_each_index) const
    -> std::vector<Facet> {
  const auto is_listed = [&](Cell_handle c, int i) {
    const Cell_handle n = c->neighbor(i);
    return n->subdomain_index() < c->subdomain_index() && !is_infinite(n);
  };
  std::vector<Cell_handle> cells = finite_cells_if(
      [&](Cell_handle c) {
        bool has_facet = false;
        for (int i = 0; i < corners && !has_facet; ++i)
          has_facet = is_listed(c, i);
        return has_facet;
      },
      for_each_index);
  internal::sort_by_time_stamp(cells);
  std::vector<Facet> result;
  for (Cell_handle c : cells)
    for (int i = 0; i < corners; ++i)
      if (is_listed(c, i))
        result.emplace_back(c, i);
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets(Label a, Label b) const -> std::vector<Facet> {
  std::vector<Facet> result = interface_facets();
  const auto other = [&](const Facet& f) {
    return std::minmax(f.first->subdomain_index(),
                       f.first->neighbor(f.second)->subdomain_index()) != std::minmax(a, b);
  };
  result.erase(std::remove_if(result.begin(), result.end(), other), result.end());
  return result;
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::measure(Cell_handle c) const {
  return m_domain.template apply<Labeled_complex>(Space::measure,
                                                  [&](int i) { return position(c->vertex(i)); });
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::measure(const Facet& f) const {
  std::array<Point, dimension> points;
  for (int i = 0; i < dimension; ++i)
    points[i] = corner(f.first, Space::facet_vertices[f.second][i]);
  return Space::facet_measure(points);
}

} // namespace CGAL::Deformable_simplicial_complexes

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H
