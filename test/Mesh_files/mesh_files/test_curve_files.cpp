#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/Unused_content.h>
#include <CGAL/Mesh_files/labeled_curves_2.h>
#include <CGAL/Mesh_files/labeled_image_2.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

// Interpretation of curve files, and content that is rejected or reported as unused.

namespace test_curve_files {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::File_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using CGAL::Deformable_simplicial_complexes::Unused_content;

DSC::Seeded_segments_2<Point> read_poly(const std::string& text, Unused_content* unused = nullptr,
                                        const std::string& node = "") {
  const Temporary_folder folder;
  write_bytes(folder / "a.poly", text);
  if (!node.empty())
    write_bytes(folder / "a.node", node);
  return CGAL::IO::read_seeded_segments<Point>(folder / "a.poly", unused);
}

std::vector<DSC::Labeled_curve_2<Point>> read_wkt(const std::string& text,
                                                  Unused_content* unused = nullptr) {
  const Temporary_folder folder;
  write_bytes(folder / "a.wkt", text);
  return CGAL::IO::read_labeled_curves<Point>(folder / "a.wkt", unused);
}

template <class Input> Complex make(const Input& input) {
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(input);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

template <class Function> std::string message_of(Function&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_PRED2(contains, text, part);
}

// A square of side length 4 with a square of side length 2 inside.
const std::string squares = "8 2\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 3 1\n7 3 3\n8 1 3\n"
                            "8\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n";

TEST(Poly, without_regions_has_label_1_but_in_holes) {
  EXPECT_NEAR(make(read_poly(squares + "0\n")).area(1), 16, 1e-12);
  EXPECT_NEAR(make(read_poly(squares + "0\n0\n")).area(1), 16, 1e-12);
  const Complex ring = make(read_poly(squares + "1\n1 2 2\n"));
  EXPECT_NEAR(ring.area(1), 12, 1e-12);
  EXPECT_EQ(ring.euler_characteristic(1), 0);
  const Complex outside = make(read_poly(squares + "1\n1 9 9\n")); // the point (9, 9) is outside
  EXPECT_NEAR(outside.area(1), 16, 1e-12);
}

TEST(Poly, with_regions_has_their_labels_and_holes) {
  const Complex dsc = make(read_poly(squares + "1\n1 2 2\n1\n1 .5 .5 7 .1\n"));
  EXPECT_NEAR(dsc.area(7), 12, 1e-12);
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 7}));
  expect_part(message_of([] { make(read_poly(squares + "1\n1 2 2\n1\n1 2.5 2 7\n")); }),
              "(2.5, 2)");
}

TEST(Poly, names_what_is_not_used) {
  Unused_content unused;
  read_poly("4 2 2 1\n0 0 0 5 6 1\n1 1 0 5 6 1\n2 0 1 5 6 0\n3 9 9 5 6 0\n3 1\n0 0 1 2\n1 1 2 2\n"
            "2 2 0 2\n0\n1\n0 .2 .2 3 .01\nmore\n",
            &unused);
  const std::map<std::string, std::size_t> expected = {{"area constraints", 1},
                                                       {"boundary markers", 7},
                                                       {"lines at the end", 1},
                                                       {"point attributes", 8},
                                                       {"points without segments", 1}};
  EXPECT_EQ(unused.numbers(), expected);
  Unused_content none;
  read_poly(squares + "0\n1\n1 2 2 1 0\n", &none);
  EXPECT_TRUE(none.empty()) << none.text();
}

TEST(Poly, may_have_its_points_in_another_file) {
  const std::string segments = "0 2 0 0\n3\n1 1 2\n2 2 3\n3 3 1\n0\n";
  EXPECT_NEAR(make(read_poly(segments, nullptr, "3 2\n1 0 0\n2 2 0\n3 0 2\n")).area(1), 2, 1e-12);
  expect_part(message_of([&] { read_poly(segments); }), "a.node");
  EXPECT_THROW(read_poly(segments, nullptr, "0 2\n"), File_error);
}

TEST(Poly, is_read_by_lines) {
  for (const std::string text :
       {"3 2\n1 0\n0 2 1\n0 3 0 1\n", "3 2\n1 0 0\n2 1 0\n3 0 1\n3\n1 1 2\n2 2\n3 3 1\n0\n",
        "3 2\n1 0 0\n2 1 0\n3 0 1\n3\n1 1 2\n2 2 3\n3 3 1\n0\n1\n1 .2 .2\n",
        "3 2\n1 0 0\n2 1 0\n3 0 1\n3\n1 1 2\n2 2 3\n3 3 1\n0\n1\n1 .2 .2 2.5\n",
        "3 2\n1 0 0\n2 1 0\n3 0 1\n0\n0\n"})
    EXPECT_THROW(read_poly(text), File_error) << text;
}

TEST(Wkt, refuses_polygons_that_are_none) {
  const std::string outside =
      message_of([] { read_wkt("\nPOLYGON ((0 0, 1 0, 1 1, 0 0),\n(2 0, 3 0, 3 1, 2 0))"); });
  expect_part(outside, "line 3");
  expect_part(outside, "hole");
  const std::string shell = "(0 0, 9 0, 9 9, 0 9, 0 0)", hole = "(1 1, 8 1, 8 8, 1 8, 1 1)",
                    inner = "(2 2, 7 2, 7 7, 2 7, 2 2)";
  for (const std::string& text :
       {"POLYGON (" + shell + ", " + hole + ", " + inner + ")",
        "POLYGON (" + hole + ", " + shell + ")", "MULTIPOLYGON ((" + shell + "), (" + inner + "))",
        "MULTIPOLYGON ((" + shell + "), (" + inner + ", " + hole + "))",
        std::string("POLYGON ((0 0 1, 1 0 1, 1 1 1, 0 0 1))"),
        std::string("POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))"),
        std::string("LINESTRING (0 0, 1 0, 1 1)"), std::string("CIRCULARSTRING (0 0, 1 0, 0 0)"),
        std::string("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 0))"),
        std::string("POINT (1 2"), std::string("SRID=4326 POLYGON EMPTY")})
    EXPECT_THROW(read_wkt(text), File_error) << text;
  const auto island = read_wkt("MULTIPOLYGON ((" + shell + ", " + hole + "), (" + inner + "))");
  EXPECT_NEAR(make(island).area(1), 81 - 49 + 25, 1e-12);
  std::string deep;
  for (int i = 0; i < 100000; ++i)
    deep += "GEOMETRYCOLLECTION (";
  EXPECT_THROW(read_wkt(deep), File_error);
}

TEST(Wkt, tells_where_curves_cross) {
  const std::string self =
      message_of([] { make(read_wkt("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")); });
  expect_part(self, "intersects itself at its segment from (0, 0) to (2, 2)");
  const std::string overlap = message_of([] {
    make(read_wkt("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((1 1, 3 1, 3 3, 1 3, 1 1)))"));
  });
  expect_part(overlap, "itself at its segment from");
}

TEST(Wkt, may_be_collections_with_points_and_prefixes) {
  Unused_content unused;
  const auto curves = read_wkt(
      "srid=4326;GeometryCollection (point (1 2), polygon ((0 0, 1 0, 1 1, 0 0)), POINT EMPTY,\n"
      "geometrycollection (Triangle ((2 0, 3 0, 3 1, 2 0))), multipoint z ((1 2 3), (4 5 6)));\n"
      "MULTIPOLYGON (EMPTY, EMPTY) linestring (5 0, 6 0, 6 1, 5 0)",
      &unused);
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[2].label, 3);
  EXPECT_NEAR(make(curves).area(2), .5, 1e-12);
  const std::map<std::string, std::size_t> expected = {
      {"empty geometries", 2}, {"points", 3}, {"spatial reference systems", 1}};
  EXPECT_EQ(unused.numbers(), expected);
}

TEST(Pgm, names_what_comes_after_its_pixels) {
  const Temporary_folder folder;
  write_bytes(folder / "a.pgm", "P2 2 1 9\n1 2\nP2 1 1 9\n3");
  Unused_content unused;
  CGAL::IO::read_labeled_image(folder / "a.pgm", &unused);
  EXPECT_EQ(unused.text(), "10 bytes after the pixels");
}

// Scaling the curves by a power of two scales the complex and does not change its triangles.
TEST(Curves, have_no_unit) {
  const auto of_scale = [](double scale) {
    std::ostringstream text;
    text.precision(17);
    const auto at = [&](double x, double y) { text << x * scale << ' ' << y * scale; };
    text << "POLYGON ((";
    at(0, 0);
    for (int i = 1; i < 20; ++i) {
      text << ", ";
      at(i, i % 3);
    }
    text << ", ";
    at(9, 12);
    text << ", ";
    at(0, 0);
    text << "))";
    return make(read_wkt(text.str()));
  };
  const Complex one = of_scale(1);
  for (double scale : {std::ldexp(1, -30), std::ldexp(1, 30), 1e-9, 1e-4, 1e4, 1e9}) {
    const Complex other = of_scale(scale);
    // Rounding decides which of several equal edges at a thin part is split.
    EXPECT_NEAR(double(other.number_of_cells()), double(one.number_of_cells()),
                .01 * double(one.number_of_cells()));
    EXPECT_NEAR(other.area(1) / (scale * scale), one.area(1), 1e-3 * one.area(1));
    if (int exponent; std::frexp(scale, &exponent) != .5)
      continue;
    const auto vertices = one.vertices(), others = other.vertices();
    ASSERT_EQ(vertices.size(), others.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      EXPECT_EQ(others[i]->point().x(), scale * vertices[i]->point().x());
      EXPECT_EQ(others[i]->point().y(), scale * vertices[i]->point().y());
    }
  }
}

} // namespace test_curve_files
