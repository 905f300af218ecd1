// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_LONG_STEPS_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_LONG_STEPS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Domain_box.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the least distance of points from the sides of the domain; infinity if it is not a box.
template <class Complex>
double distance_from_sides(const Complex& dsc, const std::vector<typename Complex::Point>& points) {
  const Domain_box<Complex> box(dsc);
  double result = std::numeric_limits<double>::infinity();
  if (box.is_box())
    for (const auto& p : points)
      for (int axis = 0; axis < Complex::dimension; ++axis)
        result = (std::min)(
            {result, p[axis] - box.extent().lower(axis), box.extent().upper(axis) - p[axis]});
  return result;
}

// Returns the length of a motion in units of the longest motion that one deformation makes well. If
// free vertices follow a flow of space, neighbors must not turn far around each other, because the
// paths in a deformation are straight, and the interface must not come close to the sides of the
// domain from far away. Otherwise, the mesh limits the displacements.
// \param limit longest displacement of a vertex relative to its neighbors, in edge lengths
template <class Complex>
double length_of_step(const Complex& dsc, const Interface_vertices<Complex>& interface_,
                      const std::vector<typename Complex::Point>& destinations,
                      bool is_flow_of_space, bool moves_segments, double limit) {
  using Vector = typename Complex::Vector;
  static constexpr double together = 4; // longest displacement with neighbors, in the same unit
  std::vector<Vector> displacements;
  std::vector<double> lengths; // in units of the limit
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    const auto v = interface_.vertices[i];
    displacements.push_back(destinations[i] - dsc.position(v));
    // Steps are usually chosen for the mean edge. Few short edges do not make them too long.
    const double edge =
        (std::max)(v->spacing() > 0 ? double(v->spacing()) : dsc.interface_edge_length(v),
                   dsc.mean_interface_edge());
    lengths.push_back(Complex::Space::length(displacements[i]) / (limit * edge));
  }
  double longest = 0;
  if (moves_segments) {
    // The vertices of sharp corners move farther than the segments. New corners appear where
    // segments vanish, so parts are shorter.
    for (const auto& segment : static_cast<const Interface_snapshot<Complex>&>(interface_).facets())
      longest = (std::max)(longest,
                           (std::min)(lengths[segment.vertices[0]], lengths[segment.vertices[1]]));
    return longest;
  }
  for (const double length : lengths)
    longest = (std::max)(longest, length);
  if (!is_flow_of_space)
    return longest / together;
  if (2 * longest <= 1)
    return 0; // so are all differences
  // The mesh between the interface and the sides of the domain must give way.
  static constexpr double part_of_room = .25;
  double farthest = 0;
  for (const Vector& displacement : displacements)
    farthest = (std::max)(farthest, Complex::Space::length(displacement));
  double relative = farthest / (std::max)(together * limit * dsc.mean_interface_edge(),
                                          part_of_room * distance_from_sides(dsc, destinations));
  const Interface_snapshot<Complex> snapshot(dsc);
  for (const auto& facet : snapshot.facets())
    for (int k = 0; k < Complex::dimension; ++k) {
      const std::size_t i = facet.vertices[k], j = facet.vertices[(k + 1) % Complex::dimension];
      const double edge =
          Complex::Space::length(dsc.displacement(interface_.vertices[i], interface_.vertices[j]));
      relative = (std::max)(relative, Complex::Space::length(displacements[i] - displacements[j]) /
                                          (limit * edge));
    }
  return relative;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_LONG_STEPS_H
