// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CHECKS_CHECK_PATCHES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CHECKS_CHECK_PATCHES_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/checks/check_surfaces_3.h>

#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the union of soups, which may be open. Equal points of a soup are merged. Throws
// `Invalid_surface_error` unless triangles meet only in common vertices and edges. Complexity: O(n
// log n).
inline Joined_soup_3 check_patches(const std::vector<Triangle_soup_3>& patches) {
  if (patches.empty())
    refuse_surface(Invalid_surface_error::Reason::empty, 0);
  std::vector<Merged_soup_3> merged;
  for (std::size_t s = 0; s < patches.size(); ++s) {
    check_numbers(patches[s], s);
    merged.push_back(merge_points(patches[s]));
    check_areas(merged.back(), s);
  }
  Joined_soup_3 joined = join(merged);
  refuse_crossings(joined, crossing_triangles(joined));
  return joined;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_CHECKS_CHECK_PATCHES_3_H
