// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/picture.h"

#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <png.h>

#include <limits>

namespace dsc {
namespace {

using Vector = CGAL::Epick::Vector_3;

constexpr int side = 800, samples = 2; // size in pixels; samples along the side of a pixel
constexpr int points = side * samples;

Vector unit(const Vector& a) { return a / std::sqrt(a.squared_length()); }

/// Returns a point in the axes of the picture: to the right, upwards, and towards the viewer.
Vector seen(const Picture_point& point, bool is_in_space) {
  static const Vector eye = unit(Vector(.55, -1, .5)),
                      right = unit(CGAL::cross_product(Vector(0, 0, 1), eye)),
                      up = CGAL::cross_product(eye, right);
  const Vector p(point[0], point[1], point[2]);
  return is_in_space ? Vector(right * p, up * p, eye * p) : p;
}

/// Returns the color of a triangle in the axes of the picture. Both sides are lit, because surfaces
/// may be open.
Picture_color shaded(const Picture_color& color, const std::array<Vector, 3>& t) {
  static constexpr double ambient = .35;
  const Vector light = unit(Vector(-.4, .5, 1)),
               normal = unit(CGAL::cross_product(t[1] - t[0], t[2] - t[0]));
  const double shade =
      ambient + (1 - ambient) * (std::max)(0., light * normal * (normal.z() < 0 ? -1 : 1));
  return {color[0] * shade, color[1] * shade, color[2] * shade};
}

class Canvas
{
public:
  Canvas()
      : m_depths(std::size_t(points) * points, -std::numeric_limits<double>::infinity()),
        m_colors(m_depths.size(), Picture_color{1, 1, 1}) {}

  /// Draws a triangle whose corners have sample coordinates and depths.
  void draw(const std::array<Vector, 3>& t, const Picture_color& color) {
    const double area = (t[1].x() - t[0].x()) * (t[2].y() - t[0].y()) -
                        (t[1].y() - t[0].y()) * (t[2].x() - t[0].x());
    if (area == 0)
      return;
    const auto bounds = [&](int axis) {
      const auto [least, most] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
      return std::make_pair((std::max)(0, int(std::floor(least))),
                            (std::min)(points - 1, int(std::ceil(most))));
    };
    const auto [x0, x1] = bounds(0);
    const auto [y0, y1] = bounds(1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        double depth = 0;
        bool is_inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const Vector &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
          const double weight =
              ((b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x())) / area;
          is_inside = is_inside && weight >= 0;
          depth += weight * t[i].z();
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
  std::vector<Picture_color> m_colors;
};

/// Returns a point of a picture in coordinates of samples, so that a box is visible. The depth has
/// the same unit.
Vector fitted(const CGAL::Bbox_2& box, const Vector& p) {
  static constexpr double margin = .05; // relative to the side
  const double extent = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), 1e-300}),
               scale = (1 - 2 * margin) * points / extent;
  return {points / 2. + scale * (p.x() - (box.xmin() + box.xmax()) / 2),
          points / 2. + scale * (p.y() - (box.ymin() + box.ymax()) / 2), scale * p.z()};
}

void write_png(const std::string& path, const Canvas& canvas) {
  const std::vector<png_byte> pixels = canvas.pixels();
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = side;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    throw std::bad_alloc();
  bytes.resize(size);
  DSC::replace_file(path, [&](std::ostream& out) { out << bytes; });
}

/// Draws a line in front of the plane with depth 0. The ends have sample coordinates.
void draw_line(Canvas& canvas, const Vector& a, const Vector& b, const Picture_color& color) {
  static constexpr double half_width = 1.5; // in samples
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::hypot(dx, dy);
  if (!(length > 0))
    return;
  const double x = -half_width * dy / length, y = half_width * dx / length;
  const Vector p(a.x() - x, a.y() - y, 1), q(b.x() - x, b.y() - y, 1), r(b.x() + x, b.y() + y, 1),
      s(a.x() + x, a.y() + y, 1);
  canvas.draw({p, q, r}, color);
  canvas.draw({p, r, s}, color);
}

} // namespace

void write_picture(const std::string& path, const Picture& picture) {
  CGAL::Bbox_2 box;
  for (const Picture_polygon& polygon : picture.polygons)
    for (const Picture_point& p : polygon.corners) {
      const Vector q = seen(p, picture.is_in_space);
      box += CGAL::Bbox_2(q.x(), q.y(), q.x(), q.y());
    }
  const auto sample = [&](const Picture_point& p) {
    return fitted(box, seen(p, picture.is_in_space));
  };
  Canvas canvas;
  for (const auto& [corners, color] : picture.polygons)
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const std::array<Vector, 3> t = {sample(corners[0]), sample(corners[i - 1]),
                                       sample(corners[i])};
      canvas.draw(t, picture.is_in_space ? shaded(color, t) : color);
    }
  for (const auto& [ends, color] : picture.lines)
    draw_line(canvas, sample(ends[0]), sample(ends[1]), color);
  write_png(path, canvas);
}

} // namespace dsc
