// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_COMPLEX_OBJECT_H
#define DSC_PYTHON_COMPLEX_OBJECT_H

#include "Guarded.h"
#include "arrays.h"

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Interface_remeshing/Carried_cell_averages.h>
#include <CGAL/Interface_remeshing/Carried_vertex_values.h>
#include <CGAL/Interface_remeshing/Number_rows.h>

#include <memory>
#include <optional>

namespace dsc_python {

namespace DSC = CGAL::Deformable_simplicial_complexes;

/// Named arrays of numbers on the vertices, or on the cells, of a complex.
template <class Handle> class Named_values
{
public:
  using Map = DSC::Number_row_map<Handle>;

  bool is_empty() const { return m_columns.empty(); }
  Map map() { return Map{&m_rows}; }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const Column& column : m_columns)
      result.push_back(column.name);
    return result;
  }

  /// Returns the array of a name, of shape (n,) or (n, k).
  /// \throws py::key_error
  py::array_t<double> get(const std::string& name, const std::vector<Handle>& items) const {
    const auto column = find(name);
    if (column == m_columns.end())
      throw py::key_error(name);
    const auto entry = [&](std::size_t i, std::size_t j) {
      return m_rows[items[i]->id()].numbers[column->begin + j];
    };
    return column->is_scalar
               ? array_of<double>(items.size(), [&](std::size_t i) { return entry(i, 0); })
               : array_of<double>(items.size(), column->size, entry);
  }

  /// Adds or replaces an array.
  /// \throws py::value_error if its shape is wrong
  void set(const std::string& name, const Array<double>& array, const std::vector<Handle>& items) {
    if ((array.ndim() != 1 && array.ndim() != 2) || std::size_t(array.shape(0)) != items.size())
      throw py::value_error("the values must have the shape (n,) or (n, k), where n = " +
                            std::to_string(items.size()));
    remove(name);
    Column column{name, 0, array.ndim() == 1 ? 1 : std::size_t(array.shape(1)), array.ndim() == 1};
    for (const Column& other : m_columns)
      column.begin += other.size;
    const double* number = array.data();
    for (const Handle item : items) {
      if (m_rows.size() <= item->id())
        m_rows.resize(item->id() + 1);
      std::vector<double>& numbers = m_rows[item->id()].numbers;
      numbers.resize(column.begin); // a reused id may have a row of a removed vertex or cell
      numbers.insert(numbers.end(), number, number + column.size);
      number += column.size;
    }
    m_columns.push_back(column);
  }

  /// Returns the same arrays for the vertices or cells of a copy, in the same order.
  Named_values copied(const std::vector<Handle>& items, const std::vector<Handle>& copies) const {
    Named_values result;
    result.m_columns = m_columns;
    for (std::size_t i = 0; !is_empty() && i < items.size(); ++i)
      put(result.map(), copies[i], m_rows[items[i]->id()]);
    return result;
  }

  /// Removes an array. Returns whether there was one.
  bool remove(const std::string& name) {
    const auto column = find(name);
    if (column == m_columns.end())
      return false;
    const auto begin = std::ptrdiff_t(column->begin), end = begin + std::ptrdiff_t(column->size);
    for (DSC::Number_row& row : m_rows)
      if (std::ptrdiff_t(row.numbers.size()) >= end)
        row.numbers.erase(row.numbers.begin() + begin, row.numbers.begin() + end);
    for (Column& other : m_columns)
      if (other.begin > column->begin)
        other.begin -= column->size;
    m_columns.erase(m_columns.begin() + (column - m_columns.cbegin()));
    return true;
  }

private:
  struct Column
  {
    std::string name;
    std::size_t begin, size; ///< place in the rows
    bool is_scalar;          ///< whether the array has one axis
  };

  typename std::vector<Column>::const_iterator find(const std::string& name) const {
    return std::find_if(m_columns.begin(), m_columns.end(),
                        [&](const Column& column) { return column.name == name; });
  }

  std::vector<Column> m_columns;
  std::vector<DSC::Number_row> m_rows; ///< by id
};

/// A complex with values that follow its mesh.
template <class Complex> class Complex_object : public Guarded<Complex>
{
public:
  using Guarded<Complex>::Guarded;

  Named_values<typename Complex::Vertex_handle> vertex_values;
  Named_values<typename Complex::Cell_handle> cell_values;

  bool has_values() const { return !vertex_values.is_empty() || !cell_values.is_empty(); }

  /// Returns a copy with the values, as a long function.
  std::unique_ptr<Complex_object> copy() const {
    return this->read_long(py::none(), [this](const Complex& complex) {
      auto result = std::make_unique<Complex_object>(Complex(complex));
      const Complex& copied = result->read();
      result->vertex_values = vertex_values.copied(complex.vertices(), copied.vertices());
      result->cell_values = cell_values.copied(complex.cells(), copied.cells());
      return result;
    });
  }
};

/// A visitor that transfers the values of a complex while it exists. On vertices they are
/// interpolated, on cells their integrals are conserved.
template <class Complex> class Value_visitor final : public DSC::Deformation_visitor<Complex>
{
public:
  using typename DSC::Deformation_visitor<Complex>::Vertex_handle;
  using typename DSC::Deformation_visitor<Complex>::Cell_handle;
  using typename DSC::Deformation_visitor<Complex>::Star;

  Value_visitor(const Complex& complex, Complex_object<Complex>& object) {
    if (!object.vertex_values.is_empty())
      m_values.emplace(complex, object.vertex_values.map());
    if (!object.cell_values.is_empty())
      m_averages.emplace(complex, object.cell_values.map());
  }

  void before_replacement(const DSC::Cavity<Complex>& cavity) override {
    for_both([&](auto& carried) { carried.before_replacement(cavity); });
  }
  void after_replacement(const DSC::Cavity<Complex>& cavity) override {
    for_both([&](auto& carried) { carried.after_replacement(cavity); });
  }
  void before_smoothing(Vertex_handle v, const Star& star,
                        const typename Complex::Point& target) override {
    for_both([&](auto& carried) { carried.before_smoothing(v, star, target); });
  }
  void after_smoothing(Vertex_handle v, const Star& star) override {
    for_both([&](auto& carried) { carried.after_smoothing(v, star); });
  }

private:
  template <class Call> void for_both(const Call& call) {
    if (m_values)
      call(*m_values);
    if (m_averages)
      call(*m_averages);
  }

  std::optional<DSC::Carried_vertex_values<Complex, DSC::Number_row_map<Vertex_handle>>> m_values;
  std::optional<DSC::Carried_cell_averages<Complex, DSC::Number_row_map<Cell_handle>>> m_averages;
};

} // namespace dsc_python

#endif // DSC_PYTHON_COMPLEX_OBJECT_H
