// The field that liquids carry, and surface tensions that depend on it.
#include "fluids_2.h"
#include "fluids_3.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>

#include <optional>

namespace test_carried_field {

using namespace fluids_2;
using Complex_3 = fluids_3::Complex;
using Fluid_3 = fluids_3::Fluid;
using Point = Fluid::Point;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Returns a regular grid of columns and rows in a box at the origin. `label_at` is a function of
// the middle of a square.
Complex grid(std::size_t columns, std::size_t rows, double width, double height,
             const std::function<int(const Point&)>& label_at) {
  std::vector<Complex::Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  const double dx = width / double(columns), dy = height / double(rows);
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i)
      points.emplace_back(i == columns ? width : double(i) * dx,
                          j == rows ? height : double(j) * dy);
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t p = j * (columns + 1) + i, q = p + columns + 1;
      if ((i + j) % 2 == 0) {
        triangles.push_back({p, p + 1, q + 1});
        triangles.push_back({p, q + 1, q});
      } else {
        triangles.push_back({p, p + 1, q});
        triangles.push_back({p + 1, q + 1, q});
      }
      labels.resize(triangles.size(), label_at({(double(i) + .5) * dx, (double(j) + .5) * dy}));
    }
  return DSC::make_deformable_simplicial_complex_2<Complex>(points, triangles, labels);
}

// Returns a disk of label 1 in a square of label 0, about the origin.
Complex disk(std::size_t corners, double radius, double half_side) {
  return planar_regions::region(
      planar_regions::around({0, 0}, corners, [radius](double) { return radius; }), {},
      CGAL::Bbox_2(-half_side, -half_side, half_side, half_side));
}

DSC::Liquid liquid(double viscosity, double diffusivity) {
  DSC::Liquid result{1, viscosity};
  result.diffusivity = diffusivity;
  return result;
}

// Lets a cosine mode along x decay in a liquid of length 1, and checks its rate and its integral.
template <class Fluid_of_dimension, class Complex_of_dimension>
void check_decay(Complex_of_dimension& complex) {
  static constexpr double diffusivity = .1, dt = .005;
  static constexpr int steps = 20;
  DSC::Fluid_properties properties;
  properties.set_liquid(1, liquid(0, diffusivity));
  Fluid_of_dimension fluid(complex, properties);
  fluid.set_field([](const auto& p) { return 2 + std::cos(CGAL_PI * p.x()); });
  const double integral = fluid.balance().field_integral;
  DSC::Fluid_balance begin, end; // begins when the mode is the mode of the mesh
  for (int k = 0; k < 2 * steps; ++k) {
    end = fluid.advance(dt, parameters::adaptation_interval(0)).after;
    if (k + 1 == steps)
      begin = end;
  }
  EXPECT_NEAR(end.field_integral, integral, 1e-12 * integral);
  const double rate = -std::log((end.greatest_field - end.least_field) /
                                (begin.greatest_field - begin.least_field)) /
                      (steps * dt),
               exact = diffusivity * CGAL_PI * CGAL_PI;
  testing::Test::RecordProperty("error_" + std::to_string(Complex_of_dimension::dimension),
                                std::to_string(rate / exact - 1));
  EXPECT_NEAR(rate, exact, .02 * exact);
  EXPECT_LT(end.greatest_field, begin.greatest_field);
  EXPECT_GT(end.least_field, begin.least_field);
}

TEST(Carried_field, decays_by_diffusion) {
  Complex plane = grid(16, 8, 1, .5, [](const Point& p) { return p.y() < .3 ? 1 : 0; });
  check_decay<Fluid>(plane);
  Complex_3 space = DSC::make_deformable_simplicial_complex_3<Complex_3>(
      CGAL::Bbox_3(0, 0, 0, 1, .2, .2), .05, [](const auto& p) { return p.z() < .14 ? 1 : 0; });
  check_decay<Fluid_3>(space);
}

// The field and its flux are continuous between liquids with different diffusivities.
TEST(Carried_field, flows_between_liquids) {
  Complex complex = grid(8, 4, 1, .5, [](const Point& p) { return p.x() < .5 ? 0 : 1; });
  DSC::Fluid_properties properties;
  properties.set_liquid(0, liquid(0, 1));
  properties.set_liquid(1, liquid(0, 3));
  Fluid fluid(complex, properties);
  EXPECT_FALSE(fluid.has_field());
  fluid.set_field([](const Point&) { return .5; });
  fluid.fix_field([](const Point& p, double) {
    return p.x() == 0 || p.x() == 1 ? std::optional<double>(p.x()) : std::nullopt;
  });
  for (int k = 0; k < 12; ++k) {
    const auto report = fluid.advance(.5, parameters::adaptation_interval(0));
    EXPECT_GE(report.after.least_field, 0);
    EXPECT_LE(report.after.greatest_field, 1);
  }
  for (auto v : complex.vertices()) {
    const double x = complex.position(v).x();
    EXPECT_NEAR(fluid.field(v), x < .5 ? 1.5 * x : 1 - .5 * (1 - x), 1e-9);
  }
}

// In a shallow cavity without net flux, the velocity of the surface is tau h / (4 mu).
TEST(Marangoni, surface_flows_to_larger_tensions) {
  static constexpr double height = .25, slope = .01;
  Complex complex = grid(36, 9, 1.5, .375, [](const Point& p) { return p.y() < height ? 1 : 0; });
  DSC::Fluid_properties properties;
  properties.set_liquid(1, liquid(1, 1));
  properties.set_surface_tension(0, 1, [](double field) { return 1 + slope * field; });
  properties.set_gravity({0, -50, 0}); // the surface stays nearly flat
  Fluid fluid(complex, properties);
  fluid.set_field([](const Point& p) { return p.x(); });
  fluid.fix_field([](const Point& p, double) { return p.x(); });
  fluid.set_side(0, false, {{{0, 0, 0}}});
  fluid.set_side(0, true, {{{0, 0, 0}}});
  fluid.set_side(1, false, {{{0, 0, 0}}});
  for (int k = 0; k < 100; ++k)
    EXPECT_TRUE(fluid.advance(.06).repetitions.empty());
  double sum = 0;
  int number = 0;
  for (auto v : complex.interface_vertices())
    if (std::abs(complex.position(v).x() - .75) < .2) {
      sum += fluid.velocity(v).x();
      ++number;
    }
  const double exact = slope * height / 4;
  testing::Test::RecordProperty("error", std::to_string(sum / number / exact - 1));
  EXPECT_NEAR(sum / number, exact, .03 * exact);
}

// A drop moves to smaller tensions: the liquids along its surface move to larger ones.
TEST(Marangoni, drop_moves_to_smaller_tensions) {
  Complex complex = disk(32, .3, 1);
  DSC::Fluid_properties properties;
  properties.set_liquid(0, liquid(.1, 0));
  properties.set_liquid(1, liquid(.1, 0));
  properties.set_surface_tension(0, 1, [](double field) { return 1 - .2 * field; });
  Fluid fluid(complex, properties);
  fluid.set_field([](const Point& p) { return p.y(); });
  for (int k = 0; k < 20; ++k)
    EXPECT_TRUE(fluid.advance(.02).repetitions.empty());
  double x = 0, y = 0;
  for (auto c : complex.cells())
    for (int i = 0; i < 3 && c->subdomain_index() == 1; ++i) {
      x += complex.measure(c) / 3 * complex.position(c->vertex(i)).x();
      y += complex.measure(c) / 3 * complex.position(c->vertex(i)).y();
    }
  x /= complex.measure(1);
  y /= complex.measure(1);
  testing::Test::RecordProperty("place", std::to_string(x) + " " + std::to_string(y));
  EXPECT_GT(y, .005);
  EXPECT_LT(std::abs(x), .05 * y);
}

// Heat does work on the interface. The check of energies must not undo such a step.
TEST(Marangoni, heat_adds_surface_energy) {
  Complex complex = disk(24, .5, 1);
  DSC::Fluid_properties properties;
  properties.set_liquid(1, liquid(0, 1));
  properties.set_surface_tension(0, 1, [](double field) { return 1 + field; });
  Fluid fluid(complex, properties);
  fluid.set_field([](const Point&) { return 0; });
  fluid.fix_field([](const Point&, double time) { return 10 * time; });
  const double begin = fluid.balance().surface_energy;
  double work = 0;
  for (int k = 0; k < 5; ++k) {
    const auto report = fluid.advance(.1, parameters::adaptation_interval(0));
    EXPECT_TRUE(report.repetitions.empty());
    work += report.work_of_tensions;
  }
  const double end = fluid.balance().surface_energy;
  EXPECT_NEAR(end, 6 * begin, 1e-6 * end);
  EXPECT_NEAR(work, end - begin, 1e-6 * end);
}

TEST(Marangoni, constant_function_is_the_constant) {
  const auto run = [](bool is_function) {
    Complex complex = disk(24, .5, 1);
    DSC::Fluid_properties properties;
    properties.set_liquid(1, liquid(.01, 0));
    if (is_function)
      properties.set_surface_tension(0, 1, [](double) { return 2.; });
    else
      properties.set_surface_tension(0, 1, 2);
    Fluid fluid(complex, properties);
    if (is_function)
      fluid.set_field([](const Point& p) { return p.x(); });
    fluid.set_velocities([&](auto v) {
      const Point p = complex.position(v);
      return Fluid::Vector(p.x(), -p.y());
    });
    for (int k = 0; k < 5; ++k)
      fluid.advance(.02);
    return std::make_pair(complex.state(), fluid.state().motion);
  };
  EXPECT_EQ(run(false), run(true));
}

TEST(Carried_field, is_restored_bitwise) {
  DSC::Fluid_properties properties;
  properties.set_liquid(0, liquid(.1, .01));
  properties.set_liquid(1, liquid(.1, .02));
  properties.set_surface_tension(0, 1, [](double field) { return 1 - .5 * field; });
  const auto run = [&](unsigned threads, bool restores) {
    const auto np = parameters::number_of_threads(threads);
    std::vector<Complex> complexes(2);
    complexes[0] = disk(24, .4, 1);
    Fluid first(complexes[0], properties);
    first.set_field([](const Point& p) { return p.y() * p.y(); });
    // Stops the liquids, and keeps the field.
    first.set_velocities([](auto) { return Fluid::Vector(0, 0); });
    EXPECT_GT(first.balance().greatest_field, .9);
    for (int k = 0; k < 5; ++k)
      first.advance(.05, np);
    complexes[1].restore(complexes[0].state());
    Fluid second(complexes[1], properties);
    second.restore(first.state());
    Fluid& fluid = restores ? second : first;
    EXPECT_TRUE(fluid.has_field());
    for (int k = 0; k < 5; ++k)
      fluid.advance(.05, np);
    return std::make_pair(fluid.complex().state(), fluid.state().field);
  };
  const auto expected = run(1, false);
  EXPECT_FALSE(expected.second.empty());
  EXPECT_EQ(run(1, true), expected);
  EXPECT_EQ(run(2, false), expected);
}

TEST(Carried_field, refuses_what_makes_no_sense) {
  DSC::Fluid_properties properties;
  EXPECT_THROW(properties.set_liquid(1, liquid(0, -1)), DSC::Error);
  EXPECT_THROW(properties.set_liquid(1, liquid(0, not_a_number)), DSC::Error);
  EXPECT_THROW(properties.set_surface_tension(0, 1, std::function<double(double)>()), DSC::Error);
  EXPECT_THROW(properties.set_surface_tension(1, 1, [](double) { return 1.; }), DSC::Error);
  properties.set_liquid(1, liquid(0, 1));
  properties.set_surface_tension(0, 1, [](double field) { return 1 - field; });
  EXPECT_EQ(properties.surface_tension(1, 0, .25), .75);
  EXPECT_THROW(properties.surface_tension(0, 1, 2), DSC::Error);
  Complex complex = disk(16, .5, 1);
  Fluid fluid(complex, properties);
  EXPECT_THROW(fluid.set_field([](const Point& p) { return p.x() > 0 ? not_a_number : 0; }),
               DSC::Error);
  EXPECT_FALSE(fluid.has_field());
  fluid.set_field([](const Point&) { return 0; });

  // A step that fails leaves the state before.
  const auto state = complex.state();
  fluid.fix_field([](const Point&, double) { return not_a_number; });
  EXPECT_THROW(fluid.advance(.1), DSC::Error);
  fluid.fix_field([](const Point&, double) { return 2; });
  EXPECT_THROW(fluid.advance(.1), DSC::Error);
  EXPECT_EQ(fluid.time(), 0);
  EXPECT_EQ(complex.state(), state);
  EXPECT_EQ(fluid.balance().greatest_field, 0);
  auto other = fluid.state();
  other.field.pop_back();
  EXPECT_THROW(fluid.restore(other), DSC::Error);
}

} // namespace test_carried_field
