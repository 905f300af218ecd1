// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_BASE64_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_BASE64_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the six bits of a character, or -1 if it is not a base64 digit.
inline int base64_digit(char c) {
  if ('A' <= c && c <= 'Z')
    return c - 'A';
  if ('a' <= c && c <= 'z')
    return c - 'a' + 26;
  if ('0' <= c && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Returns the first bytes of a text in base64, at most `maximum`. Returns fewer bytes if the text
// ends or has an invalid character. Padding may occur anywhere, because some programs encode pieces
// one after the other.
inline std::string bytes_of_base64(std::string_view text, std::size_t maximum) {
  std::string bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for (const char c : text) {
    if (bytes.size() == maximum)
      break;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      continue;
    if (c == '=') {
      number_of_bits = 0;
      continue;
    }
    const int digit = base64_digit(c);
    if (digit < 0)
      break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes += static_cast<char>(static_cast<unsigned char>(bits >> number_of_bits));
    }
  }
  return bytes;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_BASE64_H
