// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_SVG_2_H
#define CGAL_MESH_FILES_SVG_2_H

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Mesh_files/Svg_canvas.h>
#include <CGAL/Mesh_files/internal/pictures/colors.h>
#include <CGAL/Mesh_support/Error.h>

#include <map>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgMeshFilesRef

Options of `write_SVG()`.
*/
struct SVG_options
{
  /// width of the picture in pixels, positive; the height follows from the window
  double width = 800;
  bool draws_edges = false; ///< whether the edges of all triangles are drawn
  double line_width = 1.5;  ///< width of the interface lines in pixels; with 0, no lines are drawn
  Bbox_2 window; ///< visible part, in user coordinates; the whole domain if it is `Bbox_2()`
};

} // namespace IO

namespace Deformable_simplicial_complexes::internal {

// Draws a complex. The triangles with the same key are a region: `key_of(c)` is the key of a
// triangle, and `region_of(key)` is its layer without
// a path. Regions are drawn in the order of
// their keys.
template <class Complex, class KeyOf, class RegionOf>
void write_svg(const std::string& path, const Complex& dsc, const IO::SVG_options& options,
               const KeyOf& key_of, const RegionOf& region_of) {
  using Point = typename Complex::Point_2;
  if (dsc.number_of_cells() == 0)
    throw Error("there is nothing to draw: the complex is empty");
  std::array<double, 2> periods = dsc.domain().template periods<2>();
  Bbox_2 all;
  if constexpr (Complex::Domain::has_outside)
    for (const auto v : dsc.vertices())
      all += dsc.user_position(v).bbox();
  else
    all = dsc.in_user_coordinates(Point(0, 0)).bbox() +
          dsc.in_user_coordinates(Point(periods[0], periods[1])).bbox();
  for (double& period : periods)
    period *= dsc.normalization().scale;
  const Svg_canvas canvas(options.window, all, options.width, periods);

  std::map<decltype(key_of(dsc.cells().front())), Svg_layer> regions;
  Svg_layer edges = {"edges", "none", "#808080", .3},
            lines = {"interface", "none", "#000000", options.line_width};
  for (const auto c : dsc.cells()) {
    const std::array<Point, 3> corners = {dsc.in_user_coordinates(dsc.corner(c, 0)),
                                          dsc.in_user_coordinates(dsc.corner(c, 1)),
                                          dsc.in_user_coordinates(dsc.corner(c, 2))};
    const auto key = key_of(c);
    const auto [region, is_new] = regions.try_emplace(key);
    if (is_new)
      region->second = region_of(key);
    canvas.add(corners, region->second);
    if (options.draws_edges)
      canvas.add(corners, edges);
    for (int i = 0; i < 3; ++i)
      if (dsc.is_interface(typename Complex::Facet(c, i)) &&
          c->subdomain_index() > c->neighbor(i)->subdomain_index())
        canvas.add(std::array<Point, 2>{corners[(i + 1) % 3], corners[(i + 2) % 3]}, lines);
  }
  std::vector<Svg_layer> layers;
  for (auto& [key, region] : regions)
    layers.push_back(std::move(region));
  if (options.draws_edges)
    layers.push_back(std::move(edges));
  if (options.line_width > 0)
    layers.push_back(std::move(lines));
  canvas.write(path, layers);
}

// Returns the layer of triangles of a color. The thin lines around triangles close the gaps that
// antialiasing would leave between them.
inline Svg_layer svg_region(const std::string& name, const std::string& color) {
  return {name, color, color, .4};
}

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgMeshFilesRef

Draws a complex in 2D as scalable vector graphics (`.svg`). Each label has a color, which is white
for 0; the interface is drawn as black lines. A torus is drawn as its box; triangles across the seam
are drawn on both sides. n log n in the number of triangles.

\param path name of the file; its folder must exist
\param dsc the complex
\param options options of the drawing

\throws Deformable_simplicial_complexes::Error if the width or the window is out of range, or the
        complex is empty
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file of
        that name is then unchanged
*/
template <class Traits, class Tds, class Domain>
void write_SVG(const std::string& path,
               const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc,
               const SVG_options& options = SVG_options()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  internal::write_svg(
      path, dsc, options, [&](auto c) { return dsc.label(c); },
      [](int label) {
        return internal::svg_region("label_" + std::to_string(label),
                                    internal::hexadecimal(internal::color_of_label(label)));
      });
}

/*!
\ingroup PkgMeshFilesRef

Draws a complex as above, with given colors of the triangles.

\tparam ColorOf a function from `Cell_handle` to `std::string`

\param path, dsc, options as above
\param color_of returns the color of a triangle, in the form `#rrggbb` with hexadecimal digits

\throws Deformable_simplicial_complexes::Error as above
\throws Deformable_simplicial_complexes::File_error as above
*/
template <class Traits, class Tds, class Domain, class ColorOf>
void write_SVG(const std::string& path,
               const Deformable_simplicial_complex_2<Traits, Tds, Domain>& dsc,
               const SVG_options& options, const ColorOf& color_of) {
  namespace internal = Deformable_simplicial_complexes::internal;
  internal::write_svg(
      path, dsc, options, [&](auto c) -> std::string { return color_of(c); },
      [](const std::string& color) {
        return internal::svg_region("color_" + color.substr(1), color);
      });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_MESH_FILES_SVG_2_H
