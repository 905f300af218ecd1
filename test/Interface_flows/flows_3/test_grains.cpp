// Measures of grains in space, and their growth.
#include "mesh_helpers.h"

#include <CGAL/Interface_flows/Grain_growth.h>
#include <CGAL/Interface_flows/grain_statistics.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>

namespace test_grains {

namespace DSC = CGAL::Deformable_simplicial_complexes;
using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;

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
  for (int k = 0; k < 5; ++k)
    growth.advance(); // adapts the mesh
  const auto before = ball();
  double time = 0;
  for (int k = 0; k < 5; ++k)
    time += growth.advance().dt;
  const double mean = (before.growth(3) + ball().growth(3)) / 2;
  EXPECT_NEAR((ball().measure - before.measure) / time / mean, 1, .06);
  EXPECT_TRUE(complex.is_valid());
}

} // namespace test_grains
