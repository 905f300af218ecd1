// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H

#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/number_of_word.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A statement of an OBJ file that gives neither a point nor a polygon.
struct Obj_statement
{
  std::string_view keyword;
  const char* content; // the name of the unused content; null if the statement describes a surface
};

// Returns null if the keyword is unknown.
inline const Obj_statement* find_obj_statement(std::string_view keyword) {
  static constexpr Obj_statement statements[] = {{"vt", "texture coordinates"},
                                                 {"vn", "normals"},
                                                 {"vp", "points in parameter space"},
                                                 {"g", "groups"},
                                                 {"o", "objects"},
                                                 {"s", "smoothing groups"},
                                                 {"mg", "merging groups"},
                                                 {"usemtl", "materials of polygons"},
                                                 {"mtllib", "material files"},
                                                 {"usemap", "textures of polygons"},
                                                 {"maplib", "texture files"},
                                                 {"p", "point elements"},
                                                 {"l", "lines"},
                                                 {"curv", "curves"},
                                                 {"curv2", "curves"},
                                                 {"surf", nullptr},
                                                 {"bzp", nullptr},
                                                 {"bsp", nullptr},
                                                 {"cdp", nullptr},
                                                 {"call", nullptr}};
  for (const Obj_statement& statement : statements)
    if (statement.keyword == keyword)
      return &statement;
  return nullptr;
}

// Passes the points and the polygons of an OBJ file to a sink; see read_polygons.h. Throws
// `File_error` if a statement is invalid, or describes a surface without polygons.
template <class Sink> void read_obj(File_scanner& scanner, Sink& sink) {
  std::int64_t number_of_points = 0;
  // Returns the zero-based point index of a corner. A corner such as 7/3/5 has up to three indices,
  // and the first one is the index of the point. Positive indices begin with 1; negative ones count
  // back from the last point.
  const auto index_of_corner = [&] {
    const std::string_view corner = scanner.word();
    const auto index = number_of_word<std::int64_t>(corner.substr(0, corner.find('/')));
    if (!index || *index == 0 || *index < -number_of_points)
      scanner.fail(in_quotes(scanner.word()) + " is not a corner of a polygon; correct it");
    return static_cast<std::size_t>(*index > 0 ? *index - 1 : number_of_points + *index);
  };

  std::size_t weights = 0, colors = 0;
  std::map<std::string, std::size_t> unused;
  std::vector<std::size_t> corners;
  scanner.continue_lines_at('\\');
  while (scanner.next()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      const double x = scanner.template number<double>(), y = scanner.template number<double>(),
                   z = scanner.template number<double>();
      sink.point(x, y, z);
      ++number_of_points;
      weights += scanner.words_left() == 1;
      colors += scanner.words_left() > 1;
    } else if (keyword == "f" || keyword == "fo") {
      corners.clear();
      while (scanner.next_on_line())
        corners.push_back(index_of_corner());
      sink.polygon(corners);
    } else if (!scanner.is_keyword()) {
      scanner.fail(in_quotes(keyword) + " is not expected; is it an OBJ file?");
    } else if (const Obj_statement* const statement = find_obj_statement(keyword)) {
      if (!statement->content)
        scanner.fail(in_quotes(keyword) + " describes a surface without polygons or in another "
                                          "file; write the surface as polygons");
      ++unused[statement->content];
    } else {
      // A message names at most this number of unknown statements.
      constexpr std::size_t most_kinds = 40;
      ++unused[unused.size() < most_kinds ? "statements " + in_quotes(keyword)
                                          : "other statements"];
    }
    scanner.skip_line();
  }
  sink.unused("weights of points", weights);
  sink.unused("colors of points", colors);
  for (const auto& [content, number] : unused)
    sink.unused(content, number);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_OBJ_H
