// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Improves an interface repeatedly, and measures its displacement and its quality (table I of the
// paper). Prints a row of a table, without the table head.

#include "inputs.h"
#include "interface_at_start.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/triangle_quality.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

// The smallest angle of an interface triangle, and the mean of the smallest angles of all
// triangles, in degrees.
std::array<double, 2> smallest_angles(const Complex& complex) {
  double minimum = 180, sum = 0;
  const auto facets = complex.interface_facets();
  for (const auto& facet : facets) {
    const auto v = complex.facet_vertices(facet);
    const double angle =
        CGAL::Deformable_simplicial_complexes::internal::smallest_angle(std::array<Point, 3>{
            complex.position(v[0]), complex.position(v[1]), complex.position(v[2])}) /
        degree;
    minimum = (std::min)(minimum, angle);
    sum += angle;
  }
  return {minimum, sum / double(facets.size())};
}

int improve(const std::string& input, double aggressiveness, unsigned iterations) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{read_input(input, 0)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true));
  const Interface_at_start start(complex);
  const std::size_t triangles = complex.interface_facets().size();
  const double volume = complex.volume(1), edge = complex.mean_interface_edge();
  const auto before = smallest_angles(complex);
  const double begin = processor_seconds();
  // Scanned surfaces have no sharp edges; folds of their facets are noise.
  for (unsigned i = 0; i < iterations; ++i)
    DSC::improve_interface(complex, parameters::aggressiveness(aggressiveness).feature_angle(180.));
  const double seconds = processor_seconds() - begin;
  const auto after = smallest_angles(complex);
  const auto [mean, maximum] = start.distances(complex);
  const bool is_valid = check(complex);
  std::cout.precision(4);
  std::cout << "| " << input.substr(input.find_last_of('/') + 1) << " | " << aggressiveness << " | "
            << triangles << " | " << complex.interface_facets().size() << " | "
            << (is_valid ? "yes" : "**no**") << " | " << maximum / edge << " | " << mean / edge
            << " | " << 100 * (1 - complex.volume(1) / volume) << " | " << before[0] << " | "
            << after[0] << " | " << before[1] << " | " << after[1] << " | " << seconds << " |"
            << std::endl;
  return is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Improves an interface again and again.");
  std::string input;
  double aggressiveness = .025;
  unsigned iterations = 100;
  app.add_option("mesh", input, "a closed surface")->required();
  app.add_option("--aggressiveness", aggressiveness, "of the smoothing")
      ->check(CLI::Range(0., .999));
  app.add_option("--iterations", iterations, "how often")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    return dsc_benchmark::improve(input, aggressiveness, iterations);
  } catch (const std::exception& error) {
    std::cerr << "interface_improvement: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
