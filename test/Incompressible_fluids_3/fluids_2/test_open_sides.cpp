// Liquid that passes through sides of the domain against a pressure.
#include "fluids_2.h"

#include <memory>
#include <optional>

namespace test_open_sides {

using namespace fluids_2;
using Coordinates = std::array<double, 3>;

// Returns the liquid with label 1 in [0, 1] x [0, surface(x)] of the domain [0, 1] x [0, 2], with n
// cells along each side of the liquid. Vertices of the grid move vertically to the surface.
Complex tank(std::size_t n, const std::function<double(double)>& surface) {
  return planar_regions::grid(
      n, 2 * n,
      [&](std::size_t i, std::size_t j) {
        const double x = double(i) / double(n), y = double(j) / double(n), s = surface(x);
        return Complex::Point_2(x, j <= n ? s * y : s + (2 - s) * (y - 1));
      },
      [n](std::size_t, std::size_t j) { return j < n ? 1 : 0; });
}

double one(double) { return 1; }

DSC::Side_behavior open_to(double pressure) {
  DSC::Side_behavior result;
  result.pressure = [pressure](const Coordinates&, double) { return pressure; };
  return result;
}

DSC::Side_behavior inflow_of(double velocity) {
  DSC::Side_behavior result;
  result.inflow = [velocity](const Coordinates&, double) { return Coordinates{velocity, 0, 0}; };
  return result;
}

// Adds a plane above the liquid.
void add_lid(Fluid& fluid, bool sticks) {
  fluid.add_solid(DSC::Plane_solid_3({0, 1, 0}, {0, -1, 0}), {90, sticks, false});
}

double sum(const std::array<double, 6>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.);
}

// Returns the height of the surface on the side of largest x.
double height_at_right(const Complex& complex) {
  double result = 0;
  for (Vertex_handle v : complex.interface_vertices())
    if (complex.position(v).x() == 1)
      result = complex.position(v).y();
  return result;
}

// A plug flow carries a field through a channel. Where the liquid leaves, vertices do not move, but
// the field does.
TEST(Open_sides, liquid_that_leaves_takes_its_field_along) {
  static constexpr double velocity = .5, dt = .02;
  for (const bool pumps : {false, true}) {
    SCOPED_TRACE(pumps);
    Complex complex = tank(8, one);
    Fluid fluid(complex, liquid(0, 0));
    add_lid(fluid, false);
    fluid.set_side(0, false, inflow_of(velocity));
    fluid.set_side(0, true, pumps ? inflow_of(velocity) : open_to(0));
    fluid.set_velocities([](Vertex_handle) { return Fluid::Vector(velocity, 0); });
    fluid.set_field([](const Fluid::Point& p) { return p.x(); });
    fluid.fix_field([](const Fluid::Point& p, double t) {
      return p.x() == 0 ? std::optional<double>(-velocity * t) : std::nullopt;
    });
    for (int k = 0; k < 10; ++k) {
      fluid.advance(dt);
      for (Vertex_handle v : complex.vertices()) {
        const auto p = complex.position(v);
        if (p.y() <= 1) {
          EXPECT_NEAR(fluid.field(v), p.x() - velocity * fluid.time(), 1e-9) << p;
        }
      }
    }
  }
}

// All vertices are on sides: liquid that passes through the sides bounds the step, too.
TEST(Open_sides, limit_the_step) {
  Complex complex = tank(1, one); // edges of length 1
  Fluid fluid(complex, liquid(0, 0));
  fluid.set_velocities([](Vertex_handle) { return Fluid::Vector(2, 0); });
  EXPECT_EQ(fluid.largest_step(), std::numeric_limits<double>::infinity());
  fluid.set_side(0, false, inflow_of(2));
  fluid.set_side(0, true, open_to(0));
  EXPECT_DOUBLE_EQ(fluid.largest_step(.25), .125);
}

// Two liquids fill the domain, so the liquid that enters has no room.
TEST(Open_sides, are_necessary_for_an_inflow_without_a_surface) {
  for (const bool is_open : {false, true}) {
    Complex complex = tank(4, one);
    DSC::Fluid_properties properties = liquid(.1, 0);
    properties.set_liquid(0, {2, .1});
    Fluid fluid(complex, properties);
    fluid.set_side(0, false, inflow_of(.5));
    if (is_open)
      fluid.set_side(0, true, open_to(0));
    if (is_open)
      EXPECT_LT(fluid.advance(.02).volume_error, 1e-9);
    else
      EXPECT_THROW(fluid.advance(.02), DSC::Error);
  }
}

// Surface tension along a flat surface is balanced where it ends at an opening.
TEST(Open_sides, pull_at_surfaces) {
  Complex complex = tank(6, one);
  DSC::Fluid_properties properties = liquid(0, 0);
  properties.set_surface_tension(0, 1, 1);
  Fluid fluid(complex, properties);
  fluid.set_side(0, true, open_to(0));
  for (int k = 0; k < 5; ++k) {
    const auto report = fluid.advance(.02);
    EXPECT_LT(report.greatest_velocity, 1e-8);
    EXPECT_NEAR(report.volume_through_sides[1], 0, 1e-12);
  }
}

// Lengths and masses stay, and times are longer by a power of two.
TEST(Open_sides, pass_the_same_volume_in_any_unit_of_time) {
  std::array<double, 2> volumes;
  for (const int exponent : {0, 60}) {
    const double unit = std::ldexp(1., exponent);
    Complex complex = tank(6, one);
    Fluid fluid(complex, liquid(.01 / unit, 1 / (unit * unit)));
    fluid.set_side(0, true, open_to(0));
    for (int k = 0; k < 5; ++k)
      volumes[exponent > 0] = fluid.advance(.02 * unit).after.volume;
  }
  EXPECT_LT(volumes[0], .9999);
  EXPECT_EQ(volumes[1], volumes[0]);
}

// The flux of the flow of Poiseuille is h^3 dp / (12 mu L).
TEST(Open_sides, channel_has_the_flux_of_poiseuille) {
  static constexpr double dt = .1, exact = 1. / 12;
  Complex complex = tank(8, one);
  Fluid fluid(complex, liquid(1, 0));
  add_lid(fluid, true);
  fluid.set_side(1, false, {{{0, 0, 0}}});
  for (const bool is_right : {false, true}) {
    DSC::Side_behavior side = open_to(is_right ? 0 : 1);
    side.velocity = {0, 0, 0};
    fluid.set_side(0, is_right, side);
  }
  double before = 0, flux = 0;
  for (int k = 0; k < 12; ++k) {
    const auto report = fluid.advance(dt);
    before = flux;
    flux = report.volume_through_sides[0] / dt;
    EXPECT_NEAR(report.volume_through_sides[0], -report.volume_through_sides[1], 1e-10);
    EXPECT_NEAR(report.gained_volume, 0, 1e-10);
    EXPECT_NEAR(report.after.volume, 1, 1e-12);
    EXPECT_TRUE(report.repetitions.empty());
  }
  EXPECT_NEAR(flux, exact, .05 * exact);
  EXPECT_NEAR(flux, before, .005 * exact);
  EXPECT_TRUE(complex.is_valid());
}

TEST(Open_sides, hydrostatic_pressure_outside_keeps_a_tank_at_rest) {
  for (const double viscosity : {0., .1})
    for (const double pressure : {0., 3.}) {
      Complex complex = tank(6, one);
      DSC::Fluid_properties properties = liquid(viscosity, 2);
      properties.set_gas(0, {pressure, 0});
      Fluid fluid(complex, properties);
      DSC::Side_behavior side;
      side.pressure = [pressure](const Coordinates& p, double) {
        return pressure + 2 * (1 - p[1]);
      };
      fluid.set_side(0, true, side);
      for (int k = 0; k < 5; ++k)
        EXPECT_LT(fluid.advance(.05).greatest_velocity, 1e-8);
    }
}

TEST(Open_sides, outflow_equals_inflow) {
  static constexpr double dt = .05, velocity = .5;
  Complex complex = tank(5, one);
  Fluid fluid(complex, liquid(0, 0));
  add_lid(fluid, false);
  fluid.set_side(0, false, inflow_of(velocity));
  fluid.set_side(0, true, open_to(0));
  fluid.set_velocities([](Vertex_handle) { return Fluid::Vector(velocity, 0); });
  for (int k = 0; k < 60; ++k) {
    const auto report = fluid.advance(dt);
    EXPECT_NEAR(report.volume_through_sides[0], velocity * dt, 1e-10);
    EXPECT_NEAR(report.volume_through_sides[1], -velocity * dt, 1e-10);
    EXPECT_NEAR(report.after.volume, 1, 1e-12);
    EXPECT_NEAR(report.after.momentum.x(), velocity, 1e-6);
    EXPECT_TRUE(report.repetitions.empty());
  }
  EXPECT_TRUE(complex.is_valid());
}

// A column of water collapses through an open side.
TEST(Open_sides, tank_drains) {
  Complex complex = tank(6, one);
  Fluid fluid(complex, liquid(0, 1));
  fluid.set_side(0, true, open_to(0));
  double left = 0, height = 1;
  for (int k = 0; k < 60; ++k) {
    const auto report = fluid.advance(.02);
    left -= sum(report.volume_through_sides);
    EXPECT_NEAR(report.after.volume + left, 1, 1e-10);
    EXPECT_EQ(report.volume_through_sides[0], 0);
    EXPECT_LT(report.volume_through_sides[1], 0);
    EXPECT_LT(height_at_right(complex), height + 1e-12);
    height = height_at_right(complex);
  }
  EXPECT_GT(left, .2);
  EXPECT_LT(height, .6);
  EXPECT_TRUE(complex.is_valid());
}

// A layer with an oblique surface moves through both sides without any force. The surface is a
// material surface, also where it meets the open side.
TEST(Open_sides, surface_moves_with_the_liquid_up_to_the_side) {
  static constexpr double slope = .3, velocity = .5, dt = .02;
  Complex complex = tank(8, [](double x) { return .6 + slope * x; });
  Fluid fluid(complex, liquid(0, 0));
  fluid.set_side(0, false, inflow_of(velocity));
  fluid.set_side(0, true, open_to(0));
  fluid.set_velocities([](Vertex_handle) { return Fluid::Vector(velocity, 0); });
  for (int k = 0; k < 40; ++k) {
    const auto report = fluid.advance(dt);
    EXPECT_NEAR(height_at_right(complex), .9 - slope * velocity * fluid.time(), .005);
    EXPECT_NEAR(report.after.momentum.x(), velocity * report.after.volume, .01);
  }
  for (Vertex_handle v : complex.interface_vertices()) {
    const auto p = complex.position(v);
    // Remeshing smooths the bend of the surface.
    EXPECT_NEAR(p.y(), .6 + slope * (std::max)(0., p.x() - velocity * fluid.time()), .04);
  }
  EXPECT_TRUE(complex.is_valid());
}

TEST(Open_sides, restored_state_continues_with_the_same_bits) {
  const auto make = [](Complex& complex) {
    auto result = std::make_unique<Fluid>(complex, liquid(.01, 1));
    result->set_side(0, true, open_to(.1));
    return result;
  };
  Complex complex = tank(5, one);
  const auto fluid = make(complex);
  for (int k = 0; k < 5; ++k)
    fluid->advance(.02);
  Complex copy;
  copy.restore(complex.state());
  const auto restored = make(copy);
  restored->restore(fluid->state());
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(fluid->advance(.02).volume_through_sides,
              restored->advance(.02).volume_through_sides);
    EXPECT_TRUE(complex.state() == copy.state());
    EXPECT_EQ(fluid->state().motion, restored->state().motion);
  }
}

// Where a part of a side is a wall, no liquid passes.
TEST(Open_sides, part_of_a_side_is_open) {
  Complex complex = tank(5, one);
  Fluid fluid(complex, liquid(.01, 1));
  DSC::Side_behavior side;
  side.pressure = [](const Coordinates& p, double) {
    return p[1] < .45 ? std::optional<double>(0) : std::nullopt;
  };
  fluid.set_side(0, true, side);
  double left = 0;
  for (int k = 0; k < 10; ++k) {
    const auto report = fluid.advance(.02);
    left -= report.volume_through_sides[1];
    EXPECT_NEAR(report.after.volume + left, 1, 1e-10);
  }
  EXPECT_GT(left, .01);
  for (Vertex_handle v : complex.vertices()) {
    const auto p = complex.position(v);
    EXPECT_TRUE(p.x() < 1 || p.y() < .45 || fluid.velocity(v).x() == 0);
  }
}

TEST(Open_sides, refuses_what_makes_no_sense) {
  Complex complex = tank(4, one);
  Fluid fluid(complex, liquid(0, 1));
  const auto begin = complex.state();
  for (const double pressure : {-std::numeric_limits<double>::infinity(), double(NAN)}) {
    fluid.set_side(0, true, open_to(pressure));
    EXPECT_THROW(fluid.advance(.01), DSC::Error);
  }
  DSC::Side_behavior narrow;
  narrow.pressure = [](const Coordinates& p, double) {
    return std::abs(p[1] - .37) < .03 ? std::optional<double>(0) : std::nullopt;
  };
  fluid.set_side(0, true, narrow); // no vertex is in the opening
  EXPECT_THROW(fluid.advance(.01), DSC::Error);
  narrow.inflow = [](const Coordinates& p, double) {
    return std::abs(p[1] - .37) < .03 ? std::optional<Coordinates>({0, 0, 0}) : std::nullopt;
  };
  narrow.pressure = nullptr;
  fluid.set_side(0, true, narrow);
  EXPECT_THROW(fluid.advance(.01), DSC::Error);
  EXPECT_TRUE(complex.state() == begin);
  EXPECT_THROW(fluid.set_side(2, true, open_to(0)), DSC::Error);

  std::vector<Complex::Point_2> points = {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  Complex rhombus = DSC::make_deformable_simplicial_complex_2<Complex>(
      points, triangles, std::vector<int>{0, 1, 1, 0});
  Fluid in_rhombus(rhombus, liquid(0, 1));
  EXPECT_THROW(in_rhombus.set_side(0, true, open_to(0)), DSC::Error);
}

} // namespace test_open_sides
