// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface.h"
#include "output/statistics.h"

#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

namespace dsc {
namespace {

using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;

double norm(const Vector& v) { return std::sqrt(v.squared_length()); }

} // namespace

Surface_statistics surface_statistics(const std::string& path) {
  DSC::Surface_parts parts;
  const Surface surface = read_surface(path, &parts);
  Surface_statistics result = {};
  for (const std::string& name : parts.names)
    result.parts.emplace_back(name, 0);
  for (const std::size_t part : parts.of_triangles)
    ++result.parts[part].second;
  result.triangles = surface.triangles.size();
  result.min_angle = 180;

  DSC::Disjoint_sets connected(surface.points.size());
  std::vector<bool> used(surface.points.size());
  std::vector<std::array<std::size_t, 2>> edges;
  // A point of the surface as origin avoids cancellation far from the coordinate origin.
  const Surface_point& origin = surface.points[surface.triangles[0][0]];
  for (const std::array<std::size_t, 3>& triangle : surface.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = triangle[i], b = triangle[(i + 1) % 3], c = triangle[(i + 2) % 3];
      used[a] = true;
      connected.join(a, b);
      edges.push_back({(std::min)(a, b), (std::max)(a, b)});
      const Vector u = surface.points[b] - surface.points[a],
                   v = surface.points[c] - surface.points[a];
      const double angle = std::atan2(norm(CGAL::cross_product(u, v)), u * v) * (180 / CGAL_PI);
      result.min_angle = (std::min)(result.min_angle, angle);
      result.max_angle = (std::max)(result.max_angle, angle);
    }
    const Vector p = surface.points[triangle[0]] - origin, q = surface.points[triangle[1]] - origin,
                 r = surface.points[triangle[2]] - origin;
    result.area += norm(CGAL::cross_product(q - p, r - p)) / 2;
    result.volume += p * CGAL::cross_product(q, r) / 6;
  }

  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) {
      ++result.vertices;
      result.components += connected.find(v) == v;
    }

  std::sort(edges.begin(), edges.end());
  long different_edges = 0;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    result.boundary_edges += next - edge == 1;
    ++different_edges;
    edge = next;
  }
  result.euler_characteristic =
      static_cast<long>(result.vertices) - different_edges + static_cast<long>(result.triangles);
  return result;
}

} // namespace dsc
