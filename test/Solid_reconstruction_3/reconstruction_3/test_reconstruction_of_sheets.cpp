// Reconstruction of sheets: each result is verified by the counts of its simplices and by the
// distances of the points from it, which are computed here.

#include "reconstruction.h"
#include "test.h"

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Random.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_sheet_3.h>
#include <CGAL/squared_distance_3.h>

#include <chrono>
#include <map>
#include <set>

namespace test_reconstruction_of_sheets {

using Point = CGAL::Epick::Point_3;
using DSC::Invalid_points_error;
using DSC::Reconstructed_sheet_3;
using DSC::Sheet_report_3;

constexpr int side = 30;     // points on the side of a square sheet
constexpr double bound = .5; // largest distance of a point from the sheet, in spacings

class Numbers
{
public:
  explicit Numbers(unsigned seed = 5) : m_random(seed) {}
  double operator()(double size) { return size * m_random.uniform_real(-1., 1.); }

private:
  CGAL::Random m_random;
};

double height(double x, double y) { return 2 * std::sin(.2 * x) * std::cos(.15 * y); }

// Points of hills, at the points of a grid that are moved by up to `size`.
std::vector<Point> hills(double size) {
  Numbers uniform;
  std::vector<Point> points;
  for (int i = 0; i < side * side; ++i) {
    const double x = i % side + uniform(size), y = i / side + uniform(size);
    points.emplace_back(x, y, height(x, y));
  }
  return points;
}

std::vector<Point> random_hills() {
  Numbers uniform;
  std::vector<Point> points;
  for (int i = 0; i < side * side; ++i) {
    const double x = (uniform(1) + 1) * side / 2, y = (uniform(1) + 1) * side / 2;
    points.emplace_back(x, y, height(x, y));
  }
  return points;
}

std::vector<Point> moebius_band() {
  Numbers uniform;
  static constexpr double around = 80, radius = around / (2 * CGAL_PI);
  std::vector<Point> points;
  for (int i = 0; i < int(around) * 9; ++i) {
    const double a = (i % int(around) + uniform(.2)) / radius, w = double(i / int(around)) - 4,
                 r = radius + w * std::cos(a / 2);
    points.emplace_back(r * std::cos(a), r * std::sin(a), w * std::sin(a / 2));
  }
  return points;
}

std::vector<Point> half_ball() {
  static constexpr int n = 1500;
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = (i + .5) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
    points.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return points;
}

// A sheet that is rolled up. The layers are about eight distances of neighbors apart.
std::vector<Point> roll(unsigned seed) {
  Numbers uniform(seed);
  std::vector<Point> points;
  for (int i = 0; i < 1600; ++i) {
    const double t = 1.5 * CGAL_PI * (1 + uniform(1)), r = .25 + .12 * t;
    points.emplace_back(r * std::cos(t), r * std::sin(t), uniform(1));
  }
  return points;
}

std::vector<Point> with_noise(const std::vector<Point>& points, double size) {
  Numbers uniform;
  std::vector<Point> result;
  for (const Point& p : points)
    result.emplace_back(p.x() + uniform(size), p.y() + uniform(size), p.z() + uniform(size));
  return result;
}

struct Expected
{
  int euler_characteristic = 1;
  std::size_t boundaries = 1, components = 1;
  bool is_orientable = true;
};

// Counts the simplices of a soup, and measures the distances of points from all triangles.
void verify(const std::vector<Point>& points, const Expected& expected) {
  Sheet_report_3 report;
  const Reconstructed_sheet_3 sheet =
      DSC::reconstruct_sheet_3(points, CGAL::parameters::report(std::ref(report)));
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(report.number_of_components, expected.components);
  EXPECT_EQ(report.number_of_boundaries, expected.boundaries);
  EXPECT_EQ(report.is_orientable, expected.is_orientable);
  std::map<std::set<std::size_t>, int> edges;
  std::set<std::size_t> vertices;
  for (const auto& t : sheet.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      ++edges[{t[k], t[(k + 1) % 3]}];
    }
  EXPECT_EQ(vertices.size(), sheet.points.size());
  EXPECT_EQ(int(vertices.size()) - int(edges.size()) + int(sheet.triangles.size()),
            expected.euler_characteristic);
  EXPECT_TRUE(
      std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second <= 2; }));
  const double largest = (std::max)(bound * report.spacing, 6 * report.noise);
  for (const Point& p : points)
    EXPECT_TRUE(std::any_of(sheet.triangles.begin(), sheet.triangles.end(), [&](const auto& t) {
      const CGAL::Epick::Triangle_3 triangle(sheet.points[t[0]], sheet.points[t[1]],
                                             sheet.points[t[2]]);
      return CGAL::squared_distance(p, triangle) <= largest * largest;
    })) << p;
}

TEST(Reconstruction_of_sheets, finds_hills_from_regular_random_and_jittered_points) {
  verify(hills(0), {});
  verify(hills(.4), {});
  verify(random_hills(), {});
}

TEST(Reconstruction_of_sheets, smooths_noise) {
  for (const double size : {.1, .2, .4}) { // the spacing is about 1.2
    const std::vector<Point> points = with_noise(random_hills(), size);
    verify(points, {});
    const Reconstructed_sheet_3 sheet = DSC::reconstruct_sheet_3(points);
    double squares = 0;
    for (const Point& p : sheet.points)
      squares += std::pow(p.z() - height(p.x(), p.y()), 2);
    // The root mean square of the noise is size / sqrt(3)
    EXPECT_LT(std::sqrt(squares / double(sheet.points.size())), .7 * size / std::sqrt(3.)) << size;
  }
}

TEST(Reconstruction_of_sheets, keeps_sharp_edges_within_the_noise) {
  static constexpr double size = .1, slope = .8;
  std::vector<Point> roof;
  for (const Point& p : hills(.3))
    roof.emplace_back(p.x(), p.y(), slope * std::abs(p.x() - side / 2.));
  const Reconstructed_sheet_3 sheet = DSC::reconstruct_sheet_3(with_noise(roof, size));
  for (const Point& p : sheet.points)
    EXPECT_LT(std::abs(p.z() - slope * std::abs(p.x() - side / 2.)), 4 * size) << p;
}

TEST(Reconstruction_of_sheets, does_not_join_the_layers_of_a_roll) {
  for (const unsigned seed : {1, 2, 3, 4, 5, 6})
    verify(roll(seed), {});
}

TEST(Reconstruction_of_sheets, keeps_holes_and_several_components) {
  std::vector<Point> points;
  for (const Point& p : hills(.3))
    if (std::hypot(p.x() - 12, p.y() - 17) > 5)
      points.push_back(p);
  verify(points, {0, 2});
  const std::size_t number = points.size();
  for (std::size_t i = 0; i < number; ++i)
    points.emplace_back(points[i].x() + .3, points[i].y(), points[i].z() + 4);
  verify(points, {0, 4, 2});
}

TEST(Reconstruction_of_sheets, finds_a_half_ball_a_plane_and_a_one_sided_band) {
  verify(half_ball(), {});
  verify(moebius_band(), {0, 1, 1, false});
  std::vector<Point> plane;
  for (const Point& p : hills(.3))
    plane.emplace_back(p.x(), p.y(), p.x() + 2 * p.y());
  verify(plane, {});
}

TEST(Reconstruction_of_sheets, tells_where_the_points_are_no_manifold) {
  std::vector<Point> points;
  for (const Point& p : hills(.3)) {
    points.emplace_back(p.x(), p.y(), side / 2.);
    points.emplace_back(p.x(), side / 2., p.y());
  }
  Sheet_report_3 report;
  DSC::reconstruct_sheet_3(points, CGAL::parameters::report(std::ref(report)));
  EXPECT_FALSE(report.is_complete);
  EXPECT_FALSE(report.doubtful_places.empty());
  const auto error = thrown_by<Invalid_points_error>([&] {
    std::vector<Point> line;
    for (int i = 0; i < side; ++i)
      line.emplace_back(i, 2 * i, 3 * i);
    DSC::reconstruct_sheet_3(line);
  });
  EXPECT_EQ(error.reason(), Invalid_points_error::Reason::open);
}

TEST(Reconstruction_of_sheets, does_not_depend_on_the_unit) {
  const std::vector<Point> points = hills(.3);
  const auto one = DSC::reconstruct_sheet_3(points).triangles;
  for (const int exponent : {-60, 60}) {
    std::vector<Point> scaled;
    for (const Point& p : points)
      scaled.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                          std::ldexp(p.z(), exponent));
    EXPECT_EQ(DSC::reconstruct_sheet_3(scaled).triangles, one);
  }
}

// Empty balls of the points of a grid are equally large.
TEST(Reconstruction_of_sheets, does_not_depend_on_memory_or_the_order_of_points) {
  std::vector<Point> plane, corner;
  for (int i = 0; i < side * side; ++i) {
    plane.emplace_back(i % side, i / side, 0);
    corner.insert(corner.end(),
                  {{i % side, i / side, 0}, {0, i % side, i / side}, {i / side, 0, i % side}});
  }
  for (std::vector<Point> points : {plane, corner, moebius_band()}) {
    const Reconstructed_sheet_3 one = DSC::reconstruct_sheet_3(points);
    CGAL::Random random(7);
    std::vector<std::vector<char>> memory;
    for (int i = 0; i < 20000; ++i)
      memory.emplace_back(std::size_t(random.get_int(1, 600)));
    for (std::size_t i = 0; i < memory.size(); i += 2)
      memory[i] = {}; // leaves gaps
    std::rotate(points.begin(), points.begin() + 100, points.end());
    const Reconstructed_sheet_3 other = DSC::reconstruct_sheet_3(points);
    EXPECT_EQ(other.points, one.points);
    EXPECT_EQ(other.triangles, one.triangles);
  }
}

TEST(Reconstruction_of_sheets, fills_holes_with_three_or_four_edges) {
  using Triangles = std::vector<std::array<std::size_t, 3>>;
  static constexpr std::size_t n = 5;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n * n; ++i)
    points.emplace_back(double(i % n), double(i / n), 0);
  Triangles grid;
  for (std::size_t j = 0; j + 1 < n; ++j)
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const std::size_t v = i + n * j;
      grid.push_back({v, v + 1, v + n + 1});
      grid.push_back({v, v + n + 1, v + n});
    }
  const auto boundary_after = [&](std::size_t first, std::size_t number) {
    Triangles triangles = grid;
    const auto begin = triangles.begin() + std::ptrdiff_t(first);
    triangles.erase(begin, begin + std::ptrdiff_t(number));
    DSC::internal::Sheet_triangles_3 sheet(points.size(), triangles);
    DSC::internal::fill_small_holes(points, sheet);
    return sheet.boundary().size();
  };
  EXPECT_EQ(boundary_after(0, 0), 4 * (n - 1));
  EXPECT_EQ(boundary_after(12, 1), 4 * (n - 1));
  EXPECT_EQ(boundary_after(12, 2), 4 * (n - 1));
  EXPECT_EQ(boundary_after(12, 3), 4 * (n - 1) + 5);
  // Neither a triangle nor a square has holes.
  DSC::internal::Sheet_triangles_3 square(points.size(), {grid[0], grid[1]});
  DSC::internal::fill_small_holes(points, square);
  EXPECT_EQ(square.all().size(), 2);
}

TEST(Reconstruction_of_sheets, stops_at_any_moment) {
  const std::vector<Point> points = hills(.3);
  std::size_t checks = 0;
  const auto reconstruct = [&](std::size_t most) {
    checks = 0;
    const DSC::Progress_scope scope([&](const char*) { return ++checks <= most; },
                                    std::chrono::milliseconds(0));
    Sheet_report_3 report;
    try {
      DSC::reconstruct_sheet_3(points, CGAL::parameters::report(std::ref(report)));
    } catch (const DSC::Interrupted_error&) {
      EXPECT_EQ(report.number_of_points, 0);
      return false;
    }
    return true;
  };
  EXPECT_TRUE(reconstruct(std::size_t(-1)));
  const std::size_t all = checks;
  EXPECT_GT(all, 10 * points.size());
  for (const double part : {0., .01, .2, .5, .8, .99})
    EXPECT_FALSE(reconstruct(std::size_t(part * double(all)))) << part;
}

} // namespace test_reconstruction_of_sheets
