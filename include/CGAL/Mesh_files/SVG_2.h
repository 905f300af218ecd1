// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_SVG_2_H
#define CGAL_MESH_FILES_SVG_2_H

#include <CGAL/license/Mesh_files.h>

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Interface_remeshing/extract_interface_2.h>
#include <CGAL/Mesh_files/Svg_canvas.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <ostream>
#include <string>
#include <vector>

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

// Returns a color for a label: white for 0, otherwise hues by the golden angle. All colors are
// light enough for black lines.
inline std::string color_of_label(int label) {
  if (label == 0)
    return "#ffffff";
  static constexpr double golden_angle = 137.50776405, first_hue = 210, saturation = .55,
                          lightness = .66;
  const double hue = std::fmod(first_hue + golden_angle * double(std::int64_t(label) - 1), 360.);
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + (hue < 0 ? hue + 360 : hue) / 30, 12.);
    const double a = saturation * (std::min)(lightness, 1 - lightness);
    return int(
        std::lround(255 * (lightness - a * (std::max)(-1., (std::min)({k - 3, 9 - k, 1.})))));
  };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", channel(0), channel(8), channel(4));
  return text;
}

// A set of triangles of one color.
struct Svg_region
{
  std::string name, color; // attributes of the element
  std::string path;
};

// Draws a complex. The triangles with the same key are a region: `key_of(c)` is the key of a
// triangle, and `region_of(key)` is a region without its path. Regions are drawn in the order of
// their keys.
template <class Complex, class KeyOf, class RegionOf>
void write_svg(const std::string& path, const Complex& dsc, const IO::SVG_options& options,
               const KeyOf& key_of, const RegionOf& region_of) {
  using Point = typename Complex::Approximate_point_2;
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

  std::map<decltype(key_of(dsc.cells().front())), Svg_region> regions;
  std::string edges, interface_;
  for (const auto c : dsc.cells()) {
    const std::array<Point, 3> corners = {dsc.in_user_coordinates(dsc.corner(c, 0)),
                                          dsc.in_user_coordinates(dsc.corner(c, 1)),
                                          dsc.in_user_coordinates(dsc.corner(c, 2))};
    const auto key = key_of(c);
    const auto [region, is_new] = regions.try_emplace(key);
    if (is_new)
      region->second = region_of(key);
    canvas.add(corners, region->second.path);
    if (options.draws_edges)
      canvas.add(corners, edges);
    for (int i = 0; i < 3; ++i)
      if (dsc.is_interface(typename Complex::Facet(c, i)) && c->label() > c->neighbor(i)->label())
        canvas.add(std::array<Point, 2>{corners[(i + 1) % 3], corners[(i + 2) % 3]}, interface_);
  }
  replace_file_by_stream(path, [&](std::ostream& out) {
    canvas.begin(out);
    // The thin lines around triangles close the gaps that antialiasing would leave between them.
    for (const auto& [key, region] : regions)
      out << "<path id=\"" << region.name << "\" fill=\"" << region.color << "\" stroke=\""
          << region.color << "\" stroke-width=\"0.4\" d=\"" << region.path << "\"/>\n";
    if (options.draws_edges)
      out << "<path id=\"edges\" fill=\"none\" stroke=\"#808080\" stroke-width=\"0.3\" d=\""
          << edges << "\"/>\n";
    if (options.line_width > 0)
      out << "<path id=\"interface\" fill=\"none\" stroke=\"#000000\" stroke-width=\""
          << options.line_width << "\" d=\"" << interface_ << "\"/>\n";
    out << "</svg>\n";
  });
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
        return internal::Svg_region{
            "label_" + std::to_string(label), internal::color_of_label(label), {}};
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
        return internal::Svg_region{"color_" + color.substr(1), color, {}};
      });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_MESH_FILES_SVG_2_H
