// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_SHEET_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_SHEET_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>
#include <CGAL/Solid_reconstruction_3/Invalid_points_error.h>
#include <CGAL/Solid_reconstruction_3/Sheet_report_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Collected_points.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_sheet_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/cloud_properties_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_front_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/Sheet_triangles_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/sheet_checks_3.h>
#include <CGAL/Solid_reconstruction_3/internal/sheets/sheet_seams_3.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgSolidReconstruction3Ref

The result of `reconstruct_sheet_3()`: a triangle soup whose triangles share points.
*/
struct Reconstructed_sheet_3
{
  std::vector<Epick::Point_3> points;                ///< corners of the triangles
  std::vector<std::array<std::size_t, 3>> triangles; ///< indices into `points`
};

/*!
\ingroup PkgSolidReconstruction3Ref

Options of `reconstruct_sheet_3()`. The named parameters of that function have the same names.
*/
struct Sheet_options_3
{
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;
  /// Report that is filled; none if null.
  Sheet_report_3* report = nullptr;
};

namespace internal {

// Removes points without triangles.
inline Reconstructed_sheet_3 compact_sheet(const std::vector<Cloud_kernel::Point_3>& points,
                                           const Sheet_triangles_3& sheet) {
  Reconstructed_sheet_3 result;
  std::vector<std::size_t> numbers(points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!sheet.star(v).empty()) {
      numbers[v] = result.points.size();
      result.points.push_back(points[v]);
    }
  for (const auto& t : sheet.all())
    result.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
  return result;
}

// Implements `reconstruct_sheet_3()`.
inline Reconstructed_sheet_3 reconstruct_sheet(const Collected_points& points,
                                               const Sheet_options_3& options) {
  const Progress_phase phase("reconstructing a surface");
  const Sampled_sheet_3 surface(points.points, options.number_of_threads);
  const Point_cloud_3& cloud = surface.cloud();
  std::vector<double> radii;
  for (double reach : cloud.reaches())
    radii.push_back(reach_of_points * reach);
  const Sheet_front_3 front(surface.points(), cloud.spacing(), radii, clusters_of(cloud));
  if (front.triangles.empty())
    throw Invalid_points_error(Invalid_points_error::Reason::open,
                               "the points sample no surface: they lie on a line or a curve");
  Sheet_triangles_3 sheet(cloud.size(), front.triangles);
  close_seams(cloud, surface.points(), front.other_facets, sheet);
  fill_small_holes(surface.points(), sheet);
  sheet.orient();
  Sheet_report_3 report;
  report.number_of_points = cloud.size();
  report.number_of_duplicates = cloud.number_of_duplicates();
  report.number_of_outliers = cloud.number_of_outliers();
  report.spacing = cloud.spacing();
  report.noise = surface.noise();
  const Sheet_checks_3 checks(cloud, surface.points(), sheet, report);
  if (options.report != nullptr)
    *options.report = report;
  return compact_sheet(surface.points(), sheet);
}

} // namespace internal

/*!
\ingroup PkgSolidReconstruction3Ref

Reconstructs a surface with boundaries from points on it, such as a terrain or a scan from one side.
The surface may have several components, holes, and only one side. Its triangles do not intersect
each other.

The triangles are selected by the advancing front of the package
\ref PkgAdvancingFrontSurfaceReconstructionRef. An empty ball at a selected triangle is at most as
large as twice the distance of a corner from its sixth neighbor. Larger holes of the points stay
open. On a one-sided surface, the front leaves a seam, which is closed by further Delaunay facets.
The vertices are the points. If the noise exceeds 0.01 spacings, the points first move towards
quadrics that fit their neighbors, by at most three times the noise. The result does not depend on
the order of the points.

At the end, the result is verified by the points; see `Sheet_report_3::is_complete`.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\tparam PointRange a range whose value type is the key type of the point map, or a `Point_set_3`

\param points the points, in any order
\param np a `Sheet_options_3`, or named parameters with the names of its members, where `report` is a
       `std::reference_wrapper`. Also `point_map`, as for `reconstruct_point_set_3()`. Normals are
       not used.

\return the triangles. They are consistently oriented, except at edges where a one-sided surface
        cannot be.
\throws Invalid_points_error if coordinates are not finite, the extent of the points is not between
        1e-30 and 1e30, there are fewer than four different points, or they lie on a line.
\throws Error if a named parameter is out of its range.
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`.

If an exception is thrown, the report is unchanged.

\sa `reconstruct_point_set_3()`
*/
template <class ConcurrencyTag = Sequential_tag, class PointRange,
          class NP = parameters::Default_named_parameters>
Reconstructed_sheet_3 reconstruct_sheet_3(const PointRange& points,
                                          const NP& np = parameters::default_values()) {
  if constexpr (std::is_same<NP, Sheet_options_3>::value)
    return internal::reconstruct_sheet(
        internal::collect_points(points, parameters::default_values()), np);
  else {
    Sheet_options_3 options;
    options.number_of_threads = default_number_of_threads<ConcurrencyTag>();
    read_parameters<CGAL::internal_np::point_t>(np, options);
    return internal::reconstruct_sheet(internal::collect_points(points, np), options);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_SHEET_3_H
