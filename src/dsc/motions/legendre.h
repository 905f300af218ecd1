// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LEGENDRE_H
#define DSC_LEGENDRE_H

#include <cstddef>
#include <utility>

namespace dsc {

/// Returns the value of the Legendre polynomial of a degree at z, by recurrence.
inline double legendre(std::size_t degree, double z) {
  double before = 0, value = 1;
  for (std::size_t n = 0; n < degree; ++n)
    before = std::exchange(value, ((2 * double(n) + 1) * z * value - double(n) * before) /
                                      (double(n) + 1));
  return value;
}

} // namespace dsc

#endif // DSC_LEGENDRE_H
