// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_DOMAIN_BOX_H
#define DSC_DOMAIN_BOX_H

#include "programs/errors.h"

#include <CGAL/Complex_construction/Construction_options.h>

#include <array>

namespace dsc {

/// Returns the box with given least and greatest coordinates; in the plane without those of z.
template <int dimension> auto box_of_dimension(const std::array<double, 6>& d) {
  if constexpr (dimension == 2)
    return CGAL::Bbox_2(d[0], d[1], d[3], d[4]);
  else
    return CGAL::Bbox_3(d[0], d[1], d[2], d[3], d[4], d[5]);
}

/// Returns the options of a complex with normalized coordinates, in a given or the default domain.
inline DSC::Construction_options<3> normalized(const std::optional<std::array<double, 6>>& domain,
                                               const DSC::Thin_part_options& thin_parts) {
  DSC::Construction_options<3> result;
  result.normalize = true;
  result.thin_parts = thin_parts;
  if (domain)
    result.enclosing_box = box_of_dimension<3>(*domain);
  return result;
}

} // namespace dsc

#endif // DSC_DOMAIN_BOX_H
