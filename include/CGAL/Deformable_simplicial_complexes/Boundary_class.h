// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H

#include <cstdint>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Where a vertex lies on the boundary of the domain: a set of sides, as bits. Of a box, the bits 0 to
5 are the sides x minimum, x maximum, y minimum, and so on: one bit for a vertex on a face, two on
an edge, three at a corner; the vertex moves within all of them. A domain that is no box has only
`fixed` vertices on its boundary. No bit: a vertex in the inside.
*/
struct Boundary_class
{
  using Bits = std::uint8_t;        ///< a set of sides
  static constexpr Bits inside = 0; ///< on no side
  static constexpr Bits fixed = 64; ///< on the boundary of a domain that is no box: may not move

  /// Whether motion along an axis (0, 1, 2) leaves the sides.
  static bool fixes(Bits sides, int axis) {
    return (sides & fixed) != 0 || (sides >> (2 * axis) & 3) != 0;
  }

  /// Whether any motion leaves the sides, in a space of so many axes.
  static bool fixes_all(Bits sides, int dimension) {
    int axis = 0;
    while (axis < dimension && fixes(sides, axis))
      ++axis;
    return axis == dimension;
  }

  /// Whether everything of a class is also on all sides of another one.
  static bool contains(Bits sides, Bits others) { return (sides & others) == others; }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_BOUNDARY_CLASS_H
