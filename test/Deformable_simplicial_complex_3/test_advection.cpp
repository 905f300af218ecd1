#include "mesh_helpers.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Integration_scheme.h>
#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/interface_flows_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CGAL::Deformable_simplicial_complexes::Integration_scheme;
using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using Position = Complex::Approximate_point_3;
using Vector = Complex::Approximate_vector_3;
using Vertex_handle = Complex::Vertex_handle;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

// Turns about the z axis with the angular velocity 1 + t and shrinks with the rate 1/2.
Vector spiral(const Position& p, double t) {
  return Vector(-(1 + t) * p.y() - p.x() / 2, (1 + t) * p.x() - p.y() / 2, -p.z() / 2);
}

Position after_spiral(const Position& p, double t) {
  const double angle = t + t * t / 2, scale = std::exp(-t / 2);
  return {scale * (std::cos(angle) * p.x() - std::sin(angle) * p.y()),
          scale * (std::sin(angle) * p.x() + std::cos(angle) * p.y()), scale * p.z()};
}

// How far the vertices of a cube end from where they should be.
double error(Integration_scheme scheme, int steps) {
  static constexpr double end = .4;
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  std::vector<Position> expected;
  for (Vertex_handle v : vertices)
    expected.push_back(after_spiral(dsc.position(v), end));
  for (int i = 0; i < steps; ++i)
    EXPECT_TRUE(CGAL::advect_interface(dsc, spiral, i * end / steps, end / steps,
                                       parameters::scheme(scheme))
                    .complete);
  EXPECT_EQ(dsc.interface_vertices(), vertices);
  double squared = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    squared = (std::max)(squared, (dsc.position(vertices[i]) - expected[i]).squared_length());
  return std::sqrt(squared);
}

void expect_order(Integration_scheme scheme, double order) {
  const double coarse = error(scheme, 2), fine = error(scheme, 4);
  EXPECT_NEAR(std::log2(coarse / fine), order, .35);
}

} // namespace

TEST(Advection, euler_is_of_first_order) { expect_order(Integration_scheme::euler, 1); }

TEST(Advection, midpoint_rule_is_of_second_order) { expect_order(Integration_scheme::rk2, 2); }

TEST(Advection, runge_kutta_is_of_fourth_order) { expect_order(Integration_scheme::rk4, 4); }

TEST(Advection, second_order_is_the_default) {
  Complex a = make_complex(grid(4, small_meshes::cube)), b = a;
  CGAL::advect_interface(a, spiral, 0, .1);
  CGAL::advect_interface(b, spiral, 0, .1, parameters::scheme(Integration_scheme::rk2));
  EXPECT_TRUE(a.state() == b.state());
}

TEST(Advection, negative_steps_go_back) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  std::vector<Position> before;
  for (Vertex_handle v : vertices)
    before.push_back(dsc.position(v));
  const auto rk4 = parameters::scheme(Integration_scheme::rk4);
  EXPECT_TRUE(CGAL::advect_interface(dsc, spiral, 0, .1, rk4).complete);
  EXPECT_TRUE(CGAL::advect_interface(dsc, spiral, .1, -.1, rk4).complete);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_LT((dsc.position(vertices[i]) - before[i]).squared_length(), 1e-12);
}

TEST(Advection, flow_maps_are_taken_as_they_are) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  std::vector<Position> expected;
  for (Vertex_handle v : vertices)
    expected.push_back(after_spiral(dsc.position(v), .2));
  const auto map = [](const Position& p, double t, double dt) {
    EXPECT_EQ(t, 3);
    return after_spiral(p, dt);
  };
  EXPECT_TRUE(CGAL::advect_interface(dsc, map, 3, .2).complete);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(dsc.position(vertices[i]), expected[i]);
}

// The whole interface is asked once for each evaluation.
TEST(Advection, velocities_of_the_whole_interface) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  std::vector<double> times;
  const auto velocity = [&](const CGAL::Interface_snapshot_3<Complex>& interface_,
                            const std::vector<Position>& positions, double t,
                            std::vector<Vector>& velocities) {
    times.push_back(t);
    EXPECT_EQ(interface_.vertices, dsc.interface_vertices());
    EXPECT_EQ(interface_.triangles.size(), 48u);
    for (const auto& triangle : interface_.triangles) {
      EXPECT_EQ(triangle.behind, 1);
      EXPECT_EQ(triangle.in_front, 0);
      const auto& v = triangle.vertices;
      const Vector normal =
          CGAL::cross_product(positions[v[1]] - positions[v[0]], positions[v[2]] - positions[v[0]]);
      EXPECT_GT(normal * (positions[v[0]] - CGAL::ORIGIN), 0);
    }
    for (const Position& p : positions)
      velocities.push_back(spiral(p, t));
  };
  Complex reference = dsc;
  const auto rk4 = parameters::scheme(Integration_scheme::rk4);
  CGAL::advect_interface(dsc, velocity, 1, .25, rk4);
  EXPECT_EQ(times, (std::vector<double>{1, 1.125, 1.125, 1.25}));
  CGAL::advect_interface(reference, spiral, 1, .25, rk4);
  EXPECT_TRUE(dsc.state() == reference.state());
}

TEST(Flows, rotation_keeps_its_axis_and_distances) {
  const CGAL::Rigid_rotation_3 rotation({1, 0, 0}, {0, 0, 5}, CGAL_PI / 2);
  EXPECT_LT((rotation({2, 0, 7}, 0, 1) - Position(1, 1, 7)).squared_length(), 1e-30);
  EXPECT_LT((rotation({2, 0, 7}, 9, -1) - Position(1, -1, 7)).squared_length(), 1e-30);
  EXPECT_LT((rotation({2, 0, 7}, 0, 4) - Position(2, 0, 7)).squared_length(), 1e-30);
  EXPECT_EQ(rotation({1, 0, -3}, 0, .7), Position(1, 0, -3));
}

TEST(Flows, offset_moves_planes_by_speed_times_time) {
  Complex dsc = make_complex(grid(4, [](const auto& p) { return p.x() < 0 ? 1 : 0; }));
  EXPECT_TRUE(CGAL::advect_interface(dsc, CGAL::Normal_offset_3{.2}, 0, .5).complete);
  EXPECT_NEAR(dsc.volume(1), 4.4, 1e-12);
  EXPECT_TRUE(CGAL::advect_interface(dsc, CGAL::Normal_offset_3{-.2}, 0, 1).complete);
  EXPECT_NEAR(dsc.volume(1), 3.6, 1e-12);
}

TEST(Flows, offset_acts_where_phases_face_the_outside) {
  Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  const double area = dsc.area(1, 2);
  EXPECT_TRUE(CGAL::advect_interface(dsc, CGAL::Normal_offset_3{.1}, 0, .5).complete);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(dsc.volume(1), .55);
  EXPECT_NEAR(dsc.volume(1), dsc.volume(2), .02);
  EXPECT_GT(dsc.area(1, 2), area);
}

TEST(Flows, rotation_takes_axes_of_any_length) {
  for (double length : {1e-200, 1e200}) {
    const CGAL::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, length}, CGAL_PI / 2);
    EXPECT_LT((rotation({1, 0, 0}, 0, 1) - Position(0, 1, 0)).squared_length(), 1e-30) << length;
  }
}

TEST(Flows, offset_refuses_speeds_that_are_not_finite) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  for (double speed : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_THROW(CGAL::advect_interface(dsc, CGAL::Normal_offset_3{speed}, 0, 1),
                 CGAL::Deformable_simplicial_complexes::Invalid_destination_error)
        << speed;
  EXPECT_TRUE(dsc.state() == state);
  EXPECT_FALSE(CGAL::advect_interface(dsc, CGAL::Normal_offset_3{1e78}, 0, 1).complete);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Advection, refuses_velocities_of_another_number_of_vertices) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  const auto too_few = [](const auto&, const std::vector<Position>& positions, double,
                          std::vector<Vector>& velocities) {
    velocities.assign(positions.size() - 1, Vector(0, 0, 0));
  };
  EXPECT_THROW(CGAL::advect_interface(dsc, too_few, 0, .1),
               CGAL::Deformable_simplicial_complexes::Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == state);
}
