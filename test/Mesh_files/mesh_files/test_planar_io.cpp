#include "temporary_folder.h"
#include "test.h"
#include "torus.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_2.h>
#include <CGAL/Interface_remeshing/extract_interface_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/Mesh_files/VTU_2.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_files/labeled_PNG_2.h>
#include <CGAL/Mesh_files/labeled_curves_2.h>
#include <CGAL/Mesh_files/labeled_image_2.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

#include <exception>

namespace test_planar_io {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;

Complex make(const std::vector<DSC::Labeled_curve_2<Point>>& curves) {
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(curves);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

std::vector<DSC::Labeled_curve_2<Point>> read_wkt(const std::string& text) {
  const Temporary_folder folder;
  write_bytes(folder / "a.wkt", text);
  return CGAL::IO::read_labeled_curves<Point>(folder / "a.wkt");
}

DSC::Seeded_segments_2<Point> read_poly(const std::string& text) {
  const Temporary_folder folder;
  write_bytes(folder / "a.poly", text);
  return CGAL::IO::read_seeded_segments<Point>(folder / "a.poly");
}

DSC::Labeled_image_2 read_image(const std::string& bytes) {
  const Temporary_folder folder;
  write_bytes(folder / "a.pgm", bytes);
  return CGAL::IO::read_labeled_image(folder / "a.pgm");
}

// A ring with a disk inside, a strip along the top of the box, and an isolated disk.
Complex phases() {
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      CGAL::Bbox_2(0, 0, 2, 1), .08, [](const auto& p) {
        const double ring = std::hypot(p.x() - .6, p.y() - .45),
                     disk = std::hypot(p.x() - 1.5, p.y() - .4);
        return p.y() > .9 ? 3 : disk < .2 ? 2 : ring < .15 ? 2 : ring < .35 ? 1 : 0;
      });
}

std::map<int, double> areas(const Complex& dsc) {
  std::map<int, double> result;
  for (int label : dsc.labels())
    result[label] = dsc.area(label);
  return result;
}

void expect_equal_areas(const Complex& a, const Complex& b) {
  for (const auto& [label, area] : areas(a))
    if (label != 0) {
      EXPECT_NEAR(b.area(label), area, 1e-14) << label;
    }
  EXPECT_EQ(a.labels(), b.labels());
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t i = text.find(part); i != text.npos; i = text.find(part, i + 1))
    ++result;
  return result;
}

// 3 times 2 pixels: two bits with a palette; gray values of 16 bits; one color.
const char palette_png[] =
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x03\x00"
    "\x00\x00\x02\x02\x03\x00\x00\x00\xe0\x1a\x8e\x89\x00\x00\x00\x0c\x50\x4c\x54\x45\x00"
    "\x00\x00\xff\x00\x00\x00\xff\x00\x09\x09\x09\x11\x0d\xc4\x33\x00\x00\x00\x0c\x49\x44"
    "\x41\x54\x78\xda\x63\x90\x60\x38\x02\x00\x01\x10\x00\xdd\x2f\x18\xdc\x8e\x00\x00\x00"
    "\x00\x49\x45\x4e\x44\xae\x42\x60\x82";
const char gray_png[] =
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02\x00"
    "\x00\x00\x01\x10\x00\x00\x00\x00\x81\xd9\xfc\x15\x00\x00\x00\x0d\x49\x44\x41\x54\x78"
    "\xda\x63\x60\x60\x9d\xe3\x00\x00\x01\x8c\x00\xe2\xc8\x63\x52\x0c\x00\x00\x00\x00\x49"
    "\x45\x4e\x44\xae\x42\x60\x82";
const char color_png[] =
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x01\x00"
    "\x00\x00\x01\x08\x02\x00\x00\x00\x90\x77\x53\xde\x00\x00\x00\x0c\x49\x44\x41\x54\x78"
    "\xda\x63\x60\x64\x62\x06\x00\x00\x0e\x00\x07\xe9\x92\x37\xd4\x00\x00\x00\x00\x49\x45"
    "\x4e\x44\xae\x42\x60\x82";

template <std::size_t size>
DSC::Labeled_image_2 read_png(const char (&bytes)[size], std::size_t length = size - 1) {
  const Temporary_folder folder;
  write_bytes(folder / "a.png", std::string(bytes, length));
  return CGAL::IO::read_labeled_PNG(folder / "a.png");
}

TEST(Labeled_PNG, has_labels_as_gray_values_or_indices) {
  const auto image = read_png(palette_png);
  EXPECT_EQ(image.width, 3u);
  EXPECT_EQ(image.height, 2u);
  EXPECT_EQ(image.labels, (std::vector<int>{0, 1, 2, 3, 0, 1}));
  EXPECT_EQ(read_png(gray_png).labels, (std::vector<int>{5, 40000}));
}

TEST(Labeled_PNG, refuses_colors_and_what_is_damaged) {
  using CGAL::Deformable_simplicial_complexes::File_error;
  EXPECT_THROW(read_png(color_png), File_error);
  for (std::size_t length = 0; length < 80; ++length)
    EXPECT_THROW(read_png(palette_png, length), File_error) << length;
  EXPECT_THROW(CGAL::IO::read_labeled_PNG("no such file.png"), File_error);
}

TEST(Labeled_PNG, passes_on_what_callbacks_throw) {
  using CGAL::Deformable_simplicial_complexes::Progress_scope;
  const Progress_scope scope([](const char*) -> bool { throw std::runtime_error("of the user"); },
                             std::chrono::milliseconds(0));
  std::string told;
  try {
    read_png(palette_png);
  } catch (const std::exception& error) {
    told = error.what();
  }
  EXPECT_EQ(told, "of the user");
}

// Rounding makes its area zero.
TEST(Extract_polygons, knows_outer_boundaries_exactly) {
  DSC::Labeled_curve_2<Point> curve;
  curve.add_polyline(std::vector<Point>{Point(1000.0219146334566, 1000.6913223492447),
                                        Point(1000.5913591883145, 1001.6250651841983),
                                        Point(1000.322820012226, 1001.1847298970524)});
  const auto dsc =
      DSC::make_deformable_simplicial_complex_2<Complex>({curve}, CGAL::parameters::improve(false));
  const auto polygons = DSC::extract_polygons(dsc, 1);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].outer_boundary().size(), 3u);
  EXPECT_EQ(polygons[0].number_of_holes(), 0u);
  const Temporary_folder folder;
  CGAL::IO::write_WKT(folder / "a.wkt", dsc);
  EXPECT_EQ(CGAL::IO::read_labeled_curves<Point>(folder / "a.wkt").size(), 1u);
  EXPECT_TRUE(DSC::extract_polygons(dsc, 7).empty());
}

TEST(Extract_interface_2, between_two_labels) {
  const Complex dsc = phases();
  EXPECT_EQ(DSC::extract_interface(dsc).segments.size(),
            DSC::extract_interface(dsc, 0, 1).segments.size() +
                DSC::extract_interface(dsc, 0, 2).segments.size() +
                DSC::extract_interface(dsc, 2, 1).segments.size() +
                DSC::extract_interface(dsc, 0, 3).segments.size());
  EXPECT_TRUE(DSC::extract_interface(dsc, 1, 3).segments.empty());
}

TEST(Make_complex_2, refuses_what_is_not_finite_or_empty) {
  using CGAL::Deformable_simplicial_complexes::Error;
  using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
  for (double x : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(
                     {Point(0, 0), Point(1, 0), Point(x, 1)}, {{0, 1, 2}}, {0}),
                 Invalid_cells_error);
  const double inf = std::numeric_limits<double>::infinity();
  for (const CGAL::Bbox_2& box :
       {CGAL::Bbox_2(), CGAL::Bbox_2(1, 1, 0, 0), CGAL::Bbox_2(0, 0, 1, 0),
        CGAL::Bbox_2(0, 0, inf, 1), CGAL::Bbox_2(0, 0, 1 << 19, 1 << 19)})
    EXPECT_THROW(
        DSC::make_deformable_simplicial_complex_2<Complex>(box, 1, [](const auto&) { return 0; }),
        Error);
}

TEST(Make_complex_2, takes_polylines_that_repeat_their_first_point) {
  DSC::Labeled_curve_2<Point> curve;
  curve.add_polyline(std::vector<Point>{Point(0, 0), Point(1, 0), Point(0, 1), Point(0, 0)});
  EXPECT_EQ(curve.points.size(), 3u);
  EXPECT_NEAR(DSC::make_deformable_simplicial_complex_2<Complex>({curve}).area(1), .5, 1e-15);
}

TEST(Wkt, in_other_dialects) {
  EXPECT_EQ(read_wkt("\xef\xbb\xbfpolygon ((0 0, 1 0, 0 1, 0 0))").size(), 1u);
  EXPECT_TRUE(read_wkt("polygon empty").empty());
  EXPECT_TRUE(read_wkt("MULTIPOLYGON (EMPTY, Empty)").empty());
  EXPECT_THROW(read_wkt("POLYGON Z ((0 0 0, 1 0 0, 0 1 0, 0 0 0))"), File_error);
}

TEST(Poly, is_in_the_plane) {
  EXPECT_THROW(read_poly("3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1\n1 1 2\n0\n"), File_error);
}

TEST(Svg, refuses_windows_that_are_none) {
  using CGAL::Deformable_simplicial_complexes::Error;
  const Temporary_folder folder;
  const Complex dsc = phases();
  const double inf = std::numeric_limits<double>::infinity();
  for (const CGAL::Bbox_2& window :
       {CGAL::Bbox_2(1, 1, 0, 0), CGAL::Bbox_2(0, 0, 0, 1), CGAL::Bbox_2(0, 0, std::nan(""), 1),
        CGAL::Bbox_2(0, 0, inf, 1), CGAL::Bbox_2(0, 0, 1e-9, 1)}) {
    CGAL::IO::SVG_options options;
    options.window = window;
    EXPECT_THROW(CGAL::IO::write_SVG(folder / "a.svg", dsc, options), Error) << window;
  }
  CGAL::IO::SVG_options options;
  options.width = inf;
  EXPECT_THROW(CGAL::IO::write_SVG(folder / "a.svg", dsc, options), Error);
  options.width = 100;
  options.window = CGAL::Bbox_2(.5, .4, .5 + 1e-100, .4 + 1e-100);
  EXPECT_THROW(CGAL::IO::write_SVG(folder / "a.svg", dsc, options), Error); // empty by rounding
}

TEST(Polygons_2, have_the_holes_of_the_regions) {
  const Complex dsc = phases();
  const auto ring = DSC::extract_polygons(dsc, 1);
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_EQ(ring[0].number_of_holes(), 1u);
  EXPECT_EQ(DSC::extract_polygons(dsc, 2).size(), 2u);
  EXPECT_EQ(DSC::extract_polygons(dsc, 0)[0].number_of_holes(), 2u);
  EXPECT_TRUE(DSC::extract_polygons(dsc, 7).empty());
  for (const auto& [label, area] : areas(dsc)) {
    double sum = 0;
    for (const auto& polygon : DSC::extract_polygons(dsc, label)) {
      EXPECT_TRUE(polygon.outer_boundary().is_simple());
      sum += polygon.outer_boundary().area();
      for (const auto& hole : polygon.holes())
        sum += hole.area();
    }
    EXPECT_NEAR(sum, area, 1e-13);
  }
}

// Two squares of one label that touch at a corner, within a frame of another label. The region
// between the squares and the frame is pinched there.
TEST(Polygons_2, of_pinched_regions_pass_no_vertex_twice) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  for (std::size_t i = 0; i <= 4; ++i)
    for (std::size_t j = 0; j <= 4; ++j)
      points.emplace_back(double(i), double(j));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const std::size_t a = 5 * i + j, b = a + 5, c = b + 1, d = a + 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, d, c}); // clockwise
      labels.insert(labels.end(), 2, (i == 1 && j == 1) || (i == 2 && j == 2) ? 1 : 0);
    }
  const auto dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      points, triangles, labels, CGAL::parameters::improve(false));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_EQ(DSC::extract_polygons(dsc, 1).size(), 2u);
  const auto outside = DSC::extract_polygons(dsc, 0);
  ASSERT_EQ(outside.size(), 1u);
  for (const auto& hole : outside[0].holes())
    EXPECT_TRUE(hole.is_simple());
  EXPECT_EQ(outside[0].number_of_holes(), 2u);
  const Temporary_folder folder;
  CGAL::IO::write_WKT(folder / "a.wkt", dsc);
  expect_equal_areas(dsc, make(CGAL::IO::read_labeled_curves<Point>(folder / "a.wkt")));
}

TEST(Interface_2, of_a_torus_is_unwrapped) {
  const auto disk = DSC::fill_torus<torus::Complex>(torus::Domain({1, 1}), .06, [](const auto& p) {
    return std::hypot(std::remainder(p.x(), 1.), std::remainder(p.y(), 1.)) < .3 ? 1 : 0;
  });
  const auto circle = DSC::extract_interface(disk);
  EXPECT_EQ(circle.points.size(), circle.segments.size());
  double area = 0;
  for (const auto& [a, b] : circle.segments) {
    EXPECT_LT(CGAL::squared_distance(circle.points[a], circle.points[b]), .01);
    area += CGAL::determinant(circle.points[a] - CGAL::ORIGIN, circle.points[b] - CGAL::ORIGIN) / 2;
  }
  EXPECT_NEAR(area, disk.area(1), 1e-13);

  // A strip around the torus: each of its two sides is cut open.
  const auto strip = torus::grid(8, [](const auto& p) { return p.y() > .5 ? 1 : 0; });
  const auto sides = DSC::extract_interface(strip);
  EXPECT_EQ(sides.segments.size(), 16u);
  EXPECT_EQ(sides.points.size(), 18u);
  EXPECT_EQ(sides.vertices.size(), 18u);
  for (const auto& [a, b] : sides.segments)
    EXPECT_NEAR(CGAL::squared_distance(sides.points[a], sides.points[b]), 1. / 64, 1e-15);
}

TEST(Well_known_text, comes_back) {
  const Temporary_folder folder;
  const Complex dsc = phases();
  CGAL::IO::write_WKT(folder / "a.wkt", dsc);
  const auto curves = CGAL::IO::read_labeled_curves<Point>(folder / "a.wkt");
  EXPECT_EQ(curves.size(), 3u);
  expect_equal_areas(dsc, make(curves));
}

TEST(Well_known_text, of_all_kinds) {
  const auto curves = read_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1,2 1,2 2,1 2,1 1))\n\n"
                               "multipolygon(((5 0,6 0,6 1,5 0)),((5 2,6 2,6 3,5 2)))"
                               "LINESTRING (7 0, 8 0, 8 1e0, 7 0)  POLYGON EMPTY\n");
  ASSERT_EQ(curves.size(), 3u);
  const Complex dsc = make(curves);
  EXPECT_NEAR(dsc.area(1), 15, 1e-13);
  EXPECT_NEAR(dsc.area(2), 1, 1e-13);
  EXPECT_NEAR(dsc.area(3), .5, 1e-13);
  EXPECT_EQ(dsc.number_of_components(2), 2u);
  EXPECT_THROW(read_wkt(""), File_error);
  EXPECT_TRUE(read_wkt("POLYGON EMPTY").empty());
  EXPECT_THROW(make({}), Error);
}

TEST(Well_known_text, of_regions_with_common_borders) {
  const Complex dsc =
      make(read_wkt("POLYGON((0 0,1 0,1 1,0 1,0 0))\nPOLYGON((1 0,2 0,2 1,1 1,1 0))\n"
                    "POLYGON((.25 .25,.75 .25,.75 .75,.25 .75,.25 .25))"));
  EXPECT_NEAR(dsc.area(1), .75, 1e-14);
  EXPECT_NEAR(dsc.area(2), 1, 1e-14);
  EXPECT_NEAR(dsc.area(3), .25, 1e-14);
  // Boundaries that coincide only partially
  EXPECT_THROW(make(read_wkt("POLYGON((0 0,1 0,1 1,0 1,0 0))\nPOLYGON((1 0,2 0,2 2,1 2,1 0))")),
               Invalid_surface_error);
}

TEST(Well_known_text, is_refused_with_its_line) {
  for (const std::string text :
       {"POINT(1 1", "POLYGON", "POLYGON((0 0,1 0,1 1", "POLYGON((0 0,1 0,1 1,0 1))",
        "POLYGON((0 0,1 0,0 0))", "POLYGON((0 0,x 0,1 1,0 0))", "POLYGON((0 0,1e999 0,1 1,0 0))",
        "LINESTRING(0 0,1 0)", "1 2 3", "POLYGON((0 0 0,1 0 0,1 1 0,0 0 0))"}) {
    try {
      read_wkt("\n" + text);
      ADD_FAILURE() << text;
    } catch (const File_error& error) {
      EXPECT_PRED2(contains, std::string(error.what()), "line 2") << error.what();
    }
  }
  EXPECT_THROW(CGAL::IO::read_labeled_curves("nowhere.wkt"), File_error);
}

TEST(Poly, comes_back) {
  const Temporary_folder folder;
  const Complex dsc = phases();
  CGAL::IO::write_poly(folder / "a.poly", dsc);
  const auto segments = CGAL::IO::read_seeded_segments<Point>(folder / "a.poly");
  EXPECT_EQ(segments.seeds.size(), 4u);
  expect_equal_areas(dsc, DSC::make_deformable_simplicial_complex_2<Complex>(segments));
}

// A file like the examples of Triangle: indices from 1, markers, comments, a hole and no region.
TEST(Poly, of_triple_points_and_dangling_segments) {
  const auto segments = read_poly("# comment\n5 2 1 1\n1 0 0 9 1\n2 2 0 9 1\n3 2 2 9 1\n4 0 2 9 1\n"
                                  "5 1 1 9 0\n6 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n"
                                  "5 1 3 0\n6 5 2 0\n1\n1 1.5 .1\n1\n1 .1 1.5 7 -1\n");
  ASSERT_EQ(segments.segments.size(), 6u);
  EXPECT_EQ(segments.segments[0], (std::array<std::size_t, 2>{0, 1}));
  ASSERT_EQ(segments.seeds.size(), 2u);
  EXPECT_EQ(segments.seeds[0].second, 0);
  EXPECT_EQ(segments.seeds[1].second, 7);
  // The diagonal passes through point 5, where it should end.
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(segments), Invalid_surface_error);
  auto divided = segments;
  divided.segments[4] = {0, 4};
  divided.segments.push_back({4, 2});
  const auto dsc = DSC::make_deformable_simplicial_complex_2<Complex>(divided);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(7), 2, 1e-14);
}

TEST(Poly, with_seeds_that_contradict_each_other_is_refused) {
  auto segments = read_poly("3 2\n0 0 0\n1 1 0\n2 0 1\n3\n0 0 1\n1 1 2\n2 2 0\n0\n");
  EXPECT_TRUE(segments.seeds.empty());
  const auto build = [&] { return DSC::make_deformable_simplicial_complex_2<Complex>(segments); };
  EXPECT_NEAR(build().area(1), .5, 1e-15);
  segments.seeds = {{Point(.2, .2), 1}, {Point(.3, .3), 1}};
  EXPECT_NEAR(build().area(1), .5, 1e-15);
  segments.seeds.push_back({Point(.1, .1), 2});
  EXPECT_THROW(build(), Error);
  segments.seeds = {{Point(.5, 0), 1}};
  EXPECT_THROW(build(), Error);
  segments.seeds = {{Point(9, 9), 1}};
  EXPECT_THROW(build(), Error);
  segments.seeds = {{Point(NAN, 9), 1}};
  EXPECT_THROW(build(), Error);
}

TEST(Poly, is_refused_where_it_is_damaged) {
  for (const std::string text : {"", "0 2\n", "x", "1 2\n5 0 0\n", "2 2\n0 0 0\n7 1 1\n0\n0\n",
                                 "1 2\n0 0 inf\n0\n0\n", "1 2\n0 0 0\n1\n0 0 4\n0\n",
                                 "1 2\n0 0 0\n0\n0\n1\n0 1 1 1.5\n", "99999999999999999999 2\n"})
    EXPECT_THROW(read_poly(text), File_error) << text;
}

TEST(Labeled_image, of_text_and_bytes) {
  const auto text = read_image("P2\n# comment\n3 2 # size\n300\n0 1 2\n3 4 300");
  EXPECT_EQ(text.labels, (std::vector<int>{0, 1, 2, 3, 4, 300}));
  EXPECT_EQ(text(Point(.5, .5)), 3);
  EXPECT_EQ(text(Point(2.5, 1.5)), 2);
  EXPECT_EQ(text(Point(-9, 9)), 0);
  EXPECT_EQ(read_image(std::string("P5 2 1 255\n\1\2", 13)).labels, (std::vector<int>{1, 2}));
  EXPECT_EQ(read_image(std::string("P5 1 1 999\n\1\2", 13)).labels, (std::vector<int>{258}));
  for (const std::string bytes :
       {"", "P6 1 1 255\n\1\1\1", "P5 2 2 255\n\1", "P2 2 2 255\n1 2 3", "P2 0 1 1\n",
        "P5 1048577 1 255\n", "P2 1 1 9\n10", "P5", "P5 1 1 5\n\x09", "P5 1 1 255#\1", "P21 1 5 3"})
    EXPECT_THROW(read_image(bytes), File_error) << bytes;
}

TEST(Labeled_image, becomes_a_complex) {
  DSC::Labeled_image_2 image;
  image.width = image.height = 20;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      image.labels.push_back(std::hypot(column - 9.5, row - 9.5) < 6 ? 4 : 0);
  const auto dsc = DSC::make_deformable_simplicial_complex_2<Complex>(image.bbox(), 1, image);
  EXPECT_TRUE(dsc.is_valid(true));
  const double pixels = double(std::count(image.labels.begin(), image.labels.end(), 4));
  EXPECT_NEAR(dsc.area(4), pixels, .03 * pixels);
  EXPECT_NEAR(dsc.area(0) + dsc.area(4), 400, 1e-11);
}

TEST(Svg, has_a_region_for_each_color) {
  const Temporary_folder folder;
  const Complex dsc = phases();
  CGAL::IO::write_SVG(folder / "a.svg", dsc, CGAL::IO::SVG_options(), [&](auto c) {
    return std::string(dsc.label(c) == 1 ? "#ff0000" : "#0000ff");
  });
  const std::string text = file_bytes(folder / "a.svg");
  EXPECT_EQ(count(text, "<path id=\"color_ff0000\" fill=\"#ff0000\""), 1u);
  EXPECT_EQ(count(text, "<path id=\"color_0000ff\" fill=\"#0000ff\""), 1u);
  EXPECT_EQ(count(text, "<path id=\"label"), 0u);
}

TEST(Svg, has_a_region_for_each_label) {
  const Temporary_folder folder;
  CGAL::IO::SVG_options options;
  options.draws_edges = true;
  CGAL::IO::write_SVG(folder / "a.svg", phases(), options);
  const std::string text = file_bytes(folder / "a.svg");
  for (const std::string id : {"label_0", "label_1", "label_2", "label_3", "edges", "interface"})
    EXPECT_EQ(count(text, "id=\"" + id + '"'), 1u) << id;
  EXPECT_EQ(count(text, "width=\"800\" height=\"400\""), 1u);
  EXPECT_EQ(folder.number_of_files(), 1);
  options.width = 0;
  EXPECT_THROW(CGAL::IO::write_SVG(folder / "a.svg", phases(), options), Error);
  EXPECT_THROW(CGAL::IO::write_SVG(folder / "a.svg", Complex()), Error);
  EXPECT_THROW(CGAL::IO::write_SVG(folder / "none/a.svg", phases()), File_error);
}

// Each triangle is drawn once in the box of the torus. Triangles across a seam are drawn on both
// sides.
TEST(Svg, of_a_torus_is_periodic) {
  const Temporary_folder folder;
  const std::size_t n = 8;
  CGAL::IO::write_SVG(folder / "a.svg", torus::grid(n, [](const auto&) { return 0; }));
  const std::size_t drawn = count(file_bytes(folder / "a.svg"), "Z");
  EXPECT_GE(drawn, 2 * n * n);
  EXPECT_LE(drawn, 2 * (n + 2) * (n + 2));
}

TEST(Vtu_2, has_images_of_vertices_across_the_seam) {
  const Temporary_folder folder;
  CGAL::IO::write_VTU(folder / "a.vtu", phases());
  const auto dsc = torus::grid(4, [](const auto& p) { return p.x() > .5 ? 1 : 0; });
  CGAL::IO::write_VTU(folder / "t.vtu", dsc);
  CGAL::IO::write_interface_VTU(folder / "i.vtu", dsc);
  EXPECT_EQ(count(file_bytes(folder / "t.vtu"), "NumberOfCells=\"32\""), 1u);
  EXPECT_EQ(count(file_bytes(folder / "t.vtu"), "NumberOfPoints=\"16\""), 0u);
  EXPECT_EQ(count(file_bytes(folder / "i.vtu"), "NumberOfCells=\"8\""), 1u);
}

TEST(Checkpoint_2, continues_to_the_same_bits) {
  const Temporary_folder folder;
  Complex dsc = phases();
  const DSC::Normal_offset offset{.02};
  DSC::advect_interface(dsc, offset, 0, 1);
  CGAL::IO::write_checkpoint(folder / "a.dsc", dsc.state(), "what it was");
  const auto checkpoint = CGAL::IO::read_checkpoint_2(folder / "a.dsc");
  EXPECT_EQ(checkpoint.metadata, "what it was");
  Complex again;
  again.restore(checkpoint.state);
  DSC::advect_interface(dsc, offset, 0, 1);
  DSC::advect_interface(again, offset, 0, 1);
  EXPECT_TRUE(dsc.state() == again.state());
  EXPECT_EQ(CGAL::IO::checkpoint_dimension(folder / "a.dsc"), 2);
  EXPECT_THROW(CGAL::IO::read_checkpoint(folder / "a.dsc"), File_error);

  const auto dsc_on_torus = torus::grid(5, [](const auto& p) { return p.x() > .5 ? 1 : 0; });
  CGAL::IO::write_checkpoint(folder / "t.dsc", dsc_on_torus.state());
  torus::Complex restored;
  restored.restore(CGAL::IO::read_checkpoint_2(folder / "t.dsc").state);
  EXPECT_TRUE(restored.state() == dsc_on_torus.state());
  EXPECT_THROW(Complex().restore(dsc_on_torus.state()), Error);
}

} // namespace test_planar_io
