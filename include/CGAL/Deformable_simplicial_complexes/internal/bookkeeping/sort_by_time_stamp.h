// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_SORT_BY_TIME_STAMP_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_SORT_BY_TIME_STAMP_H

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A function object that compares items by time stamp, that is, in the order of creation; see
// `Item_numbers`.
struct Less_time_stamp
{
  template <class Handle> bool operator()(Handle a, Handle b) const {
    return a->time_stamp() < b->time_stamp();
  }
};

// Sorts handles in the order of creation; see `Item_numbers`. The time stamps are read once,
// because they are at scattered places in memory.
template <class Handle> void sort_by_time_stamp(std::vector<Handle>& items) {
  using Stamped = std::pair<std::size_t, Handle>;
  const auto is_less = [](const Stamped& a, const Stamped& b) { return a.first < b.first; };
  std::vector<Stamped> stamped;
  stamped.reserve(items.size());
  for (Handle item : items)
    stamped.emplace_back(item->time_stamp(), item);
  if (std::is_sorted(stamped.begin(), stamped.end(), is_less))
    return;
  boost::sort::spreadsort::integer_sort(
      stamped.begin(), stamped.end(),
      [](const Stamped& s, unsigned shift) { return s.first >> shift; }, is_less);
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i] = stamped[i].second;
}

// Returns the handles of a range for which a condition holds, in the order of creation.
template <class Handle, class Range, class Condition>
std::vector<Handle> by_time_stamp(const Range& range, const Condition& condition,
                                  std::size_t expected = 0) {
  std::vector<Handle> result;
  result.reserve(expected);
  for (Handle item : range)
    if (condition(item))
      result.push_back(item);
  sort_by_time_stamp(result);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_BOOKKEEPING_SORT_BY_TIME_STAMP_H
