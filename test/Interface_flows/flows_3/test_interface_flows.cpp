#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/face_offsetting_3.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_interface_flows {

using namespace small_meshes;
using Snapshot = DSC::Interface_snapshot<Complex>;

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

double area(const Snapshot& snapshot, const std::vector<Position>& positions) {
  double sum = 0;
  for (const auto& [vertices, behind, in_front] : snapshot.facets())
    sum += length(CGAL::cross_product(positions[vertices[1]] - positions[vertices[0]],
                                      positions[vertices[2]] - positions[vertices[0]])) /
           2;
  return sum;
}

double mean_radius(const std::vector<Position>& positions) {
  double sum = 0;
  for (const Position& p : positions)
    sum += length(p - CGAL::ORIGIN);
  return sum / double(positions.size());
}

template <class Step>
std::vector<Position> destinations(const Complex& dsc, const Step& step, double dt) {
  const Snapshot snapshot(dsc);
  std::vector<Position> result;
  step(snapshot, snapshot.positions(dsc), 0, dt, result);
  return result;
}

double largest_distance(const std::vector<Position>& a, const std::vector<Position>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    result = (std::max)(result, length(a[i] - b[i]));
  return result;
}

double maximum_norm(const Position& p) {
  return (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
}

// The forces are the gradient of the area; compared with finite differences, also on triple lines.
TEST(Mean_curvature, velocities_are_the_gradient_of_the_area) {
  const Complex dsc = mesh_helpers::jittered_grid(4, small_meshes::two_boxes, .2, 1);
  const Snapshot snapshot(dsc);
  const std::vector<Position> positions = snapshot.positions(dsc);
  std::vector<Vector> velocities;
  DSC::Mean_curvature_velocity()(snapshot, positions, 0, velocities);
  const DSC::internal::Interface_forces<Complex> tensions(snapshot, positions, {});
  double total = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    total += tensions.share(i);
  EXPECT_NEAR(total, area(snapshot, positions), 1e-12);

  mesh_helpers::Random random(2);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    static constexpr double h = 1e-6;
    const Vector way = random.vector<Complex>(1);
    std::vector<Position> plus = positions, minus = positions;
    plus[i] = plus[i] + h * way;
    minus[i] = minus[i] - h * way;
    const Eigen::Vector3d velocity(velocities[i].x(), velocities[i].y(), velocities[i].z()),
        direction(way.x(), way.y(), way.z());
    EXPECT_NEAR((area(snapshot, plus) - area(snapshot, minus)) / (2 * h),
                -direction.dot(tensions.mass(i) * velocity), 1e-8);
  }
}

TEST(Mean_curvature, spheres_shrink_at_the_exact_rate) {
  static constexpr double r = .6, dt = .005;
  Complex dsc = mesh_helpers::sphere(8, r);
  for (int i = 1; i <= 6; ++i) {
    EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Mean_curvature_flow(), i * dt, dt).complete);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_NEAR(mean_radius(Snapshot(dsc).positions(dsc)) / std::sqrt(r * r - 4 * i * dt), 1, .01);
  }
  // Explicit steps of a stable size
  Complex by_velocity = mesh_helpers::sphere(8, r);
  for (int i = 1; i <= 20; ++i)
    EXPECT_TRUE(
        DSC::advect_interface(by_velocity, DSC::Mean_curvature_velocity(), 0, .001).complete);
  EXPECT_NEAR(mean_radius(Snapshot(by_velocity).positions(by_velocity)) / std::sqrt(r * r - .08), 1,
              .01);
}

// The difference between one step and two half steps is of third order.
TEST(Mean_curvature, steps_are_of_second_order) {
  const Complex dsc = mesh_helpers::sphere(4, .6);
  const DSC::Mean_curvature_flow flow;
  const Snapshot snapshot(dsc);
  const auto error = [&](double dt) {
    const auto whole = destinations(dsc, flow, dt), half = destinations(dsc, flow, dt / 2);
    std::vector<Position> twice;
    flow(snapshot, half, dt / 2, dt / 2, twice);
    return largest_distance(whole, twice);
  };
  EXPECT_NEAR(std::log2(error(.002) / error(.001)), 3, .4);
}

// Long steps are stable: everything shrinks, finally to a point.
TEST(Mean_curvature, steps_of_any_length_are_stable) {
  const Complex dsc = mesh_helpers::sphere(4, .6);
  for (const Position& p : destinations(dsc, DSC::Mean_curvature_flow(), 1.))
    EXPECT_LT(length(p - CGAL::ORIGIN), .15);
  for (const Position& p : destinations(dsc, DSC::Mean_curvature_flow(), 1e4))
    EXPECT_LT(length(p - CGAL::ORIGIN), 1e-3);
}

// Planar films between the sides of the domain do not move, for any time step.
TEST(Mean_curvature, flat_films_stay) {
  const Complex dsc = make_complex(grid(8, small_meshes::four_phases));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  for (double dt : {.05, 10.})
    EXPECT_LT(largest_distance(before, destinations(dsc, DSC::Mean_curvature_flow(), dt)), 1e-10);
}

TEST(Mean_curvature, keeps_the_volumes_of_all_labels) {
  Complex dsc = make_complex(grid(8, small_meshes::two_boxes));
  std::map<int, double> volumes;
  for (int label : dsc.labels())
    volumes[label] = dsc.volume(label);
  double last_area = dsc.area(0) + dsc.area(1) + dsc.area(2);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Mean_curvature_flow(true), 0, .002,
                                      parameters::minimum_angle(0))
                    .complete);
    const double area = dsc.area(0) + dsc.area(1) + dsc.area(2);
    EXPECT_LT(area, last_area);
    last_area = area;
    for (const auto& [label, volume] : volumes)
      EXPECT_NEAR(dsc.volume(label), volume, 1e-12);
  }
}

// Equilibria do not depend on the time step: long steps preserve the equilibrium that short steps
// reached.
TEST(Mean_curvature, bubbles_at_rest_stay) {
  const auto bubbles = [](const small_meshes::Point& p) {
    return small_meshes::ball(p) == 0 ? 0 : p.x() < 0 ? 1 : 2;
  };
  const Complex dsc = make_complex(grid(6, bubbles));
  const Snapshot snapshot(dsc);
  const DSC::Mean_curvature_flow flow(true);
  std::vector<Position> positions = snapshot.positions(dsc), next;
  const auto step = [&](double dt) {
    next.clear();
    flow(snapshot, positions, 0, dt, next);
    const double distance = largest_distance(positions, next);
    positions = next;
    return distance;
  };
  const double first = step(.01);
  double last = first;
  for (int i = 0; i < 200; ++i)
    last = step(.01);
  EXPECT_LT(last, .01 * first); // vertices slide, still
  EXPECT_LT(step(.05), .05 * first);
}

TEST(Mean_curvature, refuses_to_go_back_in_time) {
  Complex dsc = mesh_helpers::sphere(4, .6);
  const auto before = dsc.state();
  EXPECT_THROW(DSC::advect_interface(dsc, DSC::Mean_curvature_flow(), 0, -1e-3),
               CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Volume_changer, reaches_amounts_exactly) {
  const Complex dsc = mesh_helpers::sphere(4, .6);
  const Snapshot snapshot(dsc);
  const std::vector<Position> before = snapshot.positions(dsc);
  const CGAL::Deformable_simplicial_complexes::Volume_changer<Complex> changer(snapshot);
  for (double amount : {-.1, 1e-9, .2}) {
    std::vector<Position> after = before;
    changer.change_by({{1, amount}}, after);
    EXPECT_NEAR(changer.changes(before, after)[1], amount, 1e-14);
    EXPECT_NEAR(changer.changes(before, after)[0], -amount, 1e-14);
  }
}

// Vertices of planar parts between two labels move by equal distances, also on irregular meshes.
TEST(Volume_changer, keeps_flat_parts_flat) {
  const auto half = [](const small_meshes::Point& p) { return p.z() > 0 ? 1 : 0; };
  Complex dsc = make_complex(grid(4, half));
  mesh_helpers::Random random(4);
  for (Complex::Vertex_handle v : dsc.interface_vertices()) {
    const Position p = dsc.position(v);
    const double x = p.x() + random(-.2, .2), y = p.y() + random(-.2, .2);
    dsc.move_vertex(v, {x, y, 0});
  }
  const Snapshot snapshot(dsc);
  std::vector<Position> positions = snapshot.positions(dsc);
  CGAL::Deformable_simplicial_complexes::Volume_changer<Complex>(snapshot).change_by({{1, -.4}},
                                                                                     positions);
  for (const Position& p : positions)
    EXPECT_NEAR(p.z(), .1, 1e-12); // the area is 4
}

// A convex edge that moves outwards becomes round: its vertices move by exactly the offset.
TEST(Face_offset, rounds_what_is_convex) {
  static constexpr double d = .1;
  const Complex dsc = make_complex(grid(8, small_meshes::cube));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(1), d);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(length(after[i] - before[i]), d, 1e-12);
    Vector expected(0, 0, 0); // towards the means of the sides that contain the vertex
    for (int k = 0; k < 3; ++k)
      if (std::abs(before[i][k]) == .5)
        expected = expected + Vector(k == 0, k == 1, k == 2) * (before[i][k] > 0 ? 1 : -1);
    EXPECT_GT(expected * (after[i] - before[i]), length(expected) * d * (1 - 1e-12));
  }
}

// The triangulation of the sides has no effect; the split edges end at an edge of the cube on one
// side only.
TEST(Face_offset, does_not_depend_on_the_triangles_of_a_side) {
  static constexpr double d = .01;
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto fine_on_one_side = [](const Position& p) { return p.z() > .49 ? .05 : 1.; };
  DSC::improve_interface(dsc, parameters::sizing_field(fine_on_one_side)
                                  .aggressiveness(0.)
                                  .interface_split_length(1.)
                                  .interface_collapse_length(0.)
                                  .minimum_facet_angle(0.)
                                  .flip_angle(0.));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(1), d);
  EXPECT_GT(before.size(), 500u);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].z() == .5) {
      EXPECT_NEAR(length(after[i] - before[i]), d, 1e-12);
      const int sides = 1 + (std::abs(before[i].x()) == .5) + (std::abs(before[i].y()) == .5);
      EXPECT_NEAR(after[i].z() - .5, d / std::sqrt(double(sides)), 1e-12);
    }
}

TEST(Face_offset, keeps_what_is_concave_sharp) {
  static constexpr double d = .1;
  const Complex dsc = make_complex(grid(8, small_meshes::cube));
  for (const Position& p : destinations(dsc, DSC::Face_offset_3(-1), d))
    EXPECT_NEAR(maximum_norm(p), .5 - d, 1e-12);
}

// The rim of a thin wedge, where the facet normals almost cancel, moves outwards.
TEST(Face_offset, goes_outwards_at_a_thin_rim) {
  const auto wedge = [](const small_meshes::Point& p) {
    return small_meshes::cube(p) == 1 && p.z() > 0 && p.x() > p.z() ? 1 : 0;
  };
  Complex dsc = make_complex(grid(4, wedge)); // its rim is on the y axis
  DSC::deform_interface(dsc, [&](Complex::Vertex_handle v) {
    const Position p = dsc.position(v);
    return Position(p.x(), p.y(), .1 * p.z());
  });
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(1), .05);
  bool is_rim_there = false;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i] == Position(0, 0, 0)) {
      is_rim_there = true;
      EXPECT_LT(after[i].x(), -.04);
      EXPECT_LT(std::abs(after[i].z()), .03);
    }
  EXPECT_TRUE(is_rim_there);
}

// The interface ends on sides of the domain, which constrain it.
TEST(Face_offset, stays_on_the_sides_of_the_domain) {
  const auto slope = [](const small_meshes::Point& p) { return p.x() > p.y() ? 1 : 0; };
  const Complex dsc = make_complex(grid(4, slope));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(1), .1);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (std::abs(before[i].z()) == 1 && std::abs(before[i].x()) < 1) {
      EXPECT_NEAR(after[i].z(), before[i].z(), 1e-12);
      EXPECT_NEAR(std::abs(after[i].x() - after[i].y()), .1 * std::sqrt(2.), 1e-12);
    }
}

TEST(Face_offset, refuses_thresholds_out_of_range) {
  for (double bad : {-.1, 1., std::nan("")})
    EXPECT_THROW(DSC::Face_offset_3(1, bad), CGAL::Deformable_simplicial_complexes::Error);
}

TEST(Face_offset, keeps_walls_between_labels_in_their_planes) {
  const Complex dsc = make_complex(grid(8, small_meshes::two_boxes));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(1), .05);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].x() == 0) {
      EXPECT_NEAR(after[i].x(), 0, 1e-12);
      EXPECT_NEAR(maximum_norm(after[i]),
                  maximum_norm(before[i]) == .5 ? .55 : maximum_norm(before[i]), 1e-12);
    }
  }
}

// If the angles between facets are below the threshold, vertices move by exactly the offset.
TEST(Face_offset, spheres_grow_and_shrink_by_the_offset) {
  for (double speed : {-1., 1.}) {
    Complex dsc = mesh_helpers::sphere(8, .6);
    const std::vector<Position> before = Snapshot(dsc).positions(dsc);
    const std::vector<Position> after = destinations(dsc, DSC::Face_offset_3(speed, .2), .05);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(length(after[i] - before[i]), .05, 1e-12);
    EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Face_offset_3(speed, .2), 0, .05).complete);
    EXPECT_NEAR(mean_radius(Snapshot(dsc).positions(dsc)), .6 + speed * .05, 1e-3);
  }
}

// The shape follows the field, and vertices do not slide within the sides.
TEST(Advective_face_offset, moves_across_the_interface_only) {
  const Vector velocity(.3, .2, .1);
  const auto field = [&](const Position&, double) { return velocity; };
  const Complex dsc = make_complex(grid(8, small_meshes::cube));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const auto after = destinations(dsc, DSC::Advective_face_offset_3<decltype(field)>(field), .5);
  for (std::size_t i = 0; i < before.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(after[i][k], before[i][k] + (std::abs(before[i][k]) == .5 ? .5 * velocity[k] : 0),
                  1e-12);
}

// A plane that meets a side of the domain obliquely moves there as far as elsewhere.
TEST(Advective_face_offset, slides_along_the_sides_of_the_domain) {
  const auto slope = [](const small_meshes::Point& p) { return p.x() > p.z() - 1 ? 1 : 0; };
  const auto field = [](const Position&, double) { return Vector(1, 0, 0); };
  const Complex dsc = make_complex(grid(4, slope));
  const std::vector<Position> before = Snapshot(dsc).positions(dsc);
  const auto after = destinations(dsc, DSC::Advective_face_offset_3<decltype(field)>(field), .1);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].x() > -1) {
      EXPECT_NEAR(after[i].x() - after[i].z(), -.9, 1e-12);
      EXPECT_NEAR(after[i].y(), before[i].y(), 1e-12);
      if (before[i].z() == 1) {
        EXPECT_NEAR(after[i].z(), 1, 1e-12);
      }
    }
}

// The front of a cube consists of planes, quarters of cylinders, and eighths of spheres.
TEST(Offset_with_round_edges, of_a_cube) {
  const double pi = std::acos(-1.);
  for (const double d : {.1, .3}) {
    Complex dsc = make_complex(grid(8, small_meshes::cube));
    ASSERT_NEAR(dsc.volume(1), 1, 1e-12);
    const auto report =
        DSC::advect_interface(dsc, DSC::Normal_offset{d, DSC::Corner_rule::round}, 0, 1);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GT(report.split, 100u);
    EXPECT_NEAR(dsc.volume(1) / (1 + 6 * d + 3 * pi * d * d + 4 * pi / 3 * d * d * d), 1, 1.5e-3);
  }
  // Edges stay sharp where the front moves towards them.
  Complex inner = make_complex(grid(8, small_meshes::cube));
  DSC::advect_interface(inner, DSC::Normal_offset{-.1, DSC::Corner_rule::round}, 0, 1);
  EXPECT_NEAR(inner.volume(1), std::pow(.8, 3), 1e-3);
}

} // namespace test_interface_flows
