// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_CHECKS_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_CHECKS_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Solid_reconstruction_3/Sheet_report_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Point_cloud_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/cloud_properties_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_facets_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_triangles_3.h>

#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Verifies a sheet by the points of a cloud, independently of its construction. The points of the
// sheet have the order of the cloud.
class Sheet_checks_3
{
public:
  using Point = Point_cloud_3::Point;

  Sheet_checks_3(const Point_cloud_3& cloud, const std::vector<Point>& points,
                 const Sheet_triangles_3& sheet, Sheet_report_3& report)
      : m_cloud(cloud), m_points(points), m_sheet(sheet), m_report(report),
        m_components(points.size()) {
    find_unfit_points();
    find_topology();
    find_false_boundaries();
    find_separated_points();
    for (std::size_t v = 0; v < points.size(); ++v) {
      Progress_scope::check();
      if (!sheet.is_manifold_at(v))
        doubt(v);
    }
    report.is_complete = report.unfit_points.empty() && report.doubtful_places.empty();
  }

private:
  void doubt(std::size_t v) {
    m_report.doubtful_places.emplace_back(m_points[v].x(), m_points[v].y(), m_points[v].z());
  }

  void find_unfit_points() {
    std::vector<Cloud_triangles_3::Triangle> all;
    for (const auto& t : m_sheet.all())
      all.emplace_back(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
    const Cloud_triangles_3 triangles(m_cloud, std::move(all));
    m_report.root_mean_square = triangles.residual(m_cloud);
    for (std::size_t i = 0; i < m_cloud.size(); ++i) {
      const double distance = std::sqrt((triangles.foot(i) - m_cloud.points()[i]).squared_length());
      m_report.maximum_distance = (std::max)(m_report.maximum_distance, distance);
      if (distance > m_report.largest_distance())
        m_report.unfit_points.push_back(m_cloud.index(i));
    }
    std::sort(m_report.unfit_points.begin(), m_report.unfit_points.end());
  }

  // Counts the simplices of the sheet.
  void find_topology() {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::size_t vertices = 0;
    m_report.is_orientable = true;
    for (const auto& t : m_sheet.all()) {
      Progress_scope::check();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = t[k], w = t[(k + 1) % 3];
        if (!edges.emplace(v, w).second)
          m_report.is_orientable = false;
        m_components.join(v, w);
      }
    }
    std::size_t number_of_edges = 0;
    for (const auto& [v, w] : edges)
      number_of_edges += v < w || edges.count({w, v}) == 0;
    for (std::size_t v = 0; v < m_points.size(); ++v)
      if (!m_sheet.star(v).empty()) {
        ++vertices;
        m_report.number_of_components += m_components.find(v) == v;
      }
    m_report.euler_characteristic =
        int(vertices) - int(number_of_edges) + int(m_sheet.all().size());
  }

  // Finds boundaries where the cloud has no boundary: missing triangles.
  void find_false_boundaries() {
    std::map<std::size_t, std::vector<std::size_t>> boundaries;
    Disjoint_sets chains(m_points.size());
    std::set<std::size_t> vertices;
    for (const auto& [v, w] : m_sheet.boundary()) {
      chains.join(v, w);
      vertices.insert({v, w});
      m_report.boundary_length += std::sqrt((m_points[v] - m_points[w]).squared_length());
    }
    for (std::size_t v : vertices)
      boundaries[chains.find(v)].push_back(v);
    m_report.number_of_boundaries = boundaries.size();
    for (const auto& [first, boundary] : boundaries) {
      const auto number = std::count_if(boundary.begin(), boundary.end(), [&](std::size_t v) {
        Progress_scope::check();
        return is_boundary_point(m_cloud, v);
      });
      if (2 * std::size_t(number) < boundary.size())
        doubt(first);
    }
  }

  // Finds clusters of the cloud whose points belong to several components.
  void find_separated_points() {
    const std::vector<std::size_t> clusters = clusters_of(m_cloud);
    std::map<std::size_t, std::size_t> component; // of a cluster
    std::set<std::size_t> told;
    for (std::size_t v = 0; v < m_points.size(); ++v)
      if (!m_sheet.star(v).empty()) {
        const std::size_t own = m_components.find(v),
                          expected = component.emplace(clusters[v], own).first->second;
        if (own != expected && told.insert(own).second)
          doubt(v);
      }
  }

  const Point_cloud_3& m_cloud;
  const std::vector<Point>& m_points;
  const Sheet_triangles_3& m_sheet;
  Sheet_report_3& m_report;
  Disjoint_sets m_components; // of the sheet
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_SHEETS_SHEET_CHECKS_3_H
