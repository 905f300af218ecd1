// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_FRONT_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_FRONT_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/spatial_sort.h>

#include <array>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The triangles of a sheet through points, by the advancing front of CGAL. It selects Delaunay
// facets within clusters of points, whose empty balls are small compared with the distances of
// their points. Larger balls are holes of the sheet.
class Sheet_front_3
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;

public:
  using Triangle = std::array<std::size_t, 3>; // sorted

  std::vector<Triangle> triangles;    // sorted
  std::vector<Triangle> other_facets; // Delaunay facets that are not selected, small balls first

  // \param unit the unit of length of the front; its constants are for points at distance 1
  // \param radii largest radii of the balls at the points
  // \param clusters the cluster of each point
  Sheet_front_3(const std::vector<Cloud_kernel::Point_3>& points, double unit,
                const std::vector<double>& radii, const std::vector<std::size_t>& clusters) {
    std::vector<double> bounds;
    for (double radius : radii)
      bounds.push_back(radius / unit * (radius / unit));
    Delaunay delaunay;
    triangulate(points, unit, radii, delaunay);
    const Priority priority{bounds, clusters};
    Front front(delaunay, priority);
    front.run();
    std::vector<std::pair<double, Triangle>> others;
    for (const auto& f : delaunay.finite_facets()) {
      const double squared_radius = priority(front, f.first, f.second);
      if (squared_radius == front.infinity())
        continue;
      if (front.has_on_surface(f) || front.has_on_surface(delaunay.mirror_facet(f)))
        triangles.push_back(triangle_of(f));
      else
        others.emplace_back(squared_radius, triangle_of(f));
    }
    std::sort(triangles.begin(), triangles.end());
    std::sort(others.begin(), others.end());
    for (const auto& [squared_radius, triangle] : others)
      other_facets.push_back(triangle);
  }

private:
  using Delaunay = Delaunay_triangulation_3<
      Kernel,
      Triangulation_data_structure_3<Advancing_front_surface_reconstruction_vertex_base_3<Kernel>,
                                     Advancing_front_surface_reconstruction_cell_base_3<Kernel>>>;

  static Triangle triangle_of(const Delaunay::Facet& f) {
    Triangle result;
    for (int k = 0; k < 3; ++k)
      result[std::size_t(k)] = f.first->vertex((f.second + 1 + k) & 3)->id();
    std::sort(result.begin(), result.end());
    return result;
  }

  // The squared radius of the smallest empty ball of a facet. It is infinite if it is too large, or
  // if the facet joins clusters.
  struct Priority
  {
    const std::vector<double>& bounds; // of squared radii
    const std::vector<std::size_t>& clusters;

    template <class Front>
    double operator()(const Front& front, const Delaunay::Cell_handle& c, int i) const {
      Progress_scope::check();
      const Triangle t = triangle_of({c, i});
      const double result = front.smallest_radius_delaunay_sphere(c, i);
      const bool is_within = clusters[t[0]] == clusters[t[1]] && clusters[t[0]] == clusters[t[2]];
      return is_within && result <= (std::max)({bounds[t[0]], bounds[t[1]], bounds[t[2]]})
                 ? result
                 : front.infinity();
    }
  };
  using Front = Advancing_front_surface_reconstruction<Delaunay, Priority>;

  // Triangulates the points after a small perturbation. Without it, the result of the front would
  // depend on addresses where balls are equally large, and it would find no facets in a plane.
  static void triangulate(const std::vector<Cloud_kernel::Point_3>& points, double unit,
                          const std::vector<double>& radii, Delaunay& delaunay) {
    using Vertex = std::pair<Kernel::Point_3, std::size_t>;
    static constexpr double small_change = 1e-4; // largest change, in radii
    std::vector<Vertex> vertices;                // with their indices
    Random random(0);
    for (std::size_t v = 0; v < points.size(); ++v) {
      double p[3];
      for (int k = 0; k < 3; ++k)
        p[k] =
            (points[v][k] - points[0][k] + small_change * radii[v] * random.uniform_real(-1., 1.)) /
            unit;
      vertices.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), v);
    }
    spatial_sort(vertices.begin(), vertices.end(),
                 Spatial_sort_traits_adapter_3<Kernel, First_of_pair_property_map<Vertex>>());
    Delaunay::Vertex_handle last;
    for (const auto& [point, index] : vertices) {
      Progress_scope::check();
      last = delaunay.insert(point, last);
      last->info() = index;
    }
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_FRONT_3_H
