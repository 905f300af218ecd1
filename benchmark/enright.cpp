// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Advects a surface in the Enright flow and back, and measures the difference from its initial
// state. Prints a row of a table, without the table head.

#include "inputs.h"
#include "interface_at_start.h"
#include "measures.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/bounding_box.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

namespace parameters = CGAL::parameters;

using Defaults = CGAL::Deformable_simplicial_complexes::defaults::Adaptive_advection<3>;

constexpr double radius = .15;
const Point center(.35, .35, .35);

struct Run
{
  std::string input;
  std::size_t triangles = 0;    // triangles after decimation of other inputs; 0: no decimation
  std::size_t subdivision = 16; // of the sphere
  double period = 1;
  double end = 2;
  double dt = .01;
  double tolerance = Defaults::interface_tolerance;  // in mean edges; 0: no adaptation
  unsigned interval = Defaults::adaptation_interval; // steps
  bool restores_volume = false;
};

// Returns the input. The ball of `radius` about `center` encloses any input other than `sphere`.
Surface read_surface(const Run& run) {
  Surface surface = run.input == "sphere" ? sphere(radius, run.subdivision)
                                          : read_input(run.input, run.triangles);
  const CGAL::Bbox_3 box = CGAL::bounding_box(surface.points.begin(), surface.points.end()).bbox();
  const Kernel::Point_3 middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                               (box.zmin() + box.zmax()) / 2);
  double farthest = 0;
  for (const auto& p : surface.points)
    farthest = (std::max)(farthest, std::sqrt((p - middle).squared_length()));
  const double scale = run.input == "sphere" ? 1 : radius / farthest;
  for (auto& p : surface.points)
    p = Kernel::Point_3(center.x(), center.y(), center.z()) + scale * (p - middle);
  return surface;
}

// Returns the volume between the interface and the exact sphere. Each triangle is subdivided; the
// volume is the solid angle times the difference of the cubes of the radii.
double volume_between_interface_and_sphere(const Complex& complex) {
  static constexpr int parts = 4;
  double sum = 0;
  for (const auto& facet : complex.interface_facets()) {
    const auto v = complex.facet_vertices(facet);
    const Vector a = complex.position(v[0]) - center,
                 b = complex.position(v[1]) - complex.position(v[0]),
                 c = complex.position(v[2]) - complex.position(v[0]);
    const Vector normal = CGAL::cross_product(b, c) / (2. * parts * parts);
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j + i < parts; ++j)
        for (int half = 0; half < (i + j + 2 <= parts ? 2 : 1); ++half) {
          const double s = (i + (half + 1) / 3.) / parts, t = (j + (half + 1) / 3.) / parts;
          const Vector x = a + s * b + t * c;
          const double r = std::sqrt(x.squared_length());
          const double solid_angle = std::abs(normal * x) / (r * r * r);
          sum += solid_angle * std::abs(r * r * r - radius * radius * radius) / 3;
        }
  }
  return sum;
}

double mean_distance_to_sphere(const Complex& complex) {
  const auto vertices = complex.interface_vertices();
  double sum = 0;
  for (const auto v : vertices)
    sum += std::abs(std::sqrt((complex.position(v) - center).squared_length()) - radius);
  return sum / double(vertices.size());
}

int flow(const Run& run) {
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{read_surface(run)}, CGAL::Tetgen_tetrahedralizer_3(),
      parameters::enclosing_box(CGAL::Bbox_3(0, 0, 0, 1, 1, 1)).box_subdivision(8));
  const DSC::Enright_velocity_3 velocity(run.period);
  const Interface_at_start start(complex);
  const double volume = complex.volume(1), area = complex.area(1);
  const double edge = complex.mean_interface_edge();
  const std::size_t triangles = complex.interface_facets().size();
  const double sweep = sweep_seconds(complex, complex.cells());

  const auto steps = std::size_t(std::lround(run.end / run.dt));
  const auto steps_in_period = std::size_t(std::lround(run.period / run.dt));
  std::size_t incomplete = 0, most_triangles = triangles;
  double at_periods = 0, between = 0, area_in_the_middle = 0, mean_distance = 0,
         largest_distance = 0;
  double seconds = 0;
  bool is_valid = true;
  for (std::size_t i = 0; i < steps; ++i) {
    const double begin = processor_seconds();
    const auto report = DSC::advect_adaptively(
        complex, velocity, double(i) * run.dt, run.dt,
        parameters::interface_tolerance(run.tolerance).adaptation_interval(run.interval));
    bool is_complete = report.complete;
    if (run.restores_volume && i % run.interval == 0)
      is_complete = DSC::restore_volumes(complex, std::map<int, double>{{1, volume}},
                                         parameters::quality_threshold(Defaults::quality_threshold))
                        .complete &&
                    is_complete;
    seconds += processor_seconds() - begin;
    incomplete += !is_complete;
    most_triangles = (std::max)(most_triangles, complex.interface_facets().size());
    const double change = std::abs(complex.volume(1) / volume - 1);
    if ((i + 1) % steps_in_period == 0) {
      at_periods = (std::max)(at_periods, change);
      const auto [mean, largest] = start.distances(complex);
      mean_distance = (std::max)(mean_distance, mean);
      largest_distance = (std::max)(largest_distance, largest);
      is_valid = is_valid && check(complex);
    } else {
      between = (std::max)(between, change);
    }
    if (2 * (i + 1) == steps_in_period)
      area_in_the_middle = complex.area(1) / area;
  }

  std::cout.precision(4);
  std::cout << "| " << run.input.substr(run.input.find_last_of('/') + 1) << " | " << run.period
            << " | " << run.tolerance << " | " << triangles << " | " << most_triangles << " | "
            << complex.interface_facets().size() << " | " << (is_valid ? "yes" : "**no**") << " | "
            << incomplete << " | " << 100 * at_periods << " | " << 100 * between << " | "
            << mean_distance / edge << " | " << largest_distance / edge << " | ";
  if (run.input == "sphere")
    std::cout << volume_between_interface_and_sphere(complex) << " | "
              << mean_distance_to_sphere(complex);
  else
    std::cout << "– | –";
  std::cout.precision(7);
  std::cout << " | " << area_in_the_middle;
  std::cout.precision(4);
  std::cout << " | " << seconds << " | " << seconds / double(steps) / sweep << " |" << std::endl;
  return is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  CLI::App app(
      "Takes a surface through the Enright flow and back, and measures what is left of it.");
  dsc_benchmark::Run run;
  app.add_option("input", run.input, "a closed surface, or `sphere`")->required();
  app.add_option("-n", run.subdivision, "of the sphere, which has 20 n^2 triangles")
      ->check(CLI::PositiveNumber);
  app.add_option("--triangles", run.triangles, "to which any other surface is decimated")
      ->check(CLI::PositiveNumber);
  app.add_option("--period", run.period, "after which everything is back")
      ->check(CLI::PositiveNumber);
  app.add_option("--end", run.end, "the time of the end")->check(CLI::PositiveNumber);
  app.add_option("--dt", run.dt, "the length of a step")->check(CLI::PositiveNumber);
  app.add_option("--tolerance", run.tolerance,
                 "by which the interface is adapted, in mean edges; 0 for not at all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--interval", run.interval, "adapt interface and mesh every so many steps")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--restore-volume", run.restores_volume, "restore the volume as often as that");
  CLI11_PARSE(app, argc, argv);
  try {
    return dsc_benchmark::flow(run);
  } catch (const std::exception& error) {
    std::cerr << "enright: " << run.input << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
