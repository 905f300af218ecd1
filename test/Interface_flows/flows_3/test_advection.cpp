#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/quality_measures.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_support/Error.h>

namespace test_advection {

using CGAL::Deformable_simplicial_complexes::Integration_scheme;
using namespace small_meshes;

// Rotates about the z axis with the angular velocity 1 + t and shrinks with the rate 1/2.
Vector spiral(const Position& p, double t) {
  return Vector(-(1 + t) * p.y() - p.x() / 2, (1 + t) * p.x() - p.y() / 2, -p.z() / 2);
}

Position after_spiral(const Position& p, double t) {
  const double angle = t + t * t / 2, scale = std::exp(-t / 2);
  return {scale * (std::cos(angle) * p.x() - std::sin(angle) * p.y()),
          scale * (std::sin(angle) * p.x() + std::cos(angle) * p.y()), scale * p.z()};
}

// Returns the exact positions of the vertices of the interface at the time t.
std::vector<Position> after_spiral(const Complex& dsc, double t) {
  std::vector<Position> result;
  for (Vertex_handle v : dsc.interface_vertices())
    result.push_back(after_spiral(dsc.position(v), t));
  return result;
}

// Returns the largest distance of the vertices of a cube from their exact positions.
double error(Integration_scheme scheme, int steps) {
  static constexpr double end = .4;
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  const std::vector<Position> expected = after_spiral(dsc, end);
  for (int i = 0; i < steps; ++i)
    EXPECT_TRUE(
        DSC::advect_interface(dsc, spiral, i * end / steps, end / steps, parameters::scheme(scheme))
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

TEST(Advection, euler_is_of_first_order) { expect_order(Integration_scheme::euler, 1); }

TEST(Advection, midpoint_rule_is_of_second_order) { expect_order(Integration_scheme::rk2, 2); }

TEST(Advection, runge_kutta_is_of_fourth_order) { expect_order(Integration_scheme::rk4, 4); }

// The tolerance determines the substeps, for any time step of the caller.
TEST(Advection, adaptive_steps_keep_a_tolerance) {
  for (double tolerance : {1e-3, 1e-6}) {
    Complex dsc = make_complex(grid(4, small_meshes::cube));
    const auto vertices = dsc.interface_vertices();
    const std::vector<Position> expected = after_spiral(dsc, .4);
    EXPECT_TRUE(
        DSC::advect_interface(
            dsc, spiral, 0, .4,
            parameters::scheme(Integration_scheme::adaptive).integration_tolerance(tolerance))
            .complete);
    double squared = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      squared = (std::max)(squared, (dsc.position(vertices[i]) - expected[i]).squared_length());
    EXPECT_LT(std::sqrt(squared), 3 * tolerance * dsc.mean_interface_edge());
  }
}

TEST(Advection, refuses_tolerances_that_cannot_be_kept) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto before = dsc.state();
  const auto adaptive = parameters::scheme(Integration_scheme::adaptive);
  for (double tolerance : {0., -1., std::nan("")})
    EXPECT_THROW(
        DSC::advect_interface(dsc, spiral, 0, .1, adaptive.integration_tolerance(tolerance)),
        CGAL::Deformable_simplicial_complexes::Error);
  const auto rough = [](const Position& p, double t) {
    return Vector(1e6 * std::sin(1e12 * t * p.x()), 0, 0);
  };
  EXPECT_THROW(DSC::advect_interface(dsc, rough, 0, .1, adaptive.integration_tolerance(1e-300)),
               CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == before);
}

// Relative to a large time, a step is below the precision of `double`: the whole step, or the
// substeps that the tolerance requires. Without an exception, the integration would not terminate.
TEST(Advection, refuses_steps_in_which_time_stands_still) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto before = dsc.state();
  const auto adaptive = parameters::scheme(Integration_scheme::adaptive);
  const auto uniform = [](const Position&, double) { return Vector(.1, 0, 0); };
  EXPECT_THROW(DSC::advect_interface(dsc, uniform, 1e16, 1, adaptive),
               CGAL::Deformable_simplicial_complexes::Error);
  unsigned calls = 0;
  const auto rough = [&](const Position& p, double) {
    if (++calls > 10000000)
      throw std::runtime_error("there is no end");
    return Vector(.1 * std::sin(1e4 * p.x()), 0, 0);
  };
  EXPECT_THROW(DSC::advect_interface(dsc, rough, 1e14, 1, adaptive.integration_tolerance(1e-9)),
               CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == before);
  EXPECT_TRUE(DSC::advect_interface(dsc, uniform, 1e16, 0, adaptive).complete);
}

// Stages of long substeps leave the domain of the field, although the path does not.
TEST(Advection, adaptive_steps_stay_where_the_field_is) {
  static constexpr double k = 5;
  const auto decay = [](const Position& p, double) {
    return Vector(p.x() < -1 ? std::nan("") : -k * (p.x() + 1), 0, 0);
  };
  const Complex dsc = make_complex(grid(4, small_meshes::cube));
  const DSC::Interface_snapshot<Complex> snapshot(dsc);
  const auto start = snapshot.positions(dsc);
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  const auto end = internal::integrate_adaptively(snapshot, start, decay, 0, 1, 1e-6);
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_NEAR(end[i].x(), -1 + std::exp(-k) * (start[i].x() + 1), 1e-5);
  const auto nowhere = [](const Position&, double) { return Vector(std::nan(""), 0, 0); };
  EXPECT_THROW(internal::integrate_adaptively(snapshot, start, nowhere, 0, 1, 1e-6),
               CGAL::Deformable_simplicial_complexes::Invalid_destination_error);
}

// Called once, for any scheme.
TEST(Advection, steps_of_the_whole_interface) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  const std::vector<Position> expected = after_spiral(dsc, .2);
  int calls = 0;
  const auto step = [&](const DSC::Interface_snapshot<Complex>& snapshot,
                        const std::vector<Position>& positions, double t, double dt,
                        std::vector<Position>& destinations) {
    EXPECT_EQ(snapshot.vertices, vertices);
    EXPECT_EQ(t, 3);
    for (const Position& p : positions)
      destinations.push_back(after_spiral(p, dt));
    ++calls;
  };
  EXPECT_TRUE(DSC::advect_interface(dsc, step, 3, .2).complete);
  EXPECT_EQ(calls, 1);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(dsc.position(vertices[i]), expected[i]);

  const auto nothing = [](const DSC::Interface_snapshot<Complex>&, const std::vector<Position>&,
                          double, double, std::vector<Position>&) {};
  const auto before = dsc.state();
  EXPECT_THROW(DSC::advect_interface(dsc, nothing, 0, .1),
               CGAL::Deformable_simplicial_complexes::Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == before);
}

TEST(Advection, second_order_is_the_default) {
  Complex a = make_complex(grid(4, small_meshes::cube)), b = a;
  DSC::advect_interface(a, spiral, 0, .1);
  DSC::advect_interface(b, spiral, 0, .1, parameters::scheme(Integration_scheme::rk2));
  EXPECT_TRUE(a.state() == b.state());
}

TEST(Advection, negative_steps_go_back) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  std::vector<Position> before;
  for (Vertex_handle v : vertices)
    before.push_back(dsc.position(v));
  const auto rk4 = parameters::scheme(Integration_scheme::rk4);
  EXPECT_TRUE(DSC::advect_interface(dsc, spiral, 0, .1, rk4).complete);
  EXPECT_TRUE(DSC::advect_interface(dsc, spiral, .1, -.1, rk4).complete);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_LT((dsc.position(vertices[i]) - before[i]).squared_length(), 1e-12);
}

TEST(Advection, flow_maps_are_taken_as_they_are) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  const auto vertices = dsc.interface_vertices();
  const std::vector<Position> expected = after_spiral(dsc, .2);
  const auto map = [](const Position& p, double t, double dt) {
    EXPECT_EQ(t, 3);
    return after_spiral(p, dt);
  };
  EXPECT_TRUE(DSC::advect_interface(dsc, map, 3, .2).complete);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(dsc.position(vertices[i]), expected[i]);
}

// Called once for the whole interface in each evaluation.
TEST(Advection, velocities_of_the_whole_interface) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  std::vector<double> times;
  const auto velocity = [&](const DSC::Interface_snapshot<Complex>& interface_,
                            const std::vector<Position>& positions, double t,
                            std::vector<Vector>& velocities) {
    times.push_back(t);
    EXPECT_EQ(interface_.vertices, dsc.interface_vertices());
    EXPECT_EQ(interface_.facets().size(), 48u);
    for (const auto& triangle : interface_.facets()) {
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
  const auto rk4 = parameters::scheme(Integration_scheme::rk4).largest_displacement(0.);
  DSC::advect_interface(dsc, velocity, 1, .25, rk4);
  EXPECT_EQ(times, (std::vector<double>{1, 1.125, 1.125, 1.25}));
  DSC::advect_interface(reference, spiral, 1, .25, rk4);
  EXPECT_TRUE(mesh_helpers::interface_triangles(dsc) ==
              mesh_helpers::interface_triangles(reference));
}

TEST(Flows, rotation_keeps_its_axis_and_distances) {
  const DSC::Rigid_rotation_3 rotation({1, 0, 0}, {0, 0, 5}, CGAL_PI / 2);
  EXPECT_LT((rotation({2, 0, 7}, 0, 1) - Position(1, 1, 7)).squared_length(), 1e-30);
  EXPECT_LT((rotation({2, 0, 7}, 9, -1) - Position(1, -1, 7)).squared_length(), 1e-30);
  EXPECT_LT((rotation({2, 0, 7}, 0, 4) - Position(2, 0, 7)).squared_length(), 1e-30);
  EXPECT_EQ(rotation({1, 0, -3}, 0, .7), Position(1, 0, -3));
}

TEST(Flows, offset_moves_planes_by_speed_times_time) {
  Complex dsc = make_complex(grid(4, [](const auto& p) { return p.x() < 0 ? 1 : 0; }));
  EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{.2}, 0, .5).complete);
  EXPECT_NEAR(dsc.volume(1), 4.4, 1e-12);
  EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{-.2}, 0, 1).complete);
  EXPECT_NEAR(dsc.volume(1), 3.6, 1e-12);
}

TEST(Flows, offset_acts_where_phases_face_the_outside) {
  Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  const double area = dsc.area(1, 2);
  EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, .5).complete);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(dsc.volume(1), .55);
  EXPECT_NEAR(dsc.volume(1), dsc.volume(2), .02);
  EXPECT_GT(dsc.area(1, 2), area);
}

TEST(Flows, rotation_takes_axes_of_any_length) {
  for (double length : {1e-200, 1e200}) {
    const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, length}, CGAL_PI / 2);
    EXPECT_LT((rotation({1, 0, 0}, 0, 1) - Position(0, 1, 0)).squared_length(), 1e-30) << length;
  }
}

TEST(Flows, offset_refuses_speeds_that_are_not_finite) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  for (double speed : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_THROW(DSC::advect_interface(dsc, DSC::Normal_offset{speed}, 0, 1),
                 CGAL::Deformable_simplicial_complexes::Invalid_destination_error)
        << speed;
  EXPECT_TRUE(dsc.state() == state);
  // A finite speed is refused if the step would be divided into too many parts.
  EXPECT_THROW(DSC::advect_interface(dsc, DSC::Normal_offset{1e78}, 0, 1),
               CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == state);
  // In one part, the interface goes to the sides of the domain.
  const auto report = DSC::advect_interface(
      dsc, DSC::Normal_offset{1e78}, 0, 1,
      parameters::largest_displacement(0.).domain_rule(DSC::Domain_rule::stop));
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_TRUE(v->boundary_class() != 0 || !report.complete) << dsc.position(v);
  EXPECT_GT(dsc.volume(1), 6);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Advection, refuses_velocities_of_another_number_of_vertices) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  const auto too_few = [](const auto&, const std::vector<Position>& positions, double,
                          std::vector<Vector>& velocities) {
    velocities.assign(positions.size() - 1, Vector(0, 0, 0));
  };
  EXPECT_THROW(DSC::advect_interface(dsc, too_few, 0, .1),
               CGAL::Deformable_simplicial_complexes::Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == state);
}

// Small angles

// Returns the smallest dihedral angle, or supplement of a dihedral angle, in degrees.
double extreme_angle(const Complex& dsc) {
  static constexpr double of_regular = 0.94280904158206337;
  double smallest = 1;
  for (auto c : dsc.triangulation().finite_cell_handles()) {
    const auto p = [&](int i) { return dsc.position(c->vertex(i)); };
    smallest = (std::min)(smallest, DSC::Minimum_sine_3()(p(0), p(1), p(2), p(3)));
  }
  return std::asin(of_regular * smallest) * 180 / CGAL_PI;
}

// Folds a ball.
Vector folding(const Position& p) {
  return Vector(.5 * std::sin(4 * p.y()), .5 * std::sin(4 * p.z()), .5 * std::sin(4 * p.x()));
}

// The same field, defined on the interface only, so that free vertices do not follow it.
void fold(const DSC::Interface_snapshot<Complex>&, const std::vector<Position>& positions, double,
          std::vector<Vector>& velocities) {
  for (const Position& p : positions)
    velocities.push_back(folding(p));
}

// Returns the facets of the interface as time stamps of their vertices.
std::set<std::set<std::size_t>> triangles(const Complex& dsc) {
  std::set<std::set<std::size_t>> result;
  for (const auto& f : dsc.interface_facets()) {
    const auto v = dsc.facet_vertices(f);
    result.insert({v[0]->time_stamp(), v[1]->time_stamp(), v[2]->time_stamp()});
  }
  return result;
}

// The ball does not reach the sides of the domain, and its sheets do not come near each other.
TEST(Small_angles, are_removed_in_the_end) {
  Complex with = make_complex(
      grid(10, [](const auto& p) { return (p - CGAL::ORIGIN).squared_length() < .2 ? 1 : 0; }));
  Complex without = with;
  const double volume = with.volume(1);
  std::size_t number_of_bad_steps = 0, changes = 0;
  for (int i = 0; i < 9; ++i) {
    const auto report = DSC::advect_interface(with, fold, i, .08);
    ASSERT_TRUE(with.is_valid());
    EXPECT_GE(extreme_angle(with), 5 - 1e-9) << i;
    changes += report.relocated + report.inserted;
    DSC::advect_interface(without, fold, i, .08, parameters::minimum_angle(0));
    number_of_bad_steps += extreme_angle(without) < 5;
  }
  EXPECT_GT(number_of_bad_steps, 0u);
  EXPECT_GT(changes, 0u);
  EXPECT_EQ(with.number_of_components(1), 1u);
  EXPECT_EQ(with.euler_characteristic(1), 2);
  EXPECT_NEAR(with.volume(1), volume, .03 * volume);
}

// A ball with degenerate cells rotates and keeps its facets.
TEST(Small_angles, of_what_moves_as_a_whole_stay) {
  Complex dsc = make_complex(grid(6, small_meshes::ball));
  for (Vertex_handle v : dsc.interface_vertices()) {
    const Position p = dsc.position(v);
    dsc.move_vertex(v, Position(p.x(), p.y(), .1 * p.z()));
  }
  ASSERT_LT(extreme_angle(dsc), 5);
  Complex rotating = dsc;
  const auto vertices = rotating.interface_vertices();
  const auto before = triangles(rotating);
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(
        DSC::advect_interface(rotating, DSC::Rigid_rotation_3({0, 0, 0}, {1, 2, 3}, .2), i, 1)
            .complete);
  EXPECT_EQ(rotating.interface_vertices(), vertices);
  EXPECT_EQ(triangles(rotating), before);
  EXPECT_NEAR(rotating.area(1), dsc.area(1), 1e-12);
  EXPECT_NEAR(rotating.volume(1), dsc.volume(1), 1e-13);
}

// Half of a ball folds. The vertices of the other half have zero displacement and must not move,
// even if cells between the halves become degenerate.
TEST(Small_angles, do_not_move_what_stays) {
  Complex dsc = make_complex(grid(8, small_meshes::ball));
  const auto is_still = [](const Position& p) { return p.x() >= -.05; };
  const auto fold_left = [&](const Position& p, double) {
    const Vector v = 2 * folding(p);
    return is_still(p) ? Vector(0, 0, 0) : Vector((std::min)(0., v.x()), v.y(), v.z());
  };
  struct Still
  {
    Vertex_handle vertex;
    std::size_t time_stamp;
    Position position;
  };
  std::vector<Still> still;
  for (Vertex_handle v : dsc.interface_vertices())
    if (is_still(dsc.position(v)))
      still.push_back({v, v->time_stamp(), dsc.position(v)});
  std::size_t relocated = 0;
  for (int i = 0; i < 8; ++i)
    relocated += DSC::advect_interface(dsc, fold_left, i, .1,
                                       parameters::domain_rule(DSC::Domain_rule::stop))
                     .relocated;
  ASSERT_TRUE(dsc.is_valid());
  EXPECT_GT(relocated, 0u);
  std::size_t kept = 0;
  for (const Still& s : still)
    if (dsc.is_alive(s.vertex, s.time_stamp) && s.vertex->is_interface()) {
      EXPECT_EQ(dsc.position(s.vertex), s.position);
      ++kept;
    }
  EXPECT_GT(kept, still.size() / 2);
}

TEST(Small_angles, refuses_bounds_out_of_range) {
  Complex dsc = make_complex(grid(4, small_meshes::ball));
  const auto state = dsc.state();
  for (double angle : {-1., 31., std::nan("")})
    EXPECT_THROW(DSC::advect_interface(dsc, fold, 0, .1, parameters::minimum_angle(angle)),
                 CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_TRUE(dsc.state() == state);
}

// A flow that vanishes at the sides of the domain. The harmonic extension cannot reproduce it.
Vector eddy(const Position& p, double) {
  const auto bump = [](double x) { return (1 - x * x) * (1 - x * x); };
  const double f = 3 * bump(p.x()) * bump(p.y()) * bump(p.z());
  return f * Vector(-p.y(), p.x(), p.x() * p.y());
}

struct Eddy_map
{
  Position operator()(const Position& p, double t, double dt) const {
    return DSC::internal::follow_flow<Complex>(Complex::Domain(), {p}, eddy, t, dt).front();
  }
};

struct Invertible_eddy_map : Eddy_map
{
  using Is_invertible = CGAL::Tag_true;
};

// The eddy at many points at once.
struct Eddy_at_points
{
  void operator()(const std::vector<Position>& points, double t,
                  std::vector<Vector>& velocities) const {
    velocities.clear();
    for (const Position& p : points)
      velocities.push_back(eddy(p, t));
    velocities.resize(velocities.size() - missing);
    ++calls;
  }

  std::size_t missing = 0;
  mutable int calls = 0;
};

TEST(Velocity_field_of_points, moves_as_the_field_of_a_point_does) {
  for (auto scheme : {DSC::Integration_scheme::euler, DSC::Integration_scheme::rk4,
                      DSC::Integration_scheme::adaptive}) {
    Complex by_point = mesh_helpers::sphere(8, .6), by_points = by_point;
    const Eddy_at_points at_points;
    DSC::advect_interface(by_point, eddy, 0, .05, parameters::scheme(scheme));
    DSC::advect_interface(by_points, std::cref(at_points), 0, .05, parameters::scheme(scheme));
    EXPECT_TRUE(by_point.state() == by_points.state());
    EXPECT_LT(at_points.calls, 100);
  }
}

TEST(Velocity_field_of_points, gives_one_velocity_for_each_point) {
  Complex dsc = mesh_helpers::sphere(8, .6);
  const auto state = dsc.state();
  EXPECT_THROW(DSC::advect_interface(dsc, Eddy_at_points{1}, 0, .05),
               DSC::Invalid_destination_error);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Flow_option, gives_one_destination_for_each_vertex) {
  Complex dsc = mesh_helpers::sphere(8, .6);
  DSC::Advection_options<Complex> options;
  options.deformation.flow = [](const std::vector<Vertex_handle>&) {
    return std::vector<Position>();
  };
  EXPECT_THROW(DSC::advect_interface(dsc, eddy, 0, .05, options), DSC::Error);
  EXPECT_TRUE(dsc.is_valid());
}

// Returns the fraction of the free vertices that follow the eddy.
template <class Velocity, class NamedParameters>
double part_that_follows(const Velocity& velocity, const NamedParameters& np) {
  static constexpr double dt = .05, same = 1e-6;
  Complex dsc = mesh_helpers::sphere(8, .6);
  const auto vertices = dsc.vertices();
  std::vector<Position> expected;
  for (Vertex_handle v : vertices)
    expected.push_back(Eddy_map()(dsc.position(v), 0, dt));
  EXPECT_TRUE(DSC::advect_interface(dsc, velocity, 0, dt, np).complete);
  EXPECT_TRUE(dsc.is_valid());
  double all = 0, following = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!vertices[i]->is_interface() && !dsc.is_boundary(vertices[i])) {
      ++all;
      following += (dsc.position(vertices[i]) - expected[i]).squared_length() < same * same;
    }
  EXPECT_GT(all, 50);
  return following / all;
}

TEST(Advection, takes_the_space_around_along) {
  const auto rk4 = parameters::scheme(Integration_scheme::rk4);
  EXPECT_GT(part_that_follows(eddy, rk4), .95);
  // velocities that are undefined or huge have no effect
  for (double bad : {std::nan(""), 1e300}) {
    const auto inside = [&](const Position& p, double t) {
      EXPECT_TRUE(std::isfinite(p.x()));
      return ((p - CGAL::ORIGIN).squared_length() < .5 ? 1. : bad) * eddy(p, t);
    };
    const double part = part_that_follows(inside, rk4);
    EXPECT_GT(part, .05);
    EXPECT_LT(part, .9);
  }
  // a flow map may collapse the domain, unless it is declared invertible
  EXPECT_LT(part_that_follows(Eddy_map(), rk4), .1);
  EXPECT_GT(part_that_follows(Invertible_eddy_map(), rk4), .95);
  // the user's flow has priority
  EXPECT_LT(part_that_follows(eddy, rk4.flow([](const Position& p) { return p; })), .1);
}

// A rotation would rotate the box, too. So it fades out between the interface and the box.
TEST(Advection, flows_fade_towards_a_boundary_that_they_would_move) {
  Complex dsc = mesh_helpers::sphere(8, .6);
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, 1);
  static constexpr double dt = .02;
  const auto distance = [](const Position& p) {
    return 1 - (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  };
  double room = 1;
  for (Vertex_handle v : dsc.interface_vertices())
    room = (std::min)(room, distance(dsc.position(v)));
  EXPECT_GT(room, .35);
  const auto vertices = dsc.vertices();
  std::vector<Position> expected;
  for (Vertex_handle v : vertices) {
    const Position p = dsc.position(v);
    expected.push_back(p + (std::min)(1., 2 * distance(p) / room) * (rotation(p, 0, dt) - p));
  }
  const auto report = DSC::advect_interface(dsc, rotation, 0, dt);
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.smoothed, 0u);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_LT((dsc.position(vertices[i]) - expected[i]).squared_length(), 1e-24);
}

// A ball folds, and its facets get small angles.
TEST(Advection, keeps_facets_if_told_to) {
  const auto velocity = [](const Position& p, double) { return folding(p); };
  const auto removed_facets = [&](double minimum_facet_angle) {
    Complex dsc = mesh_helpers::sphere(10, .5);
    const std::size_t before = dsc.interface_facets().size();
    for (int i = 0; i < 8; ++i)
      EXPECT_TRUE(DSC::advect_interface(
                      dsc, velocity, i, .1,
                      parameters::minimum_facet_angle(minimum_facet_angle).minimum_angle(0.))
                      .unfinished.empty());
    EXPECT_TRUE(dsc.is_valid());
    return before - dsc.interface_facets().size();
  };
  // Obstacles are removed with any bound, facets only where angles shrink by a tenth.
  EXPECT_GT(removed_facets(30), 10 + removed_facets(0));
  Complex dsc = mesh_helpers::sphere(4, .5);
  for (double bad : {-1., 31., std::nan("")})
    EXPECT_THROW(DSC::advect_interface(dsc, velocity, 0, .1, parameters::minimum_facet_angle(bad)),
                 CGAL::Deformable_simplicial_complexes::Error);
}

} // namespace test_advection
