// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_REPAIR_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_REPAIR_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parameters/improvement_options.h>

#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

struct Surface_repair_options
{
  double largest_hole;  // length of its border, in diagonals of the bounding box
  double alpha, offset; // of a wrap, in mean edges; no wrap if alpha is 0
};

template <class NamedParameters> Surface_repair_options repair_options(const NamedParameters& np) {
  // Borders of plane cuts are up to 1.6 diagonals long, those of sheets 2 and more.
  static constexpr double largest_hole = 1.6;
  // Coarser wraps close gaps that are seen; finer ones have many more triangles than the input.
  static constexpr double alpha = 1, offset = .1;
  const Surface_repair_options options = {
      number_parameter(np, internal_np::largest_hole, largest_hole),
      number_parameter(np, internal_np::wrap_alpha, alpha),
      number_parameter(np, internal_np::wrap_offset, offset)};
  if (!(options.largest_hole >= 0 && options.alpha >= 0 && std::isfinite(options.alpha)))
    throw Error("the largest hole and the alpha of a wrap must be numbers from 0 on");
  if (!(options.offset > 0 && std::isfinite(options.offset)))
    throw Error("the offset of a wrap must be more than 0");
  return options;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PARAMETERS_REPAIR_OPTIONS_H
