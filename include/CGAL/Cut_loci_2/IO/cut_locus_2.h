// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H
#define CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H

#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/SVG_2.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgCutLoci2Ref

draws a cut locus in the box of its chart as a picture: scalable vector graphics (`.svg`), with the
cut locus in black and the point in red.

\param path is the name of the file; its folder must exist.
\param locus is what `cut_locus_2()` returned.
\param domain is the torus of the chart.
\param point is the point whose cut locus it is.
\param options tell the width of the picture and of lines, and what is seen.

\throws Deformable_simplicial_complexes::Error if the width or the window are out of range.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.
*/
inline void write_SVG(const std::string& path,
                      const Deformable_simplicial_complexes::Cut_locus_2& locus,
                      const Deformable_simplicial_complexes::Torus_domain<2>& domain,
                      const Simple_cartesian<double>::Point_2& point,
                      const SVG_options& options = SVG_options()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Point = Simple_cartesian<double>::Point_2;
  const auto& periods = domain.periods();
  const internal::Svg_canvas canvas(options.window, Bbox_2(0, 0, periods[0], periods[1]),
                                    options.width, periods);
  std::string arcs, source;
  for (const auto& polyline : locus.polylines) {
    Point p = locus.vertices[polyline.front()].point;
    for (std::size_t k = 1; k < polyline.size(); ++k) {
      // On the seam of the chart, points may be on either side of it.
      const Point q = domain.near(p, locus.vertices[polyline[k]].point);
      canvas.add(std::array<Point, 2>{p, q}, arcs);
      p = q;
    }
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

/*!
\ingroup PkgCutLoci2Ref

draws a cut locus on the surface, as seen in parallel rays from opposite to the source: in black,
with the meridians and parallels of the sphere on that side in grey.

\param path is the name of the file; its folder must exist.
\param locus is what `cut_locus_2()` returned for the surface.
\param surface is a surface, best a convex one: what hides parts of it is not known.
\param options tell the width of the picture and of lines; the window is not used.

\throws Deformable_simplicial_complexes::Error if the width or the window are out of range.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.
*/
template <class Embedding, template <class> class Differentiated>
void write_SVG(
    const std::string& path, const Deformable_simplicial_complexes::Cut_locus_2& locus,
    const Deformable_simplicial_complexes::Sphere_like_surface_2<Embedding, Differentiated>&
        surface,
    const SVG_options& options = SVG_options()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  using Surface = Deformable_simplicial_complexes::Sphere_like_surface_2<Embedding, Differentiated>;
  using Point = Simple_cartesian<double>::Point_2;
  static constexpr int meridians = 24, parallels = 6, finer = 4; // 15 degrees
  const double pi = std::acos(-1.), middle = Surface::half_width;
  // By the direction along u, and the one across it that is to the left of the way out.
  const auto right = surface.direction(Point(middle + 1, middle));
  auto up = surface.direction(Point(middle, middle - 1));
  // The axes of the chart may be oblique on the unit sphere.
  const double along = right[0] * up[0] + right[1] * up[1] + right[2] * up[2];
  for (std::size_t i = 0; i < 3; ++i)
    up[i] = (up[i] - along * right[i]) / std::sqrt(1 - along * along);
  const auto seen = [&](const Point& p) {
    const auto q = surface.image(p);
    return Point(q[0] * right[0] + q[1] * right[1] + q[2] * right[2],
                 q[0] * up[0] + q[1] * up[1] + q[2] * up[2]);
  };
  const auto on_grid = [&](int meridian, int parallel) { // in parts of their distances
    const double radius = std::tan(pi / 4 * parallel / (parallels * finer)),
                 angle = 2 * pi * meridian / (meridians * finer);
    return seen(Point(middle + radius * std::cos(angle), middle + radius * std::sin(angle)));
  };
  std::vector<std::array<Point, 2>> grid;
  for (int i = 0; i < meridians * finer; ++i)
    for (int j = 0; j <= parallels * finer; ++j) {
      if (i % finer == 0 && j > 0)
        grid.push_back({on_grid(i, j - 1), on_grid(i, j)});
      if (j % finer == 0 && j > 0)
        grid.push_back({on_grid(i, j), on_grid(i + 1, j)});
    }
  Bbox_2 box;
  for (const auto& line : grid)
    box += line[0].bbox() + line[1].bbox();
  const double margin = .02 * (box.xmax() - box.xmin());
  const Bbox_2 window(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin,
                      box.ymax() + margin);
  const internal::Svg_canvas canvas(window, window, options.width, {0, 0});
  std::string lines, arcs;
  for (const auto& line : grid)
    canvas.add(line, lines);
  for (const auto& polyline : locus.polylines)
    for (std::size_t k = 1; k < polyline.size(); ++k)
      canvas.add(std::array<Point, 2>{seen(locus.vertices[polyline[k - 1]].point),
                                      seen(locus.vertices[polyline[k]].point)},
                 arcs);
  internal::replace_file_by_stream(path, [&](std::ostream& out) {
    canvas.begin(out);
    out << "<path id=\"surface\" fill=\"none\" stroke=\"#b0b0b0\" stroke-width=\".8\" d=\"" << lines
        << "\"/>\n"
        << "<path id=\"cut_locus\" fill=\"none\" stroke=\"#000000\" stroke-width=\""
        << 2 * options.line_width << "\" d=\"" << arcs << "\"/>\n</svg>\n";
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H
