// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHANGED_FACETS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHANGED_FACETS_3_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Interface_edge_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/interface_triangles_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/swept_volume_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/triangle_quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What a proposal makes of the facets of the interface that it changes.
struct Changed_facets_3
{
  double worst_before = std::numeric_limits<double>::infinity(); // triangle_quality()
  double worst_after = std::numeric_limits<double>::infinity();  // 0 if a facet turns over
  double swept_volume = 0; // between the interface before and after
};

template <class Complex>
Changed_facets_3 facets_changed_by_collapse(const Complex& complex,
                                            const Cavity_3<Complex>& collapse) {
  using Point = typename Complex::Approximate_point_3;
  Changed_facets_3 result;
  for (const auto c : collapse.removed())
    for (int i = 0; i < 4; ++i) {
      const std::pair<typename Complex::Cell_handle, int> facet(c, i);
      if (c->vertex(i) == collapse.vanishing_vertex() || !complex.is_interface(facet))
        continue;
      const auto v = complex.facet_vertices(facet);
      std::array<Point, 3> before, after;
      bool vanishes = false;
      for (int k = 0; k < 3; ++k) {
        vanishes = vanishes || v[k] == collapse.kept_vertex();
        before[k] = complex.position(v[k]);
        after[k] = v[k] == collapse.vanishing_vertex() ? complex.position(collapse.kept_vertex())
                                                       : before[k];
      }
      result.worst_before = (std::min)(result.worst_before, triangle_quality(before));
      if (vanishes)
        continue;
      const bool turns_over = !(area_vector(before) * area_vector(after) > 0);
      result.worst_after = (std::min)(result.worst_after, turns_over ? 0 : triangle_quality(after));
    }
  result.swept_volume = volume_swept_by_collapse(complex, collapse);
  return result;
}

// \pre edge.is_in_sheet(), and the proposal is to flip it
template <class Complex>
Changed_facets_3 facets_changed_by_flip(const Interface_edge_3<Complex>& edge) {
  Changed_facets_3 result;
  for (int i = 0; i < 2; ++i) {
    result.worst_before = (std::min)(result.worst_before, triangle_quality(edge.facet(i)));
    result.worst_after = (std::min)(result.worst_after, triangle_quality(edge.flipped_facet(i)));
  }
  // Flipped facets have the edge between the opposite corners in opposite directions.
  if (!(area_vector(edge.flipped_facet(0)) * area_vector(edge.flipped_facet(1)) > 0))
    result.worst_after = 0;
  const auto p = edge.flipped_facet(0);
  result.swept_volume = std::abs((edge.flipped_facet(1)[0] - p[0]) * area_vector(p)) / 3;
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHANGED_FACETS_3_H
