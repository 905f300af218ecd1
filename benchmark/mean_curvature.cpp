// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves surfaces by mean curvature, and compares the results with exact solutions. Prints a row of
// a table, without the table head.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
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

Complex make_complex(const Surface& surface, bool normalize = false) {
  return DSC::make_deformable_simplicial_complex_3<Complex>(std::vector<Surface>{surface},
                                                            CGAL::Tetgen_tetrahedralizer_3(),
                                                            parameters::normalize(normalize));
}

// The results of a flow.
struct Flow
{
  double time = 0;
  std::size_t steps = 0, incomplete = 0;
  double seconds = 0, sum_of_sweeps = 0, most_sweeps = 0;
  bool is_valid = true;
  std::size_t components = 1; // components of label 1 at the end
  int characteristic = 2;     // Euler characteristic of its interface at the end

  // One step with default parameters.
  void step(Complex& complex, double dt) {
    const double sweep = sweep_seconds(complex, complex.cells());
    const double begin = processor_seconds();
    const auto report = DSC::advect_adaptively(complex, DSC::Mean_curvature_flow(), time, dt);
    const double used = processor_seconds() - begin;
    seconds += used;
    sum_of_sweeps += used / sweep;
    most_sweeps = (std::max)(most_sweeps, used / sweep);
    incomplete += !report.complete;
    is_valid = is_valid && check(complex);
    time += dt;
    ++steps;
    components = complex.number_of_components(1);
    characteristic = complex.euler_characteristic(1);
  }

  void print_end_of_row() const {
    std::cout << " | " << components << ", " << characteristic << " | " << steps << " | "
              << incomplete << " | " << (is_valid ? "yes" : "**no**") << " | " << seconds << " | "
              << sum_of_sweeps / double(steps) << " | " << most_sweeps << " |" << std::endl;
  }
};

// A sphere shrinks with r^2 = r0^2 - 4 t, here to three tenths of its radius.
Flow shrink_sphere(std::size_t n) {
  static constexpr double last_radius = .3;
  Complex complex = make_complex(sphere(1, n));
  const std::size_t triangles = complex.interface_facets().size();
  // The time step is as accurate as the mesh; a step of the square of the edge length would be too
  // long.
  const double dt = .02 * complex.mean_interface_edge();
  Flow flow;
  double error = 0;
  const double end = (1 - last_radius * last_radius) / 4;
  while (flow.time < end) {
    flow.step(complex, (std::min)(dt, end - flow.time));
    double sum = 0;
    const auto vertices = complex.interface_vertices();
    for (const auto v : vertices)
      sum += std::sqrt((complex.position(v) - CGAL::ORIGIN).squared_length());
    const double exact = std::sqrt(1 - 4 * flow.time);
    error = (std::max)(error, std::abs(sum / double(vertices.size()) / exact - 1));
  }
  std::cout << "| sphere | " << triangles << " | error of the radius (%) | 0 | " << 100 * error;
  return flow;
}

// Returns the radius of the hole of a torus about the x axis.
double hole(const Complex& complex) {
  double result = HUGE_VAL;
  for (const auto v : complex.interface_vertices()) {
    const Point p = complex.position(v);
    result = (std::min)(result, std::hypot(p.y(), p.z()));
  }
  return result;
}

// Runs a flow until the topology of label 1 changes.
Flow run_until_change(const std::string& name, const Surface& surface, const std::string& what,
                      double exact, bool closes_hole = false) {
  static constexpr double part = .02; // fraction of the time until the thinnest part vanishes
  static constexpr double smallest_hole = .03;
  Complex complex = make_complex(surface);
  const std::size_t triangles = complex.interface_facets().size();
  const int characteristic = complex.euler_characteristic(1);
  const double tube = 2 * complex.volume(1) / complex.area(1);
  Flow flow;
  while (complex.euler_characteristic(1) == characteristic && complex.number_of_cells(1) > 0) {
    double thickness = 2 * complex.volume(1) / complex.area(1); // the radius of a tube
    if (closes_hole)
      thickness = (std::max)(hole(complex), smallest_hole);
    flow.step(complex, part * (std::min)(thickness * thickness, tube * tube));
  }
  std::cout << "| " << name << " | " << triangles << " | " << what << " | " << exact << " | "
            << flow.time;
  return flow;
}

// 20 steps of a surface, measured in sweeps.
Flow smooth(const std::string& input) {
  Complex complex = make_complex(read_input(input, 13900), true);
  const std::size_t triangles = complex.interface_facets().size();
  const double volume = complex.volume(1), edge = complex.mean_interface_edge();
  Flow flow;
  for (int i = 0; i < 20; ++i)
    flow.step(complex, .1 * edge * edge);
  std::cout << "| " << input.substr(input.find_last_of('/') + 1) << " | " << triangles
            << " | volume left (%) | | " << 100 * complex.volume(1) / volume;
  return flow;
}

Flow run(const std::string& input, std::size_t n) {
  if (input == "sphere")
    return shrink_sphere(n);
  if (input == "torus")
    return run_until_change("torus, r = 0.5", torus(.5, n), "time of collapse", .1366);
  if (input == "thick_torus")
    return run_until_change("torus, r = 0.7", torus(.7, n), "time when its hole closes", .082,
                            true);
  if (input == "dumbbell")
    return run_until_change("dumbbell", dumbbell(n), "time when it falls apart", 0);
  return smooth(input);
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Lets surfaces move with their mean curvature.");
  std::string input;
  std::size_t n = 16;
  app.add_option("input", input,
                 "`sphere`, `torus`, `thick_torus`, `dumbbell`, or a closed surface")
      ->required();
  app.add_option("-n", n, "resolution")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    const auto flow = dsc_benchmark::run(input, n);
    flow.print_end_of_row();
    return flow.is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << "mean_curvature: " << input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
