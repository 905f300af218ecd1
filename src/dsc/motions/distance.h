// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_DISTANCE_H
#define DSC_DISTANCE_H

namespace dsc {

/// A length in one of two units.
struct Distance
{
  double value;
  bool in_mean_edges; ///< unit: mean interface edge of the input if true, otherwise the unit
                      ///< of the input coordinates
  bool operator==(const Distance& other) const {
    return value == other.value && in_mean_edges == other.in_mean_edges;
  }
};

} // namespace dsc

#endif // DSC_DISTANCE_H
