// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_GRAPH_H
#define CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_GRAPH_H

#include <CGAL/Distributed_complexes/Communicator.h>

#include <algorithm>
#include <array>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

The graph of the vertices and edges of a distributed complex, for partitioners. Each rank has its
own vertices. The vertices of all ranks are numbered by rank.

\tparam d the dimension
*/
template <int d> struct Distributed_graph
{
  std::vector<std::int64_t> first; ///< number of the first vertex of each rank; the last entry is
                                   ///< the number of all vertices
  std::vector<std::int64_t> begin; ///< index in `neighbors` of the first neighbor of each own
                                   ///< vertex; the last entry is the size
  std::vector<std::int64_t> neighbors;          ///< numbers of the neighbors
  std::vector<std::int64_t> weights;            ///< work at each own vertex, greater than 0
  std::vector<std::array<double, d>> positions; ///< of the own vertices, in the unit cube
};

/*!
\ingroup PkgDistributedComplexesRef

Partitioner that divides the vertices along a space-filling curve, the Morton curve. The weights of
the parts differ by at most the weight of the vertices with one key. n log n in the number of own
vertices, and a constant number of reductions.
*/
struct Curve_partitioner
{
  /// Returns the new owner of each own vertex. Collective.
  template <int d>
  std::vector<int> operator()(Communicator& communicator, const Distributed_graph<d>& graph) const {
    static constexpr int bits = 62 / d; // of the number of a cube along an axis
    using Operation = Communicator::Operation;
    const std::size_t n = graph.weights.size(), parts = std::size_t(communicator.size());
    std::vector<std::pair<std::int64_t, std::int64_t>> keys(n); // with the weights up to there
    for (std::size_t v = 0; v < n; ++v)
      keys[v] = {key<d>(graph.positions[v], bits), graph.weights[v]};
    std::vector<std::int64_t> of_vertex(n);
    for (std::size_t v = 0; v < n; ++v)
      of_vertex[v] = keys[v].first;
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < n; ++i)
      keys[i].second += keys[i - 1].second;
    const std::int64_t all = communicator.reduced(Operation::sum, n > 0 ? keys.back().second : 0);
    // Bisects for the last key of each part except the last part.
    std::vector<std::int64_t> lower(parts - 1, 0), upper(parts - 1, std::int64_t(1) << (d * bits));
    for (int step = 0; step < d * bits; ++step) {
      std::vector<std::int64_t> below(parts - 1);
      for (std::size_t i = 0; i + 1 < parts; ++i) {
        const std::int64_t middle = lower[i] + (upper[i] - lower[i]) / 2;
        const auto it =
            std::lower_bound(keys.begin(), keys.end(), std::make_pair(middle, std::int64_t(0)));
        below[i] = it == keys.begin() ? 0 : std::prev(it)->second;
      }
      if (parts > 1)
        communicator.reduce(Operation::sum, below);
      for (std::size_t i = 0; i + 1 < parts; ++i) {
        const std::int64_t middle = lower[i] + (upper[i] - lower[i]) / 2;
        (double(below[i]) * double(parts) <= double(all) * double(i + 1) ? lower : upper)[i] =
            middle;
      }
    }
    std::vector<int> result(n);
    for (std::size_t v = 0; v < n; ++v)
      result[v] = int(std::upper_bound(lower.begin(), lower.end(), of_vertex[v]) - lower.begin());
    return result;
  }

private:
  // Returns the number of the cube of a point along the curve.
  template <int d> static std::int64_t key(const std::array<double, d>& p, int bits) {
    std::array<std::int64_t, d> cube;
    for (int k = 0; k < d; ++k)
      cube[k] = std::clamp(std::int64_t(p[k] * double(std::int64_t(1) << bits)), std::int64_t(0),
                           (std::int64_t(1) << bits) - 1);
    std::int64_t result = 0;
    for (int bit = bits; bit-- > 0;)
      for (int k = 0; k < d; ++k)
        result = 2 * result + (cube[k] >> bit & 1);
    return result;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_GRAPH_H
