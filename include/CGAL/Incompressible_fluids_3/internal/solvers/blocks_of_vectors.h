// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_BLOCKS_OF_VECTORS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_BLOCKS_OF_VECTORS_H

#include <CGAL/Mesh_support/For_each_index.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the largest power of two that is not above a positive number, or 1 for other numbers.
// Division by it is exact. So square roots and single precision give the same digits for all units
// that differ by a power of two.
inline double unit_of(double x) {
  if (!(x > 0) || !std::isfinite(x))
    return 1;
  // The inverse of the unit is a normal number, too.
  static constexpr int largest = std::numeric_limits<double>::max_exponent - 2;
  return std::ldexp(1., (std::max)(-largest, (std::min)(std::ilogb(x), largest)));
}

constexpr Eigen::Index block_size = 8192; // entries; a block fits into the cache

// Returns the number of blocks of n entries.
inline std::size_t number_of_blocks(Eigen::Index n) {
  return std::size_t((n + block_size - 1) / block_size);
}

// Calls `f(begin, size)` for each block of n entries. The blocks do not depend on the number of
// threads.
template <class Function>
void for_each_block(const For_each_index& for_each, Eigen::Index n, const Function& f) {
  for_each(
      number_of_blocks(n),
      [&](std::size_t k) {
        const Eigen::Index begin = Eigen::Index(k) * block_size;
        f(begin, (std::min)(block_size, n - begin));
      },
      2);
}

// Returns the sum of `f(begin, size)` over all blocks. The result is bitwise reproducible.
template <class Function>
double sum_of_blocks(const For_each_index& for_each, Eigen::Index n, const Function& f) {
  std::vector<double> parts(number_of_blocks(n));
  for_each_block(for_each, n, [&](Eigen::Index begin, Eigen::Index size) {
    parts[std::size_t(begin / block_size)] = f(begin, size);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_BLOCKS_OF_VECTORS_H
