// Reconstruction of solids with sharp edges, without notches and without cut corners.

#include "../../../benchmark/gear.h"
#include "reconstruction.h"
#include "test.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Crease_planes_3.h>
#include <CGAL/squared_distance_3.h>

namespace test_reconstruction_of_creases {

using namespace reconstruction;
using dsc_benchmark::clouds::Gear;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

std::vector<Kernel::Triangle_3> triangles_of(const Complex& complex) {
  std::vector<Kernel::Triangle_3> result;
  const auto surface = DSC::extract_interface(complex);
  const auto point = [&](std::size_t i) {
    const auto& p = surface.points[i];
    return Point(p.x(), p.y(), p.z());
  };
  for (const auto& t : surface.triangles)
    result.emplace_back(point(t[0]), point(t[1]), point(t[2]));
  return result;
}

TEST(Reconstruction_of_creases, makes_a_gear_without_nicks) {
  static constexpr unsigned teeth = 6;
  static constexpr double side = .045; // for cells with one point
  static constexpr int n = 4;          // samples along an edge
  const Gear gear(teeth);
  CGAL::Random random(5);
  const std::vector<Point> points = gear.sample(side, [&] { return random.get_double(); });
  Report report;
  const Complex complex =
      DSC::reconstruct_point_set_3<Complex>(points, parameters::report(std::ref(report)));
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(complex.euler_characteristic(1), 0);
  EXPECT_NEAR(complex.volume(1), gear.volume(), .002 * gear.volume());
  const auto triangles = triangles_of(complex);
  double largest = 0, squares = 0;
  for (const auto& t : triangles)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        largest = (std::max)(largest, gear.distance(t[0] + double(i) / n * (t[1] - t[0]) +
                                                    double(j) / n * (t[2] - t[0])));
  EXPECT_LT(largest, .5 * report.spacing);
  const std::vector<Point> creases = gear.creases();
  for (const Point& p : creases) {
    double nearest = 10;
    for (const auto& t : triangles)
      nearest = (std::min)(nearest, CGAL::squared_distance(p, t));
    squares += nearest;
  }
  EXPECT_LT(std::sqrt(squares / double(creases.size())), .1 * report.spacing);
}

TEST(Reconstruction_of_creases, finds_concave_corners) {
  using Place = internal::Sampled_surface_3::Point;
  using Vector = internal::Sampled_surface_3::Vector;
  CGAL::Random random(3);
  std::vector<Place> bracket; // a cube without its quarter x > .5, y > .5
  for (std::size_t k = 0; k < 8000; ++k) {
    double x[3] = {random.get_double(), random.get_double(), random.get_double()};
    const std::size_t face = k % 8;
    if (face < 6) {
      x[face % 3] = double(face / 3);
    } else {
      x[face - 6] = .5;
      x[7 - face] = (1 + x[7 - face]) / 2;
    }
    if (face >= 6 || x[0] <= .5 || x[1] <= .5)
      bracket.emplace_back(x[0], x[1], x[2]);
  }
  const internal::Sampled_surface_3 surface(bracket, {}, 1);
  const internal::Crease_planes_3 planes(surface);
  const double a = .4 * surface.cloud().spacing();
  // In the plane of the top, but outside both inner walls.
  const Place beside(.5 + a, .5 + a, 1);
  EXPECT_LT(std::sqrt((beside + planes.to_crease(beside) - Place(.5, .5, 1)).squared_length()),
            .1 * surface.cloud().spacing());
  const Place on_top(.5 - 2 * a, .5 - 2 * a, 1);
  EXPECT_EQ(planes.to_crease(on_top), Vector(0, 0, 0));
}

TEST(Reconstruction_of_creases, finds_where_planes_meet) {
  using Place = internal::Sampled_surface_3::Point;
  using Vector = internal::Sampled_surface_3::Vector;
  CGAL::Random random(3);
  std::vector<Place> cube;
  for (int k = 0; k < 6000; ++k) {
    double x[3] = {random.get_double(), random.get_double(), random.get_double()};
    x[k % 3] = k % 2;
    cube.emplace_back(x[0], x[1], x[2]);
  }
  const internal::Sampled_surface_3 surface(cube, {}, 1);
  const internal::Crease_planes_3 planes(surface);
  const double spacing = surface.cloud().spacing();
  const auto expect = [&](const Place& from, const Place& to) {
    EXPECT_LT(std::sqrt((from + planes.to_crease(from) - to).squared_length()), .1 * spacing);
  };
  const double a = .4 * spacing;
  expect({.5, a, a}, {.5, 0, 0});                           // a cut edge
  expect({.5, -a, -a}, {.5, 0, 0});                         // a fin
  expect({.5, -a, 0}, {.5, 0, 0});                          // beyond the end of a face
  expect({a, a, a}, {0, 0, 0});                             // a corner
  expect({.5, 2 * spacing, 0}, {.5, 2 * spacing, 0});       // on a face
  expect({.5, .5, a}, {.5, .5, a});                         // no edge is near
  EXPECT_EQ(planes.to_crease({.5, 0, 0}), Vector(0, 0, 0)); // on the edge
}

} // namespace test_reconstruction_of_creases
