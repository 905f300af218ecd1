// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H

// Member functions of `Labelled_complex`: access, labels, interface and measures.

#include <CGAL/Deformable_simplicial_complexes/Labelled_complex.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Marks.h>
#include <CGAL/Deformable_simplicial_complexes/internal/complex/Less_time_stamp.h>

#include <algorithm>
#include <array>
#include <vector>

#define CGAL_DSC_TEMPLATE template <class Derived, class Space, class Quality, class Domain>
#define CGAL_DSC_CLASS Labelled_complex<Derived, Space, Quality, Domain>

namespace CGAL {
namespace Deformable_simplicial_complexes {

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::number_of_cells() const -> size_type {
  size_type n = 0;
  for (const auto& total : m_totals.totals())
    n += total.cells;
  return n;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::flat_cells() const -> std::vector<Cell_handle> {
  std::vector<Cell_handle> result;
  if (m_number_of_flat_cells == 0)
    return result;
  for (Cell_handle c : finite_cells())
    if (c->quality() < quality_floor)
      result.push_back(c);
  std::sort(result.begin(), result.end(), internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::vertices() const -> std::vector<Vertex_handle> {
  std::vector<Vertex_handle> result;
  result.reserve(number_of_vertices());
  for (Vertex_handle v : finite_vertices())
    result.push_back(v);
  std::sort(result.begin(), result.end(), internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::cells() const -> std::vector<Cell_handle> {
  std::vector<Cell_handle> result;
  result.reserve(number_of_cells());
  for (Cell_handle c : finite_cells())
    result.push_back(c);
  std::sort(result.begin(), result.end(), internal::Less_time_stamp());
  return result;
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
  std::vector<Vertex_handle> result;
  for (Vertex_handle v : finite_vertices())
    if (v->is_interface())
      result.push_back(v);
  if (!std::is_sorted(result.begin(), result.end(), internal::Less_time_stamp()))
    std::sort(result.begin(), result.end(), internal::Less_time_stamp());
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets() const -> std::vector<Facet> {
  std::vector<Facet> result;
  for (Cell_handle c : finite_cells())
    for (int i = 0; i < corners; ++i) {
      const Cell_handle n = c->neighbor(i);
      if (n->label() < c->label() && !is_infinite(n))
        result.emplace_back(c, i);
    }
  std::sort(result.begin(), result.end(), [](const Facet& a, const Facet& b) {
    return a.first != b.first ? a.first->time_stamp() < b.first->time_stamp() : a.second < b.second;
  });
  return result;
}

CGAL_DSC_TEMPLATE
auto CGAL_DSC_CLASS::interface_facets(Label a, Label b) const -> std::vector<Facet> {
  std::vector<Facet> result = interface_facets();
  const auto other = [&](const Facet& f) {
    return std::minmax(f.first->label(), f.first->neighbor(f.second)->label()) != std::minmax(a, b);
  };
  result.erase(std::remove_if(result.begin(), result.end(), other), result.end());
  return result;
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::measure(Cell_handle c) const {
  return m_domain.template apply<Labelled_complex>(Space::measure(geom_traits()),
                                                   [&](int i) { return position(c->vertex(i)); });
}

CGAL_DSC_TEMPLATE
double CGAL_DSC_CLASS::measure(const Facet& f) const {
  std::array<Approximate_point, dimension> points;
  for (int i = 0; i < dimension; ++i)
    points[i] = corner(f.first, Space::facet_vertices[f.second][i]);
  return Space::facet_measure(points);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#undef CGAL_DSC_TEMPLATE
#undef CGAL_DSC_CLASS

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_QUERIES_IMPL_H
