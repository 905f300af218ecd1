// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H

#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Interface_fan_3.h>

#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The facets of the interface at a vertex, its center. In each dimension:

- `Interface_fan(complex, v, star)`, with the star of v
- `center()`
- `is_disk()`: whether the interface is a single sheet here, between the same two labels, that does
  not end at the boundary of the domain
- `rank_by_features(angle)`: in how many directions features hold the center, where facets bend by
  more than an angle, in radians: 1 in a smooth sheet, as many as there are dimensions where the
  center is a corner. \pre is_disk()
- `keeps_features(angle, w)`: whether no feature goes with the center if it goes to the neighbor w.
  \pre is_disk()
*/
template <class Complex>
using Interface_fan =
    std::conditional_t<Complex::dimension == 2, Interface_fan_2<Complex>, Interface_fan_3<Complex>>;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_INTERFACE_FAN_H
