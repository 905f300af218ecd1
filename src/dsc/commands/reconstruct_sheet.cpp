// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/reconstruct_sheet.h"
#include "motions/tracked_complex_3.h"
#include "output/report_json.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_sheet_3.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdio>
#include <functional>

namespace DSC = CGAL::Deformable_simplicial_complexes;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

namespace dsc {
namespace {

using CGAL::IO::Point_and_normal_3;
using DSC::Reconstructed_sheet_3;
using DSC::Sheet_report_3;

void write_sheet(const std::string& path, const Reconstructed_sheet_3& sheet) {
  DSC::Interface_surface_3<Tracked_complex_3::Complex> surface;
  for (const auto& p : sheet.points)
    surface.points.emplace_back(p.x(), p.y(), p.z());
  surface.triangles = sheet.triangles;
  CGAL::IO::write_interface(path, surface);
}

void write_report(const Reconstruct_options& options, const Sheet_report_3& report,
                  const Reconstructed_sheet_3& sheet, double seconds) {
  Json doubtful_places = Json::array();
  for (const auto& p : report.doubtful_places)
    doubtful_places.push_back({p.x(), p.y(), p.z()});
  write_json(options.report, {{"input", options.input},
                              {"seconds", seconds},
                              {"points", report.number_of_points},
                              {"duplicates", report.number_of_duplicates},
                              {"outliers", report.number_of_outliers},
                              {"spacing", report.spacing},
                              {"noise", report.noise},
                              {"triangles", sheet.triangles.size()},
                              {"components", report.number_of_components},
                              {"euler_characteristic", report.euler_characteristic},
                              {"boundaries", report.number_of_boundaries},
                              {"boundary_length", report.boundary_length},
                              {"is_orientable", report.is_orientable},
                              {"is_complete", report.is_complete},
                              {"root_mean_square", report.root_mean_square},
                              {"maximum_distance", report.maximum_distance},
                              {"unfit_points", report.unfit_points},
                              {"doubtful_places", doubtful_places}});
}

void print_summary(const Sheet_report_3& report, const Reconstructed_sheet_3& sheet,
                   double seconds) {
  std::printf("dsc: %zu points, %zu %s, %zu triangles, %zu %s, Euler characteristic %d, %zu %s of "
              "length %.4g%s; distances of points: root mean square %.3g, maximum %.3g (spacing "
              "%.3g, noise %.3g); %.3g s\n",
              report.number_of_points, report.number_of_outliers,
              noun(report.number_of_outliers, "outlier", "outliers"), sheet.triangles.size(),
              report.number_of_components,
              noun(report.number_of_components, "component", "components"),
              report.euler_characteristic, report.number_of_boundaries,
              noun(report.number_of_boundaries, "boundary", "boundaries"), report.boundary_length,
              report.is_orientable ? "" : ", one-sided", report.root_mean_square,
              report.maximum_distance, report.spacing, report.noise, seconds);
}

/// Prints where the sheet is not complete. Returns the exit code.
int tell_completeness(const Sheet_report_3& report, const std::vector<Point_and_normal_3>& points) {
  if (!report.unfit_points.empty()) {
    const auto& p = points[report.unfit_points.front()].first;
    std::fprintf(stderr,
                 "dsc: not complete: %zu %s farther than %.3g from the sheet, such as (%.6g, %.6g, "
                 "%.6g)\n",
                 report.unfit_points.size(),
                 noun(report.unfit_points.size(), "point is", "points are"),
                 report.largest_distance(), p.x(), p.y(), p.z());
  }
  if (!report.doubtful_places.empty()) {
    const auto& p = report.doubtful_places.front();
    std::fprintf(stderr,
                 "dsc: not complete: the sheet contradicts the points at %zu %s, such as (%.6g, "
                 "%.6g, %.6g): triangles are missing or extra; add points there\n",
                 report.doubtful_places.size(),
                 noun(report.doubtful_places.size(), "place", "places"), p.x(), p.y(), p.z());
  }
  return report.is_complete ? 0 : 1;
}

} // namespace

int reconstruct_open_sheet(const Reconstruct_options& options,
                           const std::vector<Point_and_normal_3>& points) {
  const auto begin = Clock::now();
  Sheet_report_3 report;
  const Reconstructed_sheet_3 sheet = DSC::reconstruct_sheet_3(
      points, parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal_3>())
                  .number_of_threads(options.threads)
                  .report(std::ref(report)));
  write_sheet(options.output, sheet);
  const double seconds = seconds_since(begin);
  if (!options.report.empty())
    write_report(options, report, sheet, seconds);
  if (!options.quiet)
    print_summary(report, sheet, seconds);
  return tell_completeness(report, points);
}

} // namespace dsc
