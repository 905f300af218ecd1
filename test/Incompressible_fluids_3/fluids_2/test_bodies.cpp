// Rigid bodies that liquids move, solids that move as a function of time, and sources with a flux.
#include "fluids_2.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

namespace test_bodies {

using planar_regions::circle;
using planar_regions::divided;
using planar_regions::Polygon;
using planar_regions::region;
using namespace fluids_2;
using Point = CGAL::Epick::Point_3;
using Vector = CGAL::Epick::Vector_3;

DSC::Wall_behavior attached(bool sticks) {
  DSC::Wall_behavior result;
  result.sticks = sticks;
  result.separates = false;
  return result;
}

// A tank 2 wide with a box of width 1 that floats in the middle. Its draught is `draught`.
class Floating_box
{
public:
  static constexpr double edge = .1, height = .6;

  Floating_box(double density, double draught)
      : complex(region(divided({{0, 0},
                                {2, 0},
                                {2, 1},
                                {1.5, 1},
                                {1.5, 1 - draught},
                                {.5, 1 - draught},
                                {.5, 1},
                                {0, 1}},
                               edge),
                       {}, {-.5, -.5, 2.5, 2})),
        fluid(complex, liquid(0, 1)) {
    const double bottom = 1 - draught, top = bottom + height;
    fluid.add_solid(DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 2, 2), true));
    fluid.add_body(DSC::Box_solid_3(CGAL::Bbox_2(.5, bottom, 1.5, top)),
                   DSC::rigid_box(Point(.5, bottom, -.5), Point(1.5, top, .5), density));
  }

  Complex complex;
  Fluid fluid;
};

TEST(Rigid_body, inertia) {
  const DSC::Rigid_body_3 box = DSC::rigid_box(Point(1, 2, 3), Point(2, 4, 6), 2);
  EXPECT_DOUBLE_EQ(box.mass, 12);
  EXPECT_DOUBLE_EQ(box.inertia[0], 12 * (4 + 9) / 12.);
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_hexahedron(Point(1, 2, 3), Point(2, 2, 3), Point(2, 4, 3), Point(1, 4, 3),
                        Point(1, 4, 6), Point(1, 2, 6), Point(2, 2, 6), Point(2, 4, 6), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const DSC::Rigid_body_3 same = DSC::rigid_body_of_mesh(mesh, 2);
  EXPECT_NEAR(same.mass, box.mass, 1e-13);
  EXPECT_NEAR(CGAL::squared_distance(same.center, box.center), 0, 1e-26);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(same.inertia[i], box.inertia[i], 1e-13);
  EXPECT_DOUBLE_EQ(DSC::rigid_disk(Point(0, 0, 0), 2, 3).inertia[8], 12 * CGAL_PI * 4 / 2);
  EXPECT_THROW(DSC::rigid_ball(Point(0, 0, 0), 0, 1), DSC::Error);
  EXPECT_THROW(DSC::rigid_body_of_mesh(CGAL::Surface_mesh<Point>(), 1), DSC::Error);
  CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces().begin()), mesh); // leaves a hole
  EXPECT_THROW(DSC::rigid_body_of_mesh(mesh, 1), DSC::Error);
}

TEST(Rigid_body, errors) {
  Floating_box scene(.5, .3);
  const DSC::Ball_solid_3 ball(Point(0, 0, 0), 1, DSC::Solid_side::inside);
  const DSC::Rigid_body_3 good = DSC::rigid_ball(Point(0, 0, 0), 1, 1);
  for (int k = 0; k < 5; ++k) {
    DSC::Rigid_body_3 body = good;
    k == 0   ? void(body.mass = 0)
    : k == 1 ? void(body.inertia[1] = 1)
    : k == 2 ? void(body.inertia[0] = -1)
    : k == 3 ? void(body.velocity = Vector(NAN, 0, 0))
             : void(body.rotation = {0, 1, 0, 0});
    EXPECT_THROW(scene.fluid.add_body(ball, body), DSC::Error) << k;
  }
  EXPECT_EQ(scene.fluid.number_of_bodies(), 1u);
  EXPECT_THROW(scene.fluid.body(1), DSC::Error);
}

// Archimedes: the box rests if it displaces its own mass.
TEST(Rigid_body, floating_box_rests) {
  Floating_box scene(.5, .3);
  for (int k = 0; k < 10; ++k) {
    const auto report = scene.fluid.advance(.05);
    EXPECT_NEAR(report.forces_on_solids[1].y(), .3, 1e-9);
    // The torque about the origin of a force through (1, y).
    EXPECT_NEAR(report.torques_on_solids[1].z(), .3, 1e-9);
  }
  EXPECT_NEAR(scene.fluid.body(0).center.y(), 1, 1e-9);
  EXPECT_NEAR(scene.fluid.body(0).angular_velocity.z(), 0, 1e-9);
}

// The period of linear waves is 4.684, from finite elements for the potential on square cells of
// 1/20 and 1/40, extrapolated.
TEST(Rigid_body, floating_box_swings) {
  static constexpr double period = 4.684;
  Floating_box scene(.5, .28);
  const double begin = scene.fluid.body(0).center.y();
  double lowest = begin, time_of_lowest = 0;
  while (scene.fluid.time() < .75 * period) {
    scene.fluid.advance(period / 60);
    if (const double y = scene.fluid.body(0).center.y(); y < lowest) {
      lowest = y;
      time_of_lowest = scene.fluid.time();
    }
  }
  EXPECT_NEAR(time_of_lowest, period / 2, .05 * period);
  EXPECT_NEAR(begin - lowest, .02, .003); // twice the distance from the equilibrium
}

// The added mass of a disk of radius r in a circle of radius R is that of the displaced liquid
// times (R^2 + r^2) / (R^2 - r^2) (H. Lamb, "Hydrodynamics"). A disk without mass moves, too.
TEST(Rigid_body, disk_in_a_circle_accelerates) {
  static constexpr double r = .3, dt = .01;
  const double added = (1 + r * r) / (1 - r * r);
  for (const double density : {1e-6, .5, 3.}) {
    SCOPED_TRACE(density);
    Complex complex = region(circle(1, .1), circle(r, .1), {-1.5, -1.5, 1.5, 1.5});
    Fluid fluid(complex, liquid(0, 1));
    fluid.add_solid(DSC::Ball_solid_3(Point(0, 0, 0), 1, DSC::Solid_side::outside),
                    attached(false));
    fluid.add_body(DSC::Ball_solid_3(Point(0, 0, 0), r, DSC::Solid_side::inside),
                   DSC::rigid_disk(Point(0, 0, 0), r, density), attached(false));
    for (int k = 0; k < 5; ++k)
      fluid.advance(dt);
    const double exact = (1 - density) / (density + added) * fluid.time();
    EXPECT_NEAR(fluid.body(0).velocity.y(), exact, .05 * std::abs(exact));
    EXPECT_NEAR(fluid.body(0).center.y(), exact * fluid.time() / 2, .05 * std::abs(exact));
    EXPECT_NEAR(fluid.body(0).velocity.x(), 0, .01 * std::abs(exact)); // the mesh has no symmetry
  }
}

// A drop that carries a body has a constant momentum and angular momentum.
TEST(Rigid_body, momenta_are_preserved) {
  for (const bool sticks : {false, true}) {
    SCOPED_TRACE(sticks);
    Complex complex = region(circle(1, .15), circle(.4, .15), {-2, -2, 2, 2});
    Fluid fluid(complex, liquid(sticks ? .1 : 0, 0));
    DSC::Rigid_body_3 body = DSC::rigid_disk(Point(0, 0, 0), .4, 2);
    body.velocity = Vector(.2, .1, 0);
    body.angular_velocity = Vector(0, 0, 1);
    fluid.add_body(DSC::Ball_solid_3(Point(0, 0, 0), .4, DSC::Solid_side::inside), body,
                   attached(sticks));
    const auto momenta = [&] {
      const auto balance = fluid.balance();
      const DSC::Rigid_body_3& now = fluid.body(0);
      const Vector linear = now.mass * now.velocity;
      return std::array<double, 3>{balance.momentum.x() + linear.x(),
                                   balance.momentum.y() + linear.y(),
                                   balance.angular_momentum.z() +
                                       CGAL::cross_product(now.center - CGAL::ORIGIN, linear).z() +
                                       now.inertia[8] * now.angular_velocity.z()};
    };
    fluid.advance(.01); // begins with an impact
    const std::array<double, 3> before = momenta(),
                                given = {body.mass * .2, body.mass * .1, body.inertia[8]};
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(before[i], given[i], 1e-4) << i;
    for (int k = 0; k < 10; ++k)
      fluid.advance(.02);
    const std::array<double, 3> after = momenta();
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(after[i], before[i], i < 2 ? 1e-9 : 1e-5)
          << i; // the torque has the error of the step
    EXPECT_NE(fluid.body(0).rotation[3], 0);
    EXPECT_NEAR(fluid.body(0).rotation[1], 0, 1e-15);
  }
}

// The outline of two disks around (-x, 0) and (x, 0), with edges of about a given length.
Polygon outline_of_disks(double x, double radius, double edge) {
  const double angle = std::acos(-x / radius); // of the upper vertex on both disks
  const auto parts = std::lround(2 * angle * radius / edge);
  Polygon result;
  for (const double side : {1., -1.})
    for (long k = 0; k < parts; ++k) {
      const double a = angle * (2 * double(k) / double(parts) - 1);
      result.emplace_back(side * (x + radius * std::cos(a)), side * radius * std::sin(a));
    }
  return result;
}

// At two vertices, the surface of a drop touches two overlapping disks that move past each other.
// The liquid there moves with both disks, so the vertices follow the points where the circles
// intersect.
TEST(Rigid_body, vertices_touch_two_bodies) {
  static constexpr double x = .2, r = .3;
  Complex complex = region(circle(1, .15), outline_of_disks(x, r, .1), {-2, -2, 2, 2});
  Fluid fluid(complex, liquid(0, 0));
  for (const double side : {-1., 1.}) {
    DSC::Rigid_body_3 body = DSC::rigid_disk(Point(side * x, 0, 0), r, 2);
    body.velocity = Vector(0, side == 1 ? .3 : -.1, 0);
    fluid.add_body(DSC::Ball_solid_3(body.center, r, DSC::Solid_side::inside), body,
                   attached(false));
  }
  const auto energy = [&] {
    double result = fluid.balance().energy();
    for (std::size_t k : {0, 1})
      result += fluid.body(k).mass / 2 * fluid.body(k).velocity.squared_length();
    return result;
  };
  const auto momentum = [&] {
    Vector result = fluid.balance().momentum;
    for (std::size_t k : {0, 1})
      result = result + fluid.body(k).mass * fluid.body(k).velocity;
    return result;
  };
  const double begin = energy();
  const Vector given = momentum();
  double after_impact = begin;
  for (int k = 0; k < 20; ++k) {
    const auto report = fluid.advance(.02);
    EXPECT_LT(report.depth_in_solids, 1e-9);
    if (k == 0)
      after_impact = energy();
    EXPECT_LT(after_impact, begin);
    EXPECT_LT(energy(), after_impact * (1 + 2e-3)) << k;
    EXPECT_NEAR((momentum() - given).x(), 0, 2e-4) << k;
    EXPECT_NEAR((momentum() - given).y(), 0, 2e-4) << k;
    const Point a = fluid.body(0).center, b = fluid.body(1).center;
    const Vector across = (b - a) / 2, along(-across.y(), across.x(), 0);
    const double length = std::sqrt(across.squared_length());
    for (const double sign : {-1., 1.}) {
      const Point p =
          CGAL::midpoint(a, b) + sign * std::sqrt(r * r / (length * length) - 1) * along;
      bool is_found = false;
      for (auto v : complex.interface_vertices()) {
        const auto q = complex.position(v);
        if (std::hypot(q.x() - p.x(), q.y() - p.y()) > 1e-6)
          continue;
        is_found = true;
        const auto velocity = fluid.velocity(v);
        for (const Point& center : {a, b}) {
          const Vector normal = (p - center) / r,
                       of_body = fluid.body(center == a ? 0 : 1).velocity;
          EXPECT_NEAR(normal.x() * velocity.x() + normal.y() * velocity.y(), normal * of_body,
                      5e-5);
        }
      }
      EXPECT_TRUE(is_found) << k;
    }
  }
}

// Without liquid, bodies fall freely.
TEST(Rigid_body, falls_without_liquid) {
  Complex complex = region(circle(1, .25), {}, {-2, -2, 2, 2});
  Fluid fluid(complex, liquid(0, 1));
  DSC::Rigid_body_3 body = DSC::rigid_disk(Point(0, -1.5, 0), .3, 2);
  body.velocity = Vector(.5, 0, 0);
  body.angular_velocity = Vector(0, 0, 1);
  fluid.add_body(DSC::Ball_solid_3(body.center, .3, DSC::Solid_side::inside), body);
  for (auto c : complex.cells())
    if (c->subdomain_index() == 1)
      complex.relabel(c, 0);
  for (int k = 0; k < 4; ++k)
    fluid.advance(.25);
  EXPECT_NEAR(fluid.body(0).center.x(), .5, 1e-12);
  EXPECT_NEAR(fluid.body(0).center.y(), -2, 1e-12);
  EXPECT_NEAR(fluid.body(0).velocity.y(), -1, 1e-12);
  EXPECT_DOUBLE_EQ(fluid.body(0).angular_velocity.z(), 1);
  EXPECT_NEAR(2 * std::atan2(fluid.body(0).rotation[3], fluid.body(0).rotation[0]), 1, .01);
}

// A top without symmetry keeps its angular momentum and, almost, its energy.
TEST(Rigid_body, rotates_freely) {
  DSC::Rigid_body_3 body = DSC::rigid_box(Point(-1, -2, -3), Point(1, 2, 3), 1);
  body.angular_velocity = Vector(.1, 1, .2);
  const DSC::internal::Body_inertia inertia(body, 3);
  const auto momentum = [&] {
    return Eigen::Vector3d(inertia.inertia(DSC::internal::place_of(body).rotation) *
                           DSC::internal::velocity_of(body).angular);
  };
  const auto energy = [&] {
    return inertia.energy(DSC::internal::place_of(body).rotation, DSC::internal::velocity_of(body));
  };
  const Eigen::Vector3d given = momentum();
  const double begin = energy();
  for (int k = 0; k < 200; ++k)
    DSC::internal::move_freely(body, Eigen::Vector3d::Zero(), .05, 3);
  EXPECT_LT((momentum() - given).norm(), 1e-10 * given.norm());
  EXPECT_NEAR(energy(), begin, 1e-3 * begin);
  body.rotates = {false, true, false};
  const Vector before = body.angular_velocity = Vector(0, 1, 0);
  DSC::internal::move_freely(body, Eigen::Vector3d(1, 1, 1), .05, 2);
  EXPECT_EQ(body.velocity.z(), 0);
  EXPECT_EQ(body.angular_velocity, Vector(0, 0, 0)) << before;
}

TEST(Rigid_body, state_is_restored_bitwise) {
  Floating_box scene(.5, .28);
  scene.fluid.advance(.1);
  const auto complex = scene.complex.state();
  const auto state = scene.fluid.state();
  scene.fluid.advance(.1);
  const DSC::Rigid_body_3 expected = scene.fluid.body(0);
  Floating_box other(.5, .28);
  other.complex.clear();
  other.complex.restore(complex);
  other.fluid.restore(state);
  other.fluid.advance(.1);
  EXPECT_EQ(other.fluid.body(0).center, expected.center);
  EXPECT_EQ(other.fluid.body(0).velocity, expected.velocity);
  EXPECT_EQ(other.fluid.body(0).rotation, expected.rotation);
  auto wrong = state;
  wrong.bodies.clear();
  EXPECT_THROW(other.fluid.restore(wrong), DSC::Error);
}

// Couette flow between two circles. The torque on the outer one is 4 pi mu w a^2 b^2 / (b^2 - a^2).
// The error is of second order.
TEST(Moving_solid, wheel_has_the_torque_of_couette_flow) {
  static constexpr double a = .4, b = 1, viscosity = 1, rate = .5;
  for (const double edge : {.1, .05}) {
    SCOPED_TRACE(edge);
    Complex complex = region(circle(b, edge), circle(a, edge), {-1.5, -1.5, 1.5, 1.5});
    Fluid fluid(complex, liquid(viscosity, 0));
    const DSC::Ball_solid_3 wheel(Point(0, 0, 0), a, DSC::Solid_side::inside);
    const auto motion = [](double t) {
      DSC::Solid_motion_3 result;
      result.rotation = Vector(0, 0, rate * t);
      result.angular_velocity = Vector(0, 0, rate);
      return result;
    };
    fluid.add_solid(DSC::Moving_solid_3<DSC::Ball_solid_3>(wheel, Point(0, 0, 0), motion),
                    attached(true));
    fluid.add_solid(DSC::Ball_solid_3(Point(0, 0, 0), b, DSC::Solid_side::outside), attached(true));
    double torque = 0, driving = 0;
    for (int k = 0; k < 8; ++k) {
      const auto report = fluid.advance(.1, parameters::implicitness(1));
      driving = report.torques_on_solids[0].z();
      torque = report.torques_on_solids[1].z();
    }
    const double exact = 4 * CGAL_PI * viscosity * rate * a * a * b * b / (b * b - a * a);
    EXPECT_NEAR(torque, exact, 8 * edge * edge * exact);
    EXPECT_NEAR(driving, -exact, 8 * edge * edge * exact);
  }
}

// A liquid with the viscosity k g^(n - 1) at the shear rate g between two circles. The shear stress
// is T / (2 pi r^2), so the torque is 2 pi k (2 w / (n (a^(-2/n) - b^(-2/n))))^n.
TEST(Moving_solid, wheel_in_a_power_law_liquid) {
  static constexpr double a = .5, b = 1, rate = 1, k = 1, n = .6;
  Complex complex = region(circle(b, .07), circle(a, .07), {-1.5, -1.5, 1.5, 1.5});
  DSC::Liquid power_law{1, 0};
  power_law.viscosity_at_shear_rate = [](double g) {
    return k * std::pow((std::max)(g, .01), n - 1);
  };
  DSC::Fluid_properties properties;
  properties.set_liquid(1, power_law);
  Fluid fluid(complex, properties);
  const DSC::Ball_solid_3 wheel(Point(0, 0, 0), a, DSC::Solid_side::inside);
  fluid.add_solid(DSC::Moving_solid_3<DSC::Ball_solid_3>(wheel, Vector(0, 0, 0), Point(0, 0, 0),
                                                         Vector(0, 0, rate)),
                  attached(true));
  fluid.add_solid(DSC::Ball_solid_3(Point(0, 0, 0), b, DSC::Solid_side::outside), attached(true));
  double torque = 0;
  for (int step = 0; step < 10; ++step)
    torque = fluid.advance(.05, parameters::implicitness(1)).torques_on_solids[1].z();
  const double exact =
      2 * CGAL_PI * k * std::pow(2 * rate / (n * (std::pow(a, -2 / n) - std::pow(b, -2 / n))), n);
  EXPECT_NEAR(torque, exact, .05 * exact);
  power_law.viscosity_at_shear_rate = [](double g) { return g > 0 ? -1. : 1.; };
  properties.set_liquid(1, power_law);
  Complex other = region(circle(1, .25), {}, {-2, -2, 2, 2});
  Fluid wrong(other, properties);
  wrong.set_velocities(
      [&other](Complex::Vertex_handle v) { return Fluid::Vector(other.position(v).y(), 0); });
  EXPECT_THROW(wrong.advance(.1), DSC::Error);
}

TEST(Moving_solid, oscillates_as_the_function_says) {
  const DSC::Plane_solid_3 plane(Point(0, 0, 0), Vector(0, 1, 0));
  const DSC::Moving_solid_3<DSC::Plane_solid_3> moving(plane, Point(0, 0, 0), [](double t) {
    DSC::Solid_motion_3 motion;
    motion.displacement = Vector(0, std::sin(t), 0);
    motion.velocity = Vector(0, std::cos(t), 0);
    return motion;
  });
  std::vector<DSC::Wall_3> walls;
  moving.walls(Point(5, 2, 0), .5, walls);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_DOUBLE_EQ(walls[0].distance, 2 - std::sin(.5));
  EXPECT_DOUBLE_EQ(walls[0].velocity.y(), std::cos(.5));
  const DSC::Moving_solid_3<DSC::Plane_solid_3> broken(plane, Point(0, 0, 0), [](double) {
    DSC::Solid_motion_3 motion;
    motion.displacement = Vector(NAN, 0, 0);
    return motion;
  });
  EXPECT_THROW(broken.walls(Point(0, 0, 0), 0, walls), DSC::Error);
}

TEST(Moving_solid, motion_is_the_derivative_of_places) {
  static constexpr double step = 1e-4;
  double earliest = 1;
  const auto motion = DSC::motion_of_places(
      [&earliest](double t) {
        earliest = (std::min)(earliest, t);
        return DSC::Solid_place_3{{std::sin(t), 1 + t * t, 0}, {0, t + t * t, 0}};
      },
      step);
  for (const double t : {0., step / 2, step, 1.}) {
    const DSC::Solid_motion_3 at = motion(t);
    EXPECT_EQ(at.displacement, Vector(std::sin(t), 1 + t * t, 0));
    EXPECT_EQ(at.rotation, Vector(0, t + t * t, 0));
    EXPECT_NEAR(at.velocity.x(), std::cos(t), step * step);
    EXPECT_NEAR(at.velocity.y(), 2 * t, 1e-11);
    EXPECT_NEAR(at.angular_velocity.y(), 1 + 2 * t, 1e-11);
    EXPECT_NEAR(at.angular_velocity.x(), 0, 1e-11);
  }
  EXPECT_EQ(earliest, 0);
  EXPECT_THROW(motion(1e14), DSC::Error);
  EXPECT_THROW(DSC::motion_of_places({}, 0), DSC::Error);
}

TEST(Moving_solid, motion_is_evaluated_once_for_a_time) {
  int calls = 0;
  const DSC::Moving_solid_3<DSC::Plane_solid_3> solid(
      DSC::Plane_solid_3(Point(0, 0, 0), Vector(0, 1, 0)), Point(0, 0, 0), [&calls](double) {
        ++calls;
        return DSC::Solid_motion_3();
      });
  const auto copy = solid;
  std::vector<DSC::Wall_3> walls;
  for (int k = 0; k < 3; ++k)
    (k == 1 ? copy : solid).walls(Point(0, k, 0), 1, walls);
  EXPECT_EQ(calls, 1);
  solid.walls(Point(0, 0, 0), 2, walls);
  EXPECT_EQ(calls, 2);
}

// A full tank that moves from the first instant takes its liquid along.
TEST(Moving_solid, starts_impulsively) {
  static constexpr double velocity = .5;
  for (const bool sticks : {false, true}) {
    SCOPED_TRACE(sticks);
    Complex complex =
        region(divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .125), {}, {-.5, -.5, 2, 1.5});
    Fluid fluid(complex, liquid(0, 0));
    fluid.add_solid(DSC::Moving_solid_3<DSC::Tank_solid_3>(
                        DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 1, 1)), Vector(velocity, 0, 0)),
                    attached(sticks));
    for (int k = 0; k < 4; ++k) {
      const auto report = fluid.advance(.05);
      EXPECT_NEAR(report.after.momentum.x(), velocity, 1e-9);
      EXPECT_NEAR(report.after.momentum.y(), 0, 1e-9);
      EXPECT_LT(report.after.kinetic_energy, velocity * velocity / 2 * (1 + 1e-9));
      EXPECT_TRUE(report.repetitions.empty());
    }
  }
}

// The liquid starts with the velocity of the tank, also if the tank accelerates. The velocity is
// exact because the acceleration is constant.
TEST(Moving_solid, accelerates_from_the_first_instant) {
  for (const double velocity : {0., .5}) {
    SCOPED_TRACE(velocity);
    static constexpr double acceleration = 1;
    Complex complex =
        region(divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .125), {}, {-.5, -.5, 2, 1.5});
    Fluid fluid(complex, liquid(0, 0));
    const auto motion = DSC::motion_of_places(
        [velocity](double t) {
          DSC::Solid_place_3 result;
          result.displacement = Vector(velocity * t + acceleration * t * t / 2, 0, 0);
          return result;
        },
        1e-5);
    fluid.add_solid(DSC::Moving_solid_3<DSC::Tank_solid_3>(
                        DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 1, 1)), Point(0, 0, 0), motion),
                    attached(false));
    for (int k = 0; k < 4; ++k) {
      const auto report = fluid.advance(.05);
      EXPECT_NEAR(report.after.momentum.x(), velocity + acceleration * fluid.time(), 1e-6);
    }
  }
}

// A tank jumps by four edges at the time .075. Its velocity, the derivative, is 0.
TEST(Moving_solid, must_not_jump) {
  static constexpr double jump = .5, edge = .125;
  Complex complex = region(divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, edge), {}, {-.5, -.5, 2, 1.5});
  Fluid fluid(complex, liquid(0, 0));
  const auto motion = DSC::motion_of_places(
      [](double t) {
        return DSC::Solid_place_3{{t < .075 ? 0 : jump, 0, 0}, {0, 0, 0}};
      },
      1e-5);
  fluid.add_solid(DSC::Moving_solid_3<DSC::Tank_solid_3>(
                      DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 1, 1)), Point(0, 0, 0), motion),
                  attached(false));
  fluid.advance(.05);
  const auto error = thrown_by<DSC::Fluid_step_error>([&] { fluid.advance(.05); });
  EXPECT_EQ(error.last_attempt().cause, DSC::Fluid_failure::walls);
  EXPECT_GE(error.last_attempt().amount, jump / edge / 2);
  EXPECT_PRED2(contains, std::string(error.what()), "without jumps");
  EXPECT_EQ(fluid.time(), .05);
}

// Solids act on free surfaces only, so a solid inside a liquid has no effect.
TEST(Box_solid, in_a_liquid_needs_a_hole) {
  for (const double size : {.4, .02}) { // a solid smaller than a cell
    Complex complex =
        region(divided({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .125), {}, {-.5, -.5, 1.5, 1.5});
    Fluid fluid(complex, liquid(0, 0));
    fluid.advance(.01); // adapts the mesh
    Complex::Cell_handle inside;
    double farthest = 0;
    for (Complex::Cell_handle c : complex.cells())
      if (const auto p = complex.corner(c, 0) + (complex.corner(c, 1) - complex.corner(c, 0)) / 3 +
                         (complex.corner(c, 2) - complex.corner(c, 0)) / 3;
          c->subdomain_index() == 1) {
        const double depth = (std::min)((std::min)(p.x(), 1 - p.x()), (std::min)(p.y(), 1 - p.y()));
        if (depth > farthest) {
          farthest = depth;
          inside = c;
        }
      }
    const auto p = CGAL::centroid(complex.corner(inside, 0), complex.corner(inside, 1),
                                  complex.corner(inside, 2));
    fluid.add_solid(DSC::Box_solid_3(
        CGAL::Bbox_2(p.x() - size / 2, p.y() - size / 2, p.x() + size / 2, p.y() + size / 2)));
    EXPECT_GT(fluid.depth_in_solids(), 0);
    if (size > .125) {
      const double time = fluid.time();
      EXPECT_THROW(fluid.advance(.01), DSC::Error);
      EXPECT_EQ(fluid.time(), time);
    }
  }
}

// A box moves through a full tank. Vertices that slide along its sides do not get past its corners.
TEST(Box_solid, keeps_its_corners_while_liquid_flows_around_it) {
  static constexpr double velocity = 1;
  const Polygon corners = {{.8, .3}, {1.2, .3}, {1.2, .7}, {.8, .7}};
  Complex complex = region(divided({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .1), divided(corners, .1),
                           {-.5, -.5, 2.5, 1.5});
  Fluid fluid(complex, liquid(0, 0));
  fluid.add_solid(DSC::Tank_solid_3(CGAL::Bbox_2(0, 0, 2, 1)), attached(false));
  fluid.add_solid(DSC::Moving_solid_3<DSC::Box_solid_3>(
                      DSC::Box_solid_3(CGAL::Bbox_2(.8, .3, 1.2, .7)), Vector(velocity, 0, 0)),
                  attached(false));
  for (int k = 0; k < 16; ++k) {
    const auto report = fluid.advance(.02);
    EXPECT_TRUE(report.repetitions.empty()) << k;
    for (const auto& corner : corners) {
      const double x = corner.x() + velocity * fluid.time();
      double nearest = 1;
      for (auto v : complex.interface_vertices())
        nearest = (std::min)(
            nearest, std::hypot(complex.position(v).x() - x, complex.position(v).y() - corner.y()));
      EXPECT_LT(nearest, 1e-9) << k << ", corner " << corner;
    }
  }
}

TEST(Box_solid, walls) {
  const DSC::Box_solid_3 box(CGAL::Bbox_3(0, 0, 0, 1, 2, 3));
  const auto walls = [&](double x, double y, double z) {
    std::vector<DSC::Wall_3> result;
    box.walls(Point(x, y, z), 0, result);
    EXPECT_EQ(result.size(), 6u);
    return result;
  };
  const auto least = [](const std::vector<DSC::Wall_3>& list) {
    return std::min_element(list.begin(), list.end(),
                            [](const auto& a, const auto& b) { return a.distance < b.distance; })
        ->distance;
  };
  EXPECT_DOUBLE_EQ(walls(1.5, 1, 1)[1].distance, .5);
  EXPECT_EQ(walls(1.5, 1, 1)[1].normal, Vector(1, 0, 0));
  EXPECT_DOUBLE_EQ(least(walls(1.3, 2.4, 1)), .5);   // from an edge
  EXPECT_DOUBLE_EQ(least(walls(1.2, 2.3, 3.6)), .7); // from a corner
  EXPECT_DOUBLE_EQ(least(walls(.9, 1, 1)), -.1);     // inside
  const auto nearest = [&](double x, double y, double z) {
    return box.nearest_wall(Point(x, y, z));
  };
  EXPECT_NEAR(nearest(1.3, 2.4, 1).distance, .5, 1e-14);
  EXPECT_EQ(nearest(1.5, 1, 1).normal, Vector(1, 0, 0));
  EXPECT_DOUBLE_EQ(nearest(.9, 1, 1).distance, -.1);
  EXPECT_EQ(nearest(.9, 1, 1).normal, Vector(1, 0, 0));
  EXPECT_NEAR(nearest(1.0003, 2.0004, 1).distance, .0005, 1e-14); // very near to an edge
  EXPECT_NEAR(nearest(.9997, 2.0004, 1).distance, .0004, 1e-14);
  const auto edge = walls(1, 2, 1); // on an edge
  EXPECT_EQ(edge[1].distance, 0);
  EXPECT_EQ(edge[1].normal, Vector(1, 0, 0));
  EXPECT_EQ(edge[3].distance, 0);
  EXPECT_EQ(edge[3].normal, Vector(0, 1, 0));
  EXPECT_GT(edge[5].distance, 0); // the other sides are not touched
  EXPECT_THROW(DSC::Box_solid_3(CGAL::Bbox_3(0, 0, 0, 0, 1, 1)), DSC::Error);
}

TEST(Source, flux_is_exact) {
  Complex complex = region(circle(1, .2), {}, {-2, -2, 2, 2});
  Fluid fluid(complex, liquid(0, 0));
  const double begin = fluid.balance().volume;
  fluid.add_source([](const Fluid::Point& p) { return p.x() * p.x() + p.y() * p.y() < .25; },
                   [](double t) { return 1 + t; });
  fluid.add_source([](const Fluid::Point& p) { return p.x() > 100; }, [](double) { return 1; });
  double expected = begin;
  for (int k = 0; k < 5; ++k) {
    const double middle = fluid.time() + .01;
    const auto report = fluid.advance(.02);
    expected += .02 * (1 + middle);
    EXPECT_NEAR(report.gained_volume, .02 * (1 + middle), 1e-12);
    EXPECT_NEAR(report.after.volume, expected, 1e-11);
  }
  fluid.add_source([](const Fluid::Point&) { return true; }, [](double) { return 1e6; });
  EXPECT_THROW(fluid.advance(.02), DSC::Error);
}

// A uniform flow through a channel is an exact solution. Its front moves with the liquid.
class Inflow : public testing::TestWithParam<bool>
{
};
INSTANTIATE_TEST_SUITE_P(Start, Inflow, testing::Bool());

TEST_P(Inflow, plug_flow_is_exact) {
  static constexpr double velocity = .5, dt = .05;
  static constexpr std::size_t nx = 16, ny = 4;
  Complex complex = planar_regions::grid(
      nx, ny,
      [](std::size_t i, std::size_t j) { return Complex::Point_2(double(i) / ny, double(j) / ny); },
      [](std::size_t i, std::size_t) { return i < ny ? 1 : 0; });
  Fluid fluid(complex, liquid(.1, 0));
  DSC::Side_behavior side;
  side.inflow = [](const std::array<double, 3>&, double) {
    return std::array<double, 3>{velocity, 0, 0};
  };
  fluid.set_side(0, false, side);
  if (GetParam()) // otherwise, the first step begins with a projection from rest
    fluid.set_velocities([](Complex::Vertex_handle) { return Fluid::Vector(velocity, 0); });
  for (int k = 0; k < 20; ++k) {
    const auto report = fluid.advance(dt);
    EXPECT_NEAR(report.gained_volume, velocity * dt, 1e-12);
    EXPECT_NEAR(report.after.volume, 1 + velocity * fluid.time(), 1e-10);
    // The projection neglects the mass that enters in its time.
    EXPECT_NEAR(report.after.momentum.x(), velocity * report.after.volume,
                GetParam() ? 1e-8 : .005);
    EXPECT_TRUE(report.repetitions.empty());
  }
  for (auto v : complex.interface_vertices())
    EXPECT_NEAR(complex.position(v).x(), 1 + velocity * fluid.time(), GetParam() ? 1e-7 : .005);
  EXPECT_TRUE(complex.is_valid());
  EXPECT_LT(fluid.relax(dt, 3), 1e-9); // without inflow
  side.inflow = [](const std::array<double, 3>&, double) {
    return std::array<double, 3>{NAN, 0, 0};
  };
  fluid.set_side(0, false, side);
  EXPECT_THROW(fluid.advance(dt), DSC::Error);
}

TEST(Gravity, changes_between_steps) {
  Complex complex = region(circle(1, .25), {}, {-2, -2, 2, 2});
  Fluid fluid(complex, liquid(0, 0));
  fluid.set_gravity({1, 0, 0});
  fluid.advance(.1);
  fluid.set_gravity({0, 0, 0});
  fluid.advance(.1);
  const auto balance = fluid.balance();
  EXPECT_NEAR(balance.momentum.x() / balance.mass, .1, 1e-9);
}

} // namespace test_bodies
