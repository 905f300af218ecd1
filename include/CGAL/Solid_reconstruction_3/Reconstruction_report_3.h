// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgSolidReconstruction3Ref

What `reconstruct_point_set_3()` found and how well it fits. Distances are in the unit of length of
the points.

\tparam Complex a deformable simplicial complex in space
*/
template <class Complex> struct Reconstruction_report_3
{
  std::size_t number_of_points = 0;     ///< without duplicates and outliers
  std::size_t number_of_duplicates = 0; ///< points equal to others, which were left out
  std::size_t number_of_outliers =
      0; ///< points far from all others, in clusters that are no surfaces, or on neither side of
         ///< the surface, which were left out
  double spacing = 0; ///< the mean distance of points from their 6 nearest ones
  double noise = 0;   ///< how far points are from quadrics of their neighbors

  std::size_t number_of_steps = 0;       ///< of the interface
  bool is_complete = false;              ///< whether it came to rest and there are no
                                         ///< `doubtful_places`; if it did not come to rest, it was
                                         ///< interrupted or there were not enough steps
  Improvement_report changes;            ///< of the mesh, in all steps together
  std::size_t relabeled = 0;             ///< cells that changed their side, in all steps
  std::size_t topology_changes = 0;      ///< of the interface, in all steps
  std::size_t held_back = 0;             ///< how often a vertex did not arrive where a step sent it
  double root_mean_square = 0;           ///< of the distances of points from the interface
  double maximum_distance = 0;           ///< of a point from the interface
  std::vector<std::size_t> unfit_points; ///< those farther than a spacing and four times the noise,
                                         ///< by their places among the points that were given
  /// Where the interface contradicts the sides of the points: the centers of large empty balls that
  /// lie on the wrong side of it, and a vertex of each handle that is smaller than these balls.
  /// None if it did not come to rest.
  std::vector<typename Complex::Approximate_point> doubtful_places;
  std::vector<typename Complex::Facet> facets_without_points; ///< that no point is
                                                              ///< near to: they close holes
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCTION_REPORT_3_H
