// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/hilbert_sort.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Points by their indices. Reading them can be stopped, which stops a sort of many.
template <class Point> struct Stoppable_point_map
{
  using key_type = std::size_t;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  const Point* points;
  unsigned* number_of_reads;

  friend const Point& get(const Stoppable_point_map& map, std::size_t i) {
    static constexpr unsigned often = 1 << 12; // reads, which take some microseconds
    if (++*map.number_of_reads % often == 0)
      Progress_scope::check();
    return map.points[i];
  }
};

// The indices of points along a Hilbert curve.
template <class Space>
std::vector<std::size_t>
hilbert_order(const std::vector<typename Space::Approximate_point>& points) {
  using Map = Stoppable_point_map<typename Space::Approximate_point>;
  using Sort_traits = typename Space::template Spatial_sort_traits<Simple_cartesian<double>, Map>;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  unsigned number_of_reads = 0;
  hilbert_sort(order.begin(), order.end(), Sort_traits(Map{points.data(), &number_of_reads}));
  return order;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
