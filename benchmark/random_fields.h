// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_RANDOM_FIELDS_H
#define DSC_BENCHMARK_RANDOM_FIELDS_H

#include "measures.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace dsc_benchmark {

using Field = std::vector<Vector>; // displacements in the order of `interface_vertices()`

// Displacements of up to three mean edges of the interface.
class Random_fields
{
public:
  explicit Random_fields(std::uint64_t seed) : m_engine(seed) {}

  Field operator()(const Complex& complex) {
    const std::vector<Complex::Vertex_handle> vertices = complex.interface_vertices();
    const double amplitude = 3 * complex.mean_interface_edge() * number(0, 1);
    const double kind = number(0, 1);
    if (kind < .4)
      return waves(complex, vertices, amplitude);
    if (kind < .8)
      return noise(vertices.size(), amplitude);
    if (kind < .9)
      return Field(vertices.size(), towards_side(amplitude));
    Field field = noise(vertices.size(), amplitude);
    for (std::size_t i = 0; i < field.size(); ++i)
      field[i] = complex.is_boundary(vertices[i]) ? field[i] : Vector(0, 0, 0);
    return field;
  }

  // Sometimes makes an invalid field. Returns whether the field is invalid.
  bool spoil(Field& field) {
    if (number(0, 1) > .02)
      return false;
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
    Vector& v = field[std::size_t(number(0, double(field.size())))];
    std::array<double, 3> coordinates = {v.x(), v.y(), v.z()};
    coordinates[std::size_t(number(0, 3))] = bad[std::size_t(number(0, 3))];
    v = Vector(coordinates[0], coordinates[1], coordinates[2]);
    return true;
  }

private:
  // The distributions of the standard library differ between implementations, so they are not used.
  double number(double minimum, double maximum) {
    return minimum + (maximum - minimum) * std::ldexp(double(m_engine() >> 11), -53);
  }

  Vector vector(double bound) {
    const double x = number(-bound, bound), y = number(-bound, bound);
    return Vector(x, y, number(-bound, bound));
  }

  Field noise(std::size_t n, double amplitude) {
    Field field;
    while (field.size() < n) {
      const Vector v = vector(1);
      if (v.squared_length() <= 1)
        field.push_back(amplitude * v);
    }
    return field;
  }

  Field waves(const Complex& complex, const std::vector<Complex::Vertex_handle>& vertices,
              double amplitude) {
    static constexpr std::size_t number_of_waves = 3;
    const Field directions = noise(number_of_waves, amplitude / number_of_waves);
    Field field(vertices.size(), Vector(0, 0, 0));
    for (const Vector& direction : directions) {
      const Vector wave = vector(CGAL_PI); // the domain has width 2
      const double phase = number(0, 2 * CGAL_PI);
      for (std::size_t i = 0; i < field.size(); ++i)
        field[i] =
            field[i] +
            std::sin(wave * (complex.position(vertices[i]) - CGAL::ORIGIN) + phase) * direction;
    }
    return field;
  }

  Vector towards_side(double amplitude) {
    const double side = number(0, 6), distance = side < 3 ? amplitude : -amplitude;
    std::array<double, 3> v = {0, 0, 0};
    v[std::size_t(side) % 3] = distance;
    return Vector(v[0], v[1], v[2]);
  }

  std::mt19937_64 m_engine;
};

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_RANDOM_FIELDS_H
