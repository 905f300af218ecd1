// Measures of grains in space, and their growth.
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/grain_statistics.h>
#include <CGAL/Interface_remeshing/shared_measures.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

namespace test_grains {

using namespace small_meshes;

// Expects that the last label grows by the law, after the mesh is adapted. Returns its mean rate.
double expect_rate_of_law(const Complex& complex, DSC::Grain_growth<Complex>& growth) {
  for (int k = 0; k < 5; ++k)
    growth.advance();
  const auto before = DSC::grain_statistics(complex).back();
  double time = 0;
  for (int k = 0; k < 5; ++k)
    time += growth.advance().dt;
  const auto after = DSC::grain_statistics(complex).back();
  const double mean = (before.growth(3) + after.growth(3)) / 2;
  EXPECT_NEAR((after.measure - before.measure) / time / mean, 1, .06);
  return mean;
}

// A cube with sides of length 1 between a label below z = 0 and one above it.
TEST(Grain_statistics, of_a_cube) {
  const Complex complex = make_complex(grid(8, [](const Point& p) {
    const auto is_in = [](const auto& x) { return -.5 < x && x < .5; };
    return is_in(p.x()) && is_in(p.y()) && is_in(p.z()) ? 3 : p.z() < 0 ? 1 : 2;
  }));
  const auto statistics = DSC::grain_statistics(complex);
  ASSERT_EQ(statistics.size(), 3u);
  const DSC::Grain_statistics& cube = statistics.back();
  EXPECT_EQ(cube.label, 3);
  EXPECT_NEAR(cube.measure, 1, 1e-12);
  EXPECT_NEAR(cube.boundary, 6, 1e-12);
  EXPECT_EQ(cube.neighbors, 2u);
  EXPECT_NEAR(cube.mean_width, 3, 1e-12); // 12 edges with right angles
  EXPECT_NEAR(cube.triple_lines, 4, 1e-12);
  EXPECT_NEAR(cube.growth(3), -2 * CGAL_PI * (3 - 4. / 6), 1e-12);
}

// A ball has the mean width 4 r and vanishes at the time r^2 / 4.
TEST(Grain_growth, ball_shrinks_at_its_rate) {
  static constexpr double r = .6;
  Complex complex = mesh_helpers::sphere(8, r);
  const auto ball = [&complex] { return DSC::grain_statistics(complex).back(); };
  EXPECT_NEAR(ball().mean_width, 4 * r, .05 * r);
  DSC::Grain_growth<Complex> growth(complex, {}, {10, .1});
  expect_rate_of_law(complex, growth);
  EXPECT_TRUE(complex.is_valid());
}

// An eighth of a ball around a corner of a box shrinks at an eighth of the rate of the ball.
TEST(Grain_growth, ball_in_a_corner_shrinks_at_its_rate) {
  static constexpr double r = .6;
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 1. / 8,
      [](const Complex::Point& p) { return std::hypot(p.x(), p.y(), p.z()) < r ? 1 : 0; });
  const auto ball = [&complex] { return DSC::grain_statistics(complex).back(); };
  EXPECT_NEAR(ball().mean_width, r / 2, .03 * r);
  EXPECT_EQ(ball().triple_lines, 0);
  DSC::Grain_growth<Complex> growth(complex, {}, {7, .1});
  const double mean = expect_rate_of_law(complex, growth);
  EXPECT_NEAR(mean, -CGAL_PI * std::cbrt(6 / CGAL_PI * ball().measure), .06 * r * CGAL_PI);
  EXPECT_TRUE(complex.is_valid());
}

// A wall between two labels slides along a ball that does not move, towards the middle, where its
// hole is largest.
TEST(Grain_growth, wall_slides_along_a_particle) {
  static constexpr double r = .3;
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(0, 0, 0, 1, 1, 1), .1, [](const Complex::Point& p) {
        return std::hypot(p.x() - .5, p.y() - .5, p.z() - .5) < r ? 3 : 1;
      });
  std::vector<Complex::Cell_handle> above;
  for (auto c : complex.cells()) {
    double x = 0;
    for (int i = 0; i < 4; ++i)
      x += complex.position(c->vertex(i)).x() / 4;
    if (c->subdomain_index() == 1 && x > .4)
      above.push_back(c);
  }
  for (auto c : above)
    complex.relabel(c, 2);
  DSC::Interface_energy energy;
  energy.set_mobility([](int, int b) { return b == 3 ? 0 : 1; });
  DSC::Grain_growth<Complex> growth(complex, energy, {7, .2});
  growth.advance(); // the wall becomes flat
  const double particle = complex.volume(3), below = complex.volume(1);
  while (growth.time() < .1)
    growth.advance();
  EXPECT_GT(complex.volume(1), below + .02);
  EXPECT_LT(complex.volume(1), complex.volume(2));
  EXPECT_NEAR(complex.volume(3), particle, .01 * particle);
  for (auto v : complex.interface_vertices())
    if (DSC::labels_around(complex, v).back() == 3) {
      const auto p = complex.position(v);
      EXPECT_NEAR(std::hypot(p.x() - .5, p.y() - .5, p.z() - .5), r, .03);
    }
  EXPECT_TRUE(complex.is_valid());
}

} // namespace test_grains
