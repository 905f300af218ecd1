// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_CURVES_READ_POLY_H
#define CGAL_MESH_FILES_INTERNAL_CURVES_READ_POLY_H

#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <locale>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A reader for the lines of a file in the format of Triangle (J. R. Shewchuk). Each line begins
// with a number that is a count or an index.
class Triangle_lines
{
public:
  explicit Triangle_lines(const std::string& path)
      : m_in(path, lower_case_extension(path)), m_scanner(m_in, path) {
    m_in.imbue(std::locale::classic());
  }

  // Returns whether there is another line.
  bool has_next() {
    const bool result = m_scanner.next();
    m_scanner.back();
    return result;
  }

  // Begins the next line. Returns its first number.
  std::size_t next() {
    Progress_scope::check();
    return m_scanner.number<std::size_t>();
  }

  // Returns the next number on the line. Throws `File_error` if there is none.
  template <class Number> Number number() {
    const std::optional<Number> result = optional_number<Number>();
    if (!result)
      m_scanner.fail("a number is missing on this line; correct it");
    return *result;
  }

  // Returns the next number on the line, if there is one.
  template <class Number> std::optional<Number> optional_number() {
    if (!m_scanner.next_on_line())
      return std::nullopt;
    m_scanner.back();
    return m_scanner.number<Number>();
  }

  // Returns the point given by the next two numbers. Throws `File_error` if a coordinate is not
  // finite.
  template <class Point> Point point() {
    std::array<double, 2> p;
    for (double& x : p)
      if (!std::isfinite(x = number<double>()))
        m_scanner.fail("a coordinate is not a finite number; correct it");
    return Point(p[0], p[1]);
  }

  // Ends the line. Returns the number of words that were left on it.
  std::size_t end() {
    std::size_t result = 0;
    while (m_scanner.next_on_line())
      ++result;
    return result;
  }

  [[noreturn]] void fail(const std::string& what) const { m_scanner.fail(what); }

private:
  Input_file m_in;
  File_scanner m_scanner;
};

// A reader for the segments of a .poly file; holes and regional attributes become seeds.
template <class Point> class Poly_reader
{
public:
  explicit Poly_reader(const std::string& path) : m_path(path), m_lines(path) {}

  Seeded_segments_2<Point> read() {
    if (!read_points(m_lines))
      read_node_file();
    read_segments();
    read_holes();
    if (m_lines.has_next() && read_regions() > 0)
      m_result.enclosed_label = 0;
    else
      m_result.enclosed_label = 1;
    for (; m_lines.has_next(); m_lines.end())
      m_unused.add("lines at the end");
    return m_result;
  }

  const Unused_content& unused() const { return m_unused; }

private:
  // Returns whether there are points.
  bool read_points(Triangle_lines& lines) {
    const std::size_t points = lines.next();
    if (lines.number<std::size_t>() != 2)
      lines.fail("the points are not two-dimensional: the second number must be 2");
    lines.optional_number<std::size_t>(); // number of attributes of each point
    const bool has_markers = lines.optional_number<std::size_t>().value_or(0) > 0;
    lines.end();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t index = lines.next();
      if (i == 0 && index > 1)
        lines.fail("the number of the first point is not 0 or 1; correct it");
      if (i == 0)
        m_first = index;
      if (index != m_first + i)
        lines.fail("the points are not numbered consecutively; correct the numbers");
      m_result.points.push_back(lines.point<Point>());
      const std::size_t more = lines.end();
      const std::size_t markers = has_markers && more > 0 ? 1 : 0;
      m_unused.add("boundary markers", markers);
      m_unused.add("point attributes", more - markers);
    }
    return points > 0;
  }

  void read_node_file() {
    const std::string path = std::filesystem::path(m_path).replace_extension(".node").string();
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      m_lines.fail("there are no points, and the file " + path +
                   " with the points does not exist; put it into the same folder");
    Triangle_lines lines(path);
    if (!read_points(lines))
      lines.fail("there are no points; add points");
  }

  void read_segments() {
    const std::size_t segments = m_lines.next();
    m_lines.end();
    std::vector<char> is_used(m_result.points.size(), 0);
    for (std::size_t i = 0; i < segments; ++i) {
      m_lines.next();
      std::array<std::size_t, 2> ends;
      for (std::size_t& end : ends) {
        end = m_lines.number<std::size_t>() - m_first;
        if (end >= m_result.points.size())
          m_lines.fail("a segment refers to a point that does not exist; correct it");
        is_used[end] = 1;
      }
      m_result.segments.push_back(ends);
      m_unused.add("boundary markers", m_lines.end());
    }
    if (segments == 0)
      m_lines.fail("there are no segments; add the boundaries of regions");
    m_unused.add("points without segments",
                 std::size_t(std::count(is_used.begin(), is_used.end(), 0)));
  }

  void read_holes() {
    const std::size_t holes = m_lines.next();
    m_lines.end();
    for (std::size_t i = 0; i < holes; ++i) {
      m_lines.next();
      m_result.seeds.emplace_back(m_lines.point<Point>(), 0);
      m_lines.end();
    }
  }

  // Returns the number of regions.
  std::size_t read_regions() {
    const std::size_t regions = m_lines.next();
    m_lines.end();
    for (std::size_t i = 0; i < regions; ++i) {
      m_lines.next();
      const Point p = m_lines.point<Point>();
      const double label = m_lines.number<double>();
      if (label != std::floor(label) || label < (std::numeric_limits<int>::min)() ||
          label > (std::numeric_limits<int>::max)())
        m_lines.fail(
            "the attribute of a region is not a 32-bit integer and cannot be a label; correct it");
      m_result.seeds.emplace_back(p, int(label));
      m_unused.add("area constraints", m_lines.optional_number<double>().value_or(0) > 0 ? 1 : 0);
      m_lines.end();
    }
    return regions;
  }

  std::string m_path;
  Triangle_lines m_lines;
  std::size_t m_first = 0; // number of the first point
  Seeded_segments_2<Point> m_result;
  Unused_content m_unused;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_CURVES_READ_POLY_H
