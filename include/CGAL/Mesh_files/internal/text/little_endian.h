// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_LITTLE_ENDIAN_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_LITTLE_ENDIAN_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The unsigned integer type of the same size as a number.
template <class Number>
using Bits = std::conditional_t<
    sizeof(Number) == 1, std::uint8_t,
    std::conditional_t<sizeof(Number) == 2, std::uint16_t,
                       std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>;

// Appends a number as bytes, lowest byte first. Compilers replace the loop by a single move on
// little-endian machines.
template <class Number> void append_little_endian(std::string& bytes, Number number) {
  static_assert(std::is_arithmetic<Number>::value && sizeof(Bits<Number>) == sizeof(Number));
  Bits<Number> bits;
  std::memcpy(&bits, &number, sizeof(bits));
  char buffer[sizeof(bits)];
  for (std::size_t i = 0; i < sizeof(bits); ++i)
    buffer[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  bytes.append(buffer, sizeof(buffer));
}

// Returns the number stored in little-endian order.
// \pre `sizeof(Number)` bytes are readable
template <class Number> Number little_endian(const char* bytes) {
  static_assert(std::is_arithmetic<Number>::value && sizeof(Bits<Number>) == sizeof(Number));
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes[i])) << (8 * i);
  const auto sized = static_cast<Bits<Number>>(bits);
  Number number;
  std::memcpy(&number, &sized, sizeof(number));
  return number;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_LITTLE_ENDIAN_H
