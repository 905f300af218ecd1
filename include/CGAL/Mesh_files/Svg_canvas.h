// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_SVG_CANVAS_H
#define CGAL_MESH_FILES_SVG_CANVAS_H

#include <CGAL/Mesh_files/internal/text/Xml_element.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <charconv>
#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

Shapes of the same style, which `Svg_canvas` writes as one element of a file.
*/
struct Svg_layer
{
  std::string name;      ///< name of the element
  std::string fill;      ///< color of polygons, in the form `#rrggbb`; `none` for lines
  std::string stroke;    ///< color of lines, in the same form
  double line_width;     ///< in pixels
  std::string path = {}; ///< the shapes, to which `Svg_canvas::add()` appends
};

/*!
\ingroup PkgMeshFilesRef

Canvas for polygons, segments and texts of the plane, which writes scalable vector graphics. On a
torus, it draws polygons and segments at all visible images.
*/
class Svg_canvas
{
public:
  /// Constructs a canvas.
  /// \param window the visible part of the plane; `all` if it is `Bbox_2()`
  /// \param all the extent of the drawing
  /// \param width the width of the picture, positive and at most 1e6 pixels
  /// \param periods the periods of the torus; 0 in directions without a period
  /// \throws Error if the width is out of range, or if the window is empty, higher than 1e6 pixels, or
  ///         larger than 100 periods
  Svg_canvas(const Bbox_2& window, const Bbox_2& all, double width,
             const std::array<double, 2>& periods)
      : m_window(window == Bbox_2() ? all : window), m_width(width), m_periods(periods) {
    static constexpr double most_periods = 100, widest = 1e6;
    if (!(width > 0 && width <= widest))
      throw Error(
          "the width of the picture is out of range: use more than 0 and at most a million pixels");
    const double size[2] = {m_window.xmax() - m_window.xmin(), m_window.ymax() - m_window.ymin()};
    m_scale = width / size[0];
    for (int axis = 0; axis < 2; ++axis)
      if (!(size[axis] > 0 && size[axis] * m_scale <= widest) ||
          (periods[axis] > 0 && size[axis] > most_periods * periods[axis]))
        throw Error("the window of the picture is out of range: use a finite box with positive "
                    "sides of at most a million pixels and a hundred periods");
  }

  /// Appends the visible images of a polygon with given corners, or of a segment, to a layer.
  /// \pre The coordinates are finite.
  template <class Point, std::size_t n>
  void add(const std::array<Point, n>& corners, Svg_layer& layer) const {
    std::array<int, 2> first, last;
    for (int axis = 0; axis < 2; ++axis) {
      const auto [low, high] =
          std::minmax_element(corners.begin(), corners.end(),
                              [&](const Point& p, const Point& q) { return p[axis] < q[axis]; });
      const double begin = axis == 0 ? m_window.xmin() : m_window.ymin(),
                   end = axis == 0 ? m_window.xmax() : m_window.ymax(), period = m_periods[axis];
      if (period <= 0 && ((*high)[axis] < begin || (*low)[axis] > end))
        return; // not visible
      first[axis] = period > 0 ? int(std::ceil((begin - (*high)[axis]) / period)) : 0;
      last[axis] = period > 0 ? int(std::floor((end - (*low)[axis]) / period)) : 0;
    }
    for (int i = first[0]; i <= last[0]; ++i)
      for (int j = first[1]; j <= last[1]; ++j) {
        for (std::size_t k = 0; k < n; ++k)
          append(k == 0 ? 'M' : 'L', corners[k].x() + i * m_periods[0],
                 corners[k].y() + j * m_periods[1], layer.path);
        if (n > 2)
          layer.path += 'Z';
      }
  }

  /// Adds a text in front of all layers.
  /// \param anchor which part of the text is at the point: `start`, `middle` or `end`
  template <class Point>
  void add_text(const Point& point, const std::string& anchor, const std::string& text) {
    m_texts += "<text x=\"";
    append(m_scale * (point.x() - m_window.xmin()), m_texts);
    m_texts += "\" y=\"";
    append(m_scale * (m_window.ymax() - point.y()), m_texts);
    m_texts += "\" text-anchor=\"" + anchor + "\" font-family=\"sans-serif\" font-size=\"12\">" +
               internal::xml_escaped(text) + "</text>\n";
  }

  /// Writes the layers in their order, on a white background.
  /// \throws File_error if the file cannot be written; an older file of that name is then unchanged
  void write(const std::string& path, const std::vector<Svg_layer>& layers) const {
    const double height = m_scale * (m_window.ymax() - m_window.ymin());
    replace_file(path, [&](std::ostream& out) {
      out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << m_width << "\" height=\""
          << height << "\" viewBox=\"0 0 " << m_width << ' ' << height
          << "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
      for (const Svg_layer& layer : layers)
        out << "<path id=\"" << layer.name << "\" fill=\"" << layer.fill << "\" stroke=\""
            << layer.stroke << "\" stroke-width=\"" << layer.line_width << "\" d=\"" << layer.path
            << "\"/>\n";
      out << m_texts << "</svg>\n";
    });
  }

private:
  void append(char command, double x, double y, std::string& path) const {
    path += command;
    append(m_scale * (x - m_window.xmin()), path);
    path += ',';
    append(m_scale * (m_window.ymax() - y), path);
  }

  // Appends a number with hundredths of a pixel, independent of the locale. Numbers far outside the
  // picture are clamped.
  static void append(double x, std::string& path) {
    static constexpr double farthest = 1e7;
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, (std::max)(-farthest, (std::min)(farthest, x)),
                      std::chars_format::fixed, 2);
    path.append(text, end.ptr);
  }

  Bbox_2 m_window;
  double m_width, m_scale;
  std::array<double, 2> m_periods;
  std::string m_texts; // elements
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_SVG_CANVAS_H
