#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_adaptive_advection {

using namespace small_meshes;

const double pi = std::acos(-1.);
constexpr double radius = .3;

// Deforms a ball about the origin to an ellipsoid and back within the time 1. At time t, x is
// scaled by exp(strength * sin(pi t)), and y and z are scaled by the inverse of its square root.
struct Saddle
{
  double strength;

  Vector operator()(const Position& p, double t) const {
    const double rate = strength * pi * std::cos(pi * t);
    return rate * Vector(p.x(), -p.y() / 2, -p.z() / 2);
  }
};

constexpr int steps = 20;
constexpr double dt = 1. / steps;

struct Outcome
{
  std::size_t most_vertices = 0; // of the interface
  double volume_halfway = 0;
};

template <class NamedParameters>
Outcome flow(Complex& dsc, double strength, const NamedParameters& np) {
  Outcome outcome;
  for (int i = 0; i < steps; ++i) {
    const auto report = DSC::advect_adaptively(dsc, Saddle{strength}, i * dt, dt, np);
    EXPECT_TRUE(report.complete) << i;
    outcome.most_vertices = (std::max)(outcome.most_vertices, dsc.interface_vertices().size());
    if (2 * (i + 1) == steps)
      outcome.volume_halfway = dsc.volume(1);
  }
  EXPECT_TRUE(dsc.is_valid());
  return outcome;
}

Complex ball(std::size_t n) {
  Complex dsc = mesh_helpers::sphere(n, 2 * radius);
  DSC::deform_interface(dsc, [&](Complex::Vertex_handle v) {
    return CGAL::ORIGIN + (dsc.position(v) - CGAL::ORIGIN) / 2;
  });
  dsc.measure_interface_edges();
  return dsc;
}

std::vector<Position> interface_positions(const Complex& dsc) {
  std::vector<Position> result;
  for (auto v : dsc.interface_vertices())
    result.push_back(dsc.position(v));
  return result;
}

double farthest_from_sphere(const Complex& dsc) {
  double result = 0;
  for (const Position& p : interface_positions(dsc))
    result = (std::max)(result, std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - radius));
  return result;
}

double largest_distance(const std::vector<Position>& a, const std::vector<Position>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    result = (std::max)(result, std::sqrt((a[i] - b[i]).squared_length()));
  return result;
}

constexpr double mild = -.05, strong = -.9;

TEST(Adaptive_advection, changes_nothing_without_need) {
  Complex dsc = ball(16);
  const double volume = dsc.volume(1);
  const auto vertices = dsc.interface_vertices();
  const auto positions = interface_positions(dsc);
  flow(dsc, mild, parameters::default_values());
  EXPECT_EQ(dsc.interface_vertices(), vertices);
  EXPECT_LT(largest_distance(interface_positions(dsc), positions), 1e-7);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-6 * volume);
}

// A rigid rotation does not change the interface, even if it is too coarse for its curvature.
TEST(Adaptive_advection, leaves_what_turns_rigidly) {
  Complex dsc = ball(4), stretched = ball(4);
  flow(stretched, mild, parameters::default_values());
  const auto vertices = dsc.interface_vertices();
  EXPECT_GT(stretched.interface_vertices().size(), vertices.size());

  const auto positions = interface_positions(dsc);
  const double volume = dsc.volume(1);
  const auto turn = [](const Position& p, double) { return 2 * pi * Vector(-p.y(), p.x(), 0); };
  for (int i = 0; i < 100; ++i)
    DSC::advect_adaptively(dsc, turn, i * .01, .01);
  EXPECT_EQ(dsc.interface_vertices(), vertices);
  EXPECT_LT(largest_distance(interface_positions(dsc), positions), 1e-6);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-6 * volume);
}

// A ball becomes a lens with one third of its thickness and eight times the curvature at the rim,
// and then a ball again.
TEST(Adaptive_advection, refines_what_is_bent_and_brings_it_back) {
  Complex dsc = ball(16), unchanged = ball(16);
  const double volume = dsc.volume(1), edge = dsc.mean_interface_edge();
  const std::size_t vertices = dsc.interface_vertices().size();
  const Outcome outcome = flow(dsc, strong, parameters::default_values()),
                as_it_is = flow(unchanged, strong, parameters::interface_tolerance(0.));
  EXPECT_EQ(as_it_is.most_vertices, vertices);
  EXPECT_GT(outcome.most_vertices, 1.2 * vertices);
  const double exact = 4 * pi / 3 * radius * radius * radius;
  std::printf("%zu %zu  %g %g  %g %g far %g edge %g\n", vertices, outcome.most_vertices,
              outcome.volume_halfway / exact - 1, as_it_is.volume_halfway / exact - 1,
              volume / exact - 1, dsc.volume(1) / exact - 1, farthest_from_sphere(dsc), edge);
}

TEST(Adaptive_advection, keeps_sharp_edges) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(4, small_meshes::cube));
  const Outcome outcome = flow(dsc, -.6, parameters::default_values());
  EXPECT_NEAR(outcome.volume_halfway, 1, 1e-5);
  EXPECT_NEAR(dsc.volume(1), 1, 1e-5);
}

TEST(Adaptive_advection, adapts_by_the_number_of_the_step) {
  const auto vertices_after_step = [](int step, unsigned interval) {
    Complex dsc = ball(4);
    DSC::advect_adaptively(dsc, Saddle{mild}, step * dt, dt,
                           parameters::adaptation_interval(interval));
    return dsc.interface_vertices().size();
  };
  const std::size_t before = ball(4).interface_vertices().size();
  EXPECT_GT(vertices_after_step(0, 4), before);
  EXPECT_EQ(vertices_after_step(3, 4), before);
  EXPECT_GT(vertices_after_step(3, 3), before);
  EXPECT_GT(vertices_after_step(3, 1), before);
}

TEST(Adaptive_advection, refuses_wrong_parameters) {
  using CGAL::Deformable_simplicial_complexes::Error;
  Complex dsc = ball(4);
  const auto positions = interface_positions(dsc);
  const auto step = [&](const auto& np) { DSC::advect_adaptively(dsc, Saddle{strong}, 0, dt, np); };
  EXPECT_THROW(step(parameters::interface_tolerance(-1.)), Error);
  EXPECT_THROW(step(parameters::adaptation_interval(0)), Error);
  EXPECT_THROW(step(parameters::feature_angle(181.)), Error);
  EXPECT_EQ(interface_positions(dsc), positions);
}

} // namespace test_adaptive_advection
