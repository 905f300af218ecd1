// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_VTK_NUMBERS_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_VTK_NUMBERS_H

#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Numbers of all VTK types are converted to `double`. The conversion is inexact only for integers
// that are larger than every valid index or label.

// Returns the numbers stored in little-endian bytes.
// \pre The number of bytes is a multiple of the size of `Number`.
template <class Number> std::vector<double> numbers_of_bytes(std::string_view bytes) {
  std::vector<double> numbers;
  numbers.reserve(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number))
    numbers.push_back(static_cast<double>(little_endian<Number>(bytes.data() + i)));
  return numbers;
}

// Returns the little-endian bytes of numbers.
// \pre `Number` can represent the numbers.
template <class Number> std::string bytes_of_numbers(const std::vector<double>& numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const double number : numbers)
    append_little_endian(bytes, static_cast<Number>(number));
  return bytes;
}

// A number type of VTK files.
struct Vtk_number_type
{
  template <class Number> static constexpr Vtk_number_type of(const char* name) {
    return {name, sizeof(Number), numbers_of_bytes<Number>, bytes_of_numbers<Number>};
  }

  const char* name;
  std::size_t size;
  std::vector<double> (*numbers)(std::string_view bytes);
  std::string (*bytes)(const std::vector<double>& numbers);
};

// Returns the number type with a given name, or null if there is none.
inline const Vtk_number_type* find_vtk_number_type(std::string_view name) {
  static constexpr Vtk_number_type types[] = {
      Vtk_number_type::of<std::int8_t>("Int8"),   Vtk_number_type::of<std::uint8_t>("UInt8"),
      Vtk_number_type::of<std::int16_t>("Int16"), Vtk_number_type::of<std::uint16_t>("UInt16"),
      Vtk_number_type::of<std::int32_t>("Int32"), Vtk_number_type::of<std::uint32_t>("UInt32"),
      Vtk_number_type::of<std::int64_t>("Int64"), Vtk_number_type::of<std::uint64_t>("UInt64"),
      Vtk_number_type::of<float>("Float32"),      Vtk_number_type::of<double>("Float64")};
  for (const Vtk_number_type& type : types)
    if (type.name == name)
      return &type;
  return nullptr;
}

// Returns the numbers of a text, separated by white space, or nothing if the text contains anything
// else.
inline std::optional<std::vector<double>> numbers_of_text(std::string_view text) {
  constexpr char white_space[] = " \t\r\n";
  std::vector<double> numbers;
  numbers.reserve(text.size() / 2); // a number has at least a digit and a space
  static constexpr std::size_t between_checks = 1 << 12;
  for (std::size_t begin; (begin = text.find_first_not_of(white_space)) != text.npos;) {
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(white_space));
    const std::optional<double> number = number_of_word<double>(word);
    if (!number)
      return std::nullopt;
    numbers.push_back(*number);
    if (numbers.size() % between_checks == 0)
      Progress_scope::check();
    text.remove_prefix(word.size());
  }
  return numbers;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_VTK_NUMBERS_H
