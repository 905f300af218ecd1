// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LENGTHS_REPEAT_H
#define DSC_LENGTHS_REPEAT_H

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dsc {

/// Returns whether lengths on a surface in u and v are periodic, tested at samples.
/// \param image function of u and v that returns a point in space
template <class Image>
bool lengths_repeat(const Image& image, const std::array<double, 2>& periods) {
  static constexpr int samples = 5;
  static constexpr double short_step = 1e-3, // in periods
      tolerance = 1e-3;                      // relative, for periods with few digits
  const auto length = [&](double u, double v, double du, double dv) {
    const std::array<double, 3> p = image(u, v), q = image(u + du, v + dv);
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  };
  for (int i = 0; i < samples; ++i) {
    // The samples are neither on a line of symmetry nor on a common line.
    const double u = periods[0] * (.1 + .17 * i), v = periods[1] * (.83 - .13 * i * i / samples);
    for (const auto& [a, b] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      const double du = a * short_step * periods[0], dv = b * short_step * periods[1],
                   here = length(u, v, du, dv);
      for (double there : {length(u + periods[0], v, du, dv), length(u, v + periods[1], du, dv)})
        if (!(std::abs(there - here) <= tolerance * std::max(here, there)))
          return false;
    }
  }
  return true;
}

} // namespace dsc

#endif // DSC_LENGTHS_REPEAT_H
