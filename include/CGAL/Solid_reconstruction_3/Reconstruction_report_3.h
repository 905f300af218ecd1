// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgSolidReconstruction3Ref

The report of `reconstruct_point_set_3()`. Lengths are in the unit of the points.

\tparam Complex a deformable simplicial complex in space
*/
template <class Complex> struct Reconstruction_report_3
{
  std::size_t number_of_points = 0;     ///< number of points without duplicates and outliers
  std::size_t number_of_duplicates = 0; ///< number of unused points, equal to others
  /// Number of outliers, which are not used: isolated points, points of clusters that are not
  /// surfaces, points without a side, and points off the planes of all neighbors.
  std::size_t number_of_outliers = 0;
  double spacing = 0; ///< mean distance of points from their 6 nearest neighbors
  double noise = 0;   ///< median of the residuals of quadrics at the points

  std::size_t number_of_steps = 0; ///< number of steps of the interface
  /// Whether the interface came to rest and there are no `doubtful_places`. If it did not come to
  /// rest, the observer ended the reconstruction or there were too few steps.
  bool is_complete = false;
  Improvement_report changes;       ///< changes of the mesh in all steps
  std::size_t relabeled = 0;        ///< number of cells whose label changed in all steps
  std::size_t topology_changes = 0; ///< number of changes of topology in all steps
  std::size_t held_back = 0;        ///< how often a vertex missed its destination in a step
  double root_mean_square = 0;      ///< of the distances of points to the interface
  double maximum_distance = 0;      ///< of a point to the interface
  /// Points whose distance to the interface exceeds both a spacing and four times the noise, as
  /// indices in the input.
  std::vector<std::size_t> unfit_points;
  /// Places where the interface contradicts the sides of the points: the centers of large empty
  /// balls on the wrong side of the interface, and one vertex of each handle that is smaller than
  /// such balls. It is empty if the interface did not come to rest.
  std::vector<typename Complex::Point> doubtful_places;
  /// Facets that close holes. No point is near them.
  std::vector<typename Complex::Facet> facets_without_points;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H
