// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_WKT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_WKT_H

#include <CGAL/Deformable_simplicial_complex_2/Labelled_curve_2.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/text/number_of_word.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Reads geometries in the well-known text of the Open Geospatial Consortium: each POLYGON and each
// MULTIPOLYGON is a curve with the next label, each closed LINESTRING, too.
template <class Point> class Wkt_reader
{
public:
  using Curve = Labelled_curve_2<Point>;

  explicit Wkt_reader(const std::string& path) : m_path(path), m_text(file_contents(path)) {
    static constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (std::string_view(m_text).substr(0, byte_order_mark.size()) == byte_order_mark)
      m_position = byte_order_mark.size();
  }

  std::vector<Curve> read() {
    std::vector<Curve> curves;
    for (skip_space(); m_position < m_text.size(); skip_space()) {
      curves.emplace_back();
      curves.back().label = int(curves.size());
      const std::string type = word();
      const int depth = type == "LINESTRING"                             ? 1
                        : type == "POLYGON" || type == "MULTILINESTRING" ? 2
                        : type == "MULTIPOLYGON"                         ? 3
                                                                         : 0;
      if (depth == 0)
        fail(in_quotes(type) + " is no geometry that bounds a region: use POLYGON, MULTIPOLYGON, "
                               "LINESTRING or MULTILINESTRING");
      if (const std::string more = is_letter() ? word() : ""; more == "EMPTY") {
        curves.pop_back();
        continue;
      } else if (!more.empty()) {
        fail(in_quotes(type + ' ' + more) + " has more than x and y: leave the others out");
      }
      nested(depth, curves.back());
      if (!curves.empty() && curves.back().segments.empty())
        curves.pop_back(); // its parts are empty
    }
    return curves;
  }

private:
  // A list in parentheses of lists in parentheses and so on, of ways at last.
  void nested(int depth, Curve& curve) {
    if (depth == 1)
      return way(curve);
    expect('(');
    do {
      if (!is_empty())
        nested(depth - 1, curve);
    } while (is_next(','));
    expect(')');
  }

  void way(Curve& curve) {
    std::vector<std::array<double, 2>> points;
    expect('(');
    do {
      const double x = number();
      points.push_back({x, number()});
    } while (is_next(','));
    expect(')');
    if (points.size() < 4 || points.front() != points.back())
      fail("a way is not closed: its last point must be its first, with at least two between");
    points.pop_back();
    std::vector<Point> polyline;
    for (const auto& p : points)
      polyline.emplace_back(p[0], p[1]);
    curve.add_polyline(polyline);
  }

  void skip_space() {
    while (m_position < m_text.size() &&
           std::isspace(static_cast<unsigned char>(m_text[m_position])))
      ++m_position;
  }

  bool is_letter() {
    skip_space();
    return m_position < m_text.size() &&
           std::isalpha(static_cast<unsigned char>(m_text[m_position])) != 0;
  }

  std::string word() {
    skip_space();
    std::string result;
    while (m_position < m_text.size() &&
           std::isalpha(static_cast<unsigned char>(m_text[m_position])))
      result += char(std::toupper(static_cast<unsigned char>(m_text[m_position++])));
    if (result.empty())
      fail("the name of a geometry is missing");
    return result;
  }

  bool is_empty() {
    skip_space();
    static constexpr std::string_view empty = "EMPTY";
    const std::string_view here = std::string_view(m_text).substr(m_position, empty.size());
    if (!std::equal(here.begin(), here.end(), empty.begin(), empty.end(), [](char a, char b) {
          return std::toupper(static_cast<unsigned char>(a)) == b;
        }))
      return false;
    m_position += empty.size();
    return true;
  }

  bool is_next(char c) {
    skip_space();
    if (m_position == m_text.size() || m_text[m_position] != c)
      return false;
    ++m_position;
    return true;
  }

  void expect(char c) {
    if (!is_next(c))
      fail(std::string("there should be a ") + c);
  }

  double number() {
    skip_space();
    const std::size_t end =
        (std::min)(m_text.find_first_of(" \t\r\n,()", m_position), m_text.size());
    const std::string_view text = std::string_view(m_text).substr(m_position, end - m_position);
    const auto result = number_of_word<double>(text);
    if (!result || !std::isfinite(*result))
      fail(in_quotes(text) + " should be a finite number");
    m_position = end;
    return *result;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const auto line =
        1 + std::count(m_text.begin(), m_text.begin() + std::ptrdiff_t(m_position), '\n');
    throw File_error(m_path + ", line " + std::to_string(line) + ": " + what, m_path);
  }

  std::string m_path, m_text;
  std::size_t m_position = 0;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_IO_READ_WKT_H
