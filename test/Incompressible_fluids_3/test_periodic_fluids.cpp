// Incompressible flow on flat tori.
#include "test.h"
#include "torus.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Incompressible_fluid_2.h>
#include <CGAL/Incompressible_fluid_3.h>

namespace {

using torus::Complex;
using torus::Domain;
using Fluid = CGAL::Incompressible_fluid_2<Complex>;
using Point = Fluid::Point;
using Vector = Fluid::Vector;
using Vertex_handle = Complex::Vertex_handle;

constexpr double two_pi = 2 * CGAL_PI;

// Returns the shortest vector from p to q on the unit torus.
Vector between(const Point& p, const Point& q) {
  const auto along = [](double difference) { return difference - std::round(difference); };
  return {along(q.x() - p.x()), along(q.y() - p.y())};
}

double distance(const Point& p, const Point& q) {
  return std::sqrt(between(p, q).squared_length());
}

// Returns a complex with the label 1 inside a star-shaped curve around a center, and 0 outside.
template <class Radius>
Complex drop(const Point& center, std::size_t corners, const Radius& radius) {
  std::vector<Complex::Point_2> polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double a = two_pi * double(i) / double(corners);
    polygon.emplace_back(center.x() + radius(a) * std::cos(a),
                         center.y() + radius(a) * std::sin(a));
  }
  DSC::Labeled_curve_2<Complex::Point_2> curve;
  curve.add_polyline(polygon);
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      Domain(), {curve},
      CGAL::parameters::spacing_per_segment(DSC::Construction_options<2>::fine_spacing));
}

DSC::Fluid_properties one_liquid(double viscosity, double tension) {
  DSC::Fluid_properties result;
  result.set_liquid(1, {1, viscosity});
  result.set_surface_tension(0, 1, tension);
  return result;
}

DSC::Fluid_properties two_liquids(double density, double viscosity) {
  DSC::Fluid_properties result;
  result.set_liquid(0, {1, viscosity});
  result.set_liquid(1, {density, viscosity});
  return result;
}

std::map<std::size_t, Point> interface_positions(const Complex& complex) {
  std::map<std::size_t, Point> result; // by time stamp
  for (Vertex_handle v : complex.interface_vertices())
    result[v->time_stamp()] = complex.position(v);
  return result;
}

// A planar solid, periodic along y with the period 1: the layers 0.4 < y < 0.6 and its images.
struct Periodic_slab
{
  void walls(const DSC::Ball_solid_3::Point& p, double, std::vector<DSC::Wall_3>& result) const {
    const double y = p.y() - std::floor(p.y());
    if (y > .5)
      result.push_back({y - .6, {0, 1, 0}});
    else
      result.push_back({.4 - y, {0, -1, 0}});
  }
};

} // namespace

// G. I. Taylor and A. E. Green, 1937: the velocities of these vortices decay by exp(-2 nu k^2 t).
// One liquid fills the torus. The mean velocity carries the vortices across the seams.
TEST(Periodic_fluid, vortices_decay_at_their_rate) {
  static constexpr double viscosity = .02, dt = .01;
  static constexpr int steps = 20;
  for (const Vector& mean : {Vector(0, 0), Vector(2, 1)}) {
    SCOPED_TRACE(mean);
    Complex complex = DSC::make_deformable_simplicial_complex_2<Complex>(
        Domain(), 1. / 24, [](const auto&) { return 1; });
    DSC::Fluid_properties properties;
    properties.set_liquid(1, {1, viscosity});
    Fluid fluid(complex, properties);
    fluid.set_velocities([&](Vertex_handle v) {
      const double x = two_pi * complex.position(v).x(), y = two_pi * complex.position(v).y();
      return mean + Vector(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y));
    });
    const auto energy = [&](const DSC::Fluid_balance& balance) {
      return balance.kinetic_energy - balance.mass * mean.squared_length() / 2;
    };
    EXPECT_NEAR(energy(fluid.balance()), .25, .01);
    double begin = 0, end = 0;
    for (int k = 0; k <= steps; ++k) {
      const auto report = fluid.advance(dt);
      EXPECT_EQ(report.parts, 1u);
      EXPECT_LT(report.volume_error, 1e-13);
      EXPECT_NEAR(report.after.momentum.x(), mean.x(), 1e-10);
      EXPECT_NEAR(report.after.momentum.y(), mean.y(), 1e-10);
      EXPECT_EQ(report.after.angular_momentum.z(), 0);
      (k == 0 ? begin : end) = energy(report.after);
    }
    const double rate = std::log(begin / end) / (steps * dt);
    EXPECT_NEAR(rate, 4 * viscosity * two_pi * two_pi, .03 * 4 * viscosity * two_pi * two_pi);
    EXPECT_TRUE(complex.is_valid(true));
  }
}

// A drop and the liquid around it have the same velocity, so they move like a rigid body.
TEST(Periodic_fluid, moves_drops_across_the_seams) {
  static constexpr double dt = .05;
  static constexpr int steps = 60;
  const Vector velocity(1, .35);
  Complex complex = drop({.5, .5}, 24, [](double a) { return .2 + .05 * std::cos(3 * a); });
  Fluid fluid(complex, two_liquids(3, .01));
  fluid.set_velocities([&](Vertex_handle) { return velocity; });
  fluid.advance(dt); // adapts the mesh
  const std::map<std::size_t, Point> start = interface_positions(complex);
  const double area = complex.area(1), mass = fluid.balance().mass;
  for (int k = 1; k <= steps; ++k) {
    const auto report = fluid.advance(dt);
    ASSERT_EQ(report.parts, 1u);
    EXPECT_LT(report.volume_error, 1e-13);
    EXPECT_NEAR(report.after.momentum.x(), mass * velocity.x(), 1e-10);
    EXPECT_NEAR(report.after.momentum.y(), mass * velocity.y(), 1e-10);
  }
  EXPECT_NEAR(complex.area(1), area, 1e-12);
  const auto now = interface_positions(complex);
  ASSERT_EQ(now.size(), start.size());
  for (const auto& [stamp, p] : now) {
    ASSERT_EQ(start.count(stamp), 1u);
    EXPECT_LT(distance(p, start.at(stamp) + steps * dt * velocity), 1e-9);
  }
  EXPECT_TRUE(complex.is_valid(true));
}

// The same drop or bubble oscillates in the middle of the torus and across both seams. The
// translation is a multiple of the unit of positions, so it is exact.
TEST(Periodic_fluid, drops_oscillate_across_the_seams_as_elsewhere) {
  auto liquids = two_liquids(2, .001);
  liquids.set_surface_tension(0, 1, 1);
  DSC::Fluid_properties bubble;
  bubble.set_liquid(0, {1, .001});
  bubble.set_gas(1, {10, 1.4});
  bubble.set_surface_tension(0, 1, 1);
  for (const auto& properties : {one_liquid(.001, 1), liquids, bubble}) {
    Complex middle = drop({.5, .5}, 24, [](double a) { return .25 + .03 * std::cos(2 * a); });
    auto state = middle.state();
    for (auto& p : state.points)
      for (double& x : p)
        x += x < .5 ? .5 : -.5;
    Complex corner;
    corner.restore(state);
    Fluid a(middle, properties), b(corner, properties);
    static constexpr double dt = .005;
    for (const double accuracy : {1e-9, 1e-9, 1e-9, 1e-7, 1e-7, 1e-7, 1e-7, 1e-7}) {
      const auto of_middle = a.advance(dt), of_corner = b.advance(dt);
      EXPECT_NEAR(of_middle.after.kinetic_energy, of_corner.after.kinetic_energy,
                  accuracy * of_middle.after.kinetic_energy);
      EXPECT_NEAR(of_middle.after.energy(), of_corner.after.energy(), accuracy);
      const auto there = interface_positions(middle), here = interface_positions(corner);
      ASSERT_EQ(there.size(), here.size());
      for (const auto& [stamp, p] : there)
        EXPECT_LT(distance(p + Vector(.5, .5), here.at(stamp)), accuracy);
    }
    EXPECT_GT(a.balance().kinetic_energy, 1e-4);
  }
}

TEST(Periodic_fluid, has_sources_across_the_seams) {
  Complex complex = drop({0, 0}, 24, [](double) { return .25; });
  Fluid fluid(complex, one_liquid(.01, 1));
  const double area = complex.area(1);
  bool is_in_box = true;
  fluid.add_source(
      [&](const Point& p) {
        is_in_box = is_in_box && p.x() >= 0 && p.x() < 1 && p.y() >= 0 && p.y() < 1;
        return distance(p, {0, 0}) < .15;
      },
      [](double) { return .5; });
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(fluid.advance(.01).gained_volume, .005, 1e-12);
  EXPECT_TRUE(is_in_box);
  EXPECT_NEAR(complex.area(1), area + .02, 1e-12);
  for (Vertex_handle v : complex.interface_vertices())
    EXPECT_NEAR(distance(complex.position(v), {0, 0}), std::sqrt(complex.area(1) / CGAL_PI), .005);
}

// A layer with two symmetric surfaces is like a liquid above a floor. The square of the frequency
// of its waves is k^3 tanh(k h), for unit density and tension and for half of its depth h.
TEST(Periodic_fluid, capillary_waves_run_across_the_seam) {
  static constexpr double amplitude = .01, depth = .2;
  Complex complex = DSC::make_deformable_simplicial_complex_2<Complex>(
      Domain(), 1. / 24, [](const Complex::Point_2& p) {
        return std::abs(p.y() - .5) < depth + amplitude * std::cos(two_pi * p.x()) ? 1 : 0;
      });
  Fluid fluid(complex, one_liquid(0, 1));
  const double frequency = std::sqrt(two_pi * two_pi * two_pi * std::tanh(two_pi * depth));
  // Returns the coefficient of the wave in the shape of the upper surface.
  const auto wave = [&] {
    double result = 0;
    for (const auto& f : complex.interface_facets()) {
      const auto ends = complex.facet_vertices(f);
      const Point p = complex.position(ends[0]);
      if (p.y() < .5)
        continue;
      const Point q = complex.position_near(p, ends[1]), m = CGAL::midpoint(p, q);
      result += 2 * std::abs(q.x() - p.x()) * (m.y() - .5 - depth) * std::cos(two_pi * m.x());
    }
    return result;
  };
  const double begin = wave();
  EXPECT_NEAR(begin, amplitude, .05 * amplitude);
  static constexpr int steps = 20;
  for (int k = 0; k < steps; ++k) {
    const auto report = fluid.advance(CGAL_PI / frequency / steps);
    EXPECT_NEAR(report.after.momentum.x(), 0, 1e-10);
    EXPECT_NEAR(report.after.momentum.y(), 0, 1e-10);
  }
  EXPECT_NEAR(wave(), -begin, .05 * begin);
}

// Gravity has no potential on a torus. The energy check uses its work.
TEST(Periodic_fluid, falls_freely_across_the_seam) {
  static constexpr double dt = .05, gravity = 1;
  static constexpr int steps = 40;
  Complex complex = drop({.5, .5}, 24, [](double) { return .2; });
  auto properties = one_liquid(0, 0);
  properties.set_gravity({0, -gravity, 0});
  Fluid fluid(complex, properties);
  const std::map<std::size_t, Point> start = interface_positions(complex);
  const double mass = fluid.balance().mass, time = steps * dt;
  for (int k = 0; k < steps; ++k)
    ASSERT_EQ(fluid.advance(dt, parameters::interface_tolerance(0)).parts, 1u);
  const auto balance = fluid.balance();
  EXPECT_NEAR(balance.momentum.y(), -mass * gravity * time, 1e-10);
  EXPECT_NEAR(balance.kinetic_energy, mass * gravity * gravity * time * time / 2, 1e-10);
  EXPECT_EQ(balance.potential_energy, 0);
  const auto now = interface_positions(complex);
  ASSERT_EQ(now.size(), start.size());
  for (const auto& [stamp, p] : now)
    EXPECT_LT(distance(p, start.at(stamp) - Vector(0, gravity * time * time / 2)), 1e-9);
}

// A liquid on a slab rests, and presses on it with its weight.
TEST(Periodic_fluid, rests_on_a_periodic_solid) {
  Complex complex =
      torus::grid(10, [](const torus::Point& p) { return p.y() > .4 && p.y() < .6 ? 0 : 1; });
  complex.measure_interface_edges();
  auto properties = one_liquid(.01, 0);
  properties.set_gravity({0, -1, 0});
  Fluid fluid(complex, properties);
  fluid.add_solid(Periodic_slab());
  for (int k = 0; k < 5; ++k) {
    const auto report = fluid.advance(.05);
    EXPECT_LT(report.greatest_velocity, 1e-9);
    ASSERT_EQ(report.forces_on_solids.size(), 1u);
    EXPECT_NEAR(report.forces_on_solids[0].y(), -.8, 1e-8);
  }
  EXPECT_THROW(fluid.relax(.1, 1), DSC::Error);
}

TEST(Periodic_fluid, becomes_round_across_the_seams) {
  Complex complex = drop({.05, .97}, 24, [](double a) { return .2 + .04 * std::cos(2 * a); });
  Fluid fluid(complex, one_liquid(0, 1));
  fluid.relax(.05, 30);
  const double radius = std::sqrt(complex.area(1) / CGAL_PI);
  for (Vertex_handle v : complex.interface_vertices())
    EXPECT_NEAR(distance(complex.position(v), {.05, .97}), radius, .02 * radius);
}

// A disk and the liquid around it have the same velocity.
TEST(Periodic_fluid, carries_bodies_across_the_seams) {
  static constexpr double dt = .05, radius = .2;
  static constexpr int steps = 30;
  Complex complex = drop({.5, .5}, 24, [](double) { return radius; });
  DSC::Fluid_properties properties;
  properties.set_liquid(0, {1, 0});
  Fluid fluid(complex, properties);
  auto body = DSC::rigid_disk({.5, .5, 0}, radius, 2);
  body.velocity = {1, .4, 0};
  fluid.add_body(DSC::Ball_solid_3({.5, .5, 0}, radius, DSC::Solid_side::inside), body);
  fluid.set_velocities([&](Vertex_handle) { return Vector(1, .4); });
  for (int k = 0; k < steps; ++k) {
    const auto report = fluid.advance(dt, parameters::interface_tolerance(0));
    EXPECT_LT(report.depth_in_solids, 1e-6);
    EXPECT_NEAR(report.after.momentum.x(), report.after.mass, 1e-9);
  }
  const auto& moved = fluid.body(0);
  EXPECT_NEAR(moved.velocity.x(), 1, 1e-8);
  EXPECT_NEAR(moved.velocity.y(), .4, 1e-8);
  EXPECT_NEAR(moved.center.x(), .5 + steps * dt, 1e-8);
  for (Vertex_handle v : complex.interface_vertices())
    EXPECT_NEAR(distance(complex.position(v), {moved.center.x(), moved.center.y()}), radius, 1e-6);
}

TEST(Periodic_fluid, continues_with_the_same_bits) {
  const auto complex_at_start = [] {
    return drop({.9, .1}, 20, [](double a) { return .2 + .04 * std::cos(2 * a); });
  };
  const auto properties = [] {
    auto result = two_liquids(2, .01);
    result.set_surface_tension(0, 1, 1);
    result.set_gravity({.5, -1, 0});
    return result;
  };
  Complex complex = complex_at_start();
  Fluid fluid(complex, properties());
  for (int k = 0; k < 3; ++k)
    fluid.advance(.01);
  Complex other;
  other.restore(complex.state());
  Fluid restored(other, properties());
  restored.restore(fluid.state());
  for (int k = 0; k < 3; ++k) {
    fluid.advance(.01);
    restored.advance(.01);
  }
  EXPECT_TRUE(complex.state() == other.state());
  EXPECT_EQ(fluid.state().motion, restored.state().motion);
  EXPECT_EQ(fluid.state().deviations, restored.state().deviations);
}

// In space, a liquid that fills the torus has no constrained velocity.
TEST(Periodic_fluid, vortices_decay_in_space) {
  using Domain_3 = DSC::Torus_domain<3>;
  using Complex_3 = CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default,
                                                          DSC::Volume_length_ratio_3, Domain_3>;
  static constexpr double viscosity = .05, dt = .01;
  static constexpr int steps = 6;
  Complex_3 complex = DSC::make_deformable_simplicial_complex_3<Complex_3>(
      Domain_3(), .14, [](const auto&) { return 1; });
  DSC::Fluid_properties properties;
  properties.set_liquid(1, {1, viscosity});
  CGAL::Incompressible_fluid_3<Complex_3> fluid(complex, properties);
  using Vector_3 = CGAL::Incompressible_fluid_3<Complex_3>::Vector;
  fluid.set_velocities([&](Complex_3::Vertex_handle v) {
    const double x = two_pi * complex.position(v).x(), y = two_pi * complex.position(v).y();
    return Vector_3(std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y), .5);
  });
  double begin = 0, end = 0;
  for (int k = 0; k <= steps; ++k) {
    const auto report = fluid.advance(dt);
    EXPECT_EQ(report.parts, 1u);
    EXPECT_LT(report.volume_error, 1e-13);
    EXPECT_NEAR(report.after.momentum.x(), 0, 1e-10);
    EXPECT_NEAR(report.after.momentum.z(), .5, 1e-10);
    (k == 0 ? begin : end) = report.after.kinetic_energy - .125;
  }
  const double rate = std::log(begin / end) / (steps * dt);
  EXPECT_NEAR(rate, 4 * viscosity * two_pi * two_pi, .1 * 4 * viscosity * two_pi * two_pi);
  EXPECT_TRUE(complex.is_valid(true));
}
