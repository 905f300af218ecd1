// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "inputs.h"

#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace dsc_benchmark {

void append_sphere(Surface& surface, const Kernel::Vector_3& centre, std::size_t n) {
  std::vector<Kernel::Vector_3> corners; // sides of length 2
  const double golden_ratio = (1 + std::sqrt(5.)) / 2;
  for (double a : {-1., 1.})
    for (double b : {-golden_ratio, golden_ratio}) {
      corners.emplace_back(0, a, b);
      corners.emplace_back(a, b, 0);
      corners.emplace_back(b, 0, a);
    }
  const auto are_adjacent = [&](std::size_t i, std::size_t j) {
    return (corners[i] - corners[j]).squared_length() < 5;
  };
  const auto cut_face = [&](const std::array<Kernel::Vector_3, 3>& face) {
    const auto add_triangle = [&](std::array<std::array<std::size_t, 2>, 3> places) {
      const std::size_t first = surface.points.size();
      for (const auto& [i, j] : places) {
        const Kernel::Vector_3 p =
            double(i) * face[0] + double(j) * face[1] + double(n - i - j) * face[2];
        surface.points.push_back(CGAL::ORIGIN + (centre + p / std::sqrt(p.squared_length())));
      }
      surface.triangles.push_back({first, first + 1, first + 2});
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; i + j < n; ++j) {
        add_triangle({{{i, j}, {i + 1, j}, {i, j + 1}}});
        if (i + j + 2 <= n)
          add_triangle({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
  };
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j)
      for (std::size_t k = j + 1; k < corners.size(); ++k)
        if (are_adjacent(i, j) && are_adjacent(j, k) && are_adjacent(k, i))
          cut_face({corners[i], corners[j], corners[k]});
}

void append_revolved(Surface& surface, const std::vector<std::array<double, 2>>& polygon,
                     std::size_t n) {
  const auto point = [&](std::size_t i, std::size_t j) {
    const auto [x, r] = polygon[i];
    const double angle = 2 * CGAL_PI * double(j % n) / double(n);
    return Kernel::Point_3(x, r * std::cos(angle), r * std::sin(angle));
  };
  const auto add_triangle = [&](const Kernel::Point_3& a, const Kernel::Point_3& b,
                                const Kernel::Point_3& c) {
    if (a == b || b == c || c == a) // at the axis
      return;
    const std::size_t first = surface.points.size();
    surface.points.insert(surface.points.end(), {a, b, c});
    surface.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    for (std::size_t j = 0; j < n; ++j) {
      add_triangle(point(i, j), point(i + 1, j), point(i + 1, j + 1));
      add_triangle(point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
}

Surface sphere(double radius, std::size_t n) {
  Surface surface;
  append_sphere(surface, Kernel::Vector_3(0, 0, 0), n);
  for (auto& p : surface.points)
    p = CGAL::ORIGIN + radius * (p - CGAL::ORIGIN);
  return surface;
}

Surface torus(double tube_radius, std::size_t n) {
  std::vector<std::array<double, 2>> circle;
  for (std::size_t i = 0; i < 3 * n; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(3 * n);
    circle.push_back({tube_radius * std::sin(angle), 1 - tube_radius * std::cos(angle)});
  }
  circle.push_back(circle.front());
  Surface surface;
  append_revolved(surface, circle, 5 * n);
  return surface;
}

Surface dumbbell(std::size_t n) {
  static constexpr double ball_radius = .5, degree = CGAL_PI / 180;
  const double bar_end = 1 - ball_radius * std::cos(30 * degree); // the bar begins at 150 degrees
  std::vector<std::array<double, 2>> profile;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double angle = 150 * degree * double(i) / double(2 * n);
    profile.push_back({-1 - ball_radius * std::cos(angle), ball_radius * std::sin(angle)});
  }
  for (std::size_t i = 0; i <= n; ++i)
    profile.push_back({-bar_end * double(n - i) / double(n), dumbbell_bar_radius});
  for (std::size_t i = profile.size() - 1; i-- > 0;)
    profile.push_back({-profile[i][0], profile[i][1]});
  Surface surface;
  append_revolved(surface, profile, 2 * n);
  return surface;
}

void append(Surface& surface, const Surface& other) {
  const std::size_t first = surface.points.size();
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles)
    surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

namespace {

// Two adjacent unit spheres at a distance of half a radius, with 3240 triangles in total.
Surface two_spheres() {
  Surface surface;
  for (double x : {-1.25, 1.25})
    append_sphere(surface, Kernel::Vector_3(x, 0, 0), 9);
  return surface;
}

// Collapses edges until at most `triangles` triangles are left.
Surface decimated(Surface surface, std::size_t triangles) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  namespace SMS = CGAL::Surface_mesh_simplification;
  using CGAL::Deformable_simplicial_complexes::Edge_count_stop_predicate;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Policies = SMS::GarlandHeckbert_plane_policies<Mesh, Kernel>;
  using Placement = SMS::Bounded_normal_change_placement<Policies::Get_placement>;

  Mesh mesh;
  if (!PMP::orient_polygon_soup(surface.points, surface.triangles))
    throw std::runtime_error("the surface to be decimated is not manifold");
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.triangles, mesh);
  const Policies policies(mesh);
  SMS::edge_collapse(mesh, Edge_count_stop_predicate<Mesh>(3 * triangles / 2 + 1),
                     CGAL::parameters::get_cost(policies.get_cost())
                         .get_placement(Placement(policies.get_placement())));
  mesh.collect_garbage();
  if (PMP::does_self_intersect(mesh))
    throw std::runtime_error("the decimated surface intersects itself");

  surface.points.clear();
  surface.triangles.clear();
  PMP::polygon_mesh_to_polygon_soup(mesh, surface.points, surface.triangles);
  return surface;
}

} // namespace

Surface read_input(const std::string& input, std::size_t triangles) {
  if (input == "sphere")
    return sphere(
        1, (std::max)(std::size_t(1), std::size_t(std::lround(std::sqrt(double(triangles) / 20)))));
  Surface surface = input == "two_spheres" ? two_spheres()
                                           : CGAL::IO::read_labeled_surface<Kernel::Point_3>(input);
  const bool is_too_fine = triangles > 0 && surface.triangles.size() > triangles;
  return is_too_fine ? decimated(std::move(surface), triangles) : surface;
}

} // namespace dsc_benchmark
