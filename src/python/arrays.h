// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_ARRAYS_H
#define DSC_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dsc_python {

namespace py = pybind11;

/// Array of numbers in rows, as numpy stores it. Arguments of other types are converted.
template <class Number>
using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

/// Throws ValueError unless the array has rows of `columns` numbers. Zero columns stand for an
/// array with one axis.
template <class Number>
void require_rows(const Array<Number>& array, std::size_t columns, const std::string& name) {
  const bool fits = columns == 0 ? array.ndim() == 1
                                 : array.ndim() == 2 && std::size_t(array.shape(1)) == columns;
  if (!fits)
    throw py::value_error(name + " must have the shape " +
                          (columns == 0 ? "(n,)" : "(n, " + std::to_string(columns) + ")"));
}

/// Returns the rows of an array of shape (n, columns).
template <class Result, std::size_t columns, class Number>
std::vector<std::array<Result, columns>> rows_of(const Array<Number>& array,
                                                 const std::string& name) {
  require_rows(array, columns, name);
  std::vector<std::array<Result, columns>> rows(std::size_t(array.shape(0)));
  const Number* number = array.data();
  for (auto& row : rows)
    for (Result& entry : row)
      entry = Result(*number++);
  return rows;
}

/// Returns whether the numbers of an array are integers.
inline bool is_of_integers(const py::array& array) {
  const char kind = array.dtype().kind();
  return kind == 'i' || kind == 'u' || kind == 'b';
}

/// Returns an array of integers as signed integers.
/// \throws py::value_error if a number is too large
inline Array<std::int64_t> signed_integers(const py::array& array, const std::string& name) {
  if (array.dtype().kind() == 'u' && array.itemsize() == 8) {
    const Array<std::uint64_t> numbers(array);
    for (py::ssize_t i = 0; i < numbers.size(); ++i)
      if (numbers.data()[i] >> 63 != 0)
        throw py::value_error("a number of " + name + " is too large");
  }
  return Array<std::int64_t>(array);
}

/// Returns whether the numbers of an array are real: integers or floating point numbers.
inline bool is_of_real_numbers(const py::array& array) {
  return is_of_integers(array) || array.dtype().kind() == 'f';
}

/// Returns the rows of an array of indices of shape (n, columns).
/// \throws py::type_error if the array is not of integers
/// \throws py::value_error if its shape is wrong, or an index is negative
template <std::size_t columns>
std::vector<std::array<std::size_t, columns>> index_rows_of(const py::array& array,
                                                            const std::string& name) {
  if (!is_of_integers(array))
    throw py::type_error(name + " must be an array of integers");
  const Array<std::int64_t> indices = signed_integers(array, name);
  for (py::ssize_t i = 0; i < indices.size(); ++i)
    if (indices.data()[i] < 0)
      throw py::value_error(name + " has a negative index");
  return rows_of<std::size_t, columns>(indices, name);
}

/// Returns an array of shape (n,), with entries `entry(i)`.
template <class Number, class Entry>
py::array_t<Number> array_of(std::size_t n, const Entry& entry) {
  py::array_t<Number> result{py::ssize_t(n)};
  Number* numbers = result.mutable_data();
  for (std::size_t i = 0; i < n; ++i)
    numbers[i] = Number(entry(i));
  return result;
}

/// Returns an array of shape (n, columns), with entries `entry(i, j)`.
template <class Number, class Entry>
py::array_t<Number> array_of(std::size_t n, std::size_t columns, const Entry& entry) {
  py::array_t<Number> result({py::ssize_t(n), py::ssize_t(columns)});
  Number* number = result.mutable_data();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      *number++ = Number(entry(i, j));
  return result;
}

/// Returns indices as an array of shape (n,).
inline py::array_t<std::int64_t> array_of_indices(const std::vector<std::size_t>& indices) {
  return array_of<std::int64_t>(indices.size(), [&](std::size_t i) { return indices[i]; });
}

/// Returns points or vectors with d coordinates as an array of shape (n, d).
template <class Vectors> py::array_t<double> array_of_vectors(const Vectors& vectors, int d) {
  return array_of<double>(vectors.size(), std::size_t(d),
                          [&](std::size_t i, std::size_t j) { return vectors[i][int(j)]; });
}

/// Returns labels as integers of 32 bits.
/// \throws py::type_error if the array is not of integers
/// \throws py::value_error if its shape is wrong, or a number does not fit
inline std::vector<int> labels_of(const py::array& array, const std::string& name) {
  if (!is_of_integers(array))
    throw py::type_error(name + " must be an array of integers");
  const Array<std::int64_t> numbers = signed_integers(array, name);
  require_rows(numbers, 0, name);
  std::vector<int> result;
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    result.push_back(int(numbers.data()[i]));
    if (result.back() != numbers.data()[i])
      throw py::value_error("a number of " + name + " does not fit into 32 bits");
  }
  return result;
}

} // namespace dsc_python

#endif // DSC_PYTHON_ARRAYS_H
