// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_report.h"

#include "fluids/fluid_fields.h"
#include "fluids/fluid_shapes.h"

#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Linear_element.h>

namespace dsc {
namespace {

/// A facet of the interface as seen from a point.
struct Seen_facet
{
  double weight; // approximate solid angle, in the plane the angle
  double distance;
  double value; // of the mode in the direction of the facet
};

template <class Complex>
Seen_facet seen_facet(const Complex& complex, const typename Complex::Facet& f,
                      const Scene_probe& probe) {
  const auto v = complex.facet_vertices(f);
  const auto c = from_coordinates<typename Complex::Point>(probe.center);
  const auto p = complex.position(v[0]), q = complex.position(v[1]);
  if constexpr (Complex::dimension == 2) {
    const auto m = CGAL::midpoint(p, q) - c;
    const double distance = std::sqrt(m.squared_length());
    return {std::abs(CGAL::determinant(q - p, m)) / (distance * distance), distance,
            std::cos(double(probe.mode) * std::atan2(m.y(), m.x()))};
  } else {
    const auto r = complex.position(v[2]);
    const auto m = CGAL::centroid(p, q, r) - c;
    const double distance = std::sqrt(m.squared_length());
    return {std::abs(CGAL::cross_product(q - p, r - p) * m) / (distance * distance * distance),
            distance, legendre(probe.mode, m.z() / distance)};
  }
}

/// Returns the amplitude of a mode in the distance of the interface from a point, relative to the
/// mean distance. The mode is a Legendre polynomial in space and cos(mode * angle) in the plane.
/// The interface is weighted by solid angle or angle.
template <class Complex> double amplitude(const Complex& complex, const Scene_probe& probe) {
  double sum = 0, squares = 0, mean = 0, angles = 0;
  std::vector<Seen_facet> samples;
  for (const auto& f : complex.interface_facets()) {
    samples.push_back(seen_facet(complex, f, probe));
    mean += samples.back().weight * samples.back().distance;
    angles += samples.back().weight;
  }
  mean /= angles;
  for (const Seen_facet& s : samples) {
    sum += s.weight * s.value * (s.distance / mean - 1);
    squares += s.weight * s.value * s.value;
  }
  return sum / squares;
}

/// Returns the barycentric coordinates of a place in the projection of a facet along the last axis;
/// NaN if the projection is degenerate.
template <class Points>
std::array<double, 3> coordinates_in_facet(const Points& p, const std::array<double, 2>& place) {
  if constexpr (std::tuple_size_v<Points> == 2) {
    const double b = (place[0] - p[0].x()) / (p[1].x() - p[0].x());
    return {1 - b, b, 0};
  } else {
    const auto twice_area = [](double ax, double ay, double bx, double by) {
      return ax * by - ay * bx;
    };
    const double ux = p[1].x() - p[0].x(), uy = p[1].y() - p[0].y(), vx = p[2].x() - p[0].x(),
                 vy = p[2].y() - p[0].y(), x = place[0] - p[0].x(), y = place[1] - p[0].y(),
                 whole = twice_area(ux, uy, vx, vy), b = twice_area(x, y, vx, vy) / whole,
                 c = twice_area(ux, uy, x, y) / whole;
    return {1 - b - c, b, c};
  }
}

/// Returns the largest last coordinate of the interface at a place; null if there is none.
template <class Complex> Json height(const Complex& complex, const std::array<double, 2>& place) {
  static constexpr double rounding = 1e-9;
  static constexpr int last = Complex::dimension - 1;
  Json result;
  for (const auto& f : complex.interface_facets()) {
    std::array<typename Complex::Point, Complex::dimension> p;
    const auto v = complex.facet_vertices(f);
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = complex.position(v[i]);
    const auto weights = coordinates_in_facet(p, place);
    if (!(weights[0] >= -rounding && weights[1] >= -rounding && weights[2] >= -rounding))
      continue;
    double z = p[0][last];
    for (std::size_t i = 1; i < p.size(); ++i)
      z += weights[i] * (p[i][last] - p[0][last]);
    if (std::isfinite(z) && (result.is_null() || z > result.get<double>()))
      result = z;
  }
  return result;
}

/// Returns the surface of the ball of equal volume over the surface of a label; in the plane, the
/// perimeter of the disk of equal area over the perimeter. Returns null if the label has no cells.
template <class Complex> Json circularity(const Complex& complex, int label) {
  double surface = 0;
  for (const auto& f : complex.interface_facets())
    if (f.first->subdomain_index() == label ||
        f.first->neighbor(f.second)->subdomain_index() == label)
      surface += complex.measure(f);
  const double volume = complex.measure(label);
  if (!(volume > 0) || !(surface > 0))
    return {};
  if constexpr (Complex::dimension == 2)
    return 2 * std::sqrt(CGAL_PI * volume) / surface;
  else
    return std::cbrt(36 * CGAL_PI * volume * volume) / surface;
}

/// Returns the mean of vectors at the vertices of a label, weighted by volume; null if the label
/// has no cells. `vector_at(v)` returns three coordinates.
template <class Complex, class VectorAt>
Json mean_of_label(const Complex& complex, int label, const VectorAt& vector_at) {
  std::array<double, 3> sum = {};
  double volume = 0;
  for (const auto c : complex.cells()) {
    if (c->subdomain_index() != label)
      continue;
    const double share = complex.measure(c) / Complex::corners;
    volume += complex.measure(c);
    for (int i = 0; i < Complex::corners; ++i) {
      const std::array<double, 3> vector = vector_at(c->vertex(i));
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += share * vector[axis];
    }
  }
  if (!(volume > 0))
    return {};
  for (double& x : sum)
    x /= volume;
  return sum;
}

/// Returns the barycentric coordinates of a point in a cell.
template <class Complex>
std::array<double, std::size_t(Complex::corners)>
coordinates_in_cell(const Complex& complex, typename Complex::Cell_handle c,
                    const typename Complex::Point& p) {
  const DSC::Linear_element<Complex> element(complex, c);
  std::array<double, std::size_t(Complex::corners)> result;
  for (int i = 0; i < Complex::corners; ++i)
    result[std::size_t(i)] = 1 + element.gradient(i) * (p - complex.position(c->vertex(i)));
  return result;
}

/// Returns the label, the pressure and the velocity at a point, and the field if there is one. They
/// are interpolated in the cell that contains the point. The pressure is null in the void, and the
/// velocity and the field are null outside of liquids.
template <class Complex>
Json values_at(const Fluid<Complex>& fluid, const std::array<double, 3>& point) {
  const Complex& complex = fluid.complex();
  const auto p = from_coordinates<typename Complex::Point>(point);
  typename Complex::Cell_handle cell;
  std::array<double, std::size_t(Complex::corners)> weights = {};
  double greatest = -std::numeric_limits<double>::infinity(); // least coordinate in a cell
  for (const auto c : complex.cells()) {
    const auto coordinates = coordinates_in_cell(complex, c, p);
    const double least = *std::min_element(coordinates.begin(), coordinates.end());
    if (least > greatest) {
      greatest = least;
      cell = c;
      weights = coordinates;
    }
  }
  const Fluid_fields<Complex> fields(fluid);
  double pressure = 0, field = 0;
  std::array<double, 3> velocity = {};
  for (int i = 0; i < Complex::corners; ++i) {
    const double weight = weights[std::size_t(i)];
    pressure += weight * fields.pressure(cell->vertex(i), cell);
    field += weight * fluid.field(cell->vertex(i));
    const std::array<double, 3> u = fields.velocity(cell->vertex(i), cell);
    for (std::size_t axis = 0; axis < 3; ++axis)
      velocity[axis] += weight * u[axis];
  }
  const bool is_liquid = fields.is_liquid(cell);
  Json result = {{"label", cell->subdomain_index()},
                 {"pressure", is_liquid || fields.is_gas(cell) ? Json(pressure) : Json()},
                 {"velocity", is_liquid ? Json(velocity) : Json()}};
  if (fluid.has_field())
    result["field"] = is_liquid ? Json(field) : Json();
  return result;
}

template <class Complex> Json probe_json(const Scene_probe& probe, const Fluid<Complex>& fluid) {
  using Vertex_handle = typename Complex::Vertex_handle;
  const Complex& complex = fluid.complex();
  switch (probe.kind) {
  case Scene_probe::Kind::mode:
    return amplitude(complex, probe);
  case Scene_probe::Kind::height:
    return height(complex, probe.place);
  case Scene_probe::Kind::circularity:
    return circularity(complex, probe.label);
  case Scene_probe::Kind::centroid:
    return mean_of_label(complex, probe.label,
                         [&](Vertex_handle v) { return coordinates_of(complex.position(v)); });
  case Scene_probe::Kind::point:
    return values_at(fluid, probe.point);
  case Scene_probe::Kind::velocity:
    break;
  }
  return mean_of_label(complex, probe.label, [&](Vertex_handle v) {
    return coordinates_of(fluid.velocity(v, probe.label));
  });
}

} // namespace

template <class Complex> Json probes_json(const Fluid_scene& scene, const Fluid<Complex>& fluid) {
  Json result = Json::object();
  for (const Scene_probe& probe : scene.probes)
    result[probe.name] = probe_json(probe, fluid);
  return result;
}

template Json probes_json(const Fluid_scene&, const Fluid<Tracked_complex_2::Complex>&);
template Json probes_json(const Fluid_scene&, const Fluid<Tracked_complex_3::Complex>&);

} // namespace dsc
