// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves more than two phases: rotates four phases that meet at a point by 360 degrees, grows a
// double bubble, or relaxes a double bubble. Prints a row of a table. Fails if the phases are
// wrong.

#include "counts.h"
#include "inputs.h"
#include "measures.h"
#include "small_meshes.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

using Labels = std::set<int>;
using Triangle = std::array<std::size_t, 3>;

// Sectors of a ball in label 0: the upper half, and three sectors of the lower half. Any two
// sectors share a plane; the planes consist of facets of a grid.
int four_sectors(const small_meshes::Point& p) {
  static constexpr double radius = .5;
  if ((p - CGAL::ORIGIN).squared_length() > radius * radius)
    return 0;
  if (p.z() > 0)
    return 4;
  if (p.x() > 0 && p.y() > 0)
    return 1;
  return p.x() < p.y() ? 2 : 3;
}

// Data that a rotation by 360 degrees must restore. Vertices are identified by their time stamps.
struct Phases
{
  std::map<std::size_t, Point> vertices;                       // of the interface
  std::map<Triangle, Labels> facets;                           // of the interface
  std::map<std::pair<std::size_t, std::size_t>, Labels> lines; // edges of at least three labels
  std::map<std::size_t, Labels> points;                        // vertices of at least four labels
  std::map<int, double> volumes;

  explicit Phases(const Complex& complex) {
    for (const Complex::Vertex_handle v : complex.interface_vertices())
      vertices.emplace(v->time_stamp(), complex.position(v));
    for (const Complex::Facet& f : complex.interface_facets()) {
      const Triangle t = time_stamps(complex, f);
      const Labels labels = {f.first->subdomain_index(),
                             f.first->neighbor(f.second)->subdomain_index()};
      facets.emplace(t, labels);
      for (std::size_t i = 0; i < 3; ++i) {
        lines[std::minmax(t[i], t[(i + 1) % 3])].insert(labels.begin(), labels.end());
        points[t[i]].insert(labels.begin(), labels.end());
      }
    }
    keep_those_of(3, lines);
    keep_those_of(4, points);
    for (const int label : complex.labels())
      volumes.emplace(label, complex.volume(label));
  }

  // Returns the largest distance of corresponding vertices, or infinity if one is missing.
  double distance(const Phases& other) const {
    double result = vertices.size() == other.vertices.size() ? 0 : HUGE_VAL;
    for (const auto& [time_stamp, position] : vertices) {
      const auto it = other.vertices.find(time_stamp);
      result = (std::max)(result, it == other.vertices.end()
                                      ? HUGE_VAL
                                      : std::sqrt((position - it->second).squared_length()));
    }
    return result;
  }

  // Returns the largest relative change of a volume.
  double change_of_volume(const Phases& other) const {
    double result = volumes.size() == other.volumes.size() ? 0 : HUGE_VAL;
    for (const auto& [label, volume] : volumes) {
      const auto it = other.volumes.find(label);
      result = (std::max)(result,
                          it == other.volumes.end() ? HUGE_VAL : std::abs(volume / it->second - 1));
    }
    return result;
  }

private:
  template <class Map> static void keep_those_of(std::size_t number_of_labels, Map& map) {
    for (auto it = map.begin(); it != map.end();)
      it = it->second.size() < number_of_labels ? map.erase(it) : std::next(it);
  }
};

// The point where the phases meet rotates, too, because it does not lie on the axis.
int measure_quadruple_point(std::size_t n) {
  static constexpr int number_of_steps = 180;
  static constexpr double tolerance = 1e-9;
  const auto mesh = small_meshes::grid(2 * n, four_sectors);
  Complex complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(mesh.points, mesh.tetrahedra, mesh.labels);
  const CGAL::Bbox_3 box = bounding_box(complex);
  const Phases before(complex);
  const auto is_quadruple = [](const auto& point) {
    static const Labels sectors = {1, 2, 3, 4};
    return std::includes(point.second.begin(), point.second.end(), sectors.begin(), sectors.end());
  };
  const auto quadruple_points =
      std::count_if(before.points.begin(), before.points.end(), is_quadruple);
  const DSC::Rigid_rotation_3 rotation({.1, .1, .1}, {1, 2, 3}, 360. / number_of_steps * degree);
  std::size_t incomplete = 0;
  const double begin = processor_seconds();
  for (int step = 0; step < number_of_steps; ++step)
    incomplete += DSC::advect_interface(complex, rotation, step, 1.).complete ? 0 : 1;
  const double seconds = processor_seconds() - begin;

  const Phases after(complex);
  const double distance = after.distance(before) / (box.xmax() - box.xmin());
  const double change_of_volume = after.change_of_volume(before);
  const bool same_labels = after.facets == before.facets;
  const bool same_lines = after.lines == before.lines && after.points == before.points;
  const bool is_right = check(complex) && quadruple_points == 1 && same_labels && same_lines &&
                        distance < tolerance && change_of_volume < tolerance;
  std::cout.precision(4);
  std::cout << "| " << before.facets.size() << " | " << complex.number_of_cells() << " | "
            << before.lines.size() << " | " << quadruple_points << " | " << incomplete << " | "
            << (same_labels ? "same" : "**others**") << " | "
            << (same_lines ? "same" : "**others**") << " | " << distance << " | "
            << change_of_volume << " | " << (is_right ? "yes" : "**no**") << " | " << seconds
            << " |" << std::endl;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Two spheres of radius 0.5 cut by the plane x = 0, which meet at 120 degrees like soap films, the
// wall between them, and a large surrounding sphere.
Surface double_bubble(std::size_t n) {
  static constexpr double radius = .5;
  const double rim = radius * std::sin(120 * degree);
  const std::size_t pieces_of_cap = 3 * n / 2, pieces_of_wall = n / 2;
  std::vector<std::array<double, 2>> cap, other_cap, wall;
  for (std::size_t i = 0; i < pieces_of_cap; ++i) {
    const double angle = 120 * degree * double(i) / double(pieces_of_cap);
    cap.push_back({-radius / 2 - radius * std::cos(angle), radius * std::sin(angle)});
  }
  cap.push_back({0, rim});
  for (const auto& [x, r] : cap)
    other_cap.push_back({-x, r});
  for (std::size_t i = 0; i <= pieces_of_wall; ++i)
    wall.push_back({0, rim * double(i) / double(pieces_of_wall)});
  Surface surface = sphere(2, 4);
  for (const auto& polygon : {cap, other_cap, wall})
    append_revolved(surface, polygon, 3 * n);
  CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(surface.points,
                                                                        surface.triangles);
  return surface;
}

// The triangles divide the tetrahedra into three regions. The regions that contain the centers of
// the bubbles get the labels 1 and 2, the remaining region gets label 0.
std::vector<int> labels_of_bubbles(const DSC::Tetrahedralization_3& mesh,
                                   const std::vector<Triangle>& triangles) {
  std::set<Triangle> walls;
  for (Triangle t : triangles) {
    std::sort(t.begin(), t.end());
    walls.insert(t);
  }
  betti_numbers::Joined_sets regions;
  std::map<Triangle, std::size_t> sides;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    auto v = mesh.tetrahedra[t];
    std::sort(v.begin(), v.end());
    for (const Triangle& facet : {Triangle{v[1], v[2], v[3]}, Triangle{v[0], v[2], v[3]},
                                  Triangle{v[0], v[1], v[3]}, Triangle{v[0], v[1], v[2]}})
      if (walls.count(facet) == 0)
        regions.join(t, sides.emplace(facet, t).first->second);
  }
  const auto region_at = [&](double x) {
    const auto distance = [&](const std::array<std::size_t, 4>& tetrahedron) {
      Vector sum(0, 0, 0);
      for (const std::size_t i : tetrahedron)
        sum = sum + Vector(mesh.points[i][0] - x, mesh.points[i][1], mesh.points[i][2]);
      return sum.squared_length();
    };
    const auto nearest =
        std::min_element(mesh.tetrahedra.begin(), mesh.tetrahedra.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    return regions.find(std::size_t(nearest - mesh.tetrahedra.begin()));
  };
  const std::size_t left = region_at(-.25), right = region_at(.25);
  std::vector<int> labels;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    labels.push_back(regions.find(t) == left ? 1 : regions.find(t) == right ? 2 : 0);
  return labels;
}

// Stretches along the axis by a factor.
Complex make_double_bubble(std::size_t n, double stretch = 1) {
  const Surface surface = double_bubble(n);
  std::vector<std::array<double, 3>> coordinates;
  for (const auto& p : surface.points)
    coordinates.push_back({stretch * p.x(), p.y(), p.z()});
  const DSC::Tetrahedralization_3 mesh =
      CGAL::Tetgen_tetrahedralizer_3()(coordinates, surface.triangles);
  std::vector<Complex::Point_3> points;
  for (const auto& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  return DSC::make_deformable_simplicial_complex_3<Complex>(
      points, mesh.tetrahedra, labels_of_bubbles(mesh, surface.triangles));
}

// On the triple line, the mean normal of both bubbles points outwards within the plane of the wall,
// so the wall grows. The inner vertices of the wall stay.
int measure_double_bubble(std::size_t n) {
  static constexpr int number_of_steps = 10;
  Complex complex = make_double_bubble(n);
  const std::size_t triangles = complex.interface_facets().size();
  const double step = complex.mean_interface_edge() / 4;
  const double area = complex.area(1, 2), volume = complex.volume(1);
  double smallest_area = area;
  bool is_right = area > 0;
  std::size_t incomplete = 0, unfinished = 0, events = 0;
  const double begin = processor_seconds();
  for (int i = 0; i < number_of_steps; ++i) {
    const auto report = DSC::advect_interface(complex, DSC::Normal_offset{1}, i * step, step);
    incomplete += report.complete ? 0 : 1;
    unfinished += report.unfinished.size();
    events += report.events.size();
    smallest_area = (std::min)(smallest_area, complex.area(1, 2));
    is_right = is_right && smallest_area > 0 && events == 0 && check(complex) &&
               complex.labels() == std::vector<int>{0, 1, 2};
    for (const int label : {0, 1, 2})
      is_right = is_right && components(complex, label) == 1;
  }
  const double seconds = processor_seconds() - begin;
  std::cout.precision(4);
  std::cout << "| " << triangles << " | " << complex.number_of_cells() << " | " << incomplete
            << " | " << unfinished << " | " << area << " → " << complex.area(1, 2) << " | "
            << smallest_area << " | " << volume << " → " << complex.volume(1) << " | "
            << components(complex, 0) << ", " << components(complex, 1) << ", "
            << components(complex, 2) << " | " << events << " | " << (is_right ? "yes" : "**no**")
            << " | " << seconds << " |" << std::endl;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Returns the angles of the labels 0, 1 and 2 along the triple line: means weighted by length, and
// the angle with the largest deviation from 120 degrees. Each angle is between the two facets of an
// edge that bound the label.
struct Triple_angles
{
  std::array<double, 3> means = {};
  double worst = 120;

  explicit Triple_angles(const Complex& complex) {
    using Edge = std::pair<Complex::Vertex_handle, Complex::Vertex_handle>;
    const auto less = [](const Edge& a, const Edge& b) {
      return std::make_pair(a.first->time_stamp(), a.second->time_stamp()) <
             std::make_pair(b.first->time_stamp(), b.second->time_stamp());
    };
    struct Facet
    {
      int label, other_label;
      Vector across; // away from the edge and perpendicular to it
    };
    std::map<Edge, std::vector<Facet>, decltype(less)> edges(less);
    for (const auto& facet : complex.interface_facets()) {
      const auto v = complex.facet_vertices(facet);
      for (int i = 0; i < 3; ++i) {
        Edge edge = {v[(i + 1) % 3], v[(i + 2) % 3]};
        if (edge.second->time_stamp() < edge.first->time_stamp())
          std::swap(edge.first, edge.second);
        const Point p = complex.position(edge.first);
        const Vector along = complex.position(edge.second) - p, d = complex.position(v[i]) - p;
        edges[edge].push_back({facet.first->subdomain_index(),
                               facet.first->neighbor(facet.second)->subdomain_index(),
                               d - (d * along / along.squared_length()) * along});
      }
    }
    double sum_of_lengths = 0;
    for (const auto& [edge, facets] : edges) {
      if (facets.size() != 3)
        continue;
      const double length = std::sqrt(
          (complex.position(edge.second) - complex.position(edge.first)).squared_length());
      sum_of_lengths += length;
      for (int label = 0; label < 3; ++label) {
        std::vector<Vector> bounds;
        for (const Facet& f : facets)
          if (f.label == label || f.other_label == label)
            bounds.push_back(f.across);
        const double angle =
            std::acos(bounds[0] * bounds[1] /
                      std::sqrt(bounds[0].squared_length() * bounds[1].squared_length())) /
            degree;
        means[label] += length * angle;
        if (std::abs(angle - 120) > std::abs(worst - 120))
          worst = angle;
      }
    }
    for (double& mean : means)
      mean /= sum_of_lengths;
  }
};

// Mean curvature flow with constant volumes transforms a stretched double bubble into the double
// bubble of least area: three spherical caps that meet at 120 degrees. Here two caps have the same
// radius and the third is planar.
int measure_relaxed_bubble(std::size_t n) {
  static constexpr int number_of_steps = 60;
  Complex complex = make_double_bubble(n, 1.3);
  const std::size_t triangles = complex.interface_facets().size();
  const double volume = complex.volume(1) + complex.volume(2);
  const double radius = std::cbrt(4 * volume / (9 * CGAL_PI));
  const double least_area = 27. / 4 * CGAL_PI * radius * radius;
  const auto area = [&] { return complex.area(0, 1) + complex.area(0, 2) + complex.area(1, 2); };
  const double dt = radius * radius / 100, area_at_start = area();
  std::size_t incomplete = 0;
  const double begin = processor_seconds();
  for (int step = 0; step < number_of_steps; ++step) {
    DSC::improve_interface(complex);
    DSC::control_detail(complex, parameters::collapse_length(2.));
    incomplete +=
        DSC::advect_interface(complex, DSC::Mean_curvature_flow(true), step * dt, dt).complete ? 0
                                                                                               : 1;
  }
  const double seconds = processor_seconds() - begin;
  const Triple_angles angles(complex);
  const double change_of_volume = (complex.volume(1) + complex.volume(2)) / volume - 1;
  const bool is_right = check(complex) && complex.labels() == std::vector<int>{0, 1, 2} &&
                        std::abs(area() / least_area - 1) < .01;
  std::cout.precision(4);
  std::cout << "| " << triangles << " | " << complex.interface_facets().size() << " | "
            << incomplete << " | " << 100 * (area_at_start / least_area - 1) << " → "
            << 100 * (area() / least_area - 1) << " | " << angles.means[0] << ", "
            << angles.means[1] << ", " << angles.means[2] << " | " << angles.worst << " | "
            << 100 * change_of_volume << " | " << (is_right ? "yes" : "**no**") << " | " << seconds
            << " |" << std::endl;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Turns four phases that meet in a point, or grows or relaxes a double bubble.");
  std::string name;
  std::size_t n = 10;
  app.add_option("scenario", name)
      ->required()
      ->check(CLI::IsMember({"quadruple_point", "double_bubble", "relaxed_bubble"}));
  app.add_option("-n", n, "resolution: a grid of (2n)^3 cubes, or 3n edges around the bubbles")
      ->check(CLI::Range(4, 100));
  CLI11_PARSE(app, argc, argv);
  try {
    return name == "quadruple_point" ? dsc_benchmark::measure_quadruple_point(n)
           : name == "double_bubble" ? dsc_benchmark::measure_double_bubble(n)
                                     : dsc_benchmark::measure_relaxed_bubble(n);
  } catch (const std::exception& error) {
    std::cerr << "phases: " << name << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
