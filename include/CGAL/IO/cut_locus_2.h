// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_CUT_LOCUS_2_H
#define CGAL_IO_CUT_LOCUS_2_H

#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/IO/SVG_2.h>
#include <CGAL/cut_locus_2.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

draws a cut locus in the box of its chart as a picture: scalable vector graphics (`.svg`), with the
cut locus in black and the point in red.

\param path is the name of the file; its folder must exist.
\param locus is what `cut_locus_2()` returned.
\param domain is the torus of the chart.
\param point is the point whose cut locus it is.
\param options tell the width of the picture and of lines, and what is seen.

\throws Deformable_simplicial_complexes::Error if the width is not positive.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.
*/
inline void write_SVG(const std::string& path, const Cut_locus_2& locus,
                      const Deformable_simplicial_complexes::Torus_domain<2>& domain,
                      const Simple_cartesian<double>::Point_2& point,
                      const SVG_options& options = SVG_options()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Point = Simple_cartesian<double>::Point_2;
  if (!(options.width > 0))
    throw Deformable_simplicial_complexes::Error("the width of a picture is not positive");
  const auto& periods = domain.periods();
  const bool sees_all = !(options.window.xmax() > options.window.xmin() &&
                          options.window.ymax() > options.window.ymin());
  const Bbox_2 window = sees_all ? Bbox_2(0, 0, periods[0], periods[1]) : options.window;
  const internal::Svg_canvas canvas(window, options.width, periods);
  std::string arcs, source;
  for (const auto& polyline : locus.polylines)
    for (std::size_t k = 1; k < polyline.size(); ++k) {
      const Point p = locus.vertices[polyline[k - 1]].point;
      canvas.add(std::array<Point, 2>{p, domain.near(p, locus.vertices[polyline[k]].point)}, arcs);
    }
  canvas.add(std::array<Point, 2>{point, point}, source);
  internal::replace_file_by_stream(path, [&](std::ostream& out) {
    canvas.begin(out);
    out << "<path id=\"cut_locus\" fill=\"none\" stroke=\"#000000\" stroke-width=\""
        << options.line_width << "\" d=\"" << arcs << "\"/>\n"
        << "<path id=\"point\" stroke=\"#d02020\" stroke-width=\"10\" d=\"" << source
        << "\"/>\n</svg>\n";
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_CUT_LOCUS_2_H
