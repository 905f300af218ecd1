// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Mesh_support/internal/threads/stoppable_sort.h>
#include <CGAL/algorithm.h>

#include <boost/property_map/property_map.hpp>
#include <boost/random/linear_congruential.hpp>
#include <boost/random/random_number_generator.hpp>

#include <cstddef>
#include <numeric>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A property map from indices to points. Each access checks for an interrupt, so that a long sort
// can be stopped.
template <class Point> struct Stoppable_point_map
{
  using key_type = std::size_t;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  const Point* points;
  Sparse_check* check;

  friend const Point& get(const Stoppable_point_map& map, std::size_t i) {
    (*map.check)();
    return map.points[i];
  }
};

// A random number generator for the shuffle before a sort. Each call checks for an interrupt.
struct Stoppable_random_numbers
{
  boost::rand48 engine;
  Sparse_check check;

  std::ptrdiff_t operator()(std::ptrdiff_t bound) {
    check();
    return boost::random_number_generator<boost::rand48, std::ptrdiff_t>(engine)(bound);
  }
};

// Returns the indices of points in the order of a Hilbert curve. The order is the one of CGAL's
// `hilbert_sort()`; that function cannot be used, because its shuffle cannot be interrupted.
template <class Space>
std::vector<std::size_t> hilbert_order(const std::vector<typename Space::Point>& points) {
  using Map = Stoppable_point_map<typename Space::Point>;
  using Sorter =
      typename Space::template Hilbert_sorter<typename Kernel_traits<typename Space::Point>::Kernel,
                                              Map>;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  Stoppable_random_numbers random_numbers;
  cpp98::random_shuffle(order.begin(), order.end(), random_numbers);
  Sparse_check check;
  const Sorter sort(Map{points.data(), &check});
  sort(order.begin(), order.end());
  return order;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_HILBERT_ORDER_H
