// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_CURVES_READ_WKT_H
#define CGAL_MESH_FILES_INTERNAL_CURVES_READ_WKT_H

#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/number_of_word.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cctype>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A ring of one of several polygons: the boundary of the polygon or of a hole.
struct Polygon_ring
{
  std::vector<std::array<double, 2>> points;
  std::size_t polygon;
  bool is_hole;
  std::size_t line; // of the file
};

// The nesting of rings: for each ring, the number of rings that contain it, tested at one point of
// the ring. The algorithm sorts these points by y-coordinate. Complexity: O(n log n) if the
// y-ranges of few rings overlap.
class Ring_nesting
{
public:
  explicit Ring_nesting(const std::vector<Polygon_ring>& rings)
      : m_rings(rings), m_depths(rings.size(), 0), m_is_in_shell(rings.size(), false) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const auto &a = rings[r].points[0], &b = rings[r].points[1];
      m_places.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, r});
    }
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return a.y < b.y; });
    for (std::size_t r = 0; r < rings.size(); ++r)
      count_inside(r);
  }

  // Returns the number of other rings that contain a ring.
  std::size_t depth(std::size_t ring) const { return m_depths[ring]; }

  // Returns whether a ring lies inside the outer boundary of its polygon.
  bool is_in_shell(std::size_t ring) const { return m_is_in_shell[ring]; }

private:
  struct Place
  {
    double x, y;
    std::size_t ring;
  };

  // Increments the depth of all rings that lie inside a ring. A point lies inside if its ray to the
  // right crosses the ring an odd number of times.
  void count_inside(std::size_t around) {
    const auto& points = m_rings[around].points;
    std::vector<std::size_t> crossed; // rings whose rays cross `around`, once for each crossing
    for (std::size_t i = 0; i < points.size(); ++i) {
      auto low = points[i], high = points[(i + 1) % points.size()];
      if (low[1] > high[1])
        std::swap(low, high);
      const auto is_below = [](const Place& p, double y) { return p.y < y; };
      auto place = std::lower_bound(m_places.begin(), m_places.end(), low[1], is_below);
      for (; place != m_places.end() && place->y < high[1]; ++place)
        if (place->ring != around && is_left(*place, low, high))
          crossed.push_back(place->ring);
    }
    std::sort(crossed.begin(), crossed.end());
    for (auto first = crossed.begin(); first != crossed.end();) {
      const auto last = std::upper_bound(first, crossed.end(), *first);
      if ((last - first) % 2 != 0) {
        ++m_depths[*first];
        if (!m_rings[around].is_hole && m_rings[around].polygon == m_rings[*first].polygon)
          m_is_in_shell[*first] = true;
      }
      first = last;
    }
  }

  static bool is_left(const Place& p, const std::array<double, 2>& low,
                      const std::array<double, 2>& high) {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    return CGAL::orientation(Point(low[0], low[1]), Point(high[0], high[1]), Point(p.x, p.y)) ==
           LEFT_TURN;
  }

  const std::vector<Polygon_ring>& m_rings;
  std::vector<Place> m_places; // one point of each ring, sorted by y-coordinate
  std::vector<std::size_t> m_depths;
  std::vector<bool> m_is_in_shell;
};

// A ring and a description of its fault.
struct Ring_fault
{
  std::size_t ring;
  const char* what;
};

// Returns the first hole that is not inside its polygon, or the first polygon that overlaps another
// one, if any.
// \pre Rings do not cross. Crossings are detected later, by the triangulation of the plane.
inline std::optional<Ring_fault> find_ring_fault(const std::vector<Polygon_ring>& rings) {
  const Ring_nesting nesting(rings);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].is_hole && !nesting.is_in_shell(r))
      return Ring_fault{r, "a hole is outside its polygon: the first ring of a polygon is its "
                           "boundary, and the others are holes; correct their order"};
    if (rings[r].is_hole && nesting.depth(r) % 2 == 0)
      return Ring_fault{r, "a hole is inside another hole, or in a polygon that overlaps another "
                           "one: write polygons inside holes as separate polygons"};
    if (!rings[r].is_hole && nesting.depth(r) % 2 != 0)
      return Ring_fault{r, "a polygon is inside another one of the same geometry: unite them, make "
                           "it a hole, or make it a separate geometry"};
  }
  return std::nullopt;
}

// A reader for geometries in the well-known text format of the Open Geospatial Consortium. Each
// POLYGON, each MULTIPOLYGON and each closed LINESTRING becomes a curve with the next label.
template <class Point> class Wkt_reader
{
public:
  using Curve = Labeled_curve_2<Point>;

  explicit Wkt_reader(const std::string& path) : m_path(path), m_text(file_contents(path)) {}

  std::vector<Curve> read() {
    while (!is_at_end()) {
      skip_reference_system();
      geometry(0);
      is_next(';');
    }
    return std::move(m_curves);
  }

  const Unused_content& unused() const { return m_unused; }

private:
  static constexpr int most_nested = 100; // maximum depth of nested collections

  // Returns the depth of nested lists in a geometry, down to its rings; 0 if the geometry bounds no
  // region.
  static int depth_of(const std::string& type) {
    return type == "LINESTRING" || type == "LINEARRING"                           ? 1
           : type == "POLYGON" || type == "TRIANGLE" || type == "MULTILINESTRING" ? 2
           : type == "MULTIPOLYGON"                                               ? 3
                                                                                  : 0;
  }

  // Reads a geometry or a collection of geometries.
  void geometry(int collections) {
    Progress_scope::check();
    const std::string type = word();
    const int depth = depth_of(type);
    const bool is_collection = type == "GEOMETRYCOLLECTION",
               is_point = type == "POINT" || type == "MULTIPOINT";
    if (depth == 0 && !is_collection && !is_point)
      fail(in_quotes(type) + " is not a geometry that bounds a region: use POLYGON, MULTIPOLYGON, "
                             "LINESTRING or MULTILINESTRING");
    if (const std::string more = is_letter() ? word() : ""; more == "EMPTY") {
      m_unused.add("empty geometries");
      return;
    } else if (!more.empty() && !is_point) {
      fail(in_quotes(type + ' ' + more) + " has more coordinates than x and y: remove the others");
    }
    if (is_point)
      return skip_points();
    if (is_collection)
      return collection(collections + 1);
    m_rings.clear();
    m_polygons = 0;
    nested(depth, false);
    finish_curve(type);
  }

  void collection(int depth) {
    if (depth > most_nested)
      fail("collections are nested more than 100 levels deep; use fewer levels");
    expect('(');
    do
      geometry(depth);
    while (is_next(','));
    expect(')');
  }

  void skip_points() {
    const std::size_t first = m_position;
    expect('(');
    const std::size_t end = m_text.find_first_not_of("0123456789+-.eE \t\r\n,()", m_position);
    std::size_t open = 1;
    while (open > 0 && m_position < (std::min)(end, m_text.size())) {
      open += m_text[m_position] == '(';
      open -= m_text[m_position++] == ')';
    }
    if (open > 0)
      fail("there is no ) after the points; add it");
    const auto last = m_text.begin() + std::ptrdiff_t(m_position);
    m_unused.add("points",
                 1 + std::size_t(std::count(m_text.begin() + std::ptrdiff_t(first), last, ',')));
  }

  // Adds the rings of a geometry as a curve. Throws `File_error` if rings of polygons are not
  // properly nested.
  void finish_curve(const std::string& type) {
    if (m_rings.empty()) // all its polygons are empty
      return m_unused.add("empty geometries");
    if (type == "POLYGON" || type == "MULTIPOLYGON")
      if (const std::optional<Ring_fault> fault = find_ring_fault(m_rings))
        fail_at(m_rings[fault->ring].line, fault->what);
    m_curves.emplace_back();
    m_curves.back().label = int(m_curves.size());
    for (const Polygon_ring& ring : m_rings) {
      std::vector<Point> polyline;
      for (const auto& p : ring.points)
        polyline.emplace_back(p[0], p[1]);
      m_curves.back().add_polyline(polyline);
    }
  }

  // Reads nested lists in parentheses, down to rings.
  void nested(int depth, bool is_hole) {
    if (depth == 1)
      return ring(is_hole);
    expect('(');
    bool is_first = true;
    do {
      if (is_empty())
        continue;
      nested(depth - 1, depth == 2 && !is_first);
      is_first = false;
    } while (is_next(','));
    expect(')');
    m_polygons += depth == 2;
  }

  void ring(bool is_hole) {
    const std::size_t line = line_number();
    std::vector<std::array<double, 2>> points;
    expect('(');
    do {
      Progress_scope::check();
      const double x = number();
      points.push_back({x, number()});
      if (skip_space();
          m_position < m_text.size() && m_text[m_position] != ',' && m_text[m_position] != ')')
        fail("a point has more than two coordinates, or a comma is missing: give two numbers for "
             "each point");
    } while (is_next(','));
    expect(')');
    if (points.size() < 4 || points.front() != points.back())
      fail_at(line, "a ring is not closed: its last point must equal its first point, with at "
                    "least two other points between them");
    points.pop_back();
    m_rings.push_back({std::move(points), m_polygons, is_hole, line});
  }

  // Skips a prefix such as `SRID=4326;`.
  void skip_reference_system() {
    const std::size_t end = m_text.find(';', m_position);
    std::string begin = m_text.substr(m_position, 5);
    std::transform(begin.begin(), begin.end(), begin.begin(), upper_case);
    if (begin != "SRID=" || end == std::string::npos)
      return;
    m_position = end + 1;
    m_unused.add("spatial reference systems");
  }

  bool is_at_end() {
    skip_space();
    return m_position == m_text.size();
  }

  static char upper_case(char c) { return char(std::toupper(static_cast<unsigned char>(c))); }

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
      result += upper_case(m_text[m_position++]);
    if (result.empty())
      fail("the name of a geometry is missing");
    return result;
  }

  bool is_empty() {
    skip_space();
    static constexpr std::string_view empty = "EMPTY";
    const std::string_view here = std::string_view(m_text).substr(m_position, empty.size());
    if (!std::equal(here.begin(), here.end(), empty.begin(), empty.end(),
                    [](char a, char b) { return upper_case(a) == b; }))
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

  // Returns the line of the current position. Counts from the position of the previous call.
  std::size_t line_number() {
    const auto at = [&](std::size_t position) { return m_text.begin() + std::ptrdiff_t(position); };
    m_line += std::size_t(std::count(at(m_line_position), at(m_position), '\n'));
    m_line_position = m_position;
    return m_line;
  }

  [[noreturn]] void fail(const std::string& what) { fail_at(line_number(), what); }

  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const {
    throw File_error(m_path + ", line " + std::to_string(line) + ": " + what, m_path);
  }

  std::string m_path, m_text;
  std::size_t m_position = 0;
  std::size_t m_line = 1, m_line_position = 0;
  std::vector<Polygon_ring> m_rings; // of the current geometry
  std::size_t m_polygons = 0;        // of the current geometry
  std::vector<Curve> m_curves;
  Unused_content m_unused;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_CURVES_READ_WKT_H
