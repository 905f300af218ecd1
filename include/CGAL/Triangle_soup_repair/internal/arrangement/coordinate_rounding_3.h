// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Triangle_soup_repair, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_COORDINATE_ROUNDING_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_COORDINATE_ROUNDING_3_H

#include <CGAL/license/Triangle_soup_repair.h>

#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the number of decimal digits of the shortest text that reads as a number.
inline int decimal_digits(double x) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific).ptr;
  return int(std::count_if(text.data(), std::find(text.data(), end, 'e'),
                           [](char c) { return c >= '0' && c <= '9'; }));
}

// Returns a distance that exceeds the rounding of coordinates a few times: points that were
// computed to be in one plane, rotated, and written to a file are nearer to this plane. The
// rounding is that of the file, which may have numbers of type `float` or of a few decimal digits.
// Coordinates with five digits or less are taken for exact.
inline double rounding_distance(const std::vector<Coordinates_3>& points) {
  static constexpr double of_double = 0x1p-40;             // of the largest coordinate
  static constexpr double units = 6;                       // in the last place
  static constexpr int least_digits = 6, most_digits = 12; // more digits are those of `double`
  static constexpr int bits_of_float = 24;
  double largest = 0;
  int digits = 0;
  bool are_floats = true;
  for (const Coordinates_3& p : points)
    for (const double x : p) {
      largest = (std::max)(largest, std::abs(x));
      are_floats = are_floats && double(float(x)) == x;
      if (digits <= most_digits)
        digits = (std::max)(digits, decimal_digits(x));
    }
  if (largest > 0 && digits >= least_digits && digits <= most_digits)
    return units * std::pow(10, std::floor(std::log10(largest)) + 1 - digits);
  if (largest > 0 && are_floats && digits > most_digits)
    return units * std::ldexp(1, std::ilogb(largest) + 1 - bits_of_float);
  return largest * of_double;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_COORDINATE_ROUNDING_3_H
