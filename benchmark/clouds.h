// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_CLOUDS_H
#define DSC_BENCHMARK_CLOUDS_H

#include "gear.h"
#include "inputs.h"

#include <CGAL/Random.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

/// Points of known surfaces; their kernel is the kernel of surfaces.
namespace dsc_benchmark::clouds {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

/// Points, and known properties of their surface.
struct Cloud
{
  std::vector<Point> points;
  std::function<double(const Point&)> distance; ///< distance from the surface, or empty
  std::vector<Point> creases = {};              ///< points on sharp edges
  double volume = 0;                            ///< 0 if not known
  std::vector<Point> outliers = {};             ///< points that are not on the surface
};

/// Uniform and normally distributed random numbers.
class Numbers
{
public:
  explicit Numbers(unsigned seed) : m_random(seed) {}

  double uniform(double low, double high) { return m_random.uniform_real(low, high); }
  double normal() {
    const double u = 1 - m_random.get_double(), v = m_random.get_double();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * CGAL_PI * v);
  }
  Vector vector() {
    const double x = normal(), y = normal(), z = normal(); // evaluated in this order
    return {x, y, z};
  }
  Vector direction() {
    const Vector v = vector();
    return v / std::sqrt(v.squared_length());
  }

private:
  CGAL::Random m_random;
};

/// Returns a uniformly distributed rotation about the origin.
class Turn
{
public:
  explicit Turn(Numbers& numbers) {
    m_axes[0] = numbers.direction();
    const Vector v = CGAL::cross_product(m_axes[0], numbers.direction());
    m_axes[1] = v / std::sqrt(v.squared_length());
    m_axes[2] = CGAL::cross_product(m_axes[0], m_axes[1]);
  }

  Point operator()(double x, double y, double z) const {
    return CGAL::ORIGIN + (x * m_axes[0] + y * m_axes[1] + z * m_axes[2]);
  }
  Point operator()(const Point& p) const { return (*this)(p.x(), p.y(), p.z()); }
  Point back(const Point& p) const {
    const Vector v = p - CGAL::ORIGIN;
    return {v * m_axes[0], v * m_axes[1], v * m_axes[2]};
  }

private:
  std::array<Vector, 3> m_axes;
};

/// Returns the mean distance of uniform random points in a plane from their six nearest neighbors.
/// `area` is the area per point.
inline double spacing_on_plane(double area) {
  // The mean distance to the k-th neighbor is Gamma(k + 1/2) / Gamma(k) / sqrt(pi) times the root
  // of the area.
  static constexpr double factor = .9775;
  return factor * std::sqrt(area);
}

/// A box with a square base about the origin, with a hole along the z axis. If the radius is 0,
/// there is no hole.
class Drilled_box
{
public:
  Drilled_box(double width, double height, double hole)
      : m_half(width / 2), m_top(height / 2), m_hole(hole) {}

  double volume() const { return 2 * m_top * cover(); }
  double area() const { return 2 * cover() + 4 * side() + wall(); }

  Point sample(Numbers& numbers) const {
    const double s = numbers.uniform(0, area()), z = numbers.uniform(-m_top, m_top);
    if (s < 2 * cover()) {
      double x, y;
      do {
        x = numbers.uniform(-m_half, m_half);
        y = numbers.uniform(-m_half, m_half);
      } while (x * x + y * y < m_hole * m_hole);
      return {x, y, s < cover() ? m_top : -m_top};
    }
    if (s < 2 * cover() + 4 * side()) {
      const int k = int((s - 2 * cover()) / side());
      const double u = numbers.uniform(-m_half, m_half), w = k % 2 == 0 ? m_half : -m_half;
      return k < 2 ? Point(w, u, z) : Point(u, w, z);
    }
    const double a = numbers.uniform(0, 2 * CGAL_PI);
    return {m_hole * std::cos(a), m_hole * std::sin(a), z};
  }

  double distance(const Point& p) const {
    const double x = std::abs(p.x()), y = std::abs(p.y()), z = std::abs(p.z()),
                 r = std::hypot(x, y);
    const auto beyond = [](double q, double end) { return (std::max)(0., q - end); };
    const double of_cover = std::hypot(
        z - m_top, r < m_hole ? m_hole - r : std::hypot(beyond(x, m_half), beyond(y, m_half)));
    const double of_wall = m_hole > 0 ? std::hypot(r - m_hole, beyond(z, m_top)) : of_cover;
    const auto of_side = [&](double u, double w) {
      return std::hypot(u - m_half, std::hypot(beyond(w, m_half), beyond(z, m_top)));
    };
    return (std::min)({of_cover, of_wall, of_side(x, y), of_side(y, x)});
  }

  std::vector<Point> creases() const {
    static constexpr int n = 400; // points on each edge
    std::vector<Point> result;
    for (int i = 0; i < n; ++i) {
      const double t = 2 * (i + .5) / n - 1, a = CGAL_PI * t;
      for (double u : {-m_half, m_half}) {
        for (double z : {-m_top, m_top}) {
          result.emplace_back(t * m_half, u, z);
          result.emplace_back(u, t * m_half, z);
        }
        for (double w : {-m_half, m_half})
          result.emplace_back(u, w, t * m_top);
      }
      for (double z : {-m_top, m_top})
        if (m_hole > 0)
          result.emplace_back(m_hole * std::cos(a), m_hole * std::sin(a), z);
    }
    return result;
  }

private:
  // Areas
  double cover() const { return 4 * m_half * m_half - CGAL_PI * m_hole * m_hole; }
  double side() const { return 4 * m_half * m_top; }
  double wall() const { return 4 * CGAL_PI * m_hole * m_top; }

  double m_half, m_top, m_hole;
};

/// Points of a rotated box with normally distributed noise along each axis. There are no points
/// within half a gap of the middle of a side.
inline Cloud drilled_box(const Drilled_box& box, std::size_t n, unsigned seed, double noise = 0,
                         double gap = 0) {
  Numbers numbers(seed);
  const Turn turn(numbers);
  Cloud cloud{
      {}, [box, turn](const Point& p) { return box.distance(turn.back(p)); }, {}, box.volume()};
  for (const Point& p : box.creases())
    cloud.creases.push_back(turn(p));
  const Point middle(1, 0, 0);
  while (cloud.points.size() < n) {
    const Point p = box.sample(numbers);
    if (CGAL::squared_distance(p, middle) >= gap * gap / 4)
      cloud.points.push_back(turn(p) + noise * numbers.vector());
  }
  return cloud;
}

/// Points of a rotated gear with 12 teeth, one in each grid cell of the given side length, with
/// normally distributed noise along each axis.
inline Cloud gear(double side, unsigned seed, double noise = 0) {
  static constexpr unsigned teeth = 12;
  Numbers numbers(seed);
  const Turn turn(numbers);
  const Gear gear(teeth);
  Cloud cloud{
      {}, [gear, turn](const Point& p) { return gear.distance(turn.back(p)); }, {}, gear.volume()};
  for (const Point& p : gear.creases())
    cloud.creases.push_back(turn(p));
  for (const Point& p : gear.sample(side, [&] { return numbers.uniform(0, 1); }))
    cloud.points.push_back(turn(p) + noise * numbers.vector());
  return cloud;
}

/// Adds random points in a box around a cloud.
inline void add_outliers(Cloud& cloud, double part, unsigned seed) {
  Numbers numbers(seed);
  CGAL::Bbox_3 box;
  for (const Point& p : cloud.points)
    box += p.bbox();
  for (std::size_t i = 0; double(i) < part * double(cloud.points.size()); ++i) {
    std::array<double, 3> x;
    for (int axis = 0; axis < 3; ++axis)
      x[std::size_t(axis)] = numbers.uniform(box.min(axis), box.max(axis));
    cloud.outliers.emplace_back(x[0], x[1], x[2]);
  }
}

struct Sphere
{
  std::size_t points;
  double x, radius; ///< inner spheres, which are voids, have a radius less than 1
};

/// Points of spheres about (x, 0, 0), rotated.
inline Cloud spheres(const std::vector<Sphere>& spheres, unsigned seed) {
  Numbers numbers(seed);
  const Turn turn(numbers);
  Cloud cloud;
  for (const Sphere& s : spheres) {
    for (std::size_t i = 0; i < s.points; ++i)
      cloud.points.push_back(turn(s.x, 0, 0) + s.radius * numbers.direction());
    cloud.volume += (s.radius < 1 ? -1 : 1) * 4 * CGAL_PI / 3 * std::pow(s.radius, 3);
  }
  cloud.distance = [spheres, turn](const Point& p) {
    double result = 10;
    for (const Sphere& s : spheres)
      result = (std::min)(
          result, std::abs(std::sqrt(CGAL::squared_distance(p, turn(s.x, 0, 0))) - s.radius));
    return result;
  };
  return cloud;
}

/// Returns uniform points on a closed surface, rotated; `distances` gives the distance from
/// triangles.
template <class Distances> Cloud of_surface(const Surface& surface, std::size_t n, unsigned seed) {
  Numbers numbers(seed);
  const Turn turn(numbers);
  std::vector<Kernel::Triangle_3> triangles;
  std::vector<double> areas = {0};
  Cloud cloud;
  for (const auto& t : surface.triangles) {
    const Point &p = surface.points[t[0]], &q = surface.points[t[1]], &r = surface.points[t[2]];
    triangles.emplace_back(turn(p), turn(q), turn(r));
    areas.push_back(areas.back() + std::sqrt(triangles.back().squared_area()));
    cloud.volume += CGAL::determinant(p - CGAL::ORIGIN, q - CGAL::ORIGIN, r - CGAL::ORIGIN) / 6;
  }
  cloud.volume = std::abs(cloud.volume);
  for (std::size_t i = 0; i < n; ++i) {
    const double s = numbers.uniform(0, areas.back());
    const auto place = std::upper_bound(areas.begin() + 1, areas.end() - 1, s) - areas.begin() - 1;
    const auto& t = triangles[std::size_t(place)];
    double u = numbers.uniform(0, 1), v = numbers.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    cloud.points.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
  }
  const auto distances = std::make_shared<Distances>(std::move(triangles));
  cloud.distance = [distances](const Point& p) { return (*distances)(p); };
  return cloud;
}

} // namespace dsc_benchmark::clouds

#endif // DSC_BENCHMARK_CLOUDS_H
