// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_SURFACES_SURFACE_SINKS_H
#define CGAL_MESH_FILES_INTERNAL_SURFACES_SURFACE_SINKS_H

#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/internal/surfaces/read_polygons.h>
#include <CGAL/Mesh_files/internal/surfaces/triangulated_polygon.h>
#include <CGAL/Mesh_files/internal/text/File_scanner.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The names that statements of one kind give to the polygons after them. Statements with the same
// name belong to the same part.
class Part_names
{
public:
  void begin(const std::string& name) {
    const std::size_t first = (std::min)(name.find_first_not_of(' '), name.size());
    m_name = name.substr(first, name.find_last_not_of(' ') + 1 - first);
    m_is_new = true;
    ++m_number_of_statements;
  }

  // Returns the index of the part of the next polygon.
  std::size_t of_polygon() {
    if (m_is_new)
      m_part = m_index.emplace(m_name, m_index.size()).first->second;
    m_is_new = false;
    return m_part;
  }

  std::size_t number_of_statements() const { return m_number_of_statements; }

  // Returns the number of parts with polygons.
  std::size_t size() const { return m_index.size(); }

  // Returns the names of the parts with polygons, in the order of the file.
  std::vector<std::string> names() const {
    std::vector<std::string> result(m_index.size());
    for (const auto& [name, part] : m_index)
      result[part] = name;
    return result;
  }

private:
  std::map<std::string, std::size_t> m_index;
  std::string m_name; // of the next polygon; polygons before the first statement have no name
  bool m_is_new = true;
  std::size_t m_part = 0, m_number_of_statements = 0;
};

// Names of both kinds.
struct Parts_of_kinds
{
  Part_names objects, groups;

  Part_names& of(Part_kind kind) { return kind == Part_kind::object ? objects : groups; }

  // Returns the kind that divides the polygons. Objects may consist of groups.
  Part_kind dividing() const {
    const bool by_groups = objects.number_of_statements() == 0 || groups.size() > 1;
    return objects.size() < 2 && by_groups ? Part_kind::group : Part_kind::object;
  }
};

// Receiver of the contents of a file that stores the points, counts polygons and their triangles,
// and records unused content.
template <class Point> struct Point_sink
{
  const File_scanner& file;
  std::size_t most_points; // upper bound by the size of the file
  Unused_content* not_used;
  std::vector<Point> points;
  std::size_t number_of_polygons = 0, number_of_triangles = 0, number_of_normals = 0;
  Parts_of_kinds parts = {};

  void expect_points(std::size_t n) {
    if (points.empty())
      points.reserve((std::min)(n, most_points));
  }

  void point(double x, double y, double z) {
    Progress_scope::check();
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      file.fail("a coordinate of point " + std::to_string(points.size()) +
                " is not a finite number; correct it");
    points.emplace_back(x, y, z);
  }

  void normal(double, double, double) { ++number_of_normals; }

  void part(Part_kind kind, const std::string& name) { parts.of(kind).begin(name); }

  void polygon(const std::vector<std::size_t>& corners) {
    if (corners.size() < 3)
      return unused("polygons with fewer than three corners", 1);
    ++number_of_polygons;
    number_of_triangles += corners.size() - 2;
    parts.objects.of_polygon();
    parts.groups.of_polygon();
  }

  void unused(const std::string& kind, std::size_t number) {
    if (not_used)
      not_used->add(kind, number);
  }
};

// Receiver of the contents of a file that stores the triangles of the polygons. The points are
// known.
template <class Point> struct Triangle_sink
{
  const File_scanner& file;
  Labeled_surface_3<Point>& surface;
  Part_kind kind; // of the parts
  std::vector<Point> points_of_polygon;
  std::size_t number_of_polygons = 0;
  Part_names parts = {};
  std::vector<std::size_t> part_of_triangle = {};

  void expect_points(std::size_t) {}
  void point(double, double, double) {}
  void normal(double, double, double) {}
  void unused(const std::string&, std::size_t) {}

  void part(Part_kind of, const std::string& name) {
    if (of == kind)
      parts.begin(name);
  }

  void polygon(const std::vector<std::size_t>& corners) {
    Progress_scope::check();
    points_of_polygon.clear();
    for (const std::size_t corner : corners) {
      if (corner >= surface.points.size())
        fail("refers to a point that does not exist; correct the index");
      points_of_polygon.push_back(surface.points[corner]);
    }
    const auto triangles = triangulated_polygon(points_of_polygon);
    if (triangles.empty() && corners.size() >= 3)
      fail("cannot be triangulated; replace it by triangles");
    for (const auto& triangle : triangles)
      surface.triangles.push_back(
          {corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    if (!triangles.empty())
      part_of_triangle.resize(surface.triangles.size(), parts.of_polygon());
    ++number_of_polygons;
  }

  [[noreturn]] void fail(const std::string& what) const {
    file.fail("polygon " + std::to_string(number_of_polygons) + " " + what);
  }
};

// Adds the names that do not divide the surface into parts to the unused content.
template <class Point>
void report_unused_names(Point_sink<Point>& sink, bool has_parts, Surface_format format) {
  const bool by_groups = sink.parts.dividing() == Part_kind::group;
  const Part_names &objects = sink.parts.objects, &groups = sink.parts.groups;
  const bool is_stl = format == Surface_format::stl;
  if (!has_parts || !by_groups)
    sink.unused("groups", groups.number_of_statements());
  if ((!has_parts || by_groups) && !(is_stl && objects.size() < 2))
    sink.unused(is_stl ? "names of solids" : "objects", objects.number_of_statements());
}

// Returns the number of points that are not corners of any triangle.
template <class Point>
std::size_t number_of_unused_points(const Labeled_surface_3<Point>& surface) {
  std::vector<bool> is_used(surface.points.size());
  for (const auto& triangle : surface.triangles)
    for (const std::size_t corner : triangle)
      is_used[corner] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_SURFACES_SURFACE_SINKS_H
