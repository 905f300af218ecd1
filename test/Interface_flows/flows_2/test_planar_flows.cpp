// Curves, complexes of curves, and their flows.

#include "test.h"

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_flows/velocity_fields_2.h>
#include <CGAL/Interface_remeshing/control_detail.h>

#include <CGAL/Bbox_2.h>

namespace test_planar_flows {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;
using Position = Complex::Point_2;
using Vector = Complex::Vector_2;
using Curve = DSC::Labeled_curve_2<Point>;
using Curves = std::vector<Curve>;
using Report = DSC::Deformation_report<Complex>;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

constexpr double pi = 3.14159265358979323846;

Curve polygon(const std::vector<Point>& points, int label = 1) {
  Curve result;
  result.add_polyline(points);
  result.label = label;
  return result;
}

// Returns a curve r(angle) about a center.
template <class Radius>
Curve round_curve(double x, double y, std::size_t n, const Radius& radius, int label = 1) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n), r = radius(angle);
    points.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle));
  }
  return polygon(points, label);
}

Curve circle(double x, double y, double radius, std::size_t n, int label = 1) {
  return round_curve(
      x, y, n, [=](double) { return radius; }, label);
}

Complex make(const Curves& curves) {
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(curves);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

double smallest_quality(const Complex& dsc) {
  double result = 1;
  for (auto c : dsc.cells())
    result = (std::min)(result, c->quality());
  return result;
}

std::vector<Position> positions(const Complex& dsc) {
  std::vector<Position> result;
  for (auto v : dsc.interface_vertices())
    result.push_back(dsc.position(v));
  return result;
}

double largest_distance(const std::vector<Position>& p, const std::vector<Position>& q) {
  if (p.size() != q.size())
    return std::numeric_limits<double>::infinity();
  double result = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    result = (std::max)(result, std::sqrt((p[i] - q[i]).squared_length()));
  return result;
}

Invalid_surface_error refusal(const Curves& curves) {
  try {
    make(curves);
  } catch (const Invalid_surface_error& e) {
    return e;
  }
  ADD_FAILURE() << "accepted";
  return {Reason::empty, "", 0};
}

// Rotates by 360 degrees about the origin in steps of `degrees`, and checks that the complex
// returns to its initial state.
void expect_turn(Complex& dsc, int degrees, double tolerance) {
  const auto before = positions(dsc);
  const auto labels = dsc.labels();
  std::vector<double> areas;
  for (int label : labels)
    areas.push_back(dsc.area(label));
  const DSC::Rigid_rotation_2 rotation({0, 0}, pi / 180);
  for (int angle = 0; angle < 360; angle += degrees) {
    const Report report = DSC::advect_interface(dsc, rotation, angle, degrees);
    ASSERT_TRUE(report.complete);
    EXPECT_EQ(report.relabeled, 0u);
  }
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_LT(largest_distance(positions(dsc), before), tolerance);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_NEAR(dsc.area(labels[i]), areas[i], tolerance);
}

TEST(Make_2, of_nested_curves) {
  const Complex dsc =
      make({circle(0, 0, 1, 64, 1), circle(.1, 0, .6, 48, 2), circle(.1, .1, .2, 24, 1)});
  const auto area = [](double r, double n) { return n / 2 * std::sin(2 * pi / n) * r * r; };
  EXPECT_NEAR(dsc.area(2), area(.6, 48) - area(.2, 24), 1e-12);
  EXPECT_NEAR(dsc.area(1), area(1, 64) - area(.6, 48) + area(.2, 24), 1e-12);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  EXPECT_EQ(dsc.interface_vertices().size(), 64u + 48 + 24);
  EXPECT_GT(smallest_quality(dsc), .3);
}

// A curve inside itself bounds a hole; components may touch at a point.
TEST(Make_2, of_holes_and_touching_parts) {
  Curve c = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  c.add_polyline(std::vector<Point>{{0, 0}, {1, 3}, {3, 1}});
  c.add_polyline(std::vector<Point>{{4, 4}, {6, 4}, {6, 6}});
  const Complex dsc = make({c});
  EXPECT_NEAR(dsc.area(1), 16 - 4 + 2, 1e-12);
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  EXPECT_EQ(dsc.number_of_components(0), 2u);
}

TEST(Make_2, refuses_what_bounds_nothing) {
  EXPECT_EQ(refusal({Curve()}).reason(), Reason::empty);
  Curve open = circle(0, 0, 1, 8);
  open.segments.erase(open.segments.begin() + 3);
  EXPECT_EQ(refusal({open}).reason(), Reason::open);
  EXPECT_EQ(refusal({open}).facets(), std::vector<std::size_t>{2});
  Curve bad = circle(0, 0, 1, 8);
  bad.segments[2][1] = 99;
  EXPECT_EQ(refusal({bad}).reason(), Reason::bad_index);
  bad = circle(0, 0, std::numeric_limits<double>::quiet_NaN(), 8);
  EXPECT_EQ(refusal({bad}).reason(), Reason::not_finite);
  EXPECT_THROW(make({}), CGAL::Deformable_simplicial_complexes::Error);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(
                   {circle(0, 0, 1, 8)}, parameters::enclosing_box(CGAL::Bbox_2(-1, -1, 1, 1))),
               Invalid_surface_error);
  for (double size : {1e-170, 1e160})
    EXPECT_THROW(make({polygon({{0, 0}, {size, 0}, {0, size}})}),
                 CGAL::Deformable_simplicial_complexes::Error);
}

// Free vertices keep their distance from long segments next to short segments.
TEST(Make_2, of_long_segments_beside_short_ones) {
  const Curve curve = polygon(
      {{.25, .5625}, {3.25, .5625}, {3.25, .7625}, {3.45, .7625}, {3.45, 3.5625}, {.25, 3.5625}});
  const Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      {curve}, parameters::enclosing_box(CGAL::Iso_rectangle_2<CGAL::Epick>(-4, -4, 4, 4)));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.interface_vertices().size(), 6u);
  EXPECT_NEAR(dsc.area(1), 3.2 * 3 - .2 * .2, 1e-12);
}

// The bounding boxes of most pairs of segments overlap.
TEST(Make_2, of_many_long_needles) {
  constexpr std::size_t n = 3000;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / n, radius = i % 2 == 0 ? 1 : .1;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const Complex dsc = make({polygon(points)});
  EXPECT_EQ(dsc.interface_vertices().size(), n);
  EXPECT_NEAR(dsc.area(1), n / 2. * .1 * std::sin(2 * pi / n), 1e-12);
}

TEST(Make_2, of_polygons_with_holes_in_a_flat_box) {
  CGAL::Polygon_with_holes_2<CGAL::Epick> polygon;
  for (const Point& p : circle(0, 0, .3, 64).points)
    polygon.outer_boundary().push_back(p);
  CGAL::Polygon_2<CGAL::Epick> hole;
  for (const Point& p : circle(0, 0, .1, 16).points)
    hole.push_back(p);
  polygon.add_hole(hole);
  Curve curve;
  curve.add_polygon(polygon);
  const Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      {curve}, parameters::enclosing_box(CGAL::Bbox_2(-50, -.5, 50, .5)).improve(false));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(dsc.number_of_components(0), 2u);
  EXPECT_LT(dsc.number_of_vertices(), 3000u);
}

// The reference length of limits changes with splits and collapses of the interface only.
TEST(Spacing, follows_refinement_and_not_motion) {
  Complex dsc = make({circle(0, 0, 1, 24)});
  const double edge = 2 * std::sin(pi / 24);
  const auto expect_edge = [&] {
    for (auto v : dsc.interface_vertices())
      EXPECT_NEAR(v->spacing(), edge, 1e-6 * edge);
  };
  expect_edge();
  for (int step = 0; step < 10; ++step)
    DSC::advect_interface(dsc, DSC::Normal_offset{.1}, step, 1.);
  EXPECT_EQ(dsc.interface_vertices().size(), 24u);
  expect_edge(); // for edges that are twice as long now
  DSC::control_detail(dsc, parameters::change_interface(true).sizing_field(
                               [=](const Position&) { return edge / 2; }));
  EXPECT_GT(dsc.interface_vertices().size(), 60u);
  for (auto v : dsc.interface_vertices())
    EXPECT_NEAR(v->spacing(), dsc.interface_edge_length(v), 1e-6 * edge);
  DSC::control_detail(dsc, parameters::change_interface(true)
                               .interface_split_length(4)
                               .interface_collapse_length(1)
                               .collapse_quality(.1)
                               .sizing_field([=](const Position&) { return 2 * edge; }));
  EXPECT_LT(dsc.interface_vertices().size(), 60u);
  double longest = 0;
  for (auto v : dsc.interface_vertices())
    longest = (std::max)(longest, double(v->spacing()));
  EXPECT_GT(longest, 1.2 * edge);
}

TEST(Make_2, refuses_crossings_with_their_segments) {
  const Curve eight = polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_EQ(refusal({eight}).reason(), Reason::self_intersection);
  EXPECT_EQ(refusal({eight}).facets(), (std::vector<std::size_t>{0, 2}));
  const auto e = refusal({polygon({{0, 0}, {2, 0}, {2, 2}}), polygon({{1, -1}, {3, -1}, {1, 3}})});
  EXPECT_EQ(e.reason(), Reason::crossing_surfaces);
  EXPECT_EQ(e.surface(), 0u);
  EXPECT_EQ(e.other_surface(), 1u);
  EXPECT_FALSE(e.facets().empty());
  // overlapping along a part of a segment
  EXPECT_EQ(
      refusal({polygon({{0, 0}, {4, 0}, {2, 2}}), polygon({{1, 0}, {3, 0}, {2, -2}})}).reason(),
      Reason::crossing_surfaces);
}

TEST(Planar_flows, star_turns_and_is_back) {
  Complex dsc = make({round_curve(0, 0, 120, [](double a) { return 1 + .4 * std::cos(5 * a); })});
  expect_turn(dsc, 5, 1e-12);
}

TEST(Planar_flows, nested_figure_turns_and_is_back) {
  Complex dsc = make({circle(0, 0, 1, 64, 1), circle(.2, 0, .6, 48, 2), circle(.1, .1, .2, 24, 3)});
  expect_turn(dsc, 6, 1e-12);
}

// Vertices that moved one by one changed the shape of flat polygons with few corners.
TEST(Planar_flows, flat_polygons_are_turned_exactly_by_any_angle) {
  std::mt19937 random(1);
  const auto any = [&] { return double(random()) / 4294967296.; };
  for (int i = 0; i < 40; ++i) {
    std::vector<Point> corners;
    const std::size_t n = 4 + i % 5;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 2 * pi * (double(k) + .8 * any()) / double(n), r = .2 + any();
      corners.emplace_back(r * std::cos(angle), 8 * r * std::sin(angle));
    }
    DSC::Construction_options<2> options;
    options.thin_parts.edge_per_thickness = 0;
    const Complex start =
        DSC::make_deformable_simplicial_complex_2<Complex>(Curves{polygon(corners)}, options);
    CGAL::Bbox_2 domain;
    for (auto v : start.finite_vertices())
      domain += start.position(v).bbox();
    const Position center((domain.xmin() + domain.xmax()) / 2, (domain.ymin() + domain.ymax()) / 2);
    for (double degrees : {90., 180., 270., 300., 1000.}) {
      Complex dsc = start;
      const DSC::Rigid_rotation_2 rotation(center, degrees * pi / 180);
      EXPECT_TRUE(DSC::advect_interface(dsc, rotation, 0, 1).complete) << i << ", " << degrees;
      EXPECT_EQ(dsc.interface_facets().size(), n) << i << ", " << degrees;
      EXPECT_NEAR(dsc.area(1), start.area(1), 1e-12 * start.area(1)) << i << ", " << degrees;
    }
  }
}

// Two disks of radius 1/2 grow by .2 each and merge.
TEST(Planar_flows, disks_grow_together) {
  Complex dsc = make({circle(-.6, 0, .5, 160), circle(.6, 0, .5, 160)});
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  std::size_t merged = 0;
  for (int step = 0; step < 20; ++step) {
    const Report report = DSC::advect_interface(dsc, DSC::Normal_offset{.01}, step, 1.);
    ASSERT_TRUE(dsc.is_valid());
    for (const auto& change : report.labels)
      merged += change.label == 1 ? change.merged : 0;
  }
  EXPECT_EQ(merged, 1u);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  const double r = .7, half = .6,
               exact = 2 * (pi * r * r - r * r * std::acos(half / r) +
                            half * std::sqrt(r * r - half * half));
  EXPECT_NEAR(dsc.area(1), exact, .001 * exact);
  EXPECT_EQ(dsc.euler_characteristic(1), 1);
  EXPECT_EQ(dsc.euler_characteristic(0), 0);
}

// They do not merge if topology changes are forbidden.
TEST(Planar_flows, disks_stay_apart_if_they_must) {
  Complex dsc = make({circle(-.6, 0, .5, 80), circle(.6, 0, .5, 80)});
  for (int step = 0; step < 20; ++step) {
    DSC::advect_interface(dsc, DSC::Normal_offset{.01}, step, 1.,
                          parameters::topology_control(
                              CGAL::Deformable_simplicial_complexes::Forbid_topology_changes()));
    ASSERT_TRUE(dsc.is_valid());
  }
  EXPECT_EQ(dsc.number_of_components(1), 2u);
  EXPECT_EQ(dsc.number_of_components(0), 1u);
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  EXPECT_EQ(dsc.euler_characteristic(0), -1);
}

// A ring closes its hole, unless topology changes are forbidden.
TEST(Planar_flows, hole_of_a_ring_closes) {
  Curve ring = circle(0, 0, 1, 320);
  const Curve hole = circle(0, 0, .2, 64);
  ring.add_polyline(hole.points);
  for (bool may_close : {true, false}) {
    Complex dsc = make({ring});
    EXPECT_EQ(dsc.number_of_components(0), 2u);
    EXPECT_EQ(dsc.euler_characteristic(1), 0);
    for (int step = 0; step < 12; ++step) {
      if (may_close)
        DSC::advect_interface(dsc, DSC::Normal_offset{.02}, step, 1.);
      else
        DSC::advect_interface(
            dsc, DSC::Normal_offset{.02}, step, 1.,
            parameters::topology_control(
                CGAL::Deformable_simplicial_complexes::Forbid_topology_changes()));
      ASSERT_TRUE(dsc.is_valid());
    }
    EXPECT_EQ(dsc.number_of_components(0), may_close ? 1u : 2u);
    EXPECT_EQ(dsc.euler_characteristic(1), may_close ? 1 : 0);
    EXPECT_NEAR(dsc.area(1), pi * 1.24 * 1.24, .001 * pi * 1.24 * 1.24);
  }
}

// A disk is stretched to almost twice its circumference and back; detail control adapts the
// interface.
TEST(Planar_flows, vortex_there_and_back) {
  const double radius = .15, edge = 2 * pi * radius / 80;
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      {circle(.5, .75, radius, 80)}, parameters::enclosing_box(CGAL::Bbox_2(0, 0, 1, 1)));
  const double area = dsc.area(1);
  const auto length = [&] {
    double sum = 0;
    for (const auto& f : dsc.interface_facets())
      sum += dsc.measure(f);
    return sum;
  };
  const double start = length();
  double longest = 0;
  const DSC::Single_vortex_velocity_2 vortex(2);
  for (int step = 0; step < 80; ++step) {
    const Report report = DSC::advect_interface(
        dsc, vortex, step * .025, .025,
        parameters::scheme(CGAL::Deformable_simplicial_complexes::Integration_scheme::rk4));
    EXPECT_TRUE(report.complete);
    DSC::control_detail(dsc, parameters::change_interface(true).sizing_field(
                                 [=](const Position&) { return edge; }));
    ASSERT_TRUE(dsc.is_valid(true));
    EXPECT_NEAR(dsc.area(1), area, .005 * area);
    longest = (std::max)(longest, length());
  }
  EXPECT_GT(longest, 1.8 * start);
  EXPECT_NEAR(length(), start, .01 * start);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  // Single vertices beside collapsed edges have distances of up to a quarter of an edge.
  const std::vector<Position> vertices = positions(dsc);
  double sum = 0;
  for (const Position& p : vertices) {
    const double distance = std::abs(std::hypot(p.x() - .5, p.y() - .75) - radius);
    EXPECT_LT(distance, .3 * edge);
    sum += distance;
  }
  EXPECT_LT(sum, .02 * edge * double(vertices.size()));
}

// For any field, the complex stays valid and the cells fill the domain.
TEST(Planar_flows, random_fields_never_break_it) {
  std::mt19937 random(7);
  const auto any = [&](double bound) { return bound * (double(random()) / 2147483648. - 1); };
  std::size_t relabeled = 0;
  for (int run = 0; run < 4; ++run) {
    Complex dsc = make({circle(-.6, 0, .5, 32, 1), circle(.6, 0, .5, 32, 2),
                        circle(.6, 0, .2, 12, 1), circle(0, 1, .3, 16, 3)});
    double domain = 0;
    for (int label : dsc.labels())
      domain += dsc.area(label);
    for (int step = 0; step < 15; ++step) {
      const double a = any(6), b = any(6), c = any(6), d = any(6), size = .1 + any(.09);
      const Report report = DSC::advect_interface(
          dsc,
          [&](const Position& p, double) {
            return Vector(size * std::sin(a * p.x() + b * p.y() + c),
                          size * std::sin(c * p.x() + d * p.y() + a));
          },
          0, 1, parameters::largest_displacement(run % 2 == 0 ? 0. : .5));
      const Report grown = DSC::advect_interface(dsc, DSC::Normal_offset{.05}, 0, 1);
      relabeled += report.relabeled + grown.relabeled;
      ASSERT_TRUE(dsc.is_valid(true));
      double sum = 0;
      for (int label : dsc.labels())
        sum += dsc.area(label);
      EXPECT_NEAR(sum, domain, 1e-10 * domain);
    }
  }
  EXPECT_GT(relabeled, 0u);
}

// Returns a polygon with sides of a number of equal segments.
Curve polygon_of_segments(const std::vector<Point>& corners, std::size_t segments) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto side = corners[(i + 1) % corners.size()] - corners[i];
    for (std::size_t k = 0; k < segments; ++k)
      points.push_back(corners[i] + double(k) / double(segments) * side);
  }
  return polygon(points);
}

std::vector<Point> star() {
  std::vector<Point> corners;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1 : .4;
    corners.emplace_back(r * std::cos(pi * i / 5), r * std::sin(pi * i / 5));
  }
  return corners;
}

// Returns the area of a polygon after an offset, as long as no side vanishes: corners from which
// the front moves away become arcs, the others are mitered.
double area_of_round_offset(const std::vector<Point>& corners, double distance) {
  double area = 0, perimeter = 0, angles = 0, tangents = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto a = corners[i], b = corners[(i + 1) % corners.size()];
    const auto before = b - a, after = corners[(i + 2) % corners.size()] - b;
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
    perimeter += std::sqrt(before.squared_length());
    const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before * after);
    (turn * distance > 0 ? angles : tangents) +=
        turn * distance > 0 ? turn / 2 : std::tan(turn / 2);
  }
  return area + perimeter * distance + (angles + tangents) * distance * distance;
}

// Moves a polygon by an offset and compares its area with the exact one.
void expect_round_offset(const std::vector<Point>& corners, std::size_t segments, double distance,
                         int steps) {
  SCOPED_TRACE(testing::Message() << segments << " segments, " << distance << ", " << steps
                                  << " steps");
  Complex dsc = make({polygon_of_segments(corners, segments)});
  for (int i = 0; i < steps; ++i)
    DSC::advect_interface(dsc, DSC::Normal_offset{distance / steps, DSC::Corner_rule::round}, i,
                          1.);
  EXPECT_TRUE(dsc.is_valid());
  const double exact = area_of_round_offset(corners, distance);
  EXPECT_NEAR(dsc.area(1), exact, .001 * exact);
}

// By Huygens' principle, corners from which the front moves away become arcs, for any step length.
TEST(Offset_2, makes_arcs_of_corners) {
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const int steps : {1, 5, 50})
    expect_round_offset(square, 1, .05, steps);
  expect_round_offset(square, 20, -.1, 3);
  for (const int steps : {1, 20}) {
    expect_round_offset(star(), 20, .1, steps);
    expect_round_offset(star(), 20, -.1, steps);
  }
}

// Corners stay sharp in a mitered offset. Vertices of the sides that a corner passes are removed,
// for any ratio of the step and the segments.
TEST(Offset_2, keeps_sharp_corners_that_pass_vertices) {
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const std::size_t segments : {7, 20, 27, 44})
    for (const int steps : {1, 3, 10}) {
      Complex dsc = make({polygon_of_segments(square, segments)});
      for (int i = 0; i < steps; ++i) {
        const Report report = DSC::advect_interface(dsc, DSC::Normal_offset{-.05 / steps}, i, 1.);
        EXPECT_TRUE(report.complete);
        for (const auto& change : report.labels)
          EXPECT_NEAR(change.volume_after, dsc.area(change.label), 1e-12);
      }
      EXPECT_NEAR(dsc.area(1), .81, 1e-9) << segments << " segments, " << steps << " steps";
    }
}

// A segment cuts off the spike of a mitered offset.
TEST(Offset_2, cuts_off_spikes) {
  Complex dsc = make({polygon({{0, 0}, {4, -.4}, {4, .4}})});
  DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, 1.);
  double leftmost = 0;
  for (const auto v : dsc.interface_vertices())
    leftmost = (std::min)(leftmost, dsc.position(v).x());
  EXPECT_NEAR(leftmost, -.1, .01);
  EXPECT_TRUE(dsc.is_valid());
}

// Each corner of a curve is worth its turning angle, so a curve loses an area of 2 pi per unit of
// time, also if its corners are not resolved.
TEST(Curve_shortening, of_corners_loses_the_exact_area) {
  Complex dsc = make({polygon_of_segments(star(), 20)});
  const double before = dsc.area(1);
  for (int i = 0; i < 10; ++i)
    DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(), .005 * i, .005);
  EXPECT_NEAR(before - dsc.area(1), 2 * pi * .05, .01 * 2 * pi * .05);
}

} // namespace test_planar_flows
