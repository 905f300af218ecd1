// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H
#define CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>

#include <CGAL/Origin.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

A motion along the normals of the interface. Labelled phases grow into the outside, label 0. With a
negative speed they shrink. The normal of a vertex is the mean of the normals of its facets that
face label 0, weighted by their areas, in the plane by their lengths. Vertices without such a facet
stay.

\cgalModels `InterfaceVelocity`
*/
struct Normal_offset
{
  double speed; ///< length per unit of time, in the coordinates of the complex

  /// Computes the velocities of all vertices at the given positions, see `InterfaceVelocity`. The
  /// time is linear in the size of the interface.
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Approximate_point>& positions, double /*t*/,
                  std::vector<typename Complex::Approximate_vector>& velocities) const {
    using Space = typename Complex::Space;
    using Vector = typename Complex::Approximate_vector;
    velocities.assign(positions.size(), Vector(NULL_VECTOR));
    for (const auto& facet : interface_.facets()) {
      if (facet.in_front != 0 && facet.behind != 0)
        continue;
      std::array<typename Complex::Approximate_point, Complex::dimension> corners;
      for (int i = 0; i < Complex::dimension; ++i)
        corners[i] =
            interface_.domain.near(positions[facet.vertices[0]], positions[facet.vertices[i]]);
      const Vector normal = Space::facet_normal(corners) * (facet.in_front == 0 ? 1. : -1.);
      for (std::size_t v : facet.vertices)
        velocities[v] = velocities[v] + normal;
    }
    for (Vector& v : velocities) {
      const double length = Space::length(v);
      v = length == 0 ? Vector(NULL_VECTOR) : speed * (v / length);
    }
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_NORMAL_OFFSET_H
