// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SPLIT_AT_CROSSINGS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SPLIT_AT_CROSSINGS_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A soup of split triangles. Triangle i lies in triangle `origins[i]` of the input and has its
// orientation.
struct Split_soup_3 : Triangle_soup_3
{
  std::vector<std::size_t> origins;
};

// Splits triangles where they intersect. In the result, triangles meet in common vertices and edges
// only, or have the same three corners. Intersection points are computed exactly and then rounded.
// Rounding may create new intersections, so the splitting is repeated. Degenerate triangles are
// removed. A soup without intersections is returned bitwise unchanged.
//
// Returns `nullopt` if triangles still intersect after the maximum number of repetitions.
#ifdef CGAL_DSC_EXTERN // see the component Compiled
std::optional<Split_soup_3> split_at_crossings(const Triangle_soup_3& soup);
#else
inline std::optional<Split_soup_3> split_at_crossings(const Triangle_soup_3& soup);
#endif

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#ifndef CGAL_DSC_EXTERN
#include <CGAL/Deformable_simplicial_complexes/internal/soups/split_at_crossings_3_impl.h>
#endif

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SPLIT_AT_CROSSINGS_3_H
