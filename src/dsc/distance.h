// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_DISTANCE_H
#define DSC_DISTANCE_H

namespace dsc {

/// A length, in one of two units.
struct Distance
{
  double value;
  bool in_mean_edges; ///< the unit: mean interface edges of the input, or that of the input's
                      ///< coordinates
  bool operator==(const Distance& other) const {
    return value == other.value && in_mean_edges == other.in_mean_edges;
  }
};

} // namespace dsc

#endif // DSC_DISTANCE_H
