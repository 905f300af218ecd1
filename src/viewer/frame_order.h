// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FRAME_ORDER_H
#define DSC_FRAME_ORDER_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace dsc {

using Index = std::uint32_t;
constexpr Index none = std::numeric_limits<Index>::max(); ///< no index

/// Returns indices such that the keys are increasing; equal keys are in their order.
template <class Key> std::vector<Index> sorted_indices(const std::vector<Key>& keys) {
  std::vector<Index> result(keys.size());
  std::iota(result.begin(), result.end(), 0);
  std::sort(result.begin(), result.end(),
            [&](Index a, Index b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
  return result;
}

/// Returns the index of an equal key before for each key, or `none`. Each key before is used once.
template <class Key>
std::vector<Index> matches(const std::vector<Key>& before, const std::vector<Key>& keys) {
  std::vector<Index> result(keys.size(), none);
  const std::vector<Index> former = sorted_indices(before), present = sorted_indices(keys);
  auto i = former.begin();
  for (const Index j : present) {
    while (i != former.end() && before[*i] < keys[j])
      ++i;
    if (i != former.end() && before[*i] == keys[j])
      result[j] = *i++;
  }
  return result;
}

/// Returns the probable index before of each point, or `none`, for points that are listed in the
/// order of their creation in both frames, as files of runs do. A wrong index only makes a film
/// larger.
template <class Point>
std::vector<Index> matches_in_order(const std::vector<Point>& before,
                                    const std::vector<Point>& points) {
  static constexpr std::size_t window = 64; // most points that vanish one after the other
  std::vector<Index> result(points.size(), none);
  Point displacement = {}; // of the previous point, expected of the next one
  std::size_t i = 0;
  for (std::size_t j = 0; j < points.size() && i < before.size(); ++j) {
    std::size_t best = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = i; k < std::min(i + window, before.size()) && least > 0; ++k) {
      double squared = 0;
      for (std::size_t axis = 0; axis < displacement.size(); ++axis) {
        const double difference = points[j][axis] - before[k][axis] - displacement[axis];
        squared += difference * difference;
      }
      squared *= double(1 + k - i); // prefers near places in the list
      if (squared < least) {
        least = squared;
        best = k;
      }
    }
    for (std::size_t axis = 0; axis < displacement.size(); ++axis)
      displacement[axis] = points[j][axis] - before[best][axis];
    result[j] = Index(best);
    i = best + 1;
  }
  return result;
}

/// The order in which a frame is stored: elements that the previous frame contains, in the order of
/// that frame, then all others.
struct Order
{
  std::vector<Index> indices; ///< in the frame as given
  std::vector<Index> kept;    ///< indices of the first elements in the previous frame

  explicit Order(const std::vector<Index>& matches) : indices(matches.size()) {
    std::iota(indices.begin(), indices.end(), 0);
    const auto end = std::stable_partition(indices.begin(), indices.end(),
                                           [&](Index i) { return matches[i] != none; });
    std::sort(indices.begin(), end, [&](Index a, Index b) { return matches[a] < matches[b]; });
    for (auto i = indices.begin(); i != end; ++i)
      kept.push_back(matches[*i]);
  }

  template <class T>
  std::vector<T> ordered(const std::vector<T>& rows, std::size_t width = 1) const {
    std::vector<T> result;
    result.reserve(rows.size());
    for (const Index i : indices)
      result.insert(result.end(), rows.begin() + std::ptrdiff_t(i * width),
                    rows.begin() + std::ptrdiff_t((i + 1) * width));
    return result;
  }
};

} // namespace dsc

#endif // DSC_FRAME_ORDER_H
