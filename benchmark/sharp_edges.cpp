// Reconstructs solids with sharp edges from points. Prints a row of a table for each solid, with
// the distances of the result from the solid and of the solid from the result.

#include "Triangle_distances.h"
#include "clouds.h"
#include "measures.h"
#include "solids.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using clouds::Gear;
using clouds::Numbers;
using clouds::Turn;
using Point_3 = Kernel::Point_3;
namespace parameters = CGAL::parameters;

/// A solid that is known exactly, before its rotation.
struct Solid
{
  std::function<std::vector<Point_3>(std::size_t, Numbers&)> sample; ///< of about this size
  std::function<double(const Point_3&)> distance;
  std::vector<Point_3> creases; ///< points on sharp edges
};

Solid gear(unsigned teeth) {
  const Gear gear(teeth);
  return {[gear](std::size_t n, Numbers& numbers) {
            return gear.sample(std::sqrt(gear.area() / double(n)),
                               [&] { return numbers.uniform(0, 1); });
          },
          [gear](const Point_3& p) { return gear.distance(p); }, gear.creases()};
}

Solid polyhedron(const Surface& surface) {
  Triangle_distances::Triangles triangles;
  std::vector<double> areas = {0};
  for (const auto& t : surface.triangles) {
    triangles.emplace_back(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
    areas.push_back(areas.back() + std::sqrt(triangles.back().squared_area()));
  }
  const auto distances = std::make_shared<Triangle_distances>(triangles);
  return {[triangles, areas](std::size_t n, Numbers& numbers) {
            std::vector<Point_3> result;
            while (result.size() < n) {
              const double s = numbers.uniform(0, areas.back());
              const auto place = std::upper_bound(areas.begin() + 1, areas.end() - 1, s);
              const auto& t = triangles[std::size_t(place - areas.begin() - 1)];
              const double u = std::sqrt(numbers.uniform(0, 1)), v = numbers.uniform(0, 1);
              result.push_back(t[0] + u * (t[1] - t[0]) + u * v * (t[2] - t[1]));
            }
            return result;
          },
          [distances](const Point_3& p) { return (*distances)(p); }, solids::creases(surface)};
}

Solid make_solid(const std::string& name, unsigned teeth) {
  static constexpr std::size_t round = 720; // sides, within 1e-5 radii of a circle
  const double half_diagonal = std::sqrt(.5);
  const solids::Outline square = solids::regular_polygon(4, half_diagonal),
                        circle = solids::regular_polygon(round, .5);
  if (name == "cube")
    return polyhedron(solids::prism(square, 1));
  if (name == "bracket")
    return polyhedron(
        solids::prism({{{.3, .3}}, {{.3, 1}}, {{0, 1}}, {{0, 0}}, {{1, 0}}, {{1, .3}}}, .5));
  if (name == "plate")
    return polyhedron(solids::prism(square, .05));
  if (name == "cylinder")
    return polyhedron(solids::prism(circle, 1));
  if (name == "cone")
    return polyhedron(solids::pyramid(circle, 1));
  if (name == "pyramid")
    return polyhedron(solids::pyramid(square, 1.5));
  return gear(teeth);
}

std::vector<Kernel::Triangle_3> triangles_of(const Complex& complex) {
  std::vector<Kernel::Triangle_3> result;
  const auto surface = DSC::extract_interface(complex);
  const auto point = [&](std::size_t i) {
    const auto& p = surface.points[i];
    return Point_3(p.x(), p.y(), p.z());
  };
  for (const auto& t : surface.triangles)
    result.emplace_back(point(t[0]), point(t[1]), point(t[2]));
  return result;
}

struct Options
{
  std::string solid;
  unsigned seed = 1, teeth = 12;
  std::size_t points = 20000;
  double noise = 0; // in spacings
};

void measure(const Options& options) {
  static constexpr std::size_t truth = 400000; // samples of the solid
  static constexpr int n = 8;                  // samples along an edge of a triangle
  Numbers numbers(options.seed);
  const Turn turn(numbers);
  const Solid solid = make_solid(options.solid, options.teeth);
  std::vector<Point_3> points = solid.sample(options.points, numbers);
  const auto spacing_of = [](const std::vector<Point_3>& given) {
    return CGAL::Deformable_simplicial_complexes::internal::Point_cloud_3(
               CGAL::Deformable_simplicial_complexes::internal::cloud_points(given), {}, 1)
        .spacing();
  };
  const double spacing = spacing_of(points);
  for (Point_3& p : points)
    p = turn(p) + options.noise * spacing * numbers.vector();
  const double begin = processor_seconds();
  CGAL::Deformable_simplicial_complexes::Reconstruction_report_3<Complex> report;
  const Complex complex =
      DSC::reconstruct_point_set_3<Complex>(points, parameters::report(std::ref(report)));
  const double seconds = processor_seconds() - begin;

  const auto triangles = triangles_of(complex);
  double to_truth = 0, squares = 0, weights = 0;
  for (const auto& t : triangles) {
    const double area = std::sqrt(t.squared_area());
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const double d = solid.distance(
            turn.back(t[0] + double(i) / n * (t[1] - t[0]) + double(j) / n * (t[2] - t[0])));
        squares += d * d * area;
        weights += area;
        to_truth = (std::max)(to_truth, d);
      }
  }
  const Triangle_distances distance(triangles);
  double to_surface = 0, crease_squares = 0;
  for (const Point_3& p : solid.sample(truth, numbers))
    to_surface = (std::max)(to_surface, distance(turn(p)));
  for (const Point_3& p : solid.creases) {
    const double d = distance(turn(p));
    crease_squares += d * d;
    to_surface = (std::max)(to_surface, d);
  }
  std::cout << "| " << options.solid;
  if (options.solid == "gear")
    std::cout << ", " << options.teeth << " teeth";
  std::cout << " | " << points.size() << " | " << options.seed << " | " << options.noise << " | "
            << std::sqrt(squares / weights) / spacing << " | " << to_truth / spacing << " | "
            << to_surface / spacing << " | "
            << std::sqrt(crease_squares / double(solid.creases.size())) / spacing << " | "
            << triangles.size() << " | " << complex.number_of_components(1) << " | "
            << complex.euler_characteristic(1) << " | " << seconds << " |" << std::endl;
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  using namespace dsc_benchmark;
  Options options;
  CLI::App app("Reconstructs a solid with sharp edges from its points.");
  app.add_option("solid", options.solid, "gear, cube, bracket, plate, cylinder, cone or pyramid")
      ->required();
  app.add_option("--seed", options.seed);
  app.add_option("--teeth", options.teeth);
  app.add_option("--points", options.points);
  app.add_option("--noise", options.noise, "standard deviation along each axis, in spacings");
  CLI11_PARSE(app, argc, argv);
  measure(options);
}
