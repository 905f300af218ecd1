// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_OPTIONS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_OPTIONS_3_H

#include <limits>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `repair_surface_3()` and `wrap_surface_3()`.
*/
struct Surface_repair_options_3
{
  /// Vertices nearer to each other than this become one, even if the surface bounds a solid: in
  /// mean edges of the surface, at least 0. Shorter edges vanish. Tetrahedralizers may fail where
  /// vertices nearly coincide.
  double merge_distance = 0;

  /// The longest border of holes that are filled, in diagonals of the bounding box of the part that
  /// has it, at least 0. Borders of plane cuts are up to 1.6 diagonals long, borders of flat sheets
  /// at least 2.
  double largest_hole = 1.6;

  /// The longest border of holes that are filled, in the unit of the coordinates, at least 0. A
  /// hole is filled if both bounds permit that.
  double longest_border = std::numeric_limits<double>::infinity();

  /// The parameter alpha of CGAL's alpha wrap, in mean edges of the surface, at least 0; 0 for no
  /// wrap. A ball of this radius does not pass holes that are smaller than it. At least a
  /// thousandth of the diagonal of the bounding box is used. A larger alpha closes larger gaps, a
  /// smaller one gives many more triangles.
  double wrap_alpha = 1;

  /// The distance of the wrap from the surface, in mean edges, more than 0.
  double wrap_offset = .1;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SURFACE_REPAIR_OPTIONS_3_H
