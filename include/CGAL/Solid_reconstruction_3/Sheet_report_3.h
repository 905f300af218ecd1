// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_SHEET_REPORT_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_SHEET_REPORT_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgSolidReconstruction3Ref

The report of `reconstruct_sheet_3()`. Lengths are in the unit of the points.
*/
struct Sheet_report_3
{
  std::size_t number_of_points = 0;     ///< number of points without duplicates and outliers
  std::size_t number_of_duplicates = 0; ///< number of unused points, equal to others
  /// Number of outliers, which are not used: isolated points, points of clusters that are not
  /// surfaces, and points off the planes of all neighbors.
  std::size_t number_of_outliers = 0;
  double spacing = 0; ///< mean distance of points from their 6 nearest neighbors
  double noise = 0;   ///< median of the residuals of quadrics at the points

  std::size_t number_of_components = 0; ///< number of connected components of the sheet
  int euler_characteristic = 0;         ///< Euler characteristic of the sheet
  std::size_t number_of_boundaries = 0; ///< number of connected components of its boundary
  double boundary_length = 0;           ///< length of all boundaries
  bool is_orientable = true;            ///< whether the sheet has two sides

  double root_mean_square = 0; ///< of the distances of points to the sheet
  double maximum_distance = 0; ///< of a point to the sheet
  /// Whether there are no `unfit_points` and no `doubtful_places`.
  bool is_complete = false;
  /// Points whose distance to the sheet exceeds `largest_distance()`, as indices in the input.
  std::vector<std::size_t> unfit_points;
  /// Places where the sheet contradicts the points: vertices where it is not a manifold, one vertex
  /// of each boundary where the points have no boundary, and one vertex of each component that is
  /// separated from points near it.
  std::vector<Epick::Point_3> doubtful_places;

  /// Returns the largest distance of a point that fits: half a spacing, or six times the noise if
  /// this is greater.
  double largest_distance() const { return (std::max)(.5 * spacing, 6 * noise); }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_SOLID_RECONSTRUCTION_3_SHEET_REPORT_3_H
