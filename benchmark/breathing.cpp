// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets a surface inwards and back repeatedly, with detail control before each step (Algorithm 1
// of the paper), and measures the mesh. Prints a row of a table, without the table head.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
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

double tetrahedra_per_triangle(const Complex& complex) {
  return double(complex.number_of_cells()) / double(complex.interface_facets().size());
}

int breathe(const std::string& input, std::size_t triangles, int number_of_steps, double length,
            int breaths) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{read_input(input, triangles)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::normalize(true));
  const std::size_t number_of_triangles = complex.interface_facets().size();
  const double distance = length * complex.mean_interface_edge();
  std::vector<std::size_t> sizes = {complex.number_of_cells()};
  const double ratio = tetrahedra_per_triangle(complex);

  double minimum = 180, maximum = 0, outside = 0;
  std::size_t unfinished = 0, steps = 0;
  bool is_valid = true;
  for (int breath = 0; breath < breaths; ++breath) {
    for (double speed : {-distance, distance})
      for (int i = 0; i < number_of_steps; ++i, ++steps) {
        // Edges inside the labels are twice as long as on the interface.
        DSC::control_detail(complex, parameters::collapse_length(2.));
        const auto report =
            DSC::advect_interface(complex, DSC::Normal_offset{speed}, double(steps), 1.);
        unfinished += report.unfinished.size();
        const Angles angles = dihedral_angles(complex);
        minimum = (std::min)(minimum, angles.minimum);
        maximum = (std::max)(maximum, angles.maximum);
        outside = (std::max)(outside, angles.fraction_outside_6_171());
        is_valid = is_valid && check(complex);
      }
    sizes.push_back(complex.number_of_cells());
  }

  std::cout.precision(4);
  std::cout << "| " << input.substr(input.find_last_of('/') + 1) << " | " << number_of_triangles
            << " | " << breaths << " × 2 × " << number_of_steps << " | " << length << " | "
            << (is_valid ? "yes" : "**no**") << " | " << unfinished << " | " << 100 * outside
            << " | " << minimum << " – " << maximum << " | " << ratio << " → "
            << tetrahedra_per_triangle(complex) << " | ";
  const char* separator = "";
  for (std::size_t size : sizes) {
    std::cout << separator << size;
    separator = ", ";
  }
  std::cout << " | " << processor_seconds() << " |" << std::endl;
  return is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Offsets a surface inwards and back, and measures what becomes of the mesh.");
  std::string input;
  std::size_t triangles = 0;
  int steps = 50, breaths = 1;
  double length = .1;
  app.add_option("mesh", input, "a closed surface")->required();
  app.add_option("--triangles", triangles, "to which a finer surface is decimated");
  app.add_option("--steps", steps, "in and as many out")->check(CLI::PositiveNumber);
  app.add_option("--length", length, "of a step, in mean edges")->check(CLI::PositiveNumber);
  app.add_option("--breaths", breaths, "how often in and out")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    return dsc_benchmark::breathe(input, triangles, steps, length, breaths);
  } catch (const std::exception& error) {
    std::cerr << "breathing: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
