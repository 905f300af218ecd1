// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H

#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/text/open_input.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns a word of a file in quotes, shortened, for a message of one line.
inline std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40; // characters, enough to identify the word
  std::string result(text.substr(0, longest));
  for (char& c : result)
    c = static_cast<unsigned char>(c) < ' ' || c == '\177' ? '?' : c;
  return "'" + result + "'";
}

// Returns the extension of a path in lower case, with the dot.
inline std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

// Returns the content of a file without a byte order mark. The memory is bounded by the size of the
// file. Throws File_error as open_input() does.
inline std::string file_contents(const std::string& path) {
  std::ifstream in = open_input(path, lower_case_extension(path));
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  if (error || !in.read(&bytes[0], static_cast<std::streamsize>(size)))
    throw File_error("cannot read " + path + " to its end", path);
  remove_byte_order_mark(bytes);
  return bytes;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_FILES_H
