// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HILBERT_ORDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HILBERT_ORDER_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The indices of points along a Hilbert curve.
inline std::vector<std::size_t>
hilbert_order(const std::vector<Simple_cartesian<double>::Point_3>& points) {
  using Kernel = Simple_cartesian<double>;
  using Map = Pointer_property_map<Kernel::Point_3>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  hilbert_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_3<Kernel, Map>(make_property_map(points)));
  return order;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_HILBERT_ORDER_H
