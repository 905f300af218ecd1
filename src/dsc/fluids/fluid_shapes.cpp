// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_shapes.h"

#include "programs/errors.h"

#include <iterator>

namespace dsc {

std::size_t number_of_parts(double parts) {
  static constexpr double most = 1e8;
  if (!(parts <= most))
    throw Input_error("the edge length of the scene is too small for its shapes or its domain; "
                      "choose a larger 'edge'");
  return std::size_t(std::lround((std::max)(1., parts)));
}

std::vector<double> divided_lines(const std::set<double>& lines, double edge) {
  std::vector<double> result = {*lines.begin()};
  for (auto line = std::next(lines.begin()); line != lines.end(); ++line) {
    const double from = *std::prev(line), to = *line;
    const std::size_t parts = number_of_parts((to - from) / edge);
    for (std::size_t i = 1; i < parts; ++i)
      result.push_back(from + (to - from) * double(i) / double(parts));
    result.push_back(to);
  }
  return result;
}

Surface surface_of(const Ball_shape& ball, double edge) {
  // The area of the equilateral triangles on the unit sphere.
  const double area = std::sqrt(3.) / 4 * edge * edge / (ball.radius * ball.radius);
  Run_start start;
  start.ball = Ball{ball.center, ball.radius};
  start.triangles =
      ball.triangles > 0 ? ball.triangles : number_of_parts((std::max)(20., 4 * CGAL_PI / area));
  Surface surface = start_surfaces(start).all.front();
  const Surface_point center(ball.center[0], ball.center[1], ball.center[2]);
  if (ball.mode > 0)
    for (Surface_point& p : surface.points)
      p = center + (1 + ball.amplitude * legendre(ball.mode, (p.z() - center.z()) / ball.radius)) *
                       (p - center);
  return surface;
}

namespace {

/// The surface of a cylinder. Each cap consists of rings of triangles around its center, with six
/// triangles, eighteen and so on, so that all triangles are nearly equilateral. The mantle consists
/// of layers of triangles; successive rings are rotated by half an edge.
class Cylinder_surface
{
public:
  Cylinder_surface(const Cylinder_shape& shape, double edge);

  /// Returns the triangles, oriented outwards.
  Surface surface();

private:
  using Ring = std::vector<std::size_t>;
  using Vector = decltype(Surface_point() - Surface_point());

  std::size_t add(double height, double radius, double angle);
  Ring ring(double height, double radius, std::size_t size, double first_angle);
  void add_triangle(std::size_t a, std::size_t b, std::size_t c, bool is_turned);
  void add_sector(const Ring& inner, const Ring& outer, std::size_t i, std::size_t sector,
                  bool is_turned);
  void add_cap(double height, double first_angle, const Ring& rim, bool is_turned);
  void add_layer(const Ring& below, const Ring& above, bool is_ahead);

  const Cylinder_shape& m_shape;
  Surface_point m_from;
  double m_length;
  Vector m_along, m_u, m_v; // orthonormal
  std::size_t m_rings, m_around, m_layers;
  Surface m_surface;
};

Cylinder_surface::Cylinder_surface(const Cylinder_shape& shape, double edge)
    : m_shape(shape), m_from(shape.from[0], shape.from[1], shape.from[2]) {
  const Vector axis = Surface_point(shape.to[0], shape.to[1], shape.to[2]) - m_from;
  m_length = std::sqrt(axis.squared_length());
  m_along = axis / m_length;
  // Computes a direction across the axis, from the coordinate direction with the smallest
  // component.
  const double x = std::abs(m_along.x()), y = std::abs(m_along.y()), z = std::abs(m_along.z());
  std::array<double, 3> unit = {};
  unit[x <= (std::min)(y, z) ? 0 : y <= z ? 1 : 2] = 1;
  m_u = CGAL::cross_product(m_along, Vector(unit[0], unit[1], unit[2]));
  m_u = m_u / std::sqrt(m_u.squared_length());
  m_v = CGAL::cross_product(m_along, m_u);

  m_rings = number_of_parts(shape.radius / edge);
  m_around = 6 * m_rings;
  m_layers = number_of_parts(m_length / (std::sqrt(.75) * edge));
  number_of_parts(double(m_around) * double(m_layers + m_rings));
}

std::size_t Cylinder_surface::add(double height, double radius, double angle) {
  const double scale =
      radius * (1 + m_shape.amplitude * (m_shape.wave_length > 0
                                             ? std::cos(2 * CGAL_PI * height / m_shape.wave_length)
                                             : 1));
  m_surface.points.push_back(m_from + height * m_along + scale * std::cos(angle) * m_u +
                             scale * std::sin(angle) * m_v);
  return m_surface.points.size() - 1;
}

Cylinder_surface::Ring Cylinder_surface::ring(double height, double radius, std::size_t size,
                                              double first_angle) {
  Ring result;
  for (std::size_t k = 0; k < size; ++k)
    result.push_back(add(height, radius, first_angle + 2 * CGAL_PI * double(k) / double(size)));
  return result;
}

void Cylinder_surface::add_triangle(std::size_t a, std::size_t b, std::size_t c, bool is_turned) {
  m_surface.triangles.push_back(is_turned ? std::array<std::size_t, 3>{a, c, b}
                                          : std::array<std::size_t, 3>{a, b, c});
}

/// Adds a sixth of the triangles between the rings i - 1 and i of a cap.
void Cylinder_surface::add_sector(const Ring& inner, const Ring& outer, std::size_t i,
                                  std::size_t sector, bool is_turned) {
  const auto at = [&](const Ring& r, std::size_t size, std::size_t index) {
    return size == 0 ? r[0] : r[(sector * size + index) % r.size()];
  };
  for (std::size_t k = 0; k < i; ++k) {
    add_triangle(at(inner, i - 1, k), at(outer, i, k), at(outer, i, k + 1), is_turned);
    if (k + 1 < i)
      add_triangle(at(inner, i - 1, k), at(outer, i, k + 1), at(inner, i - 1, k + 1), is_turned);
  }
}

void Cylinder_surface::add_cap(double height, double first_angle, const Ring& rim, bool is_turned) {
  Ring inner = {add(height, 0, 0)};
  for (std::size_t i = 1; i <= m_rings; ++i) {
    const Ring outer = i == m_rings ? rim
                                    : ring(height, m_shape.radius * double(i) / double(m_rings),
                                           6 * i, first_angle);
    for (std::size_t sector = 0; sector < 6; ++sector)
      add_sector(inner, outer, i, sector, is_turned);
    inner = outer;
  }
}

/// Adds the triangles between two rings. If `is_ahead`, `above` is rotated forwards by half an
/// edge, otherwise backwards.
void Cylinder_surface::add_layer(const Ring& below, const Ring& above, bool is_ahead) {
  for (std::size_t k = 0; k < m_around; ++k) {
    const std::size_t next = (k + 1) % m_around;
    if (is_ahead) {
      add_triangle(below[k], below[next], above[k], false);
      add_triangle(below[next], above[next], above[k], false);
    } else {
      add_triangle(below[k], above[next], above[k], false);
      add_triangle(below[k], below[next], above[next], false);
    }
  }
}

Surface Cylinder_surface::surface() {
  const double half = CGAL_PI / double(m_around);
  Ring below = ring(0, m_shape.radius, m_around, 0);
  add_cap(0, 0, below, true);
  for (std::size_t layer = 1; layer <= m_layers; ++layer) {
    const bool is_ahead = layer % 2 == 1;
    const Ring above =
        ring(layer == m_layers ? m_length : m_length * double(layer) / double(m_layers),
             m_shape.radius, m_around, is_ahead ? half : 0);
    add_layer(below, above, is_ahead);
    below = above;
  }
  add_cap(m_length, m_layers % 2 == 1 ? half : 0, below, false);
  return m_surface;
}

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

bool is_about(const Cylinder_shape& column, const std::array<double, 3>& place) {
  const Surface_point p(place[0], place[1], place[2]),
      from(column.from[0], column.from[1], column.from[2]),
      to(column.to[0], column.to[1], column.to[2]);
  const double part = (p - from) * (to - from) / (to - from).squared_length();
  return part > 0 && part < 1 &&
         (p - from - part * (to - from)).squared_length() <
             std::pow(column.radius * (1 + std::abs(column.amplitude)), 2);
}

} // namespace

Surface surface_of(const Cylinder_shape& shape, double edge) {
  return Cylinder_surface(shape, edge).surface();
}

bool is_about(const Fluid_shape& shape, const std::array<double, 3>& p, int dimension) {
  if (const auto* ball = std::get_if<Ball_shape>(&shape))
    return distance(p, ball->center) < ball->radius * (1 + std::abs(ball->amplitude));
  if (const auto* file = std::get_if<File_shape>(&shape))
    return distance(p, file->ball.center) < file->ball.radius;
  if (const auto* block = std::get_if<Box_shape>(&shape)) {
    for (std::size_t i = 0; i < std::size_t(dimension); ++i)
      if (!(p[i] >= block->from[i] && p[i] <= block->to[i])) // touching boxes have no gap
        return false;
    return true;
  }
  if (const auto* column = std::get_if<Cylinder_shape>(&shape))
    return is_about(*column, p);
  if (const auto* pool = std::get_if<Pool_shape>(&shape))
    return p[std::size_t(dimension - 1)] < pool->level;
  return true;
}

} // namespace dsc
