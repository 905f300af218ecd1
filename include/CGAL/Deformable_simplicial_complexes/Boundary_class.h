// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The sides of the domain that a vertex lies on, as bits. In a box, the bits 0 to 5 are the sides x
minimum, x maximum, y minimum, and so on. A vertex on a face has one bit, a vertex on an edge two,
and a corner three. The vertex moves within all its sides. If the domain is not a box, all vertices
on its boundary are `fixed`. A vertex in the interior has no bit. Bit 7 is free for domains.
*/
struct Boundary_class
{
  using Bits = std::uint8_t;        ///< set of sides
  static constexpr Bits inside = 0; ///< on no side
  /// on the boundary of a domain that is not a box; the vertex may not move
  static constexpr Bits fixed = 64;

  /// Returns whether motion along an axis (0, 1, 2) leaves the sides.
  static bool fixes(Bits sides, int axis) {
    return (sides & fixed) != 0 || (sides >> (2 * axis) & 3) != 0;
  }

  /// Returns whether any motion leaves the sides, in a space of the given dimension.
  static bool fixes_all(Bits sides, int dimension) {
    int axis = 0;
    while (axis < dimension && fixes(sides, axis))
      ++axis;
    return axis == dimension;
  }

  /// Returns whether the set `sides` contains all sides of the set `others`.
  static bool contains(Bits sides, Bits others) { return (sides & others) == others; }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H
