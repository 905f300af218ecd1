// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The interface facets at a vertex, the center of the fan. In each dimension:

- `Interface_fan(complex, v, star)`, with the star of v
- `center()`
- `is_disk()`: whether the interface at the center is a single sheet between the same two labels
  that does not end at the boundary of the domain
- `rank_by_features(angle)`: the number of directions in which features constrain the center; facets
  that differ by more than `angle`, in radians, form a feature. The rank is 1 in a smooth sheet, and
  the dimension at a corner. Precondition: is_disk()
- `keeps_features(angle, w)`: whether the features are kept when the center is moved to its neighbor
  w. Precondition: is_disk()
*/
template <class Complex>
using Interface_fan =
    std::conditional_t<Complex::dimension == 2, Interface_fan_2<Complex>, Interface_fan_3<Complex>>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
