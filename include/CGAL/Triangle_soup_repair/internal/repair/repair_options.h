// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_REPAIR_OPTIONS_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_REPAIR_OPTIONS_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/parameter_values.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_options_3.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Checks the options. Throws `Error` if a number is out of range.
inline void check_options(const Surface_repair_options_3& options) {
  if (!(options.merge_distance >= 0 && std::isfinite(options.merge_distance)))
    throw Error("the merge distance is negative or not finite: use 0 or more");
  if (!(options.largest_hole >= 0 && options.longest_border >= 0 && options.wrap_alpha >= 0 &&
        std::isfinite(options.wrap_alpha)))
    throw Error("the largest hole, the longest border or the alpha of the wrap is out of range: "
                "use 0 or more");
  if (!(options.wrap_offset > 0 && std::isfinite(options.wrap_offset)))
    throw Error("the offset of the wrap is not positive and finite: use more than 0");
}

template <class NamedParameters>
Surface_repair_options_3 repair_options(const NamedParameters& np) {
  Surface_repair_options_3 options;
  replace_value(np, internal_np::largest_hole, options.largest_hole);
  replace_value(np, internal_np::wrap_alpha, options.wrap_alpha);
  replace_value(np, internal_np::wrap_offset, options.wrap_offset);
  return options;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_REPAIR_REPAIR_OPTIONS_H
