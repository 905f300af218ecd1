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
constexpr Index none = (std::numeric_limits<Index>::max)(); ///< no index

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

template <class Point> double squared_distance(const Point& p, const Point& q) {
  double result = 0;
  for (std::size_t axis = 0; axis < p.size(); ++axis)
    result += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return result;
}

/// Returns the probable index before of each point, or `none`, for points that are listed in the
/// order of their creation in both frames, as files of runs do. A wrong index only makes a film
/// larger. The indices minimize the sum of squared distances, by dynamic programming: the index
/// before of point `j` is `j` plus a shift, the number of removed points, which never decreases.
template <class Point>
std::vector<Index> matches_in_order(const std::vector<Point>& before,
                                    const std::vector<Point>& points) {
  static constexpr std::size_t most_shifts = 1023, most_new = 256; // bounds on the search
  static constexpr std::size_t most_states = 30'000'000;           // of two bytes each
  const std::size_t n = before.size(), m = points.size();
  std::vector<Index> result(m, none);
  if (n == 0 || m == 0)
    return result;
  double limit = 0; // cost of a point without a match: a quarter of the mean distance in the list
  for (std::size_t i = 1; i < n; ++i)
    limit += squared_distance(before[i], before[i - 1]) / double(4 * n);
  const std::size_t shifts =
      (std::min)({(n > m ? n - m : 0) + most_new, most_shifts, most_states / m});
  std::vector<double> least(shifts + 1, 0); // cost of the points so far, by the last shift
  std::vector<std::uint16_t> previous(m * (shifts + 1));
  for (std::size_t j = 0; j < m; ++j) {
    double running = std::numeric_limits<double>::infinity();
    std::uint16_t from = 0;
    for (std::size_t k = 0; k <= shifts; ++k) {
      if (least[k] < running) {
        running = least[k];
        from = std::uint16_t(k);
      }
      previous[j * (shifts + 1) + k] = from;
      least[k] =
          running +
          (j + k < n ? (std::min)(limit, squared_distance(points[j], before[j + k])) : limit);
    }
  }
  auto shift = std::size_t(std::min_element(least.begin(), least.end()) - least.begin());
  for (std::size_t j = m; j-- > 0;) {
    if (j + shift < n)
      result[j] = Index(j + shift);
    shift = previous[j * (shifts + 1) + shift];
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
};

/// Returns the rows of given indices. A row has `width` entries.
template <class T>
std::vector<T> chosen_rows(const std::vector<T>& rows, const std::vector<Index>& indices,
                           std::size_t width = 1) {
  std::vector<T> result;
  result.reserve(indices.size() * width);
  for (const Index i : indices)
    result.insert(result.end(), rows.begin() + std::ptrdiff_t(i * width),
                  rows.begin() + std::ptrdiff_t((i + 1) * width));
  return result;
}

} // namespace dsc

#endif // DSC_FRAME_ORDER_H
