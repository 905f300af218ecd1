// Reconstruction of solids: point clouds of known solids, and point clouds that do not bound a
// solid.

#include "reconstruction.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Interface_remeshing/manifold_interface.h>
#include <CGAL/Mesh_files/point_set_3.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Random.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

namespace test_reconstruction {

using namespace reconstruction;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Invalid_points_error;

void append_sphere(std::vector<Point>& points, std::size_t n, const Point& center, double radius) {
  CGAL::Random random(7);
  CGAL::Random_points_on_sphere_3<Point> p(radius, random);
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(center + (*p++ - CGAL::ORIGIN));
}

std::vector<Point> sphere(std::size_t n) {
  std::vector<Point> points;
  append_sphere(points, n, CGAL::ORIGIN, 1);
  return points;
}

// A box of side lengths 2, 2 and 1 about the origin, with a hole along the z axis. If the radius is
// 0, there is no hole.
std::vector<Point> box(std::size_t n, double hole) {
  CGAL::Random random(11);
  const double top = 4 - CGAL_PI * hole * hole, wall = 2 * CGAL_PI * hole;
  std::vector<Point> points;
  while (points.size() < n) {
    double s = random.uniform_real(0., 2 * top + 8 + wall);
    const double u = random.uniform_real(-1., 1.), v = random.uniform_real(-1., 1.);
    if (s < 2 * top) {
      if (u * u + v * v >= hole * hole)
        points.emplace_back(u, v, s < top ? .5 : -.5);
    } else if ((s -= 2 * top) < 8) {
      const double side = int(s) % 2 == 0 ? 1 : -1;
      points.push_back(s < 4 ? Point(side, u, v / 2) : Point(u, side, v / 2));
    } else {
      points.emplace_back(hole * std::cos(CGAL_PI * u), hole * std::sin(CGAL_PI * u), v / 2);
    }
  }
  return points;
}

struct Result
{
  Complex complex;
  Report report;

  template <class Points> explicit Result(const Points& points) {
    complex = DSC::reconstruct_point_set_3<Complex>(points, parameters::report(std::ref(report)));
    EXPECT_TRUE(complex.is_valid());
    EXPECT_TRUE(DSC::non_manifold_vertices(complex).empty());
    EXPECT_TRUE(report.is_complete);
  }
  int euler_characteristic() const { return complex.euler_characteristic(1); }
};

std::vector<Point> positions(const Complex& complex) {
  std::vector<Point> result;
  for (auto v : complex.interface_vertices())
    result.push_back(v->point());
  return result;
}

TEST(Reconstruction, finds_a_ball) {
  const Result ball(sphere(1500));
  EXPECT_EQ(ball.euler_characteristic(), 2);
  EXPECT_NEAR(ball.complex.volume(1), 4 * CGAL_PI / 3, .01);
  EXPECT_EQ(ball.report.number_of_points, 1500);
  EXPECT_LT(ball.report.root_mean_square, .05 * ball.report.spacing);
  EXPECT_LT(ball.report.maximum_distance, .6 * ball.report.spacing);
  EXPECT_TRUE(ball.report.unfit_points.empty());
}

TEST(Reconstruction, opens_a_tunnel_and_keeps_creases) {
  const Result tunnel(box(4000, .4));
  EXPECT_EQ(tunnel.euler_characteristic(), 0);
  const double volume = 4 - CGAL_PI * .16;
  EXPECT_NEAR(tunnel.complex.volume(1), volume, .003 * volume);
  EXPECT_LT(tunnel.report.root_mean_square, .05 * tunnel.report.spacing);
  // The corners of the box, which are far from random points.
  double farthest = 0;
  for (double x : {-1., 1.})
    for (double y : {-1., 1.})
      for (double z : {-.5, .5}) {
        double nearest = 10;
        for (const Point& p : positions(tunnel.complex))
          nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, Point(x, y, z))));
        farthest = (std::max)(farthest, nearest);
      }
  EXPECT_LT(farthest, 1.5 * tunnel.report.spacing);
}

TEST(Reconstruction, separates_parts_and_finds_voids) {
  std::vector<Point> points;
  append_sphere(points, 1200, CGAL::ORIGIN, 1);
  append_sphere(points, 300, CGAL::ORIGIN, .5);
  append_sphere(points, 1200, Point(2.5, 0, 0), 1);
  const Result balls(points);
  EXPECT_EQ(balls.complex.number_of_components(1), 2);
  EXPECT_EQ(balls.complex.number_of_components(0), 2);
  EXPECT_EQ(balls.euler_characteristic(), 6);
}

TEST(Reconstruction, closes_a_hole_and_tells_it) {
  std::vector<Point> points = sphere(2000);
  points.erase(
      std::remove_if(points.begin(), points.end(), [](const Point& p) { return p.z() > .9; }),
      points.end());
  const Result ball(points);
  EXPECT_EQ(ball.euler_characteristic(), 2);
  EXPECT_GT(ball.complex.volume(1), .95 * 4 * CGAL_PI / 3);
  EXPECT_FALSE(ball.report.facets_without_points.empty());
  for (const auto& f : ball.report.facets_without_points) {
    EXPECT_TRUE(ball.complex.is_interface(f));
    const auto v = ball.complex.facet_vertices(f);
    EXPECT_GT(CGAL::centroid(v[0]->point(), v[1]->point(), v[2]->point()).z(), .7);
  }
}

TEST(Reconstruction, leaves_outliers_and_duplicates_out) {
  std::vector<Point> points = sphere(2000);
  points.insert(points.end(), points.begin(), points.begin() + 100);
  points.emplace_back(1e6, 0, 0);
  points.emplace_back(0, 0, .1);
  points.emplace_back(0, 0, 1.15); // at a distance of three spacings
  points.emplace_back(0, -.85, 0);
  const Result ball(points);
  EXPECT_EQ(ball.euler_characteristic(), 2);
  EXPECT_NEAR(ball.complex.volume(1), 4 * CGAL_PI / 3, .01);
  EXPECT_EQ(ball.report.number_of_duplicates, 100);
  EXPECT_EQ(ball.report.number_of_outliers, 4);
  EXPECT_EQ(ball.report.number_of_points, 2000);
  EXPECT_LT(ball.report.spacing, .1);
}

TEST(Reconstruction, leaves_units_of_the_result) {
  const Result ball(sphere(1500));
  double sum = 0;
  const auto facets = ball.complex.interface_facets();
  for (const auto& f : facets) {
    const auto v = ball.complex.facet_vertices(f);
    for (int k = 0; k < 3; ++k)
      sum += std::sqrt(CGAL::squared_distance(v[k]->point(), v[(k + 1) % 3]->point()));
  }
  EXPECT_NEAR(ball.complex.mean_interface_edge(), sum / double(3 * facets.size()), 1e-9);
}

TEST(Reconstruction, takes_the_known_normal_of_equal_points) {
  std::vector<std::pair<Point, Vector>> pairs;
  for (const Point& p : sphere(500)) {
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
    pairs.emplace_back(p, p - CGAL::ORIGIN);
  }
  using Pair = std::pair<Point, Vector>;
  const auto reconstruct = [&] {
    return positions(DSC::reconstruct_point_set_3<Complex>(
        pairs, parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                   .normal_map(CGAL::Second_of_pair_property_map<Pair>())));
  };
  const auto first = reconstruct();
  std::reverse(pairs.begin(), pairs.end());
  EXPECT_EQ(first, reconstruct());
}

TEST(Reconstruction, averages_noise) {
  std::vector<Point> points = sphere(3000);
  CGAL::Random random(5);
  const double noise = .01;
  for (Point& p : points)
    p = p + random.uniform_real(-noise, noise) * (p - CGAL::ORIGIN);
  const Result ball(points);
  EXPECT_EQ(ball.euler_characteristic(), 2);
  double squares = 0;
  const auto facets = ball.complex.interface_facets();
  for (const auto& f : facets) {
    const auto v = ball.complex.facet_vertices(f);
    const Point p = CGAL::centroid(v[0]->point(), v[1]->point(), v[2]->point());
    squares += std::pow(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1, 2);
  }
  EXPECT_LT(std::sqrt(squares / double(facets.size())), .5 * noise);
}

TEST(Reconstruction, does_not_depend_on_the_order_of_points) {
  std::vector<Point> points = sphere(800);
  const Result first(points), second(points);
  EXPECT_EQ(positions(first.complex), positions(second.complex));
  std::reverse(points.begin(), points.end());
  const Result third(points);
  EXPECT_EQ(positions(first.complex), positions(third.complex));
}

TEST(Reconstruction, does_not_depend_on_threads) {
  std::vector<Point> points = box(4000, .4);
  points.emplace_back(0, 0, .6); // an outlier
  const auto reconstruct = [&](unsigned threads) {
    return DSC::reconstruct_point_set_3<Complex>(points, parameters::number_of_threads(threads));
  };
  const Complex one = reconstruct(1), two = reconstruct(2);
  EXPECT_EQ(positions(one), positions(two));
  EXPECT_EQ(one.number_of_cells(), two.number_of_cells());
}

TEST(Reconstruction, takes_tiny_and_huge_coordinates) {
  for (double scale : {1e-20, 1e20}) {
    std::vector<Point> points = sphere(800);
    for (Point& p : points)
      p = CGAL::ORIGIN + scale * (p - CGAL::ORIGIN + Vector(5, -3, 2));
    const Result ball(points);
    EXPECT_EQ(ball.euler_characteristic(), 2);
    EXPECT_NEAR(ball.complex.volume(1) / (scale * scale * scale), 4 * CGAL_PI / 3, .03);
  }
}

TEST(Reconstruction, takes_maps_and_point_sets) {
  const std::vector<Point> points = sphere(800);
  std::vector<std::pair<Point, Vector>> pairs;
  CGAL::Point_set_3<Point> set;
  set.add_normal_map();
  for (const Point& p : points) {
    const Vector inwards = 3 * (CGAL::ORIGIN - p); // any length and orientation is accepted
    pairs.emplace_back(p, inwards);
    set.insert(p, inwards);
  }
  using Pair = std::pair<Point, Vector>;
  const Complex of_pairs = DSC::reconstruct_point_set_3<Complex>(
      pairs, parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                 .normal_map(CGAL::Second_of_pair_property_map<Pair>()));
  const Complex of_set = DSC::reconstruct_point_set_3<Complex>(set);
  EXPECT_EQ(of_pairs.euler_characteristic(1), 2);
  EXPECT_EQ(positions(of_pairs), positions(of_set));
}

TEST(Reconstruction, can_be_watched_and_ended) {
  std::vector<std::size_t> steps;
  Report report;
  const auto observer = [&](const Complex& complex, std::size_t step) {
    EXPECT_TRUE(complex.is_valid());
    steps.push_back(step);
    return step < 3;
  };
  const Complex complex = DSC::reconstruct_point_set_3<Complex>(
      sphere(500), parameters::observer(observer).report(std::ref(report)));
  EXPECT_EQ(steps, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_FALSE(report.is_complete);
  EXPECT_EQ(report.number_of_steps, 3);
  EXPECT_TRUE(complex.is_valid());
  DSC::reconstruct_point_set_3<Complex>(
      sphere(500), parameters::number_of_iterations(2).report(std::ref(report)));
  EXPECT_EQ(report.number_of_steps, 2);
}

TEST(Reconstruction, refuses_what_bounds_no_solid) {
  using Reason = Invalid_points_error::Reason;
  const auto expect = [](const std::vector<Point>& points, Reason reason,
                         const std::vector<std::size_t>& wrong = {}) {
    const auto error =
        thrown_by<Invalid_points_error>([&] { DSC::reconstruct_point_set_3<Complex>(points); });
    EXPECT_EQ(error.reason(), reason) << error.what();
    EXPECT_EQ(error.points(), wrong);
  };
  expect({}, Reason::too_few);
  expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Reason::too_few);
  expect(std::vector<Point>(10, Point(1, 2, 3)), Reason::too_few);
  std::vector<Point> plane, line;
  for (int i = 0; i < 100; ++i) {
    plane.emplace_back(i % 10, i / 10, 3);
    line.emplace_back(i, 2 * i, 3 * i);
  }
  expect(plane, Reason::flat);
  expect(line, Reason::flat);
  std::vector<Point> with_nan = sphere(100);
  with_nan[17] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  with_nan[5] = Point(0, 0, std::numeric_limits<double>::infinity());
  expect(with_nan, Reason::not_finite, {5, 17});
  std::vector<Point> huge = sphere(100);
  for (Point& p : huge)
    p = CGAL::ORIGIN + 1e200 * (p - CGAL::ORIGIN);
  expect(huge, Reason::out_of_range);
  EXPECT_THROW(DSC::reconstruct_point_set_3<Complex>(sphere(100), parameters::fit_tolerance(0.)),
               Error);
}

// Points, keys, maps and observers that provide only the requirements.
namespace archetypes {

struct Coordinates
{
  std::array<double, 3> values;
  double x() const { return values[0]; }
  double y() const { return values[1]; }
  double z() const { return values[2]; }
};

class Key
{
public:
  explicit Key(std::size_t i) : m_index(i) {}

private:
  friend struct Point_map;
  std::size_t m_index;
};

struct Point_map
{
  using key_type = Key;
  using value_type = Coordinates;
  using reference = Coordinates;
  using category = boost::readable_property_map_tag;

  const std::vector<Point>* points;

  Coordinates at(const Key& key) const {
    const Point& p = (*points)[key.m_index];
    return {{p.x(), p.y(), p.z()}};
  }
  friend Coordinates get(const Point_map& map, const Key& key) { return map.at(key); }
};

// The requirements of a range-based for loop.
class Keys
{
public:
  explicit Keys(std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
      m_keys.emplace_back(i);
  }
  const Key* begin() const { return m_keys.data(); }
  const Key* end() const { return m_keys.data() + m_keys.size(); }

private:
  std::vector<Key> m_keys;
};

class Observer
{
public:
  Observer(const Observer&) = delete; // passed by reference
  Observer& operator=(const Observer&) = delete;
  explicit Observer(std::size_t& steps) : m_steps(steps) {}
  bool operator()(const Complex&, std::size_t step) {
    m_steps = step;
    return true;
  }

private:
  std::size_t& m_steps;
};

} // namespace archetypes

TEST(Reconstruction, needs_no_more_than_concepts_require) {
  const std::vector<Point> points = sphere(500);
  const archetypes::Point_map map{&points};
  std::size_t steps = 0;
  archetypes::Observer observer(steps);
  Report report;
  const Complex complex = DSC::reconstruct_point_set_3<Complex>(archetypes::Keys(points.size()),
                                                                parameters::point_map(map)
                                                                    .normal_map(map)
                                                                    .observer(std::ref(observer))
                                                                    .report(std::ref(report)));
  EXPECT_EQ(complex.euler_characteristic(1), 2);
  EXPECT_EQ(steps, report.number_of_steps);
  EXPECT_GT(report.changes.smoothed, 0);
}

// Few points, points on a lattice and on common spheres: the result is a closed surface, or an
// exception is thrown.
TEST(Reconstruction, survives_degenerate_clouds) {
  CGAL::Random random(3);
  for (int n = 4; n < 40; n += 3)
    for (int grid : {2, 3, 5, 1000}) {
      std::vector<Point> points;
      for (int i = 0; i < n; ++i)
        points.emplace_back(random.get_int(0, grid), random.get_int(0, grid),
                            random.get_int(0, grid));
      try {
        const Complex complex = DSC::reconstruct_point_set_3<Complex>(points);
        EXPECT_TRUE(complex.is_valid());
      } catch (const Error&) {
      }
    }
}

TEST(Point_set_reader, takes_formats_and_normals) {
  const Temporary_folder folder;
  const auto read = [&](const std::string& name, const std::string& text) {
    const std::string path = folder / name;
    std::ofstream(path) << text;
    return CGAL::IO::read_point_set(path);
  };
  const auto expect = [](const std::vector<CGAL::IO::Point_and_normal_3>& points, bool normals) {
    ASSERT_EQ(points.size(), 2);
    EXPECT_EQ(points[1].first, Point(4, 5, 6));
    EXPECT_EQ(points[1].second, normals ? Vector(0, 0, 1) : Vector(0, 0, 0));
  };
  expect(read("a.xyz", "1 2 3\n4 5 6\n"), false);
  expect(read("a.xyz", "2\n# a comment\n1 2 3 1 0 0\n4 5 6 0 0 1\n"), true);
  expect(read("a.off", "NOFF\n2 0 0\n1 2 3 1 0 0\n4 5 6 0 0 1\n"), true);
  expect(read("a.off", "OFF\n2 0 0\n1 2 3\n4 5 6\n"), false);
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                          "property float y\nproperty float z\n";
  expect(read("a.ply", ply + "end_header\n1 2 3\n4 5 6\n"), false);
  expect(read("a.PLY", ply + "property float nx\nproperty float ny\nproperty float nz\n"
                             "end_header\n1 2 3 1 0 0\n4 5 6 0 0 1\n"),
         true);
  for (const char* wrong : {"", "1 2\n", "1 2 x\n", "1 2 3 4 5\n1 2\n"})
    EXPECT_THROW(read("b.xyz", wrong), File_error);
  EXPECT_THROW(CGAL::IO::read_point_set(folder / "missing.xyz"), File_error);
}

} // namespace test_reconstruction
