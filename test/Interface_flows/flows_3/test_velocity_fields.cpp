#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Interface_flows/velocity_fields_3.h>

namespace test_velocity_fields {

using Complex = small_meshes::Complex;
using Position = Complex::Point_3;
using Vector = Complex::Vector_3;

constexpr double h = 1e-4;

// Differences of the velocity over 2h in each direction.
template <class Field> double divergence(const Field& field, const Position& p, double t) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector step(i == 0 ? h : 0, i == 1 ? h : 0, i == 2 ? h : 0);
    sum += (field(p + step, t)[i] - field(p - step, t)[i]) / (2 * h);
  }
  return sum;
}

template <class Field> void expect_no_divergence(const Field& field) {
  mesh_helpers::Random random(1);
  for (int i = 0; i < 100; ++i)
    EXPECT_NEAR(divergence(field, {random(0, 1), random(0, 1), random(0, 1)}, random(0, 1)), 0,
                1e-5);
}

// Nothing leaves the unit cube, and the flow after half of the period reverses the flow before.
template <class Field> void expect_closed_and_reversed(const Field& field, double period) {
  mesh_helpers::Random random(2);
  for (int i = 0; i < 20; ++i) {
    const double a = random(0, 1), b = random(0, 1), t = random(0, period);
    for (double side : {0., 1.}) {
      EXPECT_NEAR(field({side, a, b}, t).x(), 0, 1e-15);
      EXPECT_NEAR(field({a, side, b}, t).y(), 0, 1e-15);
      EXPECT_NEAR(field({a, b, side}, t).z(), 0, 1e-15);
    }
    const Position p(a, b, random(0, 1));
    const Vector sum = field(p, t) + field(p, period - t);
    EXPECT_LT(sum.squared_length(), 1e-28);
  }
}

TEST(Velocity_fields, enright) {
  const DSC::Enright_velocity_3 field(2);
  // sin^2 = 1/2, sin(2 pi x) = 1 at a quarter
  EXPECT_LT((field({.25, .25, .25}, 0) - Vector(1, -.5, -.5)).squared_length(), 1e-28);
  EXPECT_LT(field({.25, .25, .25}, 1).squared_length(), 1e-28);
  EXPECT_NEAR(DSC::Enright_velocity_3()({.25, .25, .25}, 1).x(), .5, 1e-14); // cos(pi / 3)
  expect_no_divergence(field);
  expect_closed_and_reversed(field, 2);
}

TEST(Velocity_fields, single_vortex) {
  const DSC::Single_vortex_velocity_3 field(2);
  EXPECT_LT((field({.5, .25, .9}, 0) - Vector(-1, 0, 0)).squared_length(), 1e-28);
  EXPECT_NEAR(DSC::Single_vortex_velocity_3()({.5, .25, .9}, 4).x(), 0, 1e-15); // half of 8
  expect_no_divergence(field);
  expect_closed_and_reversed(field, 2);
}

TEST(Velocity_fields, curl_noise) {
  static constexpr double speed = 2;
  const DSC::Curl_noise_velocity_3 field(.5, speed, 7);
  expect_no_divergence(field);

  mesh_helpers::Random random(3);
  double squares = 0;
  bool differs = false;
  static constexpr int samples = 2000;
  for (int i = 0; i < samples; ++i) {
    const Position p(random(-50, 50), random(-50, 50), random(-50, 50));
    squares += field(p, 0).squared_length();
    EXPECT_EQ(field(p, 0), DSC::Curl_noise_velocity_3(.5, speed, 7)(p, 1));
    differs = differs || field(p, 0) != DSC::Curl_noise_velocity_3(.5, speed, 8)(p, 0);
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(std::sqrt(squares / samples), speed, .05 * speed);
}

TEST(Velocity_fields, in_user_coordinates) {
  Complex dsc;
  dsc.set_normalization({{1, 2, 3}, 4});
  const auto field = [](const Position& p, double t) { return t * (p - CGAL::ORIGIN); };
  const DSC::Velocity_in_user_coordinates_3<Complex, decltype(field)> scaled(dsc, field);
  // the position (1, 1, 1) is (5, 6, 7) in user coordinates
  EXPECT_EQ(scaled({1, 1, 1}, 2), Vector(2.5, 3, 3.5));
}

} // namespace test_velocity_fields
