// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H

#include <CGAL/Deformable_simplicial_complex_3/Surface_repair_report_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/check_surfaces_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/building/refuse_surface.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/repair/clean_soup_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/repair/distance_of_samples_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/soups/Triangle_soup_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parameters/repair_options.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Makes a soup bound a solid by steps that change more and more; ends as soon as it does.
class Surface_repairer_3
{
public:
  Surface_repairer_3(Triangle_soup_3 input, const Surface_repair_options& options)
      : m_options(options), m_input(std::move(input)), m_soup(m_input) {}

  // Throws Invalid_surface_error if nothing helps.
  void run() {
    check_numbers(m_soup, 0);
    m_report.mean_edge = mean_side(m_soup);
    if (!flaw())
      return;
    using Step = void (Surface_repairer_3::*)();
    for (Step step :
         {&Surface_repairer_3::clean, &Surface_repairer_3::stitch, &Surface_repairer_3::fill_holes,
          &Surface_repairer_3::separate, &Surface_repairer_3::wrap}) {
      (this->*step)();
      if (!flaw()) {
        measure();
        return;
      }
    }
    throw *flaw();
  }

  const Triangle_soup_3& soup() const { return m_soup; }
  const Surface_repair_report_3& report() const { return m_report; }

private:
  using Point = Predicates_kernel::Point_3;
  using Mesh = Surface_mesh<Point>;
  using Halfedge = Mesh::Halfedge_index;

  // What is wrong with the soup as it is.
  std::optional<Invalid_surface_error> flaw() const {
    try {
      check_surfaces({m_soup});
      return std::nullopt;
    } catch (const Invalid_surface_error& error) {
      return error;
    }
  }

  void merge_equal_points() {
    m_soup = merge_points(m_soup);
    m_report.degenerate_triangles += remove_collapsed_triangles(m_soup);
    m_report.repeated_triangles += remove_repeated_triangles(m_soup);
  }

  void clean() {
    const std::size_t before = m_soup.points.size();
    merge_equal_points();
    m_report.merged_points = before - m_soup.points.size();
    remove_flat_triangles();
  }

  // Triangles with three corners on a line: their neighbors are joined along it.
  void remove_flat_triangles() {
    const auto is_flat = [this](std::size_t t) {
      return exact_triangle(m_soup, t).is_degenerate();
    };
    std::size_t number = 0;
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      number += is_flat(t);
    if (number == 0)
      return;
    Mesh mesh = oriented_mesh();
    Polygon_mesh_processing::remove_degenerate_faces(mesh);
    take(mesh);
    m_report.degenerate_triangles += number;
  }

  // Borders that are a thousandth of an edge apart were one before coordinates were rounded.
  void stitch() {
    static constexpr double distance = 1e-3; // in mean edges
    m_report.stitched_points = merge_near_border_points(m_soup, distance * m_report.mean_edge);
    if (m_report.stitched_points > 0)
      merge_equal_points();
  }

  void fill_holes() {
    const std::vector<std::array<std::size_t, 2>> edges = open_edges();
    if (edges.empty())
      return;
    Mesh mesh = oriented_mesh();
    std::vector<Halfedge> holes;
    Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(holes));
    for (Halfedge h : holes) {
      const auto around = halfedges_around_face(h, mesh);
      double length = 0;
      for (Halfedge side : around)
        length += std::sqrt(
            squared_distance(mesh.point(source(side, mesh)), mesh.point(target(side, mesh))));
      if (length > m_options.largest_hole * diagonal())
        refuse_sheet(length / diagonal());
    }
    for (Halfedge h : holes) {
      if (!is_border(h, mesh))
        continue;
      std::vector<Mesh::Face_index> faces;
      Polygon_mesh_processing::triangulate_hole(mesh, h, std::back_inserter(faces));
      m_report.filled_holes += !faces.empty();
    }
    take(mesh);
  }

  [[noreturn]] void refuse_sheet(double diagonals) const {
    const Invalid_surface_error error = *flaw();
    throw Invalid_surface_error(
        error.reason(),
        "surface 0 bounds nothing: a border is " + std::to_string(diagonals) +
            " diagonals of the bounding box long, and is filled up to " +
            std::to_string(m_options.largest_hole) + ", see the parameter largest_hole",
        0, error.facets(), error.vertices());
  }

  // Triangles that cross are removed with their neighborhood, and the holes are filled.
  void separate() {
    m_report.crossing_pairs = crossings();
    if (m_report.crossing_pairs == 0)
      return;
    Mesh mesh = oriented_mesh();
    Polygon_mesh_processing::experimental::remove_self_intersections(
        mesh, CGAL::parameters::preserve_genus(false));
    Polygon_mesh_processing::remove_degenerate_faces(mesh);
    const Triangle_soup_3 before = m_soup;
    take(mesh);
    if (m_soup.triangles.empty())
      m_soup = before;
  }

  void wrap() {
    if (m_options.alpha == 0)
      return;
    m_report.alpha = m_options.alpha * m_report.mean_edge;
    m_report.offset = m_options.offset * m_report.mean_edge;
    std::vector<Point> points;
    for (const Coordinates_3& p : m_soup.points)
      points.push_back(exact_point(p));
    Mesh mesh;
    alpha_wrap_3(points, m_soup.triangles, m_report.alpha, m_report.offset, mesh);
    take(mesh);
    m_report.is_wrapped = true;
  }

  void measure() {
    static constexpr double spacing = .5; // of samples, in mean edges
    const double s = spacing * m_report.mean_edge;
    m_report.distance_from_input = distance_of_samples(m_input, m_soup, s);
    m_report.distance_to_input = distance_of_samples(m_soup, m_input, s);
  }

  std::size_t crossings() const {
    const Merged_soup_3 merged = merge_points(m_soup);
    try {
      check_areas(merged, 0);
    } catch (const Invalid_surface_error&) {
      return 0;
    }
    return crossing_triangles(merged).size();
  }

  std::vector<std::array<std::size_t, 2>> open_edges() const {
    std::vector<std::array<std::size_t, 2>> result;
    const auto sides = sorted_sides(m_soup.triangles);
    for (auto side = sides.begin(); side != sides.end();) {
      const auto end = end_of_edge(side, sides.end());
      if ((end - side) % 2 == 1)
        result.push_back(side->vertices);
      side = end;
    }
    return result;
  }

  double diagonal() const {
    Bbox_3 box;
    for (const Coordinates_3& p : m_input.points)
      box += exact_point(p).bbox();
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  }

  // Cut along edges with other than two triangles, and where triangles cannot be turned alike.
  Mesh oriented_mesh() const {
    std::vector<Point> points;
    for (const Coordinates_3& p : m_soup.points)
      points.push_back(exact_point(p));
    auto triangles = m_soup.triangles;
    Polygon_mesh_processing::orient_polygon_soup(points, triangles);
    Mesh mesh;
    Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    Polygon_mesh_processing::stitch_borders(mesh);
    return mesh;
  }

  void take(const Mesh& mesh) {
    std::vector<Point> points;
    std::vector<Triangle_indices> triangles;
    Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, points, triangles);
    m_soup.points.clear();
    for (const Point& p : points)
      m_soup.points.push_back(coordinates(p));
    m_soup.triangles = std::move(triangles);
    m_soup = merge_points(m_soup);
  }

  Surface_repair_options m_options;
  Triangle_soup_3 m_input, m_soup;
  Surface_repair_report_3 m_report;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H
