// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_options_3.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_report_3.h>
#include <CGAL/Triangle_soup_repair/internal/checks/check_surfaces_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/clean_soup_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/distance_of_samples_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/split_at_t_junctions_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/unite_components_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/iterator.h>

#include <cstdio>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A visitor that makes a wrap interruptible.
struct Stopping_wrap_visitor : Alpha_wraps_3::internal::Wrapping_default_visitor
{
  template <class Wrap, class Gate> void before_facet_treatment(const Wrap&, const Gate&) {
    Progress_scope::check();
  }
};

// A visitor that makes hole filling interruptible.
struct Stopping_hole_visitor : Polygon_mesh_processing::Hole_filling::Default_visitor
{
  void quadratic_step() const { Progress_scope::check(); }
  void cubic_step() const { Progress_scope::check(); }
};

// Makes a soup bound a solid, by repair steps of increasing strength. Ends as soon as the soup
// bounds a solid.
class Surface_repairer_3
{
public:
  Surface_repairer_3(Triangle_soup_3 input, const Surface_repair_options_3& options)
      : m_options(options), m_input(std::move(input)), m_soup(m_input) {
    options.check();
  }

  // Repairs the soup. Throws Invalid_surface_error if no step succeeds.
  void run() {
    check_numbers(m_soup, 0);
    if (m_options.merge_distance == 0 && !flaw())
      return;
    prepare();
    merge_near_vertices();
    if (!flaw()) {
      measure();
      return;
    }
    using Step = void (Surface_repairer_3::*)();
    for (Step step :
         {&Surface_repairer_3::clean, &Surface_repairer_3::stitch,
          &Surface_repairer_3::split_at_t_junctions, &Surface_repairer_3::remove_fins,
          &Surface_repairer_3::fill_holes, &Surface_repairer_3::unite, &Surface_repairer_3::wrap}) {
      attempt(step);
      if (!flaw()) {
        measure();
        return;
      }
    }
    throw *flaw();
  }

  // Replaces the soup by its wrap, even if it bounds a solid. Throws Invalid_surface_error if there
  // is no wrap.
  void run_wrap() {
    check_numbers(m_soup, 0);
    prepare();
    attempt(&Surface_repairer_3::wrap);
    if (const auto error = flaw())
      throw *error;
    if (!m_report.is_wrapped)
      throw Error("the surface cannot be wrapped: remove its finest details");
    measure();
  }

  const Triangle_soup_3& soup() const { return m_soup; }
  const Surface_repair_report_3& report() const { return m_report; }

private:
  using Point = Predicates_kernel::Point_3;
  using Mesh = Surface_mesh<Point>;
  using Halfedge = Mesh::Halfedge_index;

  static constexpr double farthest = 2; // in mean edges: removed triangles are not farther away

  // Runs a step. Undoes the step if CGAL throws an error or no triangle is left.
  void attempt(void (Surface_repairer_3::*step)()) {
    const Triangle_soup_3 soup = m_soup;
    const Surface_repair_report_3 report = m_report;
    try {
      (this->*step)();
      if (!m_soup.triangles.empty())
        return;
    } catch (const Failure_exception&) {
    }
    m_soup = soup;
    m_report = report;
  }

  // Computes the mean edge length. Throws if squares or reciprocals of lengths would overflow or
  // underflow.
  void prepare() {
    static constexpr double least = 1e-30, largest = 1e30; // in mean edges
    m_report.mean_edge = mean_side(m_soup);
    if (m_report.mean_edge == 0)
      throw *flaw();
    if (!(m_report.mean_edge >= least && diagonal(m_soup) <= largest))
      throw Error("the surface is too small or too large to be repaired: scale it to edges of more "
                  "than 1e-30 and an extent of less than 1e30");
  }

  // Returns the error that describes why the soup does not bound a solid; `nullopt` if it does.
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

  void merge_near_vertices() {
    if (m_options.merge_distance == 0)
      return;
    m_soup = merge_points(m_soup);
    m_report.merged_points = merge_near_points(
        m_soup, m_options.merge_distance * m_report.mean_edge, Merged_points::ALL);
    if (m_report.merged_points > 0)
      merge_equal_points();
  }

  void clean() {
    const std::size_t before = m_soup.points.size();
    merge_equal_points();
    m_report.merged_points += before - m_soup.points.size();
    remove_flat_triangles();
  }

  // Removes degenerate triangles. Their neighbors are joined along the common line.
  void remove_flat_triangles() {
    const auto number = std::size_t(std::count_if(
        m_soup.triangles.begin(), m_soup.triangles.end(),
        [this](const Triangle_indices& t) { return exact_triangle(m_soup, t).is_degenerate(); }));
    if (number == 0)
      return;
    Mesh mesh = oriented_mesh();
    Polygon_mesh_processing::remove_degenerate_faces(mesh);
    take(mesh);
    m_report.degenerate_triangles += number;
  }

  // Stitches open edges whose ends differ by rounding of the coordinates only: up to a thousandth
  // of the mean edge length.
  void stitch() {
    static constexpr double distance = 1e-3; // in mean edges
    m_report.stitched_points =
        merge_near_points(m_soup, distance * m_report.mean_edge, Merged_points::OF_OPEN_EDGES);
    if (m_report.stitched_points > 0)
      merge_equal_points();
  }

  // Splits open edges at vertices that lie on them, and thus closes T-junctions.
  void split_at_t_junctions() {
    m_report.split_edges = T_junction_splitter_3(m_soup).run();
    if (m_report.split_edges > 0)
      merge_equal_points();
  }

  // Removes all fins or none. They are removed if the remaining surface is closed and near to them.
  void remove_fins() {
    const Triangle_soup_3 before = merge_points(m_soup);
    m_soup.points = before.points;
    m_soup.triangles = triangles_without_fins(before);
    const std::size_t removed = before.triangles.size() - m_soup.triangles.size();
    if (removed > 0 && !m_soup.triangles.empty() && open_edges().empty() &&
        distance_of_samples(before, m_soup, m_report.mean_edge) <= farthest * m_report.mean_edge)
      m_report.removed_triangles += removed;
    else
      m_soup = before;
  }

  void fill_holes() {
    const Progress_phase phase("filling holes of a surface");
    const std::set<std::array<Coordinates_3, 2>> open = open_edges();
    if (open.empty())
      return;
    Mesh mesh = oriented_mesh();
    std::vector<Halfedge> cycles, holes; // not holes where the mesh was cut
    Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
    for (Halfedge h : cycles) {
      const auto around = halfedges_around_face(h, mesh);
      if (std::any_of(around.begin(), around.end(), [&](Halfedge side) {
            return open.count(edge(coordinates(mesh.point(source(side, mesh))),
                                   coordinates(mesh.point(target(side, mesh))))) > 0;
          }))
        holes.push_back(h);
    }
    refuse_sheets(mesh, holes);
    for (Halfedge h : holes) {
      Progress_scope::check();
      if (!is_border(h, mesh))
        continue;
      const auto faces = mesh.number_of_faces();
      fill_hole(mesh, h);
      m_report.filled_holes += mesh.number_of_faces() > faces;
    }
    take(mesh);
  }

  static void fill_hole(Mesh& mesh, Halfedge h) {
    const auto np = CGAL::parameters::visitor(Stopping_hole_visitor());
#if CGAL_VERSION_NR >= 1060000000
    Polygon_mesh_processing::triangulate_hole(mesh, h, np);
#else
    Polygon_mesh_processing::triangulate_hole(mesh, h, Emptyset_iterator(), np);
#endif
  }

  // Throws if a hole has a boundary that is too long, absolutely or relative to the extent of its
  // component.
  void refuse_sheets(Mesh& mesh, const std::vector<Halfedge>& holes) const {
    const auto components = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
    std::vector<Bbox_3> boxes(Polygon_mesh_processing::connected_components(mesh, components));
    for (const auto f : mesh.faces())
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        boxes[components[f]] += mesh.point(v).bbox();
    for (Halfedge h : holes) {
      double length = 0;
      for (Halfedge side : halfedges_around_face(h, mesh))
        length += std::sqrt(
            squared_distance(mesh.point(source(side, mesh)), mesh.point(target(side, mesh))));
      const double extent = diagonal(boxes[components[mesh.face(mesh.opposite(h))]]);
      if (length > m_options.largest_hole * extent || length > m_options.longest_border)
        refuse_sheet(length, (std::min)(m_options.largest_hole * extent, m_options.longest_border));
    }
  }

  [[noreturn]] void refuse_sheet(double length, double longest) const {
    const Invalid_surface_error error = *flaw();
    throw Invalid_surface_error(
        error.reason(),
        "surface 0 does not bound a solid: it has a hole with a boundary of length " +
            text_of(length) + ", and only holes with boundaries of up to " + text_of(longest) +
            " are filled",
        0, error.facets(), error.vertices());
  }

  static std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
  }

  // Unites intersecting components. Triangles inside the union no longer count as input.
  void unite() {
    const Progress_phase phase("uniting components of a surface");
    Triangle_soup_3 soup = merge_points(m_soup);
    const std::size_t flat = remove_flat(soup);
    const std::optional<United_surface_3> united = unite_components(soup);
    if (!united || distance_of_samples(united->sheets, united->soup, m_report.mean_edge) >
                       farthest * m_report.mean_edge)
      return;
    measure();
    m_report.degenerate_triangles += flat;
    m_report.crossing_pairs = united->crossing_pairs;
    m_report.united_parts = united->crossing_components;
    m_report.removed_triangles += united->removed_triangles;
    m_input = m_soup = united->soup;
    append(m_input, united->sheets);
  }

  static std::size_t remove_flat(Triangle_soup_3& soup) {
    return remove_triangles_if(
        soup, [&](const Triangle_indices& t) { return exact_triangle(soup, t).is_degenerate(); });
  }

  void wrap() {
    if (m_options.wrap_alpha == 0)
      return;
    const Progress_phase phase("wrapping a surface");
    static constexpr double finest = 1e-3; // in diagonals; bounds the number of triangles
    m_report.alpha =
        (std::max)(m_options.wrap_alpha * m_report.mean_edge, finest * diagonal(m_soup));
    m_report.offset = m_options.wrap_offset * m_report.mean_edge;
    static constexpr double largest = 1e6; // in diagonals; CGAL fails for larger values
    if (!((std::max)(m_report.alpha, m_report.offset) <= largest * diagonal(m_soup)) ||
        !(m_report.offset > 0))
      throw Error("the alpha or the offset of the wrap is out of range: use about 1 and 0.1");
    std::vector<Point> points;
    for (const Coordinates_3& p : m_soup.points)
      points.push_back(exact_point(p));
    Mesh mesh;
    Stopping_wrap_visitor visitor;
    alpha_wrap_3(points, m_soup.triangles, m_report.alpha, m_report.offset, mesh,
                 CGAL::parameters::default_values(), CGAL::parameters::visitor(std::ref(visitor)));
    take(mesh);
    m_report.is_wrapped = true;
  }

  // Adds the distances between the input and the soup to the report. The distances before and after
  // the union of components are added up.
  void measure() {
    static constexpr double spacing = .5; // distance of samples, in mean edges
    const double s = spacing * m_report.mean_edge;
    m_report.distance_from_input += distance_of_samples(m_input, m_soup, s);
    m_report.distance_to_input += distance_of_samples(m_soup, m_input, s);
  }

  static std::array<Coordinates_3, 2> edge(const Coordinates_3& a, const Coordinates_3& b) {
    return a < b ? std::array<Coordinates_3, 2>{a, b} : std::array<Coordinates_3, 2>{b, a};
  }

  // Returns the edges with a single triangle.
  std::set<std::array<Coordinates_3, 2>> open_edges() const {
    std::set<std::array<Coordinates_3, 2>> result;
    for_each_edge(sorted_sides(m_soup.triangles), [&](auto side, std::size_t number) {
      if (number == 1)
        result.insert(edge(m_soup.points[side->vertices[0]], m_soup.points[side->vertices[1]]));
    });
    return result;
  }

  static double diagonal(const Bbox_3& box) {
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  }

  // Returns the diagonal of the bounding box of the points that belong to triangles.
  static double diagonal(const Triangle_soup_3& soup) {
    Bbox_3 box;
    for (const Triangle_indices& t : soup.triangles)
      for (std::size_t v : t)
        box += exact_point(soup.points[v]).bbox();
    return diagonal(box);
  }

  // Returns the soup as an oriented mesh. It is cut along edges whose number of triangles is not
  // two, and along edges where the orientations are incompatible.
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

  Surface_repair_options_3 m_options;
  Triangle_soup_3 m_input, m_soup;
  Surface_repair_report_3 m_report;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_SURFACE_REPAIRER_3_H
