// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_H

#include <CGAL/Interface_remeshing/internal/values/overlap_measure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the measure of a simplex, which is positive in spite of rounding: thin simplices have
// contents, too.
template <class Space, class Corners> double positive_measure(const Corners& corners) {
  static constexpr double least = 1e-150; // below the rounding error of any measure
  return (std::max)(least, signed_measure<Space>(corners));
}

// A positively oriented triangle or tetrahedron, and its content.
template <class Space, class Value> struct Filled_simplex
{
  Clipping_simplex<Space> simplex;
  int label;
  Value content;

  double measure() const { return positive_measure<Space>(simplex.corners()); }
};

// Returns the pairs of indices of a source and a target whose bounding boxes intersect, sorted.
// Computed by a sweep along the x-axis.
template <class Simplex>
std::vector<std::pair<std::size_t, std::size_t>>
pairs_that_may_overlap(const std::vector<const Simplex*>& sources,
                       const std::vector<Simplex*>& targets) {
  using Box = std::decay_t<decltype(sources.front()->simplex.bbox())>;
  struct Start
  {
    double x;
    bool is_target;
    std::size_t index;
    const Box* box;
  };
  std::vector<Start> starts, open_sources, open_targets;
  const auto add = [&](const auto& simplices, bool are_targets) {
    for (std::size_t i = 0; i < simplices.size(); ++i) {
      const Box& box = simplices[i]->simplex.bbox();
      starts.push_back({box.xmin(), are_targets, i, &box});
    }
  };
  add(sources, false);
  add(targets, true);
  std::sort(starts.begin(), starts.end(), [](const Start& s, const Start& t) { return s.x < t.x; });
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const Start& s : starts) {
    auto& others = s.is_target ? open_sources : open_targets;
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](const Start& t) { return t.box->xmax() < s.x; }),
                 others.end());
    for (const Start& t : others)
      if (do_overlap(*s.box, *t.box))
        result.push_back(s.is_target ? std::make_pair(t.index, s.index)
                                     : std::make_pair(s.index, t.index));
    (s.is_target ? open_targets : open_sources).push_back(s);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Transfers the contents of `sources` to `targets`. Where they overlap, a source fills a target
// with its own density. The content of the sources outside the targets fills the uncovered parts of
// the targets. If these parts are smaller than the uncovered parts of the sources, the rest is
// distributed to all targets by measure.
template <class Space, class Value>
void pour(const std::vector<const Filled_simplex<Space, Value>*>& sources,
          const std::vector<Filled_simplex<Space, Value>*>& targets) {
  std::vector<double> gaps, overlaps;
  double measure = 0; // of all targets
  for (const auto* t : targets) {
    gaps.push_back(t->measure());
    measure += gaps.back();
  }
  double excess = 0; // measure of sources outside the targets
  Value left = 0. * sources.front()->content;
  const auto pairs = pairs_that_may_overlap(sources, targets);
  auto pair = pairs.begin();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto* s = sources[i];
    const auto first = pair;
    overlaps.clear();
    double sum = 0;
    for (; pair != pairs.end() && pair->first == i; ++pair) {
      overlaps.push_back(overlap_measure(s->simplex, targets[pair->second]->simplex));
      sum += overlaps.back();
    }
    const double whole = (std::max)(sum, s->measure()); // less by rounding only
    for (std::size_t k = 0; k < overlaps.size(); ++k) {
      const std::size_t j = first[std::ptrdiff_t(k)].second;
      targets[j]->content = targets[j]->content + overlaps[k] / whole * s->content;
      gaps[j] -= overlaps[k];
    }
    left = left + (whole - sum) / whole * s->content;
    excess += whole - sum;
  }
  if (!(excess > 0))
    return;
  double gap = 0;
  for (double& g : gaps)
    gap += g = (std::max)(0., g); // negative because of rounding only
  const double fill = 1 / (std::max)(gap, excess), spread = (1 - fill * gap) / measure;
  for (std::size_t j = 0; j < targets.size(); ++j)
    targets[j]->content =
        targets[j]->content + (fill * gaps[j] + spread * targets[j]->measure()) * left;
}

// Transfers contents label by label: the content of the sources of a label goes to the targets of
// the same label, or to all targets if there are none.
template <class Space, class Value>
void redistribute_contents(const std::vector<Filled_simplex<Space, Value>>& from,
                           std::vector<Filled_simplex<Space, Value>>& to) {
  using Simplex = Filled_simplex<Space, Value>;
  std::vector<int> labels;
  for (const Simplex& t : from)
    if (std::find(labels.begin(), labels.end(), t.label) == labels.end())
      labels.push_back(t.label);
  for (int label : labels) {
    std::vector<const Simplex*> sources;
    std::vector<Simplex*> targets;
    for (const Simplex& t : from)
      if (t.label == label)
        sources.push_back(&t);
    for (Simplex& t : to)
      if (t.label == label)
        targets.push_back(&t);
    if (targets.empty())
      for (Simplex& t : to)
        targets.push_back(&t);
    pour(sources, targets);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_H
