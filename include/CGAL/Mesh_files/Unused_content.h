// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_UNUSED_CONTENT_H
#define CGAL_MESH_FILES_UNUSED_CONTENT_H

#include <cstddef>
#include <map>
#include <string>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Content of a file that a reader recognized but did not use, by kind. If a result would be wrong
without the content, the reader throws `File_error` instead.
*/
class Unused_content
{
public:
  /// Adds `number` items of a kind, which is named in the plural, such as "vertex colors".
  void add(const std::string& kind, std::size_t number = 1) {
    if (number > 0)
      m_numbers[kind] += number;
  }

  /// Adds the unused content of another file, or of another part of the file.
  void add(const Unused_content& other) {
    for (const auto& [kind, number] : other.m_numbers)
      add(kind, number);
  }

  /// Returns whether everything in the file was used.
  bool empty() const { return m_numbers.empty(); }

  /// Returns the number of items of each kind.
  const std::map<std::string, std::size_t>& numbers() const { return m_numbers; }

  /// Returns all kinds in one line, such as "12 normals, 3 groups".
  std::string text() const {
    std::string result;
    for (const auto& [kind, number] : m_numbers)
      result += (result.empty() ? "" : ", ") + std::to_string(number) + ' ' + kind;
    return result;
  }

private:
  std::map<std::string, std::size_t> m_numbers;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_UNUSED_CONTENT_H
