#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Complex_construction/fill_solids_3.h>
#include <CGAL/Conforming_tetrahedralizer_3.h>

namespace test_conforming {

using namespace small_surfaces;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;
using Patch = DSC::Labeled_patch_3<Point>;
using CGAL::Deformable_simplicial_complexes::Tetrahedralization_error;

// The functions are templates, because the tetrahedralizer does not compile with old versions of
// CGAL.

template <class... Input> DSC::Tetrahedralization_3 fill(const Input&... input) {
  if constexpr (DSC::has_conforming_triangulation_3)
    return CGAL::Conforming_tetrahedralizer_3()(input...);
  else
    return {};
}

template <class Input> Complex build(const Input& input) {
  Complex dsc;
  if constexpr (DSC::has_conforming_triangulation_3)
    dsc = DSC::make_deformable_simplicial_complex_3<Complex>(input,
                                                             CGAL::Conforming_tetrahedralizer_3());
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

class Conforming_tetrahedralizer : public testing::Test
{
protected:
  void SetUp() override {
    if (!DSC::has_conforming_triangulation_3)
      GTEST_SKIP() << "CGAL 6.1 or newer is needed";
  }
};

Point at(const Points& points, std::size_t i) { return {points[i][0], points[i][1], points[i][2]}; }

using Vector = Point::R::Vector_3;

Vector twice_area(const Points& points, const std::array<std::size_t, 3>& t) {
  const Point p = at(points, t[0]);
  return CGAL::cross_product(at(points, t[1]) - p, at(points, t[2]) - p);
}

// Expects that the tetrahedra fill a volume, and that the facets form the triangles.
void expect_filled(const DSC::Tetrahedralization_3& mesh, const Points& points,
                   const Triangles& triangles, double volume) {
  ASSERT_TRUE(mesh.points.size() >= points.size() &&
              std::equal(points.begin(), points.end(), mesh.points.begin()));
  double sum = 0;
  for (const auto& v : mesh.tetrahedra) {
    const Point a = at(mesh.points, v[0]), b = at(mesh.points, v[1]), c = at(mesh.points, v[2]),
                d = at(mesh.points, v[3]);
    ASSERT_EQ(CGAL::orientation(a, b, c, d), CGAL::POSITIVE);
    sum += CGAL::volume(a, b, c, d);
  }
  EXPECT_NEAR(sum, volume, 1e-12 * volume);
  ASSERT_EQ(mesh.facets.size(), mesh.triangles_of_facets.size());
  std::vector<Vector> areas(triangles.size(), CGAL::NULL_VECTOR);
  for (std::size_t i = 0; i < mesh.facets.size(); ++i)
    areas[mesh.triangles_of_facets[i]] += twice_area(mesh.points, mesh.facets[i]);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    EXPECT_LT((areas[t] - twice_area(points, triangles[t])).squared_length(), 1e-24);
}

// A prism over a polygon that is not convex, of volume 3.
const Points prism_points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0},
                             {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};

Triangles prism_triangles() {
  Triangles result = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3},  {0, 5, 4},
                      {6, 7, 8}, {6, 8, 9}, {6, 9, 10}, {6, 10, 11}};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t j = (i + 1) % 6;
    result.push_back({i, j, j + 6});
    result.push_back({i, j + 6, i + 6});
  }
  return result;
}

TEST_F(Conforming_tetrahedralizer, fills_a_nonconvex_surface_only) {
  expect_filled(fill(prism_points, prism_triangles()), prism_points, prism_triangles(), 3);
}

TEST_F(Conforming_tetrahedralizer, divides_triangles_of_rotated_thin_plate) {
  Points points;
  for (auto [x, y, z] : prism_points) {
    z *= .01;
    const double u = .8 * x - .6 * z, w = .6 * x + .8 * z;
    points.push_back({.28 * u - .96 * y, .96 * u + .28 * y, w});
  }
  const auto mesh = fill(points, prism_triangles());
  expect_filled(mesh, points, prism_triangles(), .03);
  EXPECT_GT(mesh.facets.size(), prism_triangles().size());
}

TEST_F(Conforming_tetrahedralizer, reports_triangles_that_cross) {
  Points points = prism_points;
  points[3] = {1, 1, 2};
  EXPECT_THROW(fill(points, prism_triangles()), Tetrahedralization_error);
}

TEST_F(Conforming_tetrahedralizer, makes_nested_solids_and_cavities) {
  const Complex dsc =
      build(Surfaces{box({-1, -1, -1}, {1, 1, 1}, 1), box({-.5, -.5, -.5}, {.5, .5, .5}, 2),
                     box({1.5, -1, -1}, {1.75, 1, 1}, 3)});
  EXPECT_NEAR(dsc.volume(1), 7, 1e-12);
  EXPECT_NEAR(dsc.volume(2), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(3), 1, 1e-12);
}

TEST_F(Conforming_tetrahedralizer, makes_solids_with_a_common_wall) {
  Patch left, right, wall;
  const auto a = box({0, 0, 0}, {1, 1, 1}, 1), b = box({1, 0, 0}, {2, 1, 1}, 2);
  const auto divide = [&](const Surface& s, Patch& rest) {
    rest.points = s.points;
    for (const auto& t : s.triangles)
      if (std::any_of(t.begin(), t.end(), [&](std::size_t i) { return s.points[i].x() != 1; }))
        rest.triangles.push_back(t);
      else if (&s == &a)
        wall.triangles.push_back(t);
    if (&s == &a)
      wall.points = s.points;
    rest.label_behind = s.label;
    rest.label_in_front = 0;
  };
  divide(a, left);
  divide(b, right);
  wall.label_behind = 1;
  wall.label_in_front = 2;
  const Complex dsc = build(std::vector<Patch>{left, right, wall});
  EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(2), 1, 1e-12);
}

} // namespace test_conforming
