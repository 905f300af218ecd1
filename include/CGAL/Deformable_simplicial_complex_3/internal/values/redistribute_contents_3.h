// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/geometry/overlap_volume_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Positive even where rounding says otherwise: thin tetrahedra have contents, too.
template <class Point> double positive_volume(const std::array<Point, 4>& t) {
  static constexpr double least = 1e-150; // far below the rounding of any volume
  return (std::max)(least, signed_volume(t));
}

// A positive tetrahedron, and how much of something is in it.
template <class Point, class Value> struct Filled_tetrahedron_3
{
  Clipping_tetrahedron_3<Point> tetrahedron;
  int label;
  Value content;

  double volume() const { return positive_volume(tetrahedron.corners()); }
};

// Adds all that is in `sources` to `targets`. Where they overlap, a source fills a target to its
// own density. What sources have elsewhere fills the rest of the targets, to a common density; if
// there is too much of it, what is left goes to all targets by volume.
template <class Point, class Value>
void pour(const std::vector<const Filled_tetrahedron_3<Point, Value>*>& sources,
          const std::vector<Filled_tetrahedron_3<Point, Value>*>& targets) {
  std::vector<double> gaps, overlaps;
  double volume = 0; // of targets
  for (const auto* t : targets) {
    gaps.push_back(t->volume());
    volume += gaps.back();
  }
  double excess = 0; // volume of sources outside targets
  Value left = 0. * sources.front()->content;
  for (const auto* s : sources) {
    overlaps.clear();
    double sum = 0;
    for (const auto* t : targets) {
      overlaps.push_back(overlap_volume(s->tetrahedron, t->tetrahedron));
      sum += overlaps.back();
    }
    const double whole = (std::max)(sum, s->volume()); // less by rounding only
    for (std::size_t j = 0; j < targets.size(); ++j) {
      targets[j]->content = targets[j]->content + overlaps[j] / whole * s->content;
      gaps[j] -= overlaps[j];
    }
    left = left + (whole - sum) / whole * s->content;
    excess += whole - sum;
  }
  if (!(excess > 0))
    return;
  double gap = 0;
  for (double& g : gaps)
    gap += g = (std::max)(0., g); // less by rounding only
  const double fill = 1 / (std::max)(gap, excess), spread = (1 - fill * gap) / volume;
  for (std::size_t j = 0; j < targets.size(); ++j)
    targets[j]->content =
        targets[j]->content + (fill * gaps[j] + spread * targets[j]->volume()) * left;
}

// The same, label by label: what is in tetrahedra of a label goes to those of the same label, or to
// all if there is none.
template <class Point, class Value>
void redistribute_contents(const std::vector<Filled_tetrahedron_3<Point, Value>>& from,
                           std::vector<Filled_tetrahedron_3<Point, Value>>& to) {
  using Tetrahedron = Filled_tetrahedron_3<Point, Value>;
  std::vector<int> labels;
  for (const Tetrahedron& t : from)
    if (std::find(labels.begin(), labels.end(), t.label) == labels.end())
      labels.push_back(t.label);
  for (int label : labels) {
    std::vector<const Tetrahedron*> sources;
    std::vector<Tetrahedron*> targets;
    for (const Tetrahedron& t : from)
      if (t.label == label)
        sources.push_back(&t);
    for (Tetrahedron& t : to)
      if (t.label == label)
        targets.push_back(&t);
    if (targets.empty())
      for (Tetrahedron& t : to)
        targets.push_back(&t);
    pour(sources, targets);
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_VALUES_REDISTRIBUTE_CONTENTS_3_H
