// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes cut loci on tori, ellipsoids, bumpy surfaces and a height field, and compares distances
// at their points with the distances of a fan of geodesics. Prints a table.

#include "geodesic_fan.h"

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>
#include <CGAL/number_utils.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Point = CGAL::Epick::Point_2;
using geodesic_fan::Vector;
using Triple = std::array<double, 3>;

// Each surface is given twice: for the library as the image of a chart or of the unit sphere, and
// for the fan of geodesics as the zeros of a function in space.

// A torus whose small radius varies along the large circle.
struct Torus
{
  double large, small, part = 0;

  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    using std::sin;
    const T r = small * (1. + part * cos(2. * u)), radius = large + r * cos(v);
    return {radius * cos(u), radius * sin(u), r * sin(v)};
  }
  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    using std::sqrt;
    const T squared = x * x + y * y, distance = sqrt(squared) - large,
            r = small * (1. + part * (x * x - y * y) / squared);
    return distance * distance + z * z - r * r;
  }
  Triple periods() const { return {0, 0, 0}; }
};

struct Height_field
{
  double height;

  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    return {u, v, heights(u, v)};
  }
  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    return z - heights(x, y);
  }
  Triple periods() const { return {2 * CGAL_PI, 2 * CGAL_PI, 0}; }

private:
  template <class T> T heights(const T& x, const T& y) const {
    using std::cos;
    return height * (cos(x) * cos(y) + .5 * cos(x) + .25 * cos(2. * y));
  }
};

struct Ellipsoid
{
  Triple axes;

  template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const {
    return {axes[0] * n[0], axes[1] * n[1], axes[2] * n[2]};
  }
  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    return x * x / (axes[0] * axes[0]) + y * y / (axes[1] * axes[1]) + z * z / (axes[2] * axes[2]) -
           1.;
  }
  Triple periods() const { return {0, 0, 0}; }
};

struct Bumps
{
  double height;

  template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const {
    const T radius = 1. + 3. * height * n[0] * n[1] * n[2];
    return {radius * n[0], radius * n[1], radius * n[2]};
  }
  template <class T> T operator()(const T& x, const T& y, const T& z) const {
    using std::sqrt;
    const T squared = x * x + y * y + z * z, radius = sqrt(squared);
    return radius - 1. - 3. * height * x * y * z / (squared * radius);
  }
  Triple periods() const { return {0, 0, 0}; }
};

// Cut loci of one point on one surface, and the position of the point in space.
struct Found
{
  DSC::Cut_locus_2 locus;
  std::vector<Vector> positions; // of vertices
  double seconds;                // processor time
};

// Returns the length of the vector from a point to the parabola through three points.
template <class Fan>
double distance_from_parabola(const Fan& fan, const Vector& p,
                              const std::array<Vector, 3>& points) {
  static constexpr int iterations = 10;
  const Vector before = fan.difference(points[1], points[0]),
               after = fan.difference(points[1], points[2]), to = fan.difference(points[1], p);
  const double a = before.norm(), b = after.norm();
  if (!(a > 0 && b > 0))
    return to.norm();
  // t (first + t second), by chord lengths
  const Vector second = (after / b + before / a) / (a + b), first = after / b - b * second;
  double t = 0;
  for (int i = 0; i < iterations; ++i) {
    const Vector tangent = first + 2 * t * second;
    t += (to - t * (first + t * second)).dot(tangent) / tangent.squaredNorm();
    t = (std::max)(-a, (std::min)(b, t));
  }
  return (to - t * (first + t * second)).norm();
}

// Returns the largest distance of the reflected graph from the graph. Ends and junctions are
// compared with each other, other vertices with parabolas through three vertices.
template <class Fan>
double asymmetry(const Fan& fan, const Found& found,
                 const std::function<Vector(const Vector&)>& mirror) {
  const auto& vertices = found.locus.vertices;
  const std::vector<Vector>& positions = found.positions;
  double worst = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector p = mirror(positions[i]);
    double nearest = std::numeric_limits<double>::infinity();
    if (vertices[i].multiplicity != 2) {
      for (std::size_t j = 0; j < vertices.size(); ++j)
        if (vertices[j].multiplicity == vertices[i].multiplicity)
          nearest = (std::min)(nearest, fan.difference(p, positions[j]).norm());
    } else {
      for (const auto& arc : found.locus.polylines)
        for (std::size_t k = 1; k + 1 < arc.size(); ++k)
          nearest =
              (std::min)(nearest, distance_from_parabola(fan, p,
                                                         {positions[arc[k - 1]], positions[arc[k]],
                                                          positions[arc[k + 1]]}));
    }
    worst = (std::max)(worst, nearest);
  }
  return worst;
}

// A named surface with a point.
struct Case
{
  std::string name;
  Vector source;               // in space
  std::vector<Vector> mirrors; // normals of planes of symmetry through origin and source
};

class Table
{
public:
  Table(int rays, const std::string& only) : m_rays(rays), m_only(only) {}

  static void begin() {
    std::printf("| surface and point | arcs | vertices | complete | doubtful | largest error of "
                "distance | asymmetry | s |\n"
                "| --- | ---: | ---: | --- | ---: | ---: | ---: | ---: |\n");
  }

  bool wants(const std::string& name) const { return name.find(m_only) != std::string::npos; }

  // Computes the cut locus with the library, and compares it with a fan of geodesics.
  template <class Implicit, class Find, class Image>
  void add(const Case& c, const Implicit& implicit, const Find& find, const Image& image) {
    if (!wants(c.name))
      return;
    ++m_number;
    try {
      const std::clock_t start = std::clock();
      Found found = {find(), {}, 0};
      found.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      for (const auto& vertex : found.locus.vertices)
        found.positions.push_back(image(vertex.point));
      add_row(c, geodesic_fan::Fan<Implicit>(implicit, c.source), found);
    } catch (const std::exception& error) {
      std::printf("| %s | | | %s | | | | |\n", c.name.c_str(), error.what());
    }
    std::fflush(stdout);
  }

  void end() const {
    std::printf("\n%d of %d complete, largest error of these %.1e\n", m_complete, m_number,
                m_worst);
  }

private:
  template <class Fan> void add_row(const Case& c, Fan fan, const Found& found) {
    static constexpr std::size_t most_points = 200;
    const auto& vertices = found.locus.vertices;
    std::vector<Vector> points;
    std::vector<double> claimed;
    const std::size_t number = (std::min)(most_points, vertices.size());
    for (std::size_t k = 0; k < number; ++k) {
      const std::size_t i = k * vertices.size() / number;
      points.push_back(found.positions[i]);
      claimed.push_back(vertices[i].distance);
    }
    double error = 0, asymmetric = 0;
    if (m_rays > 0 && number > 0) {
      static constexpr double margin = 1.02; // beyond the largest distance
      const double farthest = *std::max_element(claimed.begin(), claimed.end());
      const auto distances = fan.distances(points, margin * farthest, m_rays);
      for (std::size_t k = 0; k < number; ++k)
        error = (std::max)(error, std::abs(distances[k] - claimed[k]));
    }
    for (const Vector& normal : c.mirrors)
      asymmetric = (std::max)(asymmetric, asymmetry(fan, found, [&](const Vector& p) -> Vector {
                                return p - 2 * p.dot(normal) * normal;
                              }));
    std::printf("| %s | %zu | %zu | %s | %zu | %.1e | %s | %.1f |\n", c.name.c_str(),
                found.locus.polylines.size(), vertices.size(),
                found.locus.is_complete ? "yes" : "no", found.locus.doubtful.size(), error,
                c.mirrors.empty() ? "" : text(asymmetric).c_str(), found.seconds);
    if (found.locus.is_complete) {
      ++m_complete;
      m_worst = (std::max)(m_worst, error);
    }
  }

  static std::string text(double x) {
    char result[20];
    std::snprintf(result, sizeof result, "%.1e", x);
    return result;
  }

  int m_rays, m_number = 0, m_complete = 0;
  std::string m_only;
  double m_worst = 0; // error of the complete cut loci
};

Vector vector(const Triple& p) { return Vector(p[0], p[1], p[2]); }

// A surface whose chart is a torus.
template <class Surface>
void add_of_chart(Table& table, const std::string& name, const Surface& surface, const Point& p,
                  const std::vector<Vector>& mirrors) {
  static constexpr double spacing = CGAL_PI / 20, step_of_spacing = .5;
  const DSC::Embedded_surface_2<Surface> metric(surface);
  const Domain domain({2 * CGAL_PI, 2 * CGAL_PI});
  char point[100];
  std::snprintf(point, sizeof point, " at (%g, %g)", p.x(), p.y());
  const DSC::Metric_jet_2 g = metric(p.x(), p.y());
  table.add(
      {name + point, vector(surface(p.x(), p.y())), mirrors}, surface,
      [&] {
        return DSC::cut_locus_2(metric, domain, p, spacing,
                                step_of_spacing * spacing * std::sqrt((std::min)(g.E, g.G)));
      },
      [&](const Point& q) { return vector(surface(q.x(), q.y())); });
}

// A surface that is an image of the sphere.
template <class Embedding>
void add_of_sphere(Table& table, const std::string& name, const Embedding& embedding,
                   const Triple& source, const std::vector<Vector>& mirrors) {
  static constexpr double spacing = .1, step_of_spacing = .5;
  const DSC::Sphere_like_surface_2<Embedding> surface(embedding, source);
  char point[100];
  std::snprintf(point, sizeof point, " at (%g, %g, %g)", source[0], source[1], source[2]);
  const double middle = surface.half_width;
  const DSC::Metric_jet_2 g = surface(middle, middle);
  const Vector direction = vector(source).normalized();
  const Triple n = {direction[0], direction[1], direction[2]};
  table.add(
      {name + point, vector(embedding(n)), mirrors}, embedding,
      [&] {
        return DSC::cut_locus_2(surface, spacing,
                                step_of_spacing * spacing * std::sqrt((std::min)(g.E, g.G)));
      },
      [&](const Point& q) { return vector(surface.image(q)); });
}

std::vector<Vector> mirrors_of_torus(const Point& p) {
  std::vector<Vector> result = {Vector(-std::sin(p.x()), std::cos(p.x()), 0)};
  if (p.y() == 0)
    result.push_back(Vector::UnitZ());
  return result;
}

void add_tori(Table& table) {
  for (const auto& [large, small] :
       std::vector<std::pair<double, double>>{{2, .3}, {2, .5}, {2, 1}, {3, 1}, {1.3, 1}})
    for (const Point& p : {Point(0, 0), Point(.7, 1.1), Point(0, .314159265)}) {
      char name[100];
      std::snprintf(name, sizeof name, "torus (%g, %g)", large, small);
      add_of_chart(table, name, Torus{large, small}, p, mirrors_of_torus(p));
    }
}

void add_ellipsoids(Table& table) {
  for (const Triple& axes : std::vector<Triple>{
           {1, .8, .6}, {1, .5, .2}, {1, .99, .98}, {1, 1, .1}, {1, .3, .1}, {1, .1, .1}})
    for (const Triple& source : {Triple{1, 1, 1}, Triple{.3, -1, .4}, Triple{0, .2, 1}}) {
      char name[100];
      std::snprintf(name, sizeof name, "ellipsoid (%g, %g, %g)", axes[0], axes[1], axes[2]);
      std::vector<Vector> mirrors;
      for (int i = 0; i < 3; ++i) {
        if (source[std::size_t(i)] == 0)
          mirrors.push_back(Vector::Unit(i));
        if (const std::size_t j = (i + 1) % 3, k = (i + 2) % 3; axes[j] == axes[k])
          mirrors.push_back(vector(source).cross(Vector::Unit(i)).normalized());
      }
      add_of_sphere(table, name, Ellipsoid{axes}, source, mirrors);
    }
  add_of_sphere(table, "sphere", Ellipsoid{{1, 1, 1}}, {1, 1, 1}, {Vector(1, -1, 0).normalized()});
}

void add_bumps(Table& table) {
  const Vector mirror = Vector(1, -1, 0).normalized();
  add_of_sphere(table, "sphere with bumps of 6 %", Bumps{.1}, {1, .5, .2}, {});
  add_of_sphere(table, "sphere with bumps of 6 %", Bumps{.1}, {1, 1, .2}, {mirror});
  add_of_sphere(table, "sphere with bumps of 17 %", Bumps{.3}, {1, 1, .2}, {mirror});
  add_of_chart(table, "torus (2, .8) with bumps", Torus{2, .8, .1}, Point(0, 0),
               {Vector::UnitY(), Vector::UnitZ()});
  for (const Point& p : {Point(0, .4), Point(2, 1)})
    add_of_chart(table, "height field", Height_field{.5}, p,
                 p.x() == 0 ? std::vector<Vector>{Vector::UnitX()} : std::vector<Vector>());
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Compares cut loci with a fan of geodesics.");
  int rays = 20000;
  std::string only;
  app.add_option("--rays", rays, "Geodesics of the fan, before those in between")
      ->capture_default_str();
  app.add_option("--only", only, "Part of the names of surfaces and points that are wanted");
  CLI11_PARSE(app, argc, argv);
  dsc_benchmark::Table table(rays, only);
  table.begin();
  dsc_benchmark::add_tori(table);
  dsc_benchmark::add_ellipsoids(table);
  dsc_benchmark::add_bumps(table);
  table.end();
}
