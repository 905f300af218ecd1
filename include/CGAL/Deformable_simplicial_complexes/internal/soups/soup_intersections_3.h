// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H

#include <CGAL/Deformable_simplicial_complexes/internal/soups/Triangle_soup_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Returns all pairs of triangles of a soup that intersect anywhere except in a common vertex or a
// common edge, the smaller index first; sorted. Exact.
// \pre no triangle is degenerate, and points with different indices differ
#ifdef CGAL_DSC_EXTERN // see the component Compiled
std::vector<std::pair<std::size_t, std::size_t>> crossing_triangles(const Triangle_soup_3& soup);
#else
inline std::vector<std::pair<std::size_t, std::size_t>>
crossing_triangles(const Triangle_soup_3& soup);
#endif

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#ifndef CGAL_DSC_EXTERN
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_intersections_3_impl.h>
#endif

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_SOUPS_SOUP_INTERSECTIONS_3_H
