// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/picture.h"

#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dsc {
namespace {

using Vector = std::array<double, 3>;

constexpr int side = 800, samples = 2; // size in pixels; samples along the side of a pixel
constexpr int points = side * samples;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// The axes of the picture: to the right, upwards, and towards the viewer.
struct View
{
  Vector eye = unit({.55, -1, .5});
  Vector right = unit(cross({0, 0, 1}, eye));
  Vector up = cross(eye, right);

  Vector seen(const Vector& p) const { return {dot(right, p), dot(up, p), dot(eye, p)}; }
};

/// Returns the color of a label, light enough to be shaded.
Vector color(int label) {
  static constexpr std::array<Vector, 6> colors = {
      {{.55, .7, .9}, {.95, .7, .45}, {.6, .85, .6}, {.85, .6, .8}, {.9, .85, .5}, {.6, .85, .85}}};
  return colors[std::size_t(std::abs(label - 1)) % colors.size()];
}

class Canvas
{
public:
  Canvas()
      : m_depths(std::size_t(points) * points, -std::numeric_limits<double>::infinity()),
        m_colors(m_depths.size(), Vector{1, 1, 1}) {}

  /// Draws a triangle whose corners have sample coordinates and depths.
  void draw(const std::array<Vector, 3>& t, const Vector& color) {
    const double area =
        (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
    if (area == 0)
      return;
    const auto bounds = [&](std::size_t axis) {
      const auto [least, most] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
      return std::make_pair(std::max(0, int(std::floor(least))),
                            std::min(points - 1, int(std::ceil(most))));
    };
    const auto [x0, x1] = bounds(0);
    const auto [y0, y1] = bounds(1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        double depth = 0;
        bool is_inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const Vector &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
          const double weight = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
          is_inside = is_inside && weight >= 0;
          depth += weight * t[i][2];
        }
        const std::size_t at = std::size_t(y) * points + std::size_t(x);
        if (is_inside && depth > m_depths[at]) {
          m_depths[at] = depth;
          m_colors[at] = color;
        }
      }
  }

  /// Returns the pixels, row by row from the top.
  std::vector<png_byte> pixels() const {
    std::vector<png_byte> result;
    for (int y = side; y-- > 0;)
      for (int x = 0; x < side; ++x)
        for (std::size_t channel = 0; channel < 3; ++channel) {
          double sum = 0;
          for (int i = 0; i < samples; ++i)
            for (int j = 0; j < samples; ++j)
              sum += m_colors[std::size_t(samples * y + i) * points + std::size_t(samples * x + j)]
                             [channel];
          result.push_back(png_byte(std::lround(255 * sum / (samples * samples))));
        }
    return result;
  }

private:
  std::vector<double> m_depths;
  std::vector<Vector> m_colors;
};

/// Maps the plane of a picture to samples. The points that were added are visible.
class Fit
{
public:
  void add(double x, double y) {
    const std::array<double, 2> p = {x, y};
    for (std::size_t i = 0; i < 2; ++i) {
      m_least[i] = std::min(m_least[i], p[i]);
      m_most[i] = std::max(m_most[i], p[i]);
    }
  }

  /// Returns the coordinates of a sample, and the depth in the same unit.
  Vector operator()(const Vector& p) const {
    static constexpr double margin = .05; // relative to the side
    const double extent = std::max({m_most[0] - m_least[0], m_most[1] - m_least[1], 1e-300}),
                 scale = (1 - 2 * margin) * points / extent;
    return {points / 2. + scale * (p[0] - (m_least[0] + m_most[0]) / 2),
            points / 2. + scale * (p[1] - (m_least[1] + m_most[1]) / 2), scale * p[2]};
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> m_least = {infinity, infinity}, m_most = {-infinity, -infinity};
};

void write_png(const std::string& path, const Canvas& canvas) {
  const std::vector<png_byte> pixels = canvas.pixels();
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = side;
  image.format = PNG_FORMAT_RGB;
  CGAL::Deformable_simplicial_complexes::replace_file(path, [&](const std::string& name) {
    return png_image_write_to_file(&image, name.c_str(), 0, pixels.data(), 0, nullptr) != 0;
  });
}

/// Draws a black line in front of the plane with depth 0. The ends have sample coordinates.
void draw_line(Canvas& canvas, const Vector& a, const Vector& b, const Vector& color) {
  static constexpr double half_width = 1.5; // in samples
  const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
  if (!(length > 0))
    return;
  const double x = -half_width * dy / length, y = half_width * dx / length;
  const Vector p = {a[0] - x, a[1] - y, 1}, q = {b[0] - x, b[1] - y, 1},
               r = {b[0] + x, b[1] + y, 1}, s = {a[0] + x, a[1] + y, 1};
  canvas.draw({p, q, r}, color);
  canvas.draw({p, r, s}, color);
}

} // namespace

void write_picture(const std::string& path, const std::vector<Picture_triangle>& triangles) {
  const View view;
  Fit fit;
  for (const Picture_triangle& t : triangles)
    for (const Vector& p : t.corners) {
      const Vector q = view.seen(p);
      fit.add(q[0], q[1]);
    }
  Canvas canvas;
  const Vector light = unit({-.4, .5, 1}); // in the axes of the picture
  for (const Picture_triangle& t : triangles) {
    std::array<Vector, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = fit(view.seen(t.corners[i]));
    Vector a, b;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = corners[1][i] - corners[0][i];
      b[i] = corners[2][i] - corners[0][i];
    }
    Vector normal = cross(a, b);
    if (dot(normal, normal) == 0)
      continue;
    normal = unit(normal);
    // Both sides of a triangle are lit, because surfaces may be open.
    static constexpr double ambient = .35;
    const double shade =
        ambient + (1 - ambient) * std::max(0., dot(light, normal) * (normal[2] < 0 ? -1 : 1));
    Vector shaded = color(t.label);
    for (double& c : shaded)
      c *= shade;
    canvas.draw(corners, shaded);
  }
  write_png(path, canvas);
}

void write_picture(const std::string& path, const Plane_picture& picture) {
  Fit fit;
  for (const Picture_polygon& polygon : picture.polygons)
    for (const Picture_point& p : polygon.corners)
      fit.add(p[0], p[1]);
  const auto sample = [&](const Picture_point& p) { return fit({p[0], p[1], 0}); };
  Canvas canvas;
  for (const Picture_polygon& polygon : picture.polygons)
    for (std::size_t i = 2; i < polygon.corners.size(); ++i)
      canvas.draw(
          {sample(polygon.corners[0]), sample(polygon.corners[i - 1]), sample(polygon.corners[i])},
          polygon.color);
  for (const Picture_line& line : picture.lines)
    draw_line(canvas, sample(line.ends[0]), sample(line.ends[1]), line.color);
  write_png(path, canvas);
}

Picture_color picture_color(int label) { return label == 0 ? Vector{1, 1, 1} : color(label); }

Picture_color color_of_number(double number) {
  // The colors of the map "viridis" at equal distances.
  static constexpr std::array<Picture_color, 5> colors = {{{.267, .005, .329},
                                                           {.230, .322, .546},
                                                           {.128, .567, .551},
                                                           {.369, .789, .383},
                                                           {.993, .906, .144}}};
  const double place = std::clamp(number, 0., 1.) * double(colors.size() - 1);
  const std::size_t i = std::min(std::size_t(place), colors.size() - 2);
  Picture_color result;
  for (std::size_t channel = 0; channel < 3; ++channel)
    result[channel] =
        colors[i][channel] + (place - double(i)) * (colors[i + 1][channel] - colors[i][channel]);
  return result;
}

} // namespace dsc
