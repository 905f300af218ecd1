#include "plane.h"

#include <CGAL/deform_interface_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace {

using plane::Complex;
using plane::Point;
using Report = CGAL::Deformation_report<Complex>;
constexpr double pi = 3.14159265358979323846;

Point rotated(const Point& p, double angle) {
  return Point(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
               std::sin(angle) * p.x() + std::cos(angle) * p.y());
}

TEST(Plane, disk_rotated_by_a_full_turn_is_back) {
  Complex complex = plane::disks_in_a_square({{.5, 0, .4, 1}}, 40, 2, 20);
  ASSERT_TRUE(complex.is_valid());
  std::map<std::size_t, Point> start;
  for (auto v : complex.interface_vertices())
    start[v->time_stamp()] = v->point();
  const double area = complex.area(1);
  static constexpr int steps = 72;
  for (int step = 0; step < steps; ++step) {
    const Report report = CGAL::deform_interface(complex, [&](Complex::Vertex_handle v) {
      return rotated(start.at(v->time_stamp()), 2 * pi * (step + 1) / steps);
    });
    ASSERT_TRUE(report.complete) << step;
    ASSERT_TRUE(report.events.empty());
    ASSERT_TRUE(complex.is_valid(true)) << step;
  }
  ASSERT_EQ(complex.interface_vertices().size(), start.size());
  for (auto v : complex.interface_vertices())
    EXPECT_LT((v->point() - start.at(v->time_stamp())).squared_length(), 1e-24);
  EXPECT_NEAR(complex.area(1), area, 1e-12);
}

TEST(Plane, disks_that_meet_merge) {
  Complex complex = plane::disks_in_a_square({{-.6, 0, .4, 1}, {.6, 0, .4, 1}}, 40, 2, 20);
  ASSERT_TRUE(complex.is_valid());
  ASSERT_EQ(complex.number_of_components(1), 2u);
  std::size_t merged = 0, others = 0;
  for (int step = 0; step < 12; ++step) {
    const double way = .03;
    const Report report = CGAL::deform_interface(complex, [&](Complex::Vertex_handle v) {
      const auto p = complex.position(v);
      return Point(p.x() > 0 ? p.x() - way : p.x() + way, p.y());
    });
    for (const auto& event : report.events)
      (event.kind == CGAL::Component_event::Kind::merged ? merged : others) += 1;
    ASSERT_TRUE(complex.is_valid(true)) << step;
  }
  EXPECT_EQ(complex.number_of_components(1), 1u);
  EXPECT_EQ(merged, 1u);
  EXPECT_EQ(others, 0u);
}

} // namespace
