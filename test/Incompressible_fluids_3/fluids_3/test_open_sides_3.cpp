// Liquid that passes through sides of the domain against a pressure, in space.
#include "fluids_3.h"

namespace test_open_sides_3 {

using namespace fluids_3;

// Returns the liquid with label 1 below z = 0 in the cube [-1, 1]^3.
Complex tank() {
  return small_meshes::make_complex(
      small_meshes::grid(4, [](const auto& p) { return CGAL::to_double(p.z()) < 0 ? 1 : 0; }));
}

TEST(Open_sides_3, tank_drains) {
  Complex complex = tank();
  Fluid fluid(complex, liquid(1, 0, 0, 1));
  DSC::Side_behavior side;
  side.pressure = [](const std::array<double, 3>&, double) { return 0.; };
  fluid.set_side(0, true, side);
  const double begin = fluid.balance().volume;
  double left = 0;
  for (int k = 0; k < 8; ++k) {
    const auto report = fluid.advance(.04);
    const auto& volumes = report.volume_through_sides;
    EXPECT_LT(volumes[1], 0);
    left -= std::accumulate(volumes.begin(), volumes.end(), 0.);
    EXPECT_NEAR(report.after.volume + left, begin, 1e-10);
  }
  EXPECT_GT(left, .05);
  EXPECT_TRUE(complex.is_valid());
}

TEST(Open_sides_3, hydrostatic_pressure_outside_keeps_a_tank_at_rest) {
  Complex complex = tank();
  Fluid fluid(complex, liquid(1, 0, 0, 1));
  DSC::Side_behavior side;
  side.pressure = [](const std::array<double, 3>& p, double) { return -p[2]; };
  fluid.set_side(0, true, side);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(fluid.advance(.05).greatest_velocity, 1e-8);
}

} // namespace test_open_sides_3
