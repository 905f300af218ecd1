// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REPAIR_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REPAIR_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Surface_repair_options_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <cmath>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Checks the options. Throws `Error` if a number is out of range.
inline void check_options(const Surface_repair_options_3& options) {
  if (!(options.merge_distance >= 0 && std::isfinite(options.merge_distance)))
    throw Error("the distance of vertices that become one must be a number from 0 on");
  if (!(options.largest_hole >= 0 && options.longest_border >= 0 && options.wrap_alpha >= 0 &&
        std::isfinite(options.wrap_alpha)))
    throw Error("the largest hole and the alpha of a wrap must be numbers from 0 on");
  if (!(options.wrap_offset > 0 && std::isfinite(options.wrap_offset)))
    throw Error("the offset of a wrap must be more than 0");
}

template <class NamedParameters>
Surface_repair_options_3 repair_options(const NamedParameters& np) {
  Surface_repair_options_3 options;
  options.largest_hole = number_parameter(np, internal_np::largest_hole, options.largest_hole);
  options.wrap_alpha = number_parameter(np, internal_np::wrap_alpha, options.wrap_alpha);
  options.wrap_offset = number_parameter(np, internal_np::wrap_offset, options.wrap_offset);
  return options;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REPAIR_REPAIR_OPTIONS_H
