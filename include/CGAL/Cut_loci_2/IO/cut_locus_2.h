// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H
#define CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H

#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/Mesh_files/Svg_canvas.h>

namespace CGAL::IO {

/*!
\ingroup PkgCutLoci2Ref

Writes a picture of a cut locus in the box of its chart, in the format SVG (`.svg`). The cut locus
is black and the source is red.

\param path the name of the file. Its folder must exist.
\param locus the result of `cut_locus_2()`
\param domain the torus of the chart
\param point the source of the cut locus
\param options the width of the picture, the width of lines and the visible window

\throws Deformable_simplicial_complexes::Error if the width or the window is out of range.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written. An older file of
        that name is then unchanged.
*/
inline void write_SVG(const std::string& path,
                      const Deformable_simplicial_complexes::Cut_locus_2& locus,
                      const Deformable_simplicial_complexes::Torus_domain<2>& domain,
                      const Epick::Point_2& point, const SVG_options& options = SVG_options()) {
  using Point = Epick::Point_2;
  const auto& periods = domain.periods();
  const Deformable_simplicial_complexes::Svg_canvas canvas(
      options.window, Bbox_2(0, 0, periods[0], periods[1]), options.width, periods);
  using Layer = Deformable_simplicial_complexes::Svg_layer;
  Layer arcs = {"cut_locus", "none", "#000000", options.line_width};
  Layer source = {"point", "none", "#d02020", 10};
  for (const auto& polyline : locus.polylines) {
    Point p = locus.vertices[polyline.front()].point;
    for (std::size_t k = 1; k < polyline.size(); ++k) {
      // Points at the seam of the chart may be on either side of it.
      const Point q = domain.nearest_image(p, locus.vertices[polyline[k]].point);
      canvas.add(std::array<Point, 2>{p, q}, arcs);
      p = q;
    }
  }
  canvas.add(std::array<Point, 2>{point, point}, source);
  canvas.write(path, {arcs, source});
}

/*!
\ingroup PkgCutLoci2Ref

Writes a picture of a cut locus on its surface, in the format SVG (`.svg`). It is a parallel
projection, seen from the side opposite to the source. The cut locus is black. The meridians and
parallels of the sphere on this side are grey.

\param path the name of the file. Its folder must exist.
\param locus the result of `cut_locus_2()` for the surface
\param surface the surface. Hidden parts are drawn, too, so the picture is correct for convex
       surfaces only.
\param options the width of the picture and the width of lines. The window is not used.

\throws Deformable_simplicial_complexes::Error if the width or the extent of the surface is out of
        range.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written. An older file of
        that name is then unchanged.
*/
template <class Embedding, template <class> class Differentiated>
void write_SVG(
    const std::string& path, const Deformable_simplicial_complexes::Cut_locus_2& locus,
    const Deformable_simplicial_complexes::Sphere_like_surface_2<Embedding, Differentiated>&
        surface,
    const SVG_options& options = SVG_options()) {
  using Surface = Deformable_simplicial_complexes::Sphere_like_surface_2<Embedding, Differentiated>;
  using Point = Epick::Point_2;
  static constexpr int meridians = 24, parallels = 6, finer = 4; // every 15 degrees
  const double pi = std::acos(-1.), middle = Surface::half_width;
  // The axes of the picture: the direction along u, and the perpendicular direction to its left for
  // an observer opposite to the source.
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
  const auto on_grid = [&](int meridian, int parallel) { // indices on the refined grid
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
  const Deformable_simplicial_complexes::Svg_canvas canvas(window, window, options.width, {0, 0});
  using Layer = Deformable_simplicial_complexes::Svg_layer;
  Layer lines = {"surface", "none", "#b0b0b0", .8};
  Layer arcs = {"cut_locus", "none", "#000000", 2 * options.line_width};
  for (const auto& line : grid)
    canvas.add(line, lines);
  for (const auto& polyline : locus.polylines)
    for (std::size_t k = 1; k < polyline.size(); ++k)
      canvas.add(std::array<Point, 2>{seen(locus.vertices[polyline[k - 1]].point),
                                      seen(locus.vertices[polyline[k]].point)},
                 arcs);
  canvas.write(path, {lines, arcs});
}

} // namespace CGAL::IO

#endif // CGAL_CUT_LOCI_2_IO_CUT_LOCUS_2_H
