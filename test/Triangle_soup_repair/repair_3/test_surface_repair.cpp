// Repair of surfaces that almost bound a solid.

#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Complex_construction/fill_solids_3.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/repair_surface_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace test_surface_repair {

using namespace small_surfaces;
using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;

constexpr int n = 4; // parts of an edge of a cube

void add(Surface& surface, const Point& a, const Point& b, const Point& c) {
  const std::size_t i = surface.points.size();
  surface.points.insert(surface.points.end(), {a, b, c});
  surface.triangles.push_back({i, i + 1, i + 2});
}

// A cube of 192 triangles. On each side, edges have the lengths 1/4 and 1/4 sqrt(2).
Surface cube(double x = 0) {
  Surface surface;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int a, int b) {
            double p[3];
            p[axis] = side;
            p[(axis + 1) % 3] = double(i + a) / n;
            p[(axis + 2) % 3] = double(j + b) / n;
            return Point(p[0] + x, p[1], p[2]);
          };
          const int a = side, b = 1 - side;
          add(surface, corner(0, 0), corner(a, b), corner(1, 1));
          add(surface, corner(0, 0), corner(1, 1), corner(b, a));
        }
  return surface;
}

double volume(const Surface& surface) {
  const Complex dsc = DSC::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{surface}, CGAL::Tetgen_tetrahedralizer_3());
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc.volume(surface.label);
}

template <class NP = parameters::Default_named_parameters>
void expect_refusal(const Surface& surface, Reason reason, const NP& np = NP()) {
  Surface repaired = surface;
  const auto error = thrown_by<Invalid_surface_error>([&] { DSC::repair_surface_3(repaired, np); });
  EXPECT_EQ(error.reason(), reason) << error.what();
  EXPECT_EQ(repaired.points.size(), surface.points.size()); // there may be NaN
  EXPECT_EQ(repaired.triangles, surface.triangles);
}

TEST(Surface_repair, leaves_what_bounds_a_solid) {
  Surface surface = cube();
  surface.label = 7;
  const Surface before = surface;
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_TRUE(report.was_sound());
  EXPECT_EQ(report.distance(), 0);
  EXPECT_EQ(surface.points, before.points);
  EXPECT_EQ(surface.triangles, before.triangles);
  EXPECT_EQ(surface.label, 7);
}

TEST(Surface_repair, removes_triangles_without_area) {
  Surface surface = cube();
  // An edge with an additional vertex on one side only. On the other side, a degenerate triangle
  // has its three corners on the edge.
  const auto t = surface.triangles.front();
  const Point a = surface.points[t[0]], b = surface.points[t[1]], c = surface.points[t[2]];
  const Point middle = CGAL::midpoint(a, b);
  surface.triangles.erase(surface.triangles.begin());
  add(surface, a, middle, c);
  add(surface, middle, b, c);
  add(surface, a, b, middle);
  add(surface, a, a, b);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.degenerate_triangles, 2u);
  EXPECT_EQ(report.filled_holes, 0u);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_NEAR(report.distance(), 0, 1e-15);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

TEST(Surface_repair, keeps_one_of_repeated_triangles) {
  Surface surface = cube();
  for (std::size_t t : {0, 5, 5}) {
    const auto v = surface.triangles[t];
    add(surface, surface.points[v[1]], surface.points[v[2]], surface.points[v[0]]);
  }
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.repeated_triangles, 3u);
  EXPECT_EQ(surface.triangles.size(), 192u);
  EXPECT_EQ(report.distance(), 0);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

TEST(Surface_repair, takes_walls_between_parts_away) {
  Surface surface = cube();
  const Surface neighbor = cube(1);
  for (const auto& t : neighbor.triangles)
    add(surface, neighbor.points[t[0]], neighbor.points[t[1]], neighbor.points[t[2]]);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.repeated_triangles, 64u);
  EXPECT_NEAR(volume(surface), 2, 1e-12);
}

void add_all(Surface& surface, const Surface& other, bool turned) {
  for (const auto& t : other.triangles) {
    const Point &a = other.points[t[0]], &b = other.points[t[1]], &c = other.points[t[2]];
    turned ? add(surface, a, c, b) : add(surface, a, b, c);
  }
}

TEST(Surface_repair, does_not_depend_on_orientation) {
  Surface stack = cube();
  add_all(stack, cube(1), true);
  EXPECT_EQ(DSC::repair_surface_3(stack).repeated_triangles, 64u);
  EXPECT_NEAR(volume(stack), 2, 1e-12);

  Surface turned = cube();
  add(turned, turned.points[1], turned.points[0], turned.points[2]);
  EXPECT_EQ(DSC::repair_surface_3(turned).repeated_triangles, 1u);
  EXPECT_NEAR(volume(turned), 1, 1e-12);
}

TEST(Surface_repair, keeps_one_side_of_surfaces_with_two) {
  Surface surface = cube();
  add_all(surface, cube(), true);
  EXPECT_EQ(DSC::repair_surface_3(surface).repeated_triangles, 192u);
  EXPECT_NEAR(volume(surface), 1, 1e-12);

  Surface sheet;
  add(sheet, Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0));
  add(sheet, Point(1, 0, 0), Point(0, 0, 0), Point(0, 1, 0));
  expect_refusal(sheet, Reason::open);
}

TEST(Surface_repair, keeps_small_parts) {
  Surface surface;
  for (const Point& p : cube().points)
    surface.points.emplace_back(1e4 * p.x(), 1e4 * p.y(), 1e4 * p.z());
  surface.triangles = cube().triangles;
  Surface small = cube();
  for (Point& p : small.points) // edges of one thousandth of the mean length
    p = p + Vector(2e4, 0, 0);
  small.triangles.pop_back();
  add_all(surface, small, false);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.stitched_points, 0u);
  EXPECT_EQ(report.filled_holes, 1u);
  EXPECT_EQ(surface.triangles.size(), 384u);
  EXPECT_LT(report.distance(), 1e-9);
}

TEST(Surface_repair, measures_borders_beside_the_part_that_has_them) {
  Surface surface = cube();
  surface.points.emplace_back(100, 100, 100); // in no triangle
  surface.triangles.resize(32);
  expect_refusal(surface, Reason::open);
  surface = cube();
  add(surface, Point(3, 3, 3), Point(3.2, 3, 3), Point(3, 3.2, 3));
  expect_refusal(surface, Reason::open);
}

TEST(Surface_repair, removes_walls_inside_solids) {
  Surface surface = cube();
  add(surface, Point(0, 0, 0), Point(.5, .5, .5), Point(0, 0, .25)); // on an edge of two others
  add(surface, Point(0, 0, 0), Point(.5, .5, .5), Point(.25, 0, 0));
  add(surface, Point(0, 0, .25), Point(.5, .5, .5), Point(.25, 0, 0));
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_EQ(report.removed_triangles, 3u);
  EXPECT_NEAR(report.distance_to_input, 0, 1e-15);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

TEST(Surface_repair, ends_soon_if_there_are_many_points_as_triangles) {
  Surface surface = cube();
  add_all(surface, cube(.4), false);
  for (int i = 0; i < 20000; ++i)
    surface.triangles.push_back({0, 0, 0});
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.united_parts, 2u);
  EXPECT_GT(report.mean_edge, .25);
  EXPECT_NEAR(volume(surface), 1.4, 1e-12);
}

TEST(Surface_repair, stitches_borders_that_are_near) {
  Surface surface = cube();
  for (std::size_t i = 0; i < 3; ++i) // these points belong to the first triangle only
    surface.points[i] = surface.points[i] + Vector(1e-5, -1e-5, 1e-5);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.stitched_points, 3u);
  EXPECT_EQ(report.filled_holes, 0u);
  EXPECT_EQ(surface.triangles.size(), 192u);
  EXPECT_LT(report.distance(), 2e-5);
  EXPECT_NEAR(volume(surface), 1, 1e-4);
}

TEST(Surface_repair, fills_holes) {
  Surface surface = cube();
  surface.triangles.erase(surface.triangles.begin() + 10, surface.triangles.begin() + 12);
  surface.triangles.erase(surface.triangles.begin() + 100);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.filled_holes, 2u);
  EXPECT_EQ(surface.triangles.size(), 192u);
  EXPECT_NEAR(report.distance_from_input, 0, 1e-15);
  EXPECT_GT(report.distance_to_input, .05); // at the middle of a hole
  EXPECT_LT(report.distance_to_input, .13);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

TEST(Surface_repair, turns_triangles_alike_to_fill_holes) {
  Surface surface = cube();
  for (std::size_t t = 0; t < surface.triangles.size(); t += 3)
    std::swap(surface.triangles[t][0], surface.triangles[t][1]);
  surface.triangles.pop_back();
  EXPECT_EQ(DSC::repair_surface_3(surface).filled_holes, 1u);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

TEST(Surface_repair, removes_crossings) {
  // A vertex of a face is moved through the opposite face.
  Surface surface = cube();
  for (Point& p : surface.points)
    if (p == Point(.5, .5, 1))
      p = Point(.5, .5, -.1);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_GT(report.crossing_pairs, 0u);
  EXPECT_EQ(report.united_parts, 1u);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_NEAR(report.distance(), 0, 1e-12);
  // The vertex is the apex of a pyramid about the vertical axis of the cube. The face below cuts
  // off its tip. Six triangles meet at the vertex; they cover three quarters of a square of side
  // length 1/2.
  const double pyramid = 3. / 4 * .25 * 1.1 / 3;
  EXPECT_NEAR(volume(surface), 1 - pyramid * (1 - std::pow(.1 / 1.1, 3)), 1e-12);
}

TEST(Surface_repair, wraps_what_it_is_told_to) {
  Surface surface = cube();
  const Surface other = cube(.4); // faces of both components overlap
  for (const auto& t : other.triangles)
    add(surface, other.points[t[0]], other.points[t[1]], other.points[t[2]]);
  DSC::Surface_repair_options_3 options;
  options.wrap_alpha = .5;
  options.wrap_offset = .05;
  const auto report = DSC::wrap_surface_3(surface, options);
  EXPECT_TRUE(report.is_wrapped);
  EXPECT_DOUBLE_EQ(report.alpha, .5 * report.mean_edge);
  EXPECT_DOUBLE_EQ(report.offset, .05 * report.mean_edge);
  EXPECT_LT(report.distance_to_input, 2 * report.offset);
  // the area is 2 (1.4 + 1.4 + 1); corners are cut off
  EXPECT_NEAR(volume(surface), 1.4 + 7.6 * report.offset, .03);
}

TEST(Surface_repair, refuses_sheets_and_leaves_them) {
  Surface sheet = cube();
  sheet.triangles.resize(32); // one face
  expect_refusal(sheet, Reason::open);
  Surface box = cube();
  box.triangles.erase(box.triangles.begin(), box.triangles.begin() + 32);
  expect_refusal(box, Reason::open);
  EXPECT_EQ(DSC::repair_surface_3(box, parameters::largest_hole(3.)).filled_holes, 1u);
  EXPECT_NEAR(volume(box), 1, 1e-12);
}

TEST(Surface_repair, refuses_what_is_no_surface) {
  expect_refusal(Surface(), Reason::empty);
  Surface surface = cube();
  surface.points[3] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_refusal(surface, Reason::not_finite);
  surface = cube();
  surface.triangles[3][1] = surface.points.size();
  expect_refusal(surface, Reason::bad_index);
  Surface line;
  add(line, Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0));
  Surface repaired = line;
  EXPECT_THROW(DSC::repair_surface_3(repaired), Invalid_surface_error);
  EXPECT_EQ(repaired.points, line.points);
}

TEST(Surface_repair, checks_its_parameters) {
  Surface surface = cube();
  EXPECT_THROW(DSC::repair_surface_3(surface, parameters::largest_hole(-1)), Error);
  EXPECT_THROW(DSC::repair_surface_3(surface, parameters::wrap_alpha(-1)), Error);
  EXPECT_THROW(DSC::repair_surface_3(surface, parameters::wrap_offset(0)), Error);
  DSC::Surface_repair_options_3 options;
  options.wrap_offset = 1e308;
  EXPECT_THROW(DSC::wrap_surface_3(surface, options), Error);
  options = {};
  options.wrap_alpha = 0;
  EXPECT_THROW(DSC::wrap_surface_3(surface, options), Error);
  options = {};
  options.longest_border = -1;
  EXPECT_THROW(DSC::repair_surface_3(surface, options), Error);
  for (double scale : {1e-170, 1e160}) {
    Surface extreme = cube();
    for (Point& p : extreme.points)
      p = Point(scale * p.x(), scale * p.y(), scale * p.z());
    extreme.triangles.pop_back();
    EXPECT_THROW(DSC::repair_surface_3(extreme), Error) << scale;
  }
}

TEST(Surface_repair, works_at_any_scale) {
  for (double scale : {1e-20, 1e-6, 1e6, 1e20}) {
    Surface surface = cube();
    for (Point& p : surface.points)
      p = Point(scale * p.x(), scale * p.y(), scale * p.z());
    surface.triangles.pop_back();
    const auto report = DSC::repair_surface_3(surface);
    EXPECT_EQ(report.filled_holes, 1u);
    EXPECT_LT(report.distance_from_input, 1e-12 * scale);
  }
}

Surface box(const Point& least, const Point& largest, bool turned = false) {
  Surface result;
  for (const Point& p : cube().points)
    result.points.emplace_back(least.x() + p.x() * (largest.x() - least.x()),
                               least.y() + p.y() * (largest.y() - least.y()),
                               least.z() + p.z() * (largest.z() - least.z()));
  result.triangles = cube().triangles;
  if (turned)
    for (auto& t : result.triangles)
      std::swap(t[1], t[2]);
  return result;
}

void expect_union(const std::vector<Surface>& parts, std::size_t crossing, double exact_volume) {
  Surface surface;
  for (const Surface& part : parts)
    add_all(surface, part, false);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.united_parts, crossing);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_NEAR(report.distance(), 0, 1e-15);
  EXPECT_NEAR(volume(surface), exact_volume, 1e-12);
}

TEST(Surface_repair, unites_parts_that_cross) {
  const Surface a = box(Point(0, 0, 0), Point(2, 1, 1)),
                b = box(Point(1.1, .2, .3), Point(3, 2, 1.7));
  const double both = 2 + 1.9 * 1.8 * 1.4 - .9 * .8 * .7;
  expect_union({a, b}, 2, both);
  expect_union({a, box(Point(1.1, .2, .3), Point(3, 2, 1.7), true)}, 2, both);
  // With faces in a common plane, which overlap.
  expect_union({cube(), cube(.4)}, 2, 1.4);
  // Three components at once.
  expect_union({a, b, box(Point(1.5, .5, .5), Point(1.75, .75, 3))}, 3,
               both + .25 * .25 * (3 - 1.7));
}

// A torus that overlaps itself around its axis: a regular polygon turned about an axis through it.
Surface spindle_torus(int meridians, int corners) {
  Surface surface;
  const auto point = [&](int i, int j) {
    const double a = 2 * CGAL_PI * (i % meridians) / meridians,
                 b = 2 * CGAL_PI * (j % corners) / corners, r = .4 + .5 * std::cos(b);
    return Point(r * std::cos(a), r * std::sin(a), .5 * std::sin(b));
  };
  for (int i = 0; i < meridians; ++i)
    for (int j = 0; j < corners; ++j) {
      add(surface, point(i, j), point(i + 1, j), point(i + 1, j + 1));
      add(surface, point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  return surface;
}

TEST(Surface_repair, unites_parts_that_nearly_meet_in_a_point) {
  Surface surface = spindle_torus(12, 8);
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_EQ(report.united_parts, 1u);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_NEAR(report.distance(), 0, 1e-15);
  EXPECT_NEAR(volume(surface), 1.7, .01); // nearly that of frusta of pyramids
}

TEST(Surface_repair, unites_parts_that_nearly_coincide) {
  for (double angle : {1e-15, 1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    Surface surface = cube(), turned = cube();
    for (Point& p : turned.points)
      p = Point(p.x() + angle * (p.y() - .7 * p.z()), p.y() + angle * (.3 * p.z() - p.x()),
                p.z() + angle * (.7 * p.x() - .3 * p.y()));
    append(surface, turned);
    EXPECT_FALSE(DSC::repair_surface_3(surface).is_wrapped) << angle;
    std::optional<DSC::Patches_of_surfaces_3<Point>> patches;
    const Complex dsc =
        DSC::fill_solids_3<Complex>({surface}, CGAL::Tetgen_tetrahedralizer_3(), patches);
    EXPECT_NEAR(dsc.volume(surface.label), 1, 10 * angle + 1e-7) << angle;
  }
}

TEST(Surface_repair, keeps_cavities_of_parts_that_cross) {
  const Surface a = box(Point(0, 0, 0), Point(2, 1, 1)),
                b = box(Point(1.1, .2, .3), Point(3, 2, 1.7));
  const double both = 2 + 1.9 * 1.8 * 1.4 - .9 * .8 * .7;
  for (bool turned : {false, true})
    expect_union({a, b, box(Point(.2, .2, .2), Point(.5, .5, .5), turned)}, 2, both - .027);
  // A cavity of one component into which the other one extends, and a solid inside a cavity.
  expect_union({a, b, box(Point(.2, .2, .2), Point(1.5, .5, .5))}, 3,
               both - (1.3 * .3 * .3 - .4 * .3 * .2));
  expect_union(
      {a, b, box(Point(.2, .2, .2), Point(.6, .6, .6)), box(Point(.3, .3, .3), Point(.5, .5, .5))},
      2, both - .064 + .008);
}

TEST(Surface_repair, unites_touching_parts_only_where_they_share_area) {
  // The components share a part of a face, with different triangles.
  expect_union({cube(), box(Point(1, .3, .3), Point(2, .6, .7))}, 2, 1 + .3 * .4);
  // Components that touch at vertices or edges bound a solid without repair.
  Surface corner = cube();
  add_all(corner, box(Point(1, 1, 1), Point(2, 2, 2)), false);
  EXPECT_TRUE(DSC::repair_surface_3(corner).was_sound());
  Surface edge = cube();
  add_all(edge, box(Point(1, 1, 0), Point(2, 2, 1)), false);
  EXPECT_TRUE(DSC::repair_surface_3(edge).was_sound());
}

TEST(Surface_repair, removes_fins) {
  Surface surface = cube();
  add(surface, Point(0, 0, 0), Point(.25, 0, 0), Point(0, 0, -.2)); // outside
  add(surface, Point(.25, 0, 0), Point(0, 0, 0), Point(0, 0, -.2)); // its other side
  const auto report = DSC::repair_surface_3(surface);
  EXPECT_FALSE(report.is_wrapped);
  EXPECT_NEAR(volume(surface), 1, 1e-12);
}

// The edge between two faces has an additional vertex on one side, at distance `gap` from the edge.
Surface with_t_junction(double gap) {
  Surface surface = cube();
  const auto t = surface.triangles.front();
  const Point a = surface.points[t[0]], b = surface.points[t[1]], c = surface.points[t[2]];
  const Point middle = CGAL::midpoint(a, b) + Vector(gap, gap, gap);
  surface.triangles.erase(surface.triangles.begin());
  add(surface, a, middle, c);
  add(surface, middle, b, c);
  return surface;
}

TEST(Surface_repair, closes_t_junctions) {
  for (double gap : {0., 1e-15, 1e-9, -1e-9, 1e-5}) {
    Surface surface = with_t_junction(gap);
    const auto report = DSC::repair_surface_3(surface);
    EXPECT_EQ(report.split_edges, 1u) << gap;
    EXPECT_EQ(report.filled_holes, 0u) << gap;
    EXPECT_EQ(surface.triangles.size(), 194u) << gap;
    EXPECT_NEAR(volume(surface), 1, 1e-4) << gap;
  }
  Surface wide = with_t_junction(.01); // a hole of positive width
  EXPECT_EQ(DSC::repair_surface_3(wide).filled_holes, 1u);
}

TEST(Surface_repair, fills_holes_up_to_a_length) {
  Surface surface = cube();
  surface.triangles.erase(surface.triangles.begin() + 10, surface.triangles.begin() + 12);
  DSC::Surface_repair_options_3 options;
  options.longest_border = .99;
  Surface repaired = surface;
  EXPECT_THROW(DSC::repair_surface_3(repaired, options), Invalid_surface_error);
  options.longest_border = 1.01;
  EXPECT_EQ(DSC::repair_surface_3(repaired, options).filled_holes, 1u);
}

TEST(Surface_repair, merges_vertices_that_nearly_coincide) {
  // An edge of one cube is so close to an edge of the other cube that TetGen merges them.
  Surface surface = cube();
  add_all(surface, box(Point(1 + 1e-15, 1, 0), Point(2, 2, 1)), false);
  EXPECT_TRUE(DSC::repair_surface_3(surface).was_sound());
  DSC::Surface_repair_options_3 options;
  options.merge_distance = 1e-6;
  const auto report = DSC::repair_surface_3(surface, options);
  EXPECT_EQ(report.merged_points, std::size_t(n) + 1);
  EXPECT_LT(report.distance(), 2e-15);
  EXPECT_NEAR(volume(surface), 2, 1e-12);
  options.merge_distance = -1;
  EXPECT_THROW(DSC::repair_surface_3(surface, options), Error);
}

TEST(Surface_repair, does_not_depend_on_units) {
  std::vector<Surface> broken = {cube(), with_t_junction(1e-9), cube(), cube()};
  add_all(broken[0], box(Point(.3, .2, .1), Point(2.1, 3.3, .7)), false);
  broken[2].triangles.pop_back();
  for (Point& p : broken[3].points)
    if (p == Point(.5, .5, 1))
      p = Point(.5, .5, -.1);
  for (const Surface& surface : broken) {
    Surface repaired = surface;
    DSC::repair_surface_3(repaired);
    for (int exponent : {-30, 30}) {
      const double unit = std::ldexp(1., exponent);
      Surface scaled = surface;
      for (Point& p : scaled.points)
        p = Point(unit * p.x(), unit * p.y(), unit * p.z());
      DSC::repair_surface_3(scaled);
      for (Point& p : scaled.points)
        p = Point(p.x() / unit, p.y() / unit, p.z() / unit);
      EXPECT_EQ(scaled.points, repaired.points);
      EXPECT_EQ(scaled.triangles, repaired.triangles);
    }
  }
}

TEST(Surface_repair, stops_when_asked) {
  using CGAL::Deformable_simplicial_complexes::Interrupted_error;
  using CGAL::Deformable_simplicial_complexes::Progress_scope;
  Surface surface = cube();
  add_all(surface, box(Point(.3, .2, .1), Point(2.1, 3.3, .7)), false);
  const Surface before = surface;
  const Progress_scope scope([](const char*) { return false; }, std::chrono::milliseconds(0));
  EXPECT_THROW(DSC::repair_surface_3(surface), Interrupted_error);
  EXPECT_THROW(DSC::wrap_surface_3(surface), Interrupted_error);
  EXPECT_EQ(surface.points, before.points);
  EXPECT_EQ(surface.triangles, before.triangles);
}

} // namespace test_surface_repair
