// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_PICTURES_COLORS_H
#define CGAL_MESH_FILES_INTERNAL_PICTURES_COLORS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Color = std::array<double, 3>; // red, green and blue, from 0 to 1

// Returns the color of a label in pictures, films and charts: white for 0, otherwise hues by the
// golden angle. By default, colors are light enough for black lines and for shades.
inline Color color_of_label(int label, double saturation = .55, double lightness = .66) {
  if (label == 0)
    return {1, 1, 1};
  static constexpr double golden_angle = 137.50776405, first_hue = 210;
  const double hue = std::fmod(first_hue + golden_angle * double(std::int64_t(label) - 1), 360.);
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + (hue < 0 ? hue + 360 : hue) / 30, 12.);
    const double a = saturation * (std::min)(lightness, 1 - lightness);
    return lightness - a * (std::max)(-1., (std::min)({k - 3, 9 - k, 1.}));
  };
  return {channel(0), channel(8), channel(4)};
}

// The colors of the map "viridis" at equal distances, from dark blue to yellow.
inline constexpr std::array<Color, 5> color_map = {{{.267, .005, .329},
                                                    {.230, .322, .546},
                                                    {.128, .567, .551},
                                                    {.369, .789, .383},
                                                    {.993, .906, .144}}};

// Returns the color of a number from 0 to 1 in the color map.
inline Color color_of_number(double number) {
  const double place = std::clamp(number, 0., 1.) * double(color_map.size() - 1);
  const std::size_t i = (std::min)(std::size_t(place), color_map.size() - 2);
  Color result;
  for (std::size_t channel = 0; channel < 3; ++channel)
    result[channel] = color_map[i][channel] +
                      (place - double(i)) * (color_map[i + 1][channel] - color_map[i][channel]);
  return result;
}

// Returns a color in the form `#rrggbb` with hexadecimal digits.
inline std::string hexadecimal(const Color& color) {
  char text[8];
  const auto channel = [&](std::size_t i) { return unsigned(std::lround(255 * color[i])) & 255u; };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", channel(0), channel(1), channel(2));
  return text;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_PICTURES_COLORS_H
