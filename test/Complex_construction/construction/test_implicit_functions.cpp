#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>

namespace test_implicit_functions {

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using CGAL::Deformable_simplicial_complexes::Error;

constexpr double pi = 3.14159265358979323846;

template <class Label_at>
Complex make(const CGAL::Bbox_3& box, double edge, const Label_at& label_at) {
  return DSC::make_deformable_simplicial_complex_3<Complex>(box, edge, label_at);
}

TEST(Make_complex_in_a_box, fills_it_exactly) {
  const Complex dsc = make(CGAL::Bbox_3(-1, 0, 2, 1, 3, 3), .5, [](const Point&) { return 0; });
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(0), 6, 1e-13);
  EXPECT_GE(dsc.number_of_cells(), 6u * 4 * 2 * 6);
  EXPECT_EQ(dsc.interface_facets().size(), 0u);
}

TEST(Make_complex_in_a_box, of_a_torus) {
  const auto is_inside = [](const Point& p) {
    const double q = std::hypot(p.x(), p.y()) - 1;
    return q * q + p.z() * p.z() < .16 ? 1 : 0;
  };
  const double volume = 2 * pi * pi * .16;
  double last = 1;
  for (double edge : {.25, .125}) {
    const Complex dsc = make(CGAL::Bbox_3(-2, -2, -1, 2, 2, 1), edge, is_inside);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_EQ(dsc.euler_characteristic(1), 0);
    const double error = std::abs(dsc.volume(1) / volume - 1);
    EXPECT_LT(error, .3 * last); // proportional to the square of the edge length
    last = error;
  }
  EXPECT_LT(last, .02);
}

// A ball of few edges, in several positions relative to the grid, and its two halves.
TEST(Make_complex_in_a_box, of_a_small_ball) {
  const double volume = 4. / 3 * pi;
  const CGAL::Bbox_3 box(-2, -2, -2, 2, 2, 2);
  for (const double edges : {2., 3., 4.})
    for (const double shift : {0., .137, .31}) {
      const auto is_inside = [&](const Point& p) {
        return std::hypot(p.x() - shift, p.y() - shift / 2, p.z() + shift / 3) < 1;
      };
      const Complex whole = make(box, 1 / edges, [&](const Point& p) { return int(is_inside(p)); });
      EXPECT_NEAR(whole.volume(1) / volume, 1, 1e-3) << edges << ' ' << shift;
      const Complex halves = make(
          box, 1 / edges, [&](const Point& p) { return is_inside(p) ? p.x() < shift ? 1 : 2 : 0; });
      EXPECT_NEAR(halves.volume(1) / volume, .5, 5e-3) << edges << ' ' << shift;
      EXPECT_NEAR(halves.volume(2) / volume, .5, 5e-3) << edges << ' ' << shift;
    }
}

TEST(Make_complex_in_a_box, labels_at_many_points_give_the_same_complex) {
  const auto label = [](const Point& p) { return p.x() + p.y() * p.y() < .2 ? 1 : 0; };
  const auto labels = [&](const std::vector<Point>& points) {
    std::vector<int> result;
    for (const Point& p : points)
      result.push_back(label(p));
    return result;
  };
  const CGAL::Bbox_3 box(-1, -1, -1, 1, 1, 1);
  EXPECT_TRUE(make(box, .3, label).state() == make(box, .3, labels).state());
  const auto one_label = [](const std::vector<Point>&) { return std::vector<int>(1); };
  EXPECT_THROW(make(box, .3, one_label), Error);
}

// Two overlapping balls, and a wall between them.
TEST(Make_complex_in_a_box, of_several_labels) {
  const auto label_at = [](const Point& p) {
    if (p.x() * p.x() + p.y() * p.y() + p.z() * p.z() < 1)
      return 1;
    return (p.x() - 1) * (p.x() - 1) + p.y() * p.y() + p.z() * p.z() < 1 ? 2 : 0;
  };
  const Complex dsc = make(CGAL::Bbox_3(-1.5, -1.5, -1.5, 2.5, 1.5, 1.5), .15, label_at);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(1), 4 * pi / 3, .03 * 4 * pi / 3);
  EXPECT_NEAR(dsc.volume(2), 11 * pi / 12, .03 * 11 * pi / 12);
}

TEST(Make_complex_in_a_box, refuses_what_is_out_of_range) {
  const auto nothing = [](const Point&) { return 0; };
  EXPECT_THROW(make(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 0, nothing), Error);
  EXPECT_THROW(make(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 1e-9, nothing), Error);
  EXPECT_THROW(make(CGAL::Bbox_3(0, 0, 0, 1, 1, 0), .1, nothing), Error);
  EXPECT_THROW(make(CGAL::Bbox_3(0, 0, 0, 1e-40, 1e-40, 1e-40), 1e-41, nothing), Error);
}

} // namespace test_implicit_functions
