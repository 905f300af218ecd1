// Incompressible flow in the plane.
#include "fluids_2.h"

namespace test_fluid_2 {

using namespace fluids_2;
using Point = Fluid::Point;
using Vector = Fluid::Vector;

// Returns the region around a center. `radius` is a function of the angle.
Complex around(const Point& center, std::size_t corners, const CGAL::Bbox_2& box,
               const std::function<double(double)>& radius) {
  return planar_regions::region(planar_regions::around({center.x(), center.y()}, corners, radius),
                                {}, box);
}

Complex disk(std::size_t corners, const CGAL::Bbox_2& box) {
  return around({0, 0}, corners, box, [](double) { return .5; });
}

const CGAL::Bbox_2 square(-1, -1, 1, 1);

DSC::Fluid_properties two_liquids(double density, double viscosity) {
  DSC::Fluid_properties result;
  result.set_liquid(0, {1, viscosity});
  result.set_liquid(1, {density, viscosity});
  return result;
}

Vector rotation(const Point& p) { return {-p.y(), p.x()}; }

// Returns the angular momentum of a label about the origin, for density 1, with linear velocities
// in cells.
double angular_momentum(const Fluid& fluid, int label) {
  double result = 0;
  for (auto c : fluid.complex().cells()) {
    if (c->subdomain_index() != label)
      continue;
    // The products of linear functions are integrated exactly at the midpoints of the edges.
    for (int i = 0; i < 3; ++i) {
      const Vertex_handle v = c->vertex(i), w = c->vertex((i + 1) % 3);
      const Point p = CGAL::midpoint(fluid.complex().position(v), fluid.complex().position(w));
      const Vector u = (fluid.velocity(v, label) + fluid.velocity(w, label)) / 2;
      result += fluid.complex().measure(c) / 3 * (p.x() * u.y() - p.y() * u.x());
    }
  }
  return result;
}

double greatest_velocity(const Fluid& fluid, int label) {
  double result = 0;
  for (auto c : fluid.complex().cells())
    for (int i = 0; i < 3 && c->subdomain_index() == label; ++i)
      result = (std::max)(result, fluid.velocity(c->vertex(i), label).squared_length());
  return std::sqrt(result);
}

// Lord Rayleigh, "On the capillary phenomena of jets", 1879: the square of the frequency of mode n
// is n (n^2 - 1) for unit density, tension and radius.
TEST(Fluid_2, droplet_oscillates) {
  static constexpr double amplitude = .02;
  Complex complex =
      around({0, 0}, 32, {-2, -2, 2, 2}, [](double a) { return 1 + amplitude * std::cos(2 * a); });
  DSC::Fluid_properties properties;
  properties.set_liquid(1, {1, 0});
  properties.set_surface_tension(0, 1, 1);
  Fluid fluid(complex, properties);
  const double half_period = CGAL_PI / std::sqrt(6.);
  static constexpr int steps = 20;
  for (int k = 0; k < steps; ++k) {
    const auto report = fluid.advance(half_period / steps);
    EXPECT_LT(report.volume_error, 1e-13);
    EXPECT_EQ(report.after.momentum.z(), 0);
    EXPECT_EQ(report.after.angular_momentum.x(), 0);
  }
  double right = 0, top = 0;
  for (Vertex_handle v : complex.interface_vertices()) {
    right = (std::max)(right, complex.position(v).x());
    top = (std::max)(top, complex.position(v).y());
  }
  EXPECT_NEAR((right - top) / 2, -amplitude, .05 * amplitude);
  EXPECT_TRUE(complex.is_valid());
}

TEST(Fluid_2, that_rotates_has_twice_its_angular_velocity_as_vorticity) {
  Complex complex = disk(16, square);
  Fluid fluid(complex, two_liquids(1, 0));
  fluid.set_velocities([&](Vertex_handle v, int label) {
    return (label == 1 ? 1. : -3.) * rotation(complex.position(v));
  });
  for (auto c : complex.cells()) {
    bool is_at_interface = false;
    for (int i = 0; i < 3; ++i)
      is_at_interface = is_at_interface || complex.is_interface(c->vertex(i));
    // At the interface, the normal velocities of both liquids are equal.
    EXPECT_TRUE(is_at_interface ||
                std::abs(fluid.vorticity(c) - (c->subdomain_index() == 1 ? 2 : -6)) < 1e-10);
  }
}

// All vertices follow the flow, also those far from the interface. The energy of Taylor-Green
// vortices is constant without viscosity.
TEST(Fluid_2, vortices_keep_their_energy) {
  for (const double viscosity : {0., .02}) {
    SCOPED_TRACE(viscosity);
    Complex complex = around({.5, 1}, 12, {0, 0, 1, 2}, [](double) { return .2; });
    Fluid fluid(complex, two_liquids(1, viscosity));
    fluid.set_velocities([&](Vertex_handle v) {
      const double x = CGAL_PI * complex.position(v).x(), y = CGAL_PI * complex.position(v).y();
      return Vector(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y));
    });
    static constexpr double dt = .025;
    const double begin = fluid.advance(dt).after.kinetic_energy;
    double end = 0;
    for (int k = 0; k < 16; ++k)
      end = fluid.advance(dt).after.kinetic_energy;
    const double decay = std::exp(-4 * CGAL_PI * CGAL_PI * viscosity * 16 * dt);
    EXPECT_NEAR(end / begin, decay, .02 * decay);
  }
}

// A disk of liquid rotates in another liquid at rest.
TEST(Fluid_2, liquids_slip_along_each_other) {
  for (const double density : {1., 20.}) {
    SCOPED_TRACE(density);
    Complex complex = disk(32, square);
    Fluid fluid(complex, two_liquids(density, 0));
    fluid.set_velocities([&](Vertex_handle v, int label) {
      return label == 1 ? rotation(complex.position(v)) : Vector(0, 0);
    });
    fluid.advance(.02);
    const double begin = angular_momentum(fluid, 1);
    for (int k = 0; k < 10; ++k)
      fluid.advance(.02);
    EXPECT_NEAR(angular_momentum(fluid, 1), begin, .01 * begin);
    EXPECT_LT(greatest_velocity(fluid, 0), .05);
    EXPECT_TRUE(complex.is_valid());
  }
}

TEST(Fluid_2, viscous_liquids_drag_each_other) {
  Complex complex = disk(32, square);
  Fluid fluid(complex, two_liquids(1, .05));
  fluid.set_velocities([&](Vertex_handle v, int label) {
    return label == 1 ? rotation(complex.position(v)) : Vector(0, 0);
  });
  for (int k = 0; k < 10; ++k)
    fluid.advance(.02);
  for (Vertex_handle v : complex.interface_vertices())
    EXPECT_LT((fluid.velocity(v, 0) - fluid.velocity(v, 1)).squared_length(), .1 * .1);
  EXPECT_GT(angular_momentum(fluid, 0), .01);
}

TEST(Fluid_2, in_a_slippery_bowl_rests_or_keeps_its_spin) {
  for (const bool spins : {false, true}) {
    SCOPED_TRACE(spins);
    Complex complex = disk(24, square);
    DSC::Fluid_properties properties;
    properties.set_liquid(1, {1, 0});
    properties.set_gravity({0, spins ? 0. : -1., 0});
    Fluid fluid(complex, properties);
    fluid.add_solid(DSC::Ball_solid_3({0, 0, 0}, .5, DSC::Solid_side::outside), {90, false, false});
    if (spins)
      fluid.set_velocities([&](Vertex_handle v) { return rotation(complex.position(v)); });
    fluid.advance(.02);
    const double begin = angular_momentum(fluid, 1);
    for (int k = 0; k < 10; ++k)
      fluid.advance(.02);
    if (spins)
      EXPECT_NEAR(angular_momentum(fluid, 1), begin, 1e-3 * begin);
    else
      EXPECT_LT(greatest_velocity(fluid, 1), 1e-9);
  }
}

// The interface of two liquids ends at a moving side, which moves along it or across it.
TEST(Fluid_2, has_the_velocity_of_no_slip_sides) {
  for (const int axis : {0, 1}) {
    SCOPED_TRACE(axis);
    Complex complex = DSC::make_deformable_simplicial_complex_2<Complex>(
        square, .2, [](const auto& p) { return p.y() > 0 ? 1 : 0; });
    Fluid fluid(complex, two_liquids(1, .1));
    std::array<double, 3> velocity = {1, 1, 0};
    velocity[std::size_t(axis)] = 5; // perpendicular to the side: no effect
    fluid.set_side(axis, true, {velocity});
    for (int k = 0; k < 5; ++k)
      fluid.advance(.01);
    bool has_side = false;
    for (Vertex_handle v : complex.vertices()) {
      const Point p = complex.position(v);
      if (p[axis] != 1 || std::abs(p[1 - axis]) == 1)
        continue;
      has_side = true;
      for (const int label : {0, 1}) {
        EXPECT_NEAR(fluid.velocity(v, label)[1 - axis], 1, 1e-12);
        EXPECT_EQ(fluid.velocity(v, label)[axis], 0);
      }
    }
    EXPECT_TRUE(has_side);
    EXPECT_TRUE(complex.is_valid());
  }
}

TEST(Fluid_2, tanks_have_walls_in_the_plane) {
  for (const bool is_open : {false, true}) {
    std::vector<DSC::Wall_3> walls;
    DSC::Tank_solid_3(square, is_open).walls({0, .25, 0}, 0, walls);
    ASSERT_EQ(walls.size(), is_open ? 3u : 4u);
    for (const DSC::Wall_3& wall : walls) {
      EXPECT_EQ(wall.normal.z(), 0);
      EXPECT_EQ(wall.distance, 1 + wall.normal.y() * .25);
    }
  }
}

TEST(Fluid_2, refuses_what_makes_no_sense) {
  Complex complex = disk(16, square);
  Fluid fluid(complex, two_liquids(1, 0));
  EXPECT_THROW(DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 1, 0)), DSC::Error);
  EXPECT_THROW(fluid.set_side(2, true, {}), DSC::Error);
  EXPECT_THROW(fluid.set_side(0, true, {{{NAN, 0, 0}}}), DSC::Error);
  EXPECT_THROW(fluid.set_velocities([](Vertex_handle) { return Vector(NAN, 0); }), DSC::Error);
}

} // namespace test_fluid_2
