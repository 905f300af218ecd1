// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_POLYGONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_POLYGONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/IO/Ply_reader.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/read_obj.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/read_off.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/read_stl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/File_scanner.h>

#include <istream>

namespace CGAL::Deformable_simplicial_complexes::internal {

enum class Surface_format { none, off, obj, ply, stl };

// Reads a surface file and passes its content to `sink`, in the order of the file:
// - `expect_points(n)`: the number of points, if the file gives it; it may be wrong;
// - `point(x, y, z)`: a point; coordinates may be infinite or NaN;
// - `normal(x, y, z)`: the normal of the last point, if the file gives it;
// - `polygon(corners)`: the indices of the corners, a `std::vector<std::size_t>`. A polygon may
//   come before its points, and its indices may be wrong;
// - `unused(kind, number)`: content that is not passed, reported at the end.
//
// Stores only the current polygon. Throws `File_error` with the line if the file is invalid.
// \pre `format` is not `none`, and `scanner` is at the beginning of the file that `in` reads.
template <class Sink>
void read_polygons(std::istream& in, Surface_format format, File_scanner& scanner, Sink& sink) {
  switch (format) {
  case Surface_format::off:
    return read_off(scanner, sink);
  case Surface_format::obj:
    return read_obj(scanner, sink);
  case Surface_format::ply:
    return Ply_reader(scanner).read(sink);
  case Surface_format::stl:
    return is_binary_stl(in, scanner.path()) ? read_binary_stl(scanner, sink)
                                             : Stl_text_reader<Sink>(scanner, sink).read();
  case Surface_format::none:
    break;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IO_READ_POLYGONS_H
