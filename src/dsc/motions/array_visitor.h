// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ARRAY_VISITOR_H
#define DSC_ARRAY_VISITOR_H

#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Number_rows.h>
#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>
#include <CGAL/Mesh_files/Mesh_arrays.h>

#include <optional>

namespace dsc {

/// A visitor that transfers the arrays of a mesh through the changes of a complex. Arrays of
/// floating-point numbers are averages over cells, whose integrals are conserved, or values at
/// vertices, which are interpolated. A new vertex gets the integers of the nearest vertex around
/// it. A new cell gets the integers of the old cell of its label that it overlaps most.
template <class Complex> class Array_visitor final : public DSC::Deformation_visitor<Complex>
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Mesh_array = DSC::Mesh_array;
  using Mesh_arrays = DSC::Mesh_arrays;

  /// \param arrays by increasing time stamps of the vertices and cells; they outlive the visitor
  Array_visitor(const Complex& complex, const Mesh_arrays& arrays)
      : m_complex(complex), m_arrays(arrays) {
    give(arrays.points, true, complex.vertices(), complex.vertex_id_bound(), m_vertex_integers);
    give(arrays.points, false, complex.vertices(), complex.vertex_id_bound(), m_values);
    give(arrays.cells, true, complex.cells(), complex.cell_id_bound(), m_cell_integers);
    give(arrays.cells, false, complex.cells(), complex.cell_id_bound(), m_averages);
    if (!m_values.empty())
      m_carried_values.emplace(complex, Row_map<Vertex_handle>{&m_values});
    if (!m_averages.empty())
      m_carried_averages.emplace(complex, Row_map<Cell_handle>{&m_averages});
  }

  void before_replacement(const DSC::Cavity<Complex>& cavity) override {
    for_both([&](auto& carried) { carried.before_replacement(cavity); });
    m_new_vertices.clear();
    m_new_cells.clear();
    if (!m_vertex_integers.empty())
      for (std::size_t i = 0; i < cavity.vertices().size(); ++i)
        if (cavity.vertices()[i].handle == Vertex_handle())
          m_new_vertices.emplace_back(i, integers_near(cavity, cavity.vertices()[i].position));
    if (!m_cell_integers.empty())
      for (const auto& cell : cavity.planned())
        if (!cavity.is_infinite(cell.vertices))
          m_new_cells.push_back(integers_of(cavity, cell));
  }
  void after_replacement(const DSC::Cavity<Complex>& cavity) override {
    for_both([&](auto& carried) { carried.after_replacement(cavity); });
    for (const auto& [i, integers] : m_new_vertices)
      put(Row_map<Vertex_handle>{&m_vertex_integers}, cavity.vertices()[i].handle, integers);
    auto next = m_new_cells.begin();
    if (!m_cell_integers.empty())
      for (const Cell_handle c : cavity.created())
        if (!m_complex.is_infinite(c))
          put(Row_map<Cell_handle>{&m_cell_integers}, c, *next++);
  }
  void before_smoothing(Vertex_handle v, const std::vector<Cell_handle>& star,
                        const typename Complex::Point& target) override {
    for_both([&](auto& carried) { carried.before_smoothing(v, star, target); });
  }
  void after_smoothing(Vertex_handle v, const std::vector<Cell_handle>& star) override {
    for_both([&](auto& carried) { carried.after_smoothing(v, star); });
  }

  /// Returns the arrays for the current vertices and cells. Must be called once, after all changes.
  Mesh_arrays finish() {
    m_carried_averages.reset(); // converts integrals into averages
    Mesh_arrays result = m_arrays;
    take(m_vertex_integers, true, m_complex.vertices(), result.points);
    take(m_values, false, m_complex.vertices(), result.points);
    take(m_cell_integers, true, m_complex.cells(), result.cells);
    take(m_averages, false, m_complex.cells(), result.cells);
    return result;
  }

private:
  using Row = DSC::Number_row; // of all arrays of integers, or of all other arrays
  template <class Handle> using Row_map = DSC::Number_row_map<Handle>;
  using Clipping = DSC::internal::Clipping_simplex<typename Complex::Space>;

  template <class Call> void for_both(const Call& call) {
    if (m_carried_averages)
      call(*m_carried_averages);
    if (m_carried_values)
      call(*m_carried_values);
  }

  // Copies the numbers of the arrays into rows, which stay empty if there are no such arrays.
  template <class Handle>
  static void give(const std::vector<Mesh_array>& arrays, bool of_integers,
                   const std::vector<Handle>& items, std::size_t bound, std::vector<Row>& rows) {
    for (const Mesh_array& array : arrays) {
      if (array.is_integer() != of_integers)
        continue;
      rows.resize(bound);
      auto next = array.values.begin();
      for (const Handle item : items) {
        auto& numbers = rows[item->id()].numbers;
        numbers.insert(numbers.end(), next, next + std::ptrdiff_t(array.components));
        next += std::ptrdiff_t(array.components);
      }
    }
  }

  // Copies the numbers of the rows into the arrays.
  template <class Handle>
  static void take(const std::vector<Row>& rows, bool of_integers, const std::vector<Handle>& items,
                   std::vector<Mesh_array>& arrays) {
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
  Row integers_near(const Cavity& cavity, const Position& p) const {
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
    return m_vertex_integers[nearest->id()];
  }

  // Returns the integers of the removed cell of the label of a planned cell that the planned cell
  // overlaps most.
  template <class Cavity, class Cell>
  Row integers_of(const Cavity& cavity, const Cell& planned) const {
    const auto& numbers = [&](Cell_handle c) -> const auto& {
      return m_cell_integers[c->id()].numbers;
    };
    std::vector<Cell_handle> candidates;
    for (const Cell_handle c : cavity.removed())
      if (!m_complex.is_infinite(c) && c->subdomain_index() == planned.parent->subdomain_index())
        candidates.push_back(c);
    if (candidates.empty()) // the parent is infinite
      candidates = {*std::find_if(cavity.removed().begin(), cavity.removed().end(),
                                  [&](Cell_handle c) { return !m_complex.is_infinite(c); })};
    Cell_handle best = candidates.front();
    if (std::all_of(candidates.begin(), candidates.end(),
                    [&](Cell_handle c) { return numbers(c) == numbers(best); }))
      return m_cell_integers[best->id()];
    DSC::internal::Cell_corners<Complex> corners;
    for (int i = 0; i < Complex::corners; ++i)
      corners[i] = cavity.vertices()[planned.vertices[i]].position;
    const Clipping simplex(corners);
    double largest = 0;
    for (const Cell_handle c : candidates) {
      const double overlap = DSC::internal::overlap_measure(
          Clipping(DSC::internal::cell_corners(m_complex, c, corners[0])), simplex);
      if (overlap > largest) {
        largest = overlap;
        best = c;
      }
    }
    return m_cell_integers[best->id()];
  }

  const Complex& m_complex;
  const Mesh_arrays& m_arrays;
  std::vector<Row> m_vertex_integers, m_values, m_cell_integers, m_averages; // indexed by id
  std::vector<std::pair<std::size_t, Row>> m_new_vertices; // by vertex of the cavity
  std::vector<Row> m_new_cells;                            // finite planned cells
  std::optional<DSC::Carried_cell_averages<Complex, Row_map<Cell_handle>>> m_carried_averages;
  std::optional<DSC::Carried_vertex_values<Complex, Row_map<Vertex_handle>>> m_carried_values;
};

} // namespace dsc

#endif // DSC_ARRAY_VISITOR_H
