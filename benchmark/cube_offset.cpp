// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets the unit cube by face offsetting. Outwards, its edges and corners become round; inwards,
// it stays a cube. Prints a row of a table.

#include "inputs.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/number_utils.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

// Each side consists of n^2 squares.
Surface cube(std::size_t n) {
  Surface surface;
  surface.label = 1;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto corner = [&](std::size_t i, std::size_t j) {
        std::array<double, 3> p;
        p[axis] = side;
        p[(axis + 1) % 3] = double(i) / double(n);
        p[(axis + 2) % 3] = double(j) / double(n);
        surface.points.emplace_back(p[0], p[1], p[2]);
        return surface.points.size() - 1;
      };
      const auto add_triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        surface.triangles.push_back({a, side == 0 ? c : b, side == 0 ? b : c});
      };
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const std::size_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                            d = corner(i, j + 1);
          if ((i + j) % 2 == 0) {
            add_triangle(a, b, c);
            add_triangle(a, c, d);
          } else {
            add_triangle(a, b, d);
            add_triangle(b, c, d);
          }
        }
    }
  return surface;
}

double rounded_cube(double r) {
  return 1 + 6 * r + 3 * CGAL_PI * r * r + 4 * CGAL_PI * r * r * r / 3;
}

double distance_from_cube(const Point& p, double half_side) {
  double squares = 0, inside = -half_side;
  for (int i = 0; i < 3; ++i) {
    const double d = std::abs(p[i] - .5) - half_side;
    squares += d > 0 ? d * d : 0;
    inside = (std::max)(inside, d);
  }
  return squares > 0 ? std::sqrt(squares) : -inside;
}

// The results of an offset.
struct Outcome
{
  std::size_t steps = 0, incomplete = 0;
  double seconds = 0;
};

void step(Complex& complex, double speed, double r, double dr, Outcome& outcome) {
  DSC::control_detail(complex, parameters::collapse_length(2.));
  outcome.incomplete +=
      DSC::advect_interface(complex, DSC::Face_offset_3(speed), r, dr).complete ? 0 : 1;
  ++outcome.steps;
}

// The boundary between a face and a round edge is visible only from vertices nearby. So the first
// step is short, and later steps grow with the radius and with the edge length on the round edge.
Outcome offset_outwards(Complex& complex, double end, double tolerance) {
  Outcome outcome;
  const double longest = complex.mean_interface_edge(), begin = processor_seconds();
  for (double r = 0; r < end;) {
    const double length = std::sqrt(8 * tolerance * r); // edge length around the round edges
    const double dr = (std::min)(end - r, r == 0 ? .001 : (std::min)(.25 * r, .25 * length));
    if (r > 0) {
      const DSC::Curvature_sizing_field<3> size(complex, tolerance,
                                                (std::min)(.5 * length, longest), longest);
      DSC::improve_interface(complex, parameters::sizing_field(std::cref(size))
                                          .aggressiveness(0.)
                                          .interface_split_length(1.5)
                                          .interface_collapse_length(.5)
                                          .curved_splits(true)
                                          .swept_volume(.02)
                                          .feature_angle(65.));
    }
    step(complex, 1, r, dr, outcome);
    r = r + dr < end ? r + dr : end;
  }
  outcome.seconds = processor_seconds() - begin;
  return outcome;
}

Outcome offset_inwards(Complex& complex, double end) {
  Outcome outcome;
  const double begin = processor_seconds(), longest_step = complex.mean_interface_edge() / 8;
  const auto steps = std::size_t(std::ceil(end / longest_step));
  for (std::size_t i = 0; i < steps; ++i) {
    DSC::improve_interface(complex);
    step(complex, -1, end * double(i) / double(steps), end / double(steps), outcome);
  }
  outcome.seconds = processor_seconds() - begin;
  return outcome;
}

int measure(bool outwards, std::size_t n, double distance, double tolerance) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{cube(n)}, CGAL::Tetgen_tetrahedralizer_3());
  const std::size_t triangles = complex.interface_facets().size();
  const Outcome outcome =
      outwards ? offset_outwards(complex, distance, tolerance) : offset_inwards(complex, distance);
  const double side = 1 - 2 * distance;
  const double exact = outwards ? rounded_cube(distance) : side * side * side;
  double farthest = 0; // distance of a vertex from the exact surface
  for (const auto v : complex.interface_vertices()) {
    const Point p = complex.position(v);
    farthest = (std::max)(farthest, outwards ? std::abs(distance_from_cube(p, .5) - distance)
                                             : distance_from_cube(p, side / 2));
  }
  const bool is_valid = check(complex);
  std::cout.precision(4);
  std::cout << "| " << (outwards ? "outwards" : "inwards") << " | " << triangles << " | "
            << complex.interface_facets().size() << " | " << outcome.steps << " | "
            << outcome.incomplete << " | " << (is_valid ? "yes" : "**no**") << " | ";
  std::cout.precision(6);
  std::cout << complex.volume(1) << " | " << exact << " | ";
  std::cout.precision(2);
  std::cout << 100 * (complex.volume(1) / exact - 1) << " | " << farthest << " | ";
  std::cout.precision(4);
  std::cout << outcome.seconds << " |" << std::endl;
  return is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app("Offsets the unit cube by face offsetting.");
  bool inwards = false;
  std::size_t n = 24;
  double distance = .1, tolerance = .0004;
  app.add_flag("--inwards", inwards);
  app.add_option("-n", n, "12 n^2 triangles")->check(CLI::Range(2, 200));
  app.add_option("--distance", distance, "of the offset")->check(CLI::Range(1e-3, .4));
  app.add_option("--tolerance", tolerance, "of the round edges, in sides of the cube")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  return dsc_benchmark::measure(!inwards, n, distance, tolerance);
}
