// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_THIN_PART_OPTIONS_H
#define CGAL_COMPLEX_CONSTRUCTION_THIN_PART_OPTIONS_H

#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef
Options of `refine_thin_parts()`, and of the functions that make a complex.
*/
struct Thin_part_options
{
  /// Longest edge of the interface, in thicknesses of the phase or the gap at it; at least 1, or 0
  /// for no refinement. Cells of thin parts then have a quality above that at which they are
  /// relabeled.
  double edge_per_thickness = 3;
  /// Largest number of new facets of the interface. Their cells take about a second.
  unsigned most_new_facets = 10000;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(edge_per_thickness >= 1 || edge_per_thickness == 0))
      throw Error("the length of edges in thicknesses is out of range: use 1 or more, or 0");
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_THIN_PART_OPTIONS_H
