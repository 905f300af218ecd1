// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_APPLY_TO_CORNERS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_APPLY_TO_CORNERS_H

#include <utility>

namespace CGAL::Deformable_simplicial_complexes::internal {

template <class Function, class Corner, int... i>
decltype(auto) apply_to_corners(const Function& f, const Corner& corner,
                                std::integer_sequence<int, i...>) {
  return f(corner(i)...);
}

// Returns f(corner(0), ..., corner(n - 1)), for example a predicate or a measure of a simplex with
// n corners.
template <int n, class Function, class Corner>
decltype(auto) apply_to_corners(const Function& f, const Corner& corner) {
  return apply_to_corners(f, corner, std::make_integer_sequence<int, n>());
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_APPLY_TO_CORNERS_H
