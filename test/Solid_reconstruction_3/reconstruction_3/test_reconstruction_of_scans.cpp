// Reconstruction of scans: points of any density, any unit of length, and interruption at any
// moment.

#include "reconstruction.h"
#include "test.h"

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Random.h>

namespace test_reconstruction_of_scans {

using namespace reconstruction;
using CGAL::Deformable_simplicial_complexes::Interrupted_error;
using CGAL::Deformable_simplicial_complexes::Invalid_points_error;
using CGAL::Deformable_simplicial_complexes::Progress_scope;

// A house with a flat roof. The points of the floor are denser.
std::vector<Point> house(std::size_t n) {
  CGAL::Random random(3);
  std::vector<Point> points;
  while (points.size() < n) {
    const double part = random.get_double(), u = random.uniform_real(-1., 1.),
                 v = random.uniform_real(-1., 1.), side = random.get_bool() ? 1 : -1;
    if (part < .6)
      points.emplace_back(u, v, 0);
    else if (part < .7)
      points.emplace_back(u, v, 1);
    else if (part < .85)
      points.emplace_back(side, u, (v + 1) / 2);
    else
      points.emplace_back(u, side, (v + 1) / 2);
  }
  return points;
}

// A ball about a point that is not the origin.
std::vector<Point> ball(int n, double scale) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
    points.emplace_back(scale * (r * std::cos(a) + 3), scale * (r * std::sin(a) - 2),
                        scale * (z + .5));
  }
  return points;
}

// If points are denser in some parts, the target cell size differs much between neighbors. If the
// initial cells were degenerate, their improvement would take most of the time.
TEST(Reconstruction_of_scans, begins_with_cells_of_good_shape) {
  static constexpr double flat = .05;
  Complex complex;
  const auto observer = [&](const Complex& start, std::size_t) {
    complex = start;
    return false;
  };
  const std::vector<Point> points = house(12000);
  DSC::reconstruct_point_set_3<Complex>(points, parameters::observer(observer));
  std::size_t number_of_flat = 0;
  for (auto c : complex.cells())
    number_of_flat += c->quality() < flat;
  EXPECT_EQ(number_of_flat, 0);
  EXPECT_LT(complex.number_of_cells(), 8 * points.size());
}

TEST(Reconstruction_of_scans, leaves_clusters_of_outliers_out) {
  static constexpr std::size_t outliers = 60;
  std::vector<Point> points = ball(2000, 1);
  CGAL::Random random(9);
  for (std::size_t i = 0; i < outliers; ++i) {
    const double x = random.uniform_real(5., 6.), y = random.uniform_real(-1., 0.),
                 z = random.uniform_real(1., 2.);
    points.emplace_back(x, y, z);
  }
  Report report;
  const Complex complex =
      DSC::reconstruct_point_set_3<Complex>(points, parameters::report(std::ref(report)));
  EXPECT_EQ(report.number_of_outliers, outliers);
  EXPECT_EQ(report.number_of_points, 2000);
  EXPECT_EQ(complex.number_of_components(1), 1);
  EXPECT_TRUE(report.is_complete);
}

TEST(Reconstruction_of_scans, refuses_open_sheets) {
  CGAL::Random random(4);
  std::vector<Point> hills;
  for (int i = 0; i < 1500; ++i) {
    const double x = random.get_double(), y = random.get_double();
    hills.emplace_back(x, y, .1 * std::sin(6 * x) * std::cos(6 * y));
  }
  const auto error =
      thrown_by<Invalid_points_error>([&] { DSC::reconstruct_point_set_3<Complex>(hills); });
  EXPECT_EQ(error.reason(), Invalid_points_error::Reason::sheet);
  EXPECT_PRED2(contains, std::string(error.what()), "open sheet") << error.what();
}

TEST(Reconstruction_of_scans, stops_at_any_moment) {
  const std::vector<Point> points = ball(500, 1);
  const auto reconstruct = [&](const std::function<bool()>& go_on) {
    Report report;
    report.number_of_points = 17;
    const Progress_scope scope([&](const char*) { return go_on(); }, std::chrono::milliseconds(0));
    try {
      DSC::reconstruct_point_set_3<Complex>(points, parameters::report(std::ref(report)));
    } catch (const Interrupted_error&) {
      EXPECT_EQ(report.number_of_points, 17); // the previous content
      return false;
    }
    return true;
  };
  std::size_t checks = 0;
  EXPECT_TRUE(reconstruct([&] { return ++checks > 0; }));
  EXPECT_GT(checks, 10 * points.size());
  for (const double part : {0., .001, .01, .1, .5, .99}) {
    std::size_t left = std::size_t(part * double(checks));
    EXPECT_FALSE(reconstruct([&] { return left-- > 0; })) << part;
  }
}

TEST(Reconstruction_of_scans, does_not_depend_on_the_unit) {
  const int n = 700;
  const Complex one = DSC::reconstruct_point_set_3<Complex>(ball(n, 1));
  const auto points = [](const Complex& complex, double scale) {
    std::vector<Point> result;
    for (auto v : complex.interface_vertices())
      result.push_back(CGAL::ORIGIN + scale * (v->point() - CGAL::ORIGIN));
    return result;
  };
  for (const int exponent : {-30, 30}) {
    const double unit = std::ldexp(1., exponent);
    const Complex other = DSC::reconstruct_point_set_3<Complex>(ball(n, unit));
    EXPECT_EQ(points(other, 1 / unit), points(one, 1)) << exponent;
  }
  for (const double unit : {1e-9, 1e-4, 1e4, 1e9}) {
    const Complex other = DSC::reconstruct_point_set_3<Complex>(ball(n, unit));
    EXPECT_EQ(other.euler_characteristic(1), 2) << unit;
    EXPECT_NEAR(other.volume(1) / (unit * unit * unit), one.volume(1), 1e-3 * one.volume(1))
        << unit;
  }
}

} // namespace test_reconstruction_of_scans
