// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_COUNTS_H
#define DSC_BENCHMARK_COUNTS_H

#include "betti_numbers.h"
#include "measures.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace dsc_benchmark {

/// The sorted time stamps of the vertices of a facet. No two vertices ever have the same time
/// stamp.
inline std::array<std::size_t, 3> time_stamps(const Complex& complex, const Complex::Facet& f) {
  const auto v = complex.facet_vertices(f);
  std::array<std::size_t, 3> result = {v[0]->time_stamp(), v[1]->time_stamp(), v[2]->time_stamp()};
  std::sort(result.begin(), result.end());
  return result;
}

/// Returns the number of components of a label, counted from scratch; the complex updates its
/// numbers incrementally.
inline long components(const Complex& complex, int label) {
  betti_numbers::Joined_sets sets;
  std::vector<std::size_t> cells;
  for (const Complex::Cell_handle c : complex.triangulation().finite_cell_handles()) {
    if (c->subdomain_index() != label)
      continue;
    cells.push_back(c->time_stamp());
    for (int i = 0; i < 4; ++i)
      if (!complex.is_infinite(c->neighbor(i)) && !complex.is_interface(std::make_pair(c, i)))
        sets.join(c->time_stamp(), c->neighbor(i)->time_stamp());
  }
  return std::count_if(cells.begin(), cells.end(),
                       [&](std::size_t i) { return sets.find(i) == i; });
}

/// Returns V - E + F of the whole interface, counted from scratch.
inline long euler_characteristic(const Complex& complex) {
  betti_numbers::Simplex_count count;
  for (const Complex::Facet& f : complex.interface_facets())
    count.add(time_stamps(complex, f));
  return count.euler_characteristic();
}

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_COUNTS_H
