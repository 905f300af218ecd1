// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_TEXT_CONTENT_LIMIT_H
#define CGAL_MESH_FILES_INTERNAL_TEXT_CONTENT_LIMIT_H

#include <sstream>
#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The largest content of a file that readers accept, in bytes. The content is what the file
// decompresses to, or what its header promises. So the size of the file bounds the memory.
constexpr double most_content(double bytes_of_file) { return 64e6 + 100 * bytes_of_file; }

// Returns why the content of a file is not accepted, as the end of a message about the file; empty
// if it is.
inline std::string why_too_large(double content, double bytes_of_file) {
  if (content <= most_content(bytes_of_file))
    return "";
  std::ostringstream text;
  text << "has " << content / 1e9 << " GB of content in " << bytes_of_file / 1e6
       << " MB, more than is accepted (64 MB, and 100 times the file); write it without "
          "compression, unless it is damaged";
  return text.str();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_TEXT_CONTENT_LIMIT_H
