// Reconstructs solids and sheets from points of known surfaces by this package and by two methods
// of CGAL, and prints a row of a table for each method.

#include "Triangle_distances.h"
#include "clouds.h"
#include "inputs.h"
#include "measures.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Mesh_files/point_set_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_sheet_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc_benchmark {
namespace {

using clouds::Cloud;
using clouds::Drilled_box;
using clouds::Point;
using clouds::Vector;
using Mesh = CGAL::Surface_mesh<Point>;
namespace parameters = CGAL::parameters;

struct Reconstruction
{
  Mesh mesh;
  std::string told = {}; ///< according to the report
};

using Method = std::function<Reconstruction(const std::vector<Point>&)>;

Reconstruction by_complex(const std::vector<Point>& points, unsigned threads) {
  CGAL::Deformable_simplicial_complexes::Reconstruction_report_3<Complex> report;
  const Complex complex = DSC::reconstruct_point_set_3<Complex>(
      points, parameters::number_of_threads(threads).report(std::ref(report)));
  Reconstruction result;
  DSC::interface_to_surface_mesh(DSC::extract_interface(complex), result.mesh);
  const auto tell = [&](std::size_t number, const char* what) {
    if (number > 0)
      result.told += (result.told.empty() ? "" : ", ") + std::to_string(number) + " " + what;
  };
  tell(report.facets_without_points.size(), "triangles without points");
  tell(report.number_of_outliers, "outliers");
  tell(report.unfit_points.size(), "unfit points");
  tell(report.doubtful_places.size(), "doubtful places");
  if (!report.is_complete && report.doubtful_places.empty())
    tell(report.number_of_steps, "steps were not enough");
  return result;
}

Reconstruction by_poisson(const std::vector<Point>& points) {
  using Pair = std::pair<Point, Vector>;
  static constexpr unsigned neighbors = 18;
  std::vector<Pair> pairs;
  for (const Point& p : points)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                        .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(pairs, neighbors, maps);
  pairs.erase(CGAL::mst_orient_normals(pairs, neighbors, maps), pairs.end());
  Reconstruction result;
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, 6);
  CGAL::poisson_surface_reconstruction_delaunay(
      pairs.begin(), pairs.end(), CGAL::First_of_pair_property_map<Pair>(),
      CGAL::Second_of_pair_property_map<Pair>(), result.mesh, spacing);
  return result;
}

Reconstruction of_soup(std::vector<Point> points,
                       std::vector<std::array<std::size_t, 3>> triangles) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::orient_polygon_soup(points, triangles);
  Reconstruction result;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, result.mesh);
  return result;
}

Reconstruction by_sheet(const std::vector<Point>& points, unsigned threads) {
  CGAL::Deformable_simplicial_complexes::Sheet_report_3 report;
  const auto sheet = DSC::reconstruct_sheet_3(
      points, parameters::number_of_threads(threads).report(std::ref(report)));
  std::vector<Point> used;
  for (const auto& p : sheet.points)
    used.emplace_back(p.x(), p.y(), p.z());
  Reconstruction result = of_soup(used, sheet.triangles);
  result.told = std::to_string(report.number_of_components) + " components, " +
                std::to_string(report.number_of_boundaries) + " boundaries, " +
                (report.is_complete ? "complete" : "not complete");
  return result;
}

Reconstruction by_advancing_front(const std::vector<Point>& points) {
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(triangles));
  return of_soup(points, triangles);
}

/// Root mean square and maximum.
struct Spread
{
  double squares = 0, weights = 0, largest = 0;

  void add(double value, double weight = 1) {
    squares += weight * value * value;
    weights += weight;
    largest = (std::max)(largest, value);
  }
  void print(double unit) const {
    if (weights > 0)
      std::cout << std::sqrt(squares / weights) / unit << " | " << largest / unit << " | ";
    else
      std::cout << " | | ";
  }
};

/// Returns the distances of the surface from the truth, sampled on each triangle.
Spread of_surface_from_truth(const std::vector<Kernel::Triangle_3>& triangles, const Cloud& cloud) {
  static constexpr int n = 4; // samples along an edge
  Spread result;
  for (const auto& t : triangles)
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        result.add(cloud.distance(t[0] + (i + 1. / 3) / n * (t[1] - t[0]) +
                                  (j + 1. / 3) / n * (t[2] - t[0])),
                   std::sqrt(t.squared_area()));
  return result;
}

double resident_megabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

std::vector<Kernel::Triangle_3> triangles_of(const Mesh& mesh) {
  std::vector<Kernel::Triangle_3> result;
  for (auto f : mesh.faces()) {
    std::array<Point, 3> p;
    std::size_t k = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p[k++] = mesh.point(v);
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

void measure(const std::string& name, const Cloud& cloud, const std::string& method,
             const Method& reconstruct) {
  std::vector<Point> given = cloud.points;
  given.insert(given.end(), cloud.outliers.begin(), cloud.outliers.end());
  std::cout << "| " << name << " | " << method << " | ";
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const double processor_begin = processor_seconds();
  Reconstruction found;
  try {
    found = reconstruct(given);
  } catch (const CGAL::Deformable_simplicial_complexes::Error& error) {
    found.told = "refused: " + std::string(error.what());
  }
  const double processor = processor_seconds() - processor_begin,
               seconds = std::chrono::duration<double>(Clock::now() - begin).count(),
               megabytes = resident_megabytes();
  const Mesh& mesh = found.mesh;
  if (mesh.number_of_faces() == 0) {
    std::cout << "0 | | | | | | | | | ";
  } else {
    // The neighbors of CGAL include the point itself.
    const double spacing =
        CGAL::compute_average_spacing<CGAL::Sequential_tag>(cloud.points, 6) * 7 / 6;
    const std::vector<Kernel::Triangle_3> triangles = triangles_of(mesh);
    const Triangle_distances distance(triangles);
    std::size_t open_edges = 0;
    for (auto h : mesh.halfedges())
      open_edges += mesh.is_border(h);
    Spread of_points, of_creases;
    for (const Point& p : cloud.points)
      of_points.add(distance(p));
    for (const Point& p : cloud.creases)
      of_creases.add(distance(p));
    std::cout << mesh.number_of_faces() << " | "
              << long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) +
                     long(mesh.number_of_faces())
              << " | " << open_edges << " | ";
    of_points.print(spacing);
    (cloud.distance ? of_surface_from_truth(triangles, cloud) : Spread()).print(spacing);
    if (!cloud.creases.empty())
      std::cout << std::sqrt(of_creases.squares / of_creases.weights) / spacing;
    std::cout << " | ";
    if (cloud.volume > 0 && open_edges == 0)
      std::cout << 100 * (CGAL::Polygon_mesh_processing::volume(mesh) / cloud.volume - 1);
    std::cout << " | ";
  }
  std::cout << found.told << " | " << processor << " | " << seconds << " | " << long(megabytes)
            << " |" << std::endl;
}

struct Options
{
  std::string cloud;
  unsigned seed = 1, threads = 1;
  std::size_t points = 20000;
  double width = 0; // in spacings
  bool is_open = false, with_peers = false;
};

Cloud make_cloud(const Options& options) {
  static constexpr double width = 2, height = 1, hole = .4, noise = .005, outliers = .01,
                          gear_side = .02; // side length of cells with one point: 34 000 points
  const std::size_t n = options.points;
  const unsigned seed = options.seed;
  const Drilled_box box(width, height, hole);
  const double spacing = clouds::spacing_on_plane(box.area() / double(n));
  const std::string& name = options.cloud;
  if (name == "tunnel")
    return clouds::drilled_box(box, n, seed);
  if (name == "noise")
    return clouds::drilled_box(box, n, seed, noise);
  if (name == "outliers") {
    Cloud cloud = clouds::drilled_box(box, n, seed);
    clouds::add_outliers(cloud, outliers, seed + 1);
    return cloud;
  }
  if (name == "hole")
    return clouds::drilled_box(box, n, seed, 0, options.width * spacing);
  if (name == "narrow") {
    const double unit = clouds::spacing_on_plane(
        Drilled_box(width, height, options.width / 2 * spacing).area() / double(n));
    return clouds::drilled_box(Drilled_box(width, height, options.width / 2 * unit), n, seed);
  }
  if (name == "plate") {
    const double unit = clouds::spacing_on_plane(Drilled_box(width, 0, 0).area() / double(n));
    return clouds::drilled_box(Drilled_box(width, options.width * unit, 0), n, seed);
  }
  if (name == "gear")
    return clouds::gear(gear_side, seed);
  if (name == "noisy_gear")
    return clouds::gear(gear_side, seed, noise);
  if (name == "spheres")
    return clouds::spheres({{4000, 0, 1}, {4000, 2.5, 1}}, seed);
  if (name == "nested")
    return clouds::spheres({{8000, 0, 1}, {2000, 0, .5}}, seed);
  if (name.size() > 4 && name.substr(name.size() - 4) == ".off")
    return clouds::of_surface<Triangle_distances>(read_input(name, 0), n, seed);
  Cloud cloud;
  for (const auto& p : CGAL::IO::read_point_set(name))
    cloud.points.push_back(p.first);
  return cloud;
}

std::string name_of_row(const Options& options) {
  std::string result = options.cloud.substr(options.cloud.find_last_of('/') + 1);
  if (options.width > 0) {
    const std::string digits = std::to_string(options.width);
    result += " " + digits.substr(0, digits.find('.') + 2) + " sp";
  }
  return result + " " + std::to_string(options.seed);
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  using namespace dsc_benchmark;
  Options options;
  CLI::App app("Solids from points");
  app.add_option("CLOUD", options.cloud,
                 "tunnel, noise, outliers, hole, narrow, plate, gear, noisy_gear, spheres, nested, "
                 "a closed surface to "
                 "take random points of (.off), or points (.xyz, .pwn, .ply)")
      ->required();
  app.add_option("--seed", options.seed, "Of points and rotation");
  app.add_option("--points", options.points, "How many; those of spheres and files are fixed");
  app.add_option("--width", options.width,
                 "Of what the cloud is named for, in mean distances of a point from its neighbors");
  app.add_option("--threads", options.threads);
  app.add_flag("--open", options.is_open, "Reconstruct an open sheet");
  app.add_flag("--peers", options.with_peers, "Measure CGAL's Poisson and advancing front, too");
  CLI11_PARSE(app, argc, argv);
  const Cloud cloud = make_cloud(options);
  const std::string row = name_of_row(options);
  measure(row, cloud, "this package", [&](const auto& points) {
    return options.is_open ? by_sheet(points, options.threads)
                           : by_complex(points, options.threads);
  });
  if (options.with_peers) {
    measure(row, cloud, "Poisson", by_poisson);
    measure(row, cloud, "advancing front", by_advancing_front);
  }
}
