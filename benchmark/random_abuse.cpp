// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Deforms small complexes by displacement fields that no physics would come up with, and checks
// that they stay valid. What it prints and writes depends on nothing but the options: compare it
// between runs, also with and without address space randomization (`setarch -R`).

#include "measures.h"
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/IO/checkpoint_3.h>
#include <CGAL/advect_interface_3.h>

#include <CLI/CLI.hpp>
#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace {

using dsc_benchmark::Complex;
using dsc_benchmark::Point;
using dsc_benchmark::Vector;
using Field = std::vector<Vector>; // displacements in the order of `interface_vertices()`
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

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

  // Makes a field that is to be refused, now and then. Returns whether it did.
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
  // Not a distribution of the standard library, as these differ.
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
      const Vector wave = vector(CGAL_PI); // the domain is 2 wide
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

// The CRC-32 of what a checkpoint would hold, over all states so far.
class Checksum
{
public:
  void add(const Complex::State& state) {
    namespace internal = CGAL::Deformable_simplicial_complexes::internal;
    internal::Checkpoint_encoder encoder;
    std::apply([&](const auto&... members) { (encoder(members), ...); }, internal::members(state));
    m_crc.process_bytes(encoder.bytes().data(), encoder.bytes().size());
  }
  std::uint32_t value() const { return m_crc.checksum(); }

private:
  boost::crc_32_type m_crc;
};

struct Counts
{
  std::size_t refused = 0, complete = 0, incomplete = 0, restarts = 0;
  std::size_t split = 0, collapsed = 0, flipped = 0, relabeled = 0;
  std::size_t merged_components = 0, split_components = 0, vanished_components = 0;

  void add(const CGAL::Deformation_report<Complex>& report) {
    ++(report.complete ? complete : incomplete);
    split += report.split;
    collapsed += report.collapsed;
    flipped += report.flipped;
    relabeled += report.relabeled;
    for (const auto& label : report.labels) {
      merged_components += label.merged;
      split_components += label.split;
      vanished_components += label.vanished;
    }
  }
};

void deform(Complex& complex, const Field& field, bool is_bad, unsigned threads, Counts& counts) {
  using CGAL::Deformable_simplicial_complexes::Integration_scheme;
  const Complex::State before = is_bad ? complex.state() : Complex::State();
  const auto velocity = [&](const CGAL::Interface_snapshot_3<Complex>&, const std::vector<Point>&,
                            double, Field& velocities) { velocities = field; };
  try {
    counts.add(CGAL::advect_interface(
        complex, velocity, 0., 1.,
        parameters::scheme(Integration_scheme::euler).number_of_threads(threads)));
    if (is_bad)
      throw std::runtime_error("a destination that is not finite was accepted");
  } catch (const CGAL::Deformable_simplicial_complexes::Invalid_destination_error&) {
    if (!is_bad)
      throw;
    if (complex.state() != before)
      throw std::runtime_error("a deformation was refused, but not without a change");
    ++counts.refused;
  }
  if (!dsc_benchmark::check(complex))
    throw std::runtime_error("the complex is invalid");
}

// Prints a row of the table and returns the last complex.
Complex abuse(const std::string& name, const Complex& initial, std::size_t number_of_fields,
              unsigned threads, Random_fields& fields, Checksum& checksum, std::ostream& out) {
  const std::size_t few = initial.interface_vertices().size() / 4;
  Complex complex = initial;
  Counts counts;
  for (std::size_t i = 0; i < number_of_fields; ++i) {
    if (complex.interface_vertices().size() < few) {
      complex = initial;
      ++counts.restarts;
    }
    Field field = fields(complex);
    const bool is_bad = fields.spoil(field);
    deform(complex, field, is_bad, threads, counts);
    checksum.add(complex.state());
  }
  out << "| " << name << " | " << number_of_fields << " | " << counts.refused << " | "
      << counts.complete << " | " << counts.incomplete << " | " << counts.restarts << " | "
      << counts.split << " | " << counts.collapsed << " | " << counts.flipped << " | "
      << counts.relabeled << " | " << counts.merged_components << " | " << counts.split_components
      << " | " << counts.vanished_components << " |\n";
  return complex;
}

void run(std::size_t number_of_fields, std::uint64_t seed, unsigned threads,
         const std::string& checkpoint) {
  Random_fields fields(seed);
  Checksum checksum;
  std::ostringstream out;
  out << "| mesh | fields | refused | complete | incomplete | restarts | split | collapsed | "
         "flipped | relabeled | merged | divided | vanished |\n"
         "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
         "---: |\n";
  abuse("ball", small_meshes::make_complex(small_meshes::grid(8, small_meshes::ball)),
        number_of_fields / 2, threads, fields, checksum, out);
  const Complex last = abuse(
      "quadrants", small_meshes::make_complex(small_meshes::grid(6, small_meshes::four_phases)),
      number_of_fields - number_of_fields / 2, threads, fields, checksum, out);
  out << "\nEvery state was valid. CRC-32 of all states: " << std::hex << checksum.value() << '\n';
  std::cout << out.str();
  if (!checkpoint.empty())
    CGAL::IO::write_checkpoint(checkpoint, last.state(), out.str());
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Deforms small complexes at random and checks that they stay valid.");
  std::size_t number_of_fields = 2000;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::string checkpoint;
  app.add_option("--fields", number_of_fields, "number of displacement fields");
  app.add_option("--seed", seed, "of the random numbers");
  app.add_option("--threads", threads, "number of threads");
  app.add_option("--checkpoint", checkpoint, "a file for the last complex and what is printed");
  CLI11_PARSE(app, argc, argv);
  try {
    run(number_of_fields, seed, threads, checkpoint);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "random_abuse: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
