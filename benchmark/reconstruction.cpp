// Reconstructs solids from points that sample known surfaces, by this package and by two methods of
// CGAL, and prints a table of distances.

#include "inputs.h"
#include "measures.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/extract_interface_3.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/number_utils.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>
#include <CGAL/reconstruct_point_set_3.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace dsc_benchmark {
namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

// Points and what is known of their surface.
struct Cloud
{
  std::vector<Point> points;
  std::function<double(const Point&)> distance; // from the surface; none if that is not known
  std::vector<Point> creases;                   // points on them
  double volume = 0;
};

// Uniform numbers, and those of a normal distribution.
class Numbers
{
public:
  explicit Numbers(unsigned seed) : m_random(seed) {}

  double uniform(double low, double high) { return m_random.uniform_real(low, high); }
  double normal() {
    const double u = 1 - m_random.get_double(), v = m_random.get_double();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * CGAL_PI * v);
  }
  Vector direction() {
    const Vector v(normal(), normal(), normal());
    return v / std::sqrt(v.squared_length());
  }

private:
  CGAL::Random m_random;
};

// A box about the origin with a hole along the z axis, turned.
class Drilled_box
{
public:
  Drilled_box(double width, double height, double hole, Numbers& numbers)
      : m_half(width / 2), m_top(height / 2), m_hole(hole) {
    m_axes[0] = numbers.direction();
    const Vector v = CGAL::cross_product(m_axes[0], numbers.direction());
    m_axes[1] = v / std::sqrt(v.squared_length());
    m_axes[2] = CGAL::cross_product(m_axes[0], m_axes[1]);
  }

  double volume() const { return 2 * m_top * (4 * m_half * m_half - CGAL_PI * m_hole * m_hole); }

  Point sample(Numbers& numbers) const {
    const double cover = 4 * m_half * m_half - CGAL_PI * m_hole * m_hole, side = 4 * m_half * m_top,
                 wall = 4 * CGAL_PI * m_hole * m_top;
    const double s = numbers.uniform(0, 2 * cover + 4 * side + wall);
    const double z = numbers.uniform(-m_top, m_top);
    if (s < 2 * cover) {
      double x, y;
      do {
        x = numbers.uniform(-m_half, m_half);
        y = numbers.uniform(-m_half, m_half);
      } while (x * x + y * y < m_hole * m_hole);
      return turned(x, y, s < cover ? m_top : -m_top);
    }
    if (s < 2 * cover + 4 * side) {
      const int k = int((s - 2 * cover) / side);
      const double u = numbers.uniform(-m_half, m_half), w = k % 2 == 0 ? m_half : -m_half;
      return k < 2 ? turned(w, u, z) : turned(u, w, z);
    }
    const double a = numbers.uniform(0, 2 * CGAL_PI);
    return turned(m_hole * std::cos(a), m_hole * std::sin(a), z);
  }

  double distance(const Point& p) const {
    const Vector v = p - CGAL::ORIGIN;
    const double x = std::abs(v * m_axes[0]), y = std::abs(v * m_axes[1]),
                 z = std::abs(v * m_axes[2]), r = std::hypot(x, y);
    const auto beyond = [](double q, double end) { return (std::max)(0., q - end); };
    const double cover = std::hypot(
        z - m_top, r < m_hole ? m_hole - r : std::hypot(beyond(x, m_half), beyond(y, m_half)));
    const double wall = m_hole > 0 ? std::hypot(r - m_hole, beyond(z, m_top)) : cover;
    const auto side = [&](double u, double w) {
      return std::hypot(u - m_half, std::hypot(beyond(w, m_half), beyond(z, m_top)));
    };
    return (std::min)({cover, wall, side(x, y), side(y, x)});
  }

  std::vector<Point> creases() const {
    static constexpr int n = 400; // points on each
    std::vector<Point> result;
    for (int i = 0; i < n; ++i) {
      const double t = 2 * (i + .5) / n - 1, a = CGAL_PI * t;
      for (double u : {-m_half, m_half}) {
        for (double z : {-m_top, m_top}) {
          result.push_back(turned(t * m_half, u, z));
          result.push_back(turned(u, t * m_half, z));
        }
        for (double w : {-m_half, m_half})
          result.push_back(turned(u, w, t * m_top));
      }
      for (double z : {-m_top, m_top})
        if (m_hole > 0)
          result.push_back(turned(m_hole * std::cos(a), m_hole * std::sin(a), z));
    }
    return result;
  }

private:
  Point turned(double x, double y, double z) const {
    return CGAL::ORIGIN + (x * m_axes[0] + y * m_axes[1] + z * m_axes[2]);
  }

  double m_half, m_top, m_hole;
  std::array<Vector, 3> m_axes;
};

Cloud drilled_box(double width, double height, double hole, std::size_t n, double noise,
                  unsigned seed) {
  Numbers numbers(seed);
  const Drilled_box box(width, height, hole, numbers);
  Cloud cloud{{}, [box](const Point& p) { return box.distance(p); }, box.creases(), box.volume()};
  for (std::size_t i = 0; i < n; ++i)
    cloud.points.push_back(box.sample(numbers) +
                           noise * Vector(numbers.normal(), numbers.normal(), numbers.normal()));
  return cloud;
}

// Spheres about the origin and (2.5, 0, 0); inner ones have half the radius.
Cloud spheres(const std::vector<std::array<double, 3>>& number_center_radius) {
  Numbers numbers(1);
  Cloud cloud;
  for (const auto& [n, x, r] : number_center_radius) {
    for (int i = 0; i < int(n); ++i)
      cloud.points.push_back(Point(x, 0, 0) + r * numbers.direction());
    cloud.volume += (r < 1 ? -1 : 1) * 4 * CGAL_PI / 3 * r * r * r;
  }
  cloud.distance = [number_center_radius](const Point& p) {
    double result = 10;
    for (const auto& [n, x, r] : number_center_radius)
      result =
          (std::min)(result, std::abs(std::sqrt(CGAL::squared_distance(p, Point(x, 0, 0))) - r));
    return result;
  };
  return cloud;
}

double signed_volume(const Surface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles)
    sum +=
        CGAL::determinant(surface.points[t[0]] - CGAL::ORIGIN, surface.points[t[1]] - CGAL::ORIGIN,
                          surface.points[t[2]] - CGAL::ORIGIN) /
        6;
  return sum;
}

// Uniform on a closed surface.
Cloud of_surface(const std::string& path, std::size_t n) {
  Numbers numbers(1);
  const Surface surface = read_input(path, 0);
  std::vector<double> areas = {0};
  for (const auto& t : surface.triangles)
    areas.push_back(areas.back() +
                    std::sqrt(CGAL::squared_area(surface.points[t[0]], surface.points[t[1]],
                                                 surface.points[t[2]])));
  Cloud cloud;
  cloud.volume = std::abs(signed_volume(surface));
  for (std::size_t i = 0; i < n; ++i) {
    const double s = numbers.uniform(0, areas.back());
    const auto place = std::upper_bound(areas.begin() + 1, areas.end() - 1, s) - areas.begin() - 1;
    const auto& t = surface.triangles[std::size_t(place)];
    double u = numbers.uniform(0, 1), v = numbers.uniform(0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Point& p = surface.points[t[0]];
    cloud.points.push_back(p + u * (surface.points[t[1]] - p) + v * (surface.points[t[2]] - p));
  }
  return cloud;
}

Cloud of_file(const std::string& path) {
  Cloud cloud;
  std::ifstream in(path);
  double x, y, z, nx, ny, nz;
  while (in >> x >> y >> z >> nx >> ny >> nz)
    cloud.points.emplace_back(x, y, z);
  return cloud;
}

Mesh by_complex(const std::vector<Point>& points) {
  const Complex complex = CGAL::reconstruct_point_set_3<Complex>(points);
  Mesh mesh;
  CGAL::interface_to_surface_mesh(CGAL::extract_interface(complex), mesh);
  return mesh;
}

Mesh by_poisson(const std::vector<Point>& points) {
  using Pair = std::pair<Point, Vector>;
  static constexpr unsigned neighbors = 18;
  std::vector<Pair> pairs;
  for (const Point& p : points)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  const auto maps = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                        .normal_map(CGAL::Second_of_pair_property_map<Pair>());
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(pairs, neighbors, maps);
  pairs.erase(CGAL::mst_orient_normals(pairs, neighbors, maps), pairs.end());
  Mesh mesh;
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, 6);
  CGAL::poisson_surface_reconstruction_delaunay(
      pairs.begin(), pairs.end(), CGAL::First_of_pair_property_map<Pair>(),
      CGAL::Second_of_pair_property_map<Pair>(), mesh, spacing);
  return mesh;
}

Mesh by_advancing_front(const std::vector<Point>& points) {
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(triangles));
  std::vector<Point> used = points;
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::orient_polygon_soup(used, triangles);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(used, triangles, mesh);
  return mesh;
}

double root_mean_square(const std::vector<double>& values, double unit) {
  double sum = 0;
  for (double v : values)
    sum += v * v;
  return std::sqrt(sum / double(values.size())) / unit;
}

// Of all of the surface from the truth, by points on each triangle.
double root_mean_square_of(const Mesh& mesh, const Cloud& cloud, double unit) {
  static constexpr int n = 4;
  double squares = 0, areas = 0;
  for (auto f : mesh.faces()) {
    std::array<Point, 3> p;
    std::size_t k = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p[k++] = mesh.point(v);
    const double area = std::sqrt(CGAL::squared_area(p[0], p[1], p[2]));
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const double d = cloud.distance(p[0] + (i + 1. / 3) / n * (p[1] - p[0]) +
                                        (j + 1. / 3) / n * (p[2] - p[0]));
        squares += area * d * d;
        areas += area;
      }
  }
  return std::sqrt(squares / areas) / unit;
}

void measure(const std::string& name, const Cloud& cloud, const std::string& method,
             Mesh (*reconstruct)(const std::vector<Point>&)) {
  const double begin = processor_seconds();
  const Mesh mesh = reconstruct(cloud.points);
  const double seconds = processor_seconds() - begin;
  std::cout << "| " << name << " | " << method << " | ";
  if (mesh.number_of_faces() == 0) {
    std::cout << "nothing found | | | | | | | | " << seconds << " |\n";
    return;
  }
  // CGAL counts a point among its own neighbors.
  const double spacing =
      CGAL::compute_average_spacing<CGAL::Sequential_tag>(cloud.points, 6) * 7 / 6;
  Tree tree(mesh.faces().begin(), mesh.faces().end(), mesh);
  tree.accelerate_distance_queries();
  const auto distances = [&](const std::vector<Point>& points) {
    std::vector<double> result;
    for (const Point& p : points)
      result.push_back(std::sqrt(tree.squared_distance(p)));
    return result;
  };
  std::size_t open_edges = 0;
  for (auto h : mesh.halfedges())
    open_edges += mesh.is_border(h);
  const std::vector<double> of_points = distances(cloud.points);
  std::cout << mesh.number_of_faces() << " | "
            << long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) +
                   long(mesh.number_of_faces())
            << " | " << open_edges << " | " << root_mean_square(of_points, spacing) << " | "
            << *std::max_element(of_points.begin(), of_points.end()) / spacing << " | ";
  if (cloud.distance)
    std::cout << root_mean_square_of(mesh, cloud, spacing);
  std::cout << " | ";
  if (!cloud.creases.empty())
    std::cout << root_mean_square(distances(cloud.creases), spacing);
  std::cout << " | ";
  if (cloud.volume > 0)
    std::cout << 100 * (CGAL::Polygon_mesh_processing::volume(mesh) / cloud.volume - 1);
  std::cout << " | " << seconds << " |" << std::endl;
}

Cloud make_cloud(const std::string& name, const std::string& data, unsigned seed,
                 std::size_t points) {
  if (name == "kitten")
    return of_file(data + "/points_3/kitten.xyz");
  if (name == "tunnel")
    return drilled_box(2, 1, .4, points, 0, seed);
  if (name == "noise")
    return drilled_box(2, 1, .4, points, .005, seed);
  if (name == "fandisk" || name == "elephant")
    return of_surface(data + "/meshes/" + name + ".off", name == "fandisk" ? 30000 : 20000);
  if (name == "spheres")
    return spheres({{4000, 0, 1}, {4000, 2.5, 1}});
  if (name == "nested")
    return spheres({{8000, 0, 1}, {2000, 0, .5}});
  throw CLI::ValidationError(name + " is no cloud");
}

} // namespace
} // namespace dsc_benchmark

int main(int argc, char** argv) {
  using namespace dsc_benchmark;
  std::string name, data;
  unsigned seed = 1;
  std::size_t points = 20000;
  bool with_peers = false;
  CLI::App app("Solids from points");
  app.add_option("CLOUD", name, "kitten, tunnel, noise, fandisk, elephant, spheres, nested")
      ->required();
  app.add_option("--data", data, "Folder with CGAL's meshes and points_3")->required();
  app.add_option("--seed", seed);
  app.add_option("--points", points, "Of tunnel and noise");
  app.add_flag("--peers", with_peers, "Measure CGAL's Poisson and advancing front, too");
  CLI11_PARSE(app, argc, argv);
  const Cloud cloud = make_cloud(name, data, seed, points);
  const std::string row =
      name + (name == "tunnel" || name == "noise" ? " " + std::to_string(seed) : std::string());
  measure(row, cloud, "this package", by_complex);
  if (with_peers) {
    measure(row, cloud, "Poisson", by_poisson);
    measure(row, cloud, "advancing front", by_advancing_front);
  }
}
