// The balance of volumes in reports: thin phases of few facets, long steps, and corners.
#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/number_utils.h>

namespace test_balance {

using namespace small_meshes;
using Report = DSC::Deformation_report<Complex>;

const Report::Label_change& of_label(const Report& report, int label) {
  return *std::find_if(report.labels.begin(), report.labels.end(),
                       [&](const auto& change) { return change.label == label; });
}

// A plate of the thickness 1 in the middle of a box. Each side of the plate has few facets.
Complex plate(double length) {
  auto mesh = grid(6, [](const Point& p) {
    return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < .34 ? 1 : 0;
  });
  for (Point& p : mesh.points)
    p = Point(1.5 * length * p.x(), 1.5 * length * p.y(), 1.5 * p.z());
  return make_complex(mesh);
}

TEST(Thin_phases, keep_their_volume_in_offsets) {
  for (double length : {10., 100.})
    for (double distance : {-.001, .05, -.2}) {
      Complex dsc = plate(length);
      ASSERT_NEAR(dsc.volume(1), length * length, 1e-9 * length * length);
      const Report report = DSC::advect_interface(dsc, DSC::Normal_offset{distance}, 0, 1);
      ASSERT_TRUE(dsc.is_valid());
      const double side = length + 2 * distance, exact = side * side * (1 + 2 * distance);
      EXPECT_NEAR(dsc.volume(1), exact, 1e-3 * exact) << length << " " << distance;
      EXPECT_EQ(report.relabeled, 0u);
      EXPECT_TRUE(report.complete);
    }
}

TEST(Thin_phases, keep_their_volume_in_a_shear) {
  Complex dsc = plate(100);
  const double volume = dsc.volume(1);
  const auto shear = [](const Position& p, double) {
    return Vector(.3 * p.y() + .1 * p.z(), 0, .001 * p.x());
  };
  for (int i = 0; i < 5; ++i)
    DSC::advect_interface(dsc, shear, .1 * i, .1);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(1), volume, 1e-3 * volume);
}

TEST(Thin_phases, thin_gaps_stay_until_the_sides_touch) {
  auto mesh = grid(6, [](const Point& p) { return std::abs(p.z()) > .34 ? 1 : 0; });
  for (Point& p : mesh.points)
    p = Point(50 * p.x(), 50 * p.y(), 1.5 * p.z()); // a gap of width 1
  Complex dsc = make_complex(mesh);
  for (int i = 0; i < 4; ++i) { // to the width .2
    DSC::advect_interface(dsc, DSC::Normal_offset{.1}, i, 1);
    EXPECT_NEAR(dsc.volume(0), 1e4 * (1 - .2 * (i + 1)), 1) << i;
    EXPECT_EQ(dsc.number_of_components(1), 2u);
  }
  const Report report = DSC::advect_interface(dsc, DSC::Normal_offset{.15}, 4, 1);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_NEAR(dsc.volume(0), 0, 1e-9);
  // Small cells change their label before the sides touch.
  EXPECT_NEAR(of_label(report, 0).volume_unexplained(), 0, 2e-3 * 1e4);
}

// The swept volume is that of all vertices at their destinations, and overlaps explain the rest.
TEST(Balance, is_exact_without_remeshing) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  const double before = dsc.volume(1);
  const auto report = DSC::deform_interface(
      dsc,
      [&](Vertex_handle v) {
        const Position p = dsc.position(v);
        return p + .05 * Vector(std::sin(4 * p.y()), std::cos(3 * p.z()), p.z());
      },
      parameters::minimum_angle(0).minimum_facet_angle(0));
  ASSERT_EQ(report.relabeled, 0u);
  const auto& change = of_label(report, 1);
  EXPECT_EQ(change.volume_before, before);
  EXPECT_GT(std::abs(change.volume_swept), 1e-4);
  EXPECT_NEAR(change.volume_after, before + change.volume_swept, 1e-13);
  EXPECT_EQ(change.volume_of_overlaps, 0);
  EXPECT_NEAR(of_label(report, 0).volume_swept, -change.volume_swept, 1e-15);
  EXPECT_TRUE(report.complete);
}

TEST(Balance, tells_of_what_is_lost) {
  Report report;
  report.labels.push_back({1});
  auto& change = report.labels[0];
  change.volume_before = 5;
  change.volume_after = 4;
  change.volume_swept = -.75;
  change.volume_of_overlaps = .25;
  EXPECT_EQ(change.volume_unexplained(), -.5);
  EXPECT_FALSE(report.is_balanced());
  change.volume_swept = -1.25;
  EXPECT_TRUE(report.is_balanced());
}

TEST(Balance, of_successive_deformations_adds_up) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  const double before = dsc.volume(1);
  Report sum = DSC::advect_interface(dsc, DSC::Normal_offset{.05}, 0, 1);
  sum.append(DSC::advect_interface(dsc, DSC::Normal_offset{-.1}, 1, 1));
  EXPECT_EQ(sum.steps, 2u);
  const auto& change = of_label(sum, 1);
  EXPECT_EQ(change.volume_before, before);
  EXPECT_EQ(change.volume_after, dsc.volume(1));
  EXPECT_NEAR(change.volume_after - before,
              change.volume_swept + change.volume_of_overlaps + change.volume_unexplained(), 1e-14);
}

TEST(Long_steps, turn_a_cube_exactly) {
  for (double angle : {90., 120., 180., 270., 500.}) {
    Complex dsc = make_complex(grid(8, [](const Point& p) {
      return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < .5 ? 1 : 0;
    }));
    const double radians = angle * CGAL_PI / 180;
    const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {1, 2, 3}, radians);
    const auto vertices = dsc.interface_vertices();
    std::vector<Position> expected;
    for (Vertex_handle v : vertices)
      expected.push_back(rotation(dsc.position(v), 0, 1));
    const Report report = DSC::advect_interface(dsc, rotation, 0, 1);
    EXPECT_TRUE(report.complete) << angle;
    EXPECT_GT(report.steps, 1u);
    ASSERT_EQ(dsc.interface_vertices(), vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      EXPECT_LT((dsc.position(vertices[i]) - expected[i]).squared_length(), 1e-24) << angle;
    EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
  }
}

TEST(Long_steps, turn_a_ball_in_a_field) {
  Complex dsc = make_complex(grid(8, small_meshes::ball));
  const double volume = dsc.volume(1);
  const auto spin = [](const Position& p, double) { return 20 * Vector(-p.y(), p.x(), 0); };
  const Report report = DSC::advect_interface(dsc, spin, 0, .1); // by two radians
  EXPECT_GT(report.steps, 1u);
  EXPECT_TRUE(report.complete);
  EXPECT_NEAR(dsc.volume(1), volume, 1e-4 * volume);
}

// Without the division, the ball collapses on straight paths.
TEST(Long_steps, are_not_divided_if_told_so) {
  Complex dsc = make_complex(grid(8, small_meshes::ball));
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, 2);
  const Report report =
      DSC::advect_interface(dsc, rotation, 0, 1, parameters::largest_displacement(0.));
  EXPECT_EQ(report.steps, 1u);
  EXPECT_TRUE(dsc.is_valid());
}

// A cube has few planes at each vertex. They move as a whole.
TEST(Corners, of_a_cube_are_mitered) {
  for (double distance : {.1, -.1}) {
    Complex dsc = make_complex(grid(8, [](const Point& p) {
      return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) < .5 ? 1 : 0;
    }));
    ASSERT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{distance}, 0, 1).complete);
    EXPECT_NEAR(dsc.volume(1), std::pow(1 + 2 * distance, 3), 1e-12);
    for (Vertex_handle v : dsc.interface_vertices()) {
      const Position p = dsc.position(v);
      EXPECT_NEAR((std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}), .5 + distance,
                  1e-12);
    }
  }
}

} // namespace test_balance
