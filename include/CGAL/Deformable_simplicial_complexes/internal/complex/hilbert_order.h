// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The indices of points along a Hilbert curve.
template <class Space>
std::vector<std::size_t>
hilbert_order(const std::vector<typename Space::Approximate_point>& points) {
  using Map = typename Pointer_property_map<typename Space::Approximate_point>::const_type;
  using Sort_traits = typename Space::template Spatial_sort_traits<Simple_cartesian<double>, Map>;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  hilbert_sort(order.begin(), order.end(), Sort_traits(make_property_map(points)));
  return order;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
