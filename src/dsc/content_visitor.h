// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CONTENT_VISITOR_H
#define DSC_CONTENT_VISITOR_H

#include "mesh_content.h"

#include <CGAL/Deformable_simplicial_complexes/Carried_cell_averages.h>
#include <CGAL/Deformable_simplicial_complexes/Carried_vertex_values.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Number_rows.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

/// The numbers of all arrays at a vertex or cell.
using Content_row = DSC::Number_row;
template <class Handle> using Content_map = DSC::Number_row_map<Handle>;

/// A visitor that transfers the arrays and entities of a mesh through the changes of a complex.
/// Arrays of floating-point numbers are averages over cells, whose integrals are conserved, or
/// values at vertices, which are interpolated. A new vertex gets the integers of the nearest vertex
/// around it. Integers of cells are not transferred: see `Separation`.
template <class Complex> class Content_visitor : public DSC::Deformation_visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  Content_visitor(const Complex& complex, const Mesh_content& content)
      : m_complex(complex), m_content(content), m_integers(complex.vertex_id_bound()),
        m_values(complex.vertex_id_bound()), m_cell_rows(complex.cell_id_bound()) {
    const std::vector<Vertex_handle> vertices = complex.vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex_handle v = vertices[i];
      m_time_stamps.push_back(v->time_stamp());
      m_integers[v->id()] = row(content.arrays.points, true, i);
      m_values[v->id()] = row(content.arrays.points, false, i);
    }
    const std::vector<Cell_handle> cells = complex.cells();
    for (std::size_t i = 0; i < cells.size(); ++i)
      m_cell_rows[cells[i]->id()] = row(content.arrays.cells, false, i);
    if (!vertices.empty() && !m_values[vertices.front()->id()].numbers.empty())
      m_carried_values.emplace(complex, Content_map<Vertex_handle>{&m_values});
    if (!cells.empty() && !m_cell_rows[cells.front()->id()].numbers.empty())
      m_carried_averages.emplace(complex, Content_map<Cell_handle>{&m_cell_rows});
  }

  template <class Cavity> void before_replacement(const Cavity& cavity) {
    for_both([&](auto& carried) { carried.before_replacement(cavity); });
    m_new_integers.clear();
    for (std::size_t i = 0; i < cavity.vertices().size(); ++i)
      if (cavity.vertices()[i].handle == Vertex_handle())
        m_new_integers.emplace_back(i, integers_near(cavity, cavity.vertices()[i].position));
  }
  template <class Cavity> void after_replacement(const Cavity& cavity) {
    for_both([&](auto& carried) { carried.after_replacement(cavity); });
    for (auto& [i, integers] : m_new_integers)
      put(Content_map<Vertex_handle>{&m_integers}, cavity.vertices()[i].handle, integers);
  }
  template <class Star, class Point>
  void before_smoothing(Vertex_handle v, const Star& star, const Point& target) {
    for_both([&](auto& carried) { carried.before_smoothing(v, star, target); });
  }
  template <class Star> void after_smoothing(Vertex_handle v, const Star& star) {
    for_both([&](auto& carried) { carried.after_smoothing(v, star); });
  }

  /// Returns the content for the current vertices and cells. Must be called once, after all
  /// changes.
  /// \param row_of_cell for each cell, the row of an initial cell with the same integers
  Mesh_content finish(const std::vector<std::size_t>& row_of_cell) {
    m_carried_averages.reset(); // converts integrals into averages
    Mesh_content result = m_content;
    const std::vector<Vertex_handle> vertices = m_complex.vertices();
    take(result.arrays.points, true, m_integers, vertices);
    take(result.arrays.points, false, m_values, vertices);
    take(result.arrays.cells, false, m_cell_rows, m_complex.cells());
    for (Mesh_array& array : result.arrays.cells)
      if (array.is_integer())
        array = array.selected(row_of_cell);
    follow(result.entities, vertices);
    return result;
  }

private:
  template <class Call> void for_both(const Call& call) {
    if (m_carried_averages)
      call(*m_carried_averages);
    if (m_carried_values)
      call(*m_carried_values);
  }

  static Content_row row(const std::vector<Mesh_array>& arrays, bool of_integers, std::size_t i) {
    Content_row result;
    for (const Mesh_array& array : arrays)
      if (array.is_integer() == of_integers) {
        const auto begin = array.values.begin() + std::ptrdiff_t(i * array.components);
        result.numbers.insert(result.numbers.end(), begin,
                              begin + std::ptrdiff_t(array.components));
      }
    return result;
  }

  // Copies the numbers of the rows into the arrays.
  template <class Handle>
  static void take(std::vector<Mesh_array>& arrays, bool of_integers,
                   const std::vector<Content_row>& rows, const std::vector<Handle>& items) {
    std::size_t first = 0;
    for (Mesh_array& array : arrays) {
      if (array.is_integer() != of_integers)
        continue;
      array.values.clear();
      for (const Handle item : items) {
        const auto begin = rows[item->id()].numbers.begin() + std::ptrdiff_t(first);
        array.values.insert(array.values.end(), begin, begin + std::ptrdiff_t(array.components));
      }
      first += array.components;
    }
  }

  template <class Cavity, class Position>
  Content_row integers_near(const Cavity& cavity, const Position& p) const {
    Vertex_handle nearest;
    double least = 0;
    for (const auto& v : cavity.vertices()) {
      if (v.handle == Vertex_handle() || m_complex.is_infinite(v.handle))
        continue;
      const double distance = (v.position - p).squared_length();
      if (nearest == Vertex_handle() || distance < least) {
        least = distance;
        nearest = v.handle;
      }
    }
    return m_integers[nearest->id()];
  }

  // Updates vertex indices. New vertices get the reference 0; the vertices of entities still exist.
  void follow(Mesh_entities& entities, const std::vector<Vertex_handle>& vertices) const {
    std::vector<std::size_t> now(m_time_stamps.size(), 0);
    std::vector<int> references;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto it =
          std::lower_bound(m_time_stamps.begin(), m_time_stamps.end(), vertices[i]->time_stamp());
      const bool is_old = it != m_time_stamps.end() && *it == vertices[i]->time_stamp();
      const auto before = static_cast<std::size_t>(it - m_time_stamps.begin());
      if (is_old)
        now[before] = i;
      if (!entities.vertex_references.empty())
        references.push_back(is_old ? entities.vertex_references[before] : 0);
    }
    renumber_vertices(entities, now);
    entities.vertex_references = references;
  }

  const Complex& m_complex;
  const Mesh_content& m_content;
  std::vector<std::size_t> m_time_stamps;                     // time stamps of the initial vertices
  std::vector<Content_row> m_integers, m_values, m_cell_rows; // indexed by id
  std::vector<std::pair<std::size_t, Content_row>> m_new_integers; // by vertex of the cavity
  std::optional<DSC::Carried_cell_averages<Complex, Content_map<Cell_handle>>> m_carried_averages;
  std::optional<DSC::Carried_vertex_values<Complex, Content_map<Vertex_handle>>> m_carried_values;
};

} // namespace dsc

#endif // DSC_CONTENT_VISITOR_H
