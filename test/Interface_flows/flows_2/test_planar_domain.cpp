// Interfaces at the domain boundary, and growing domains, in the plane.

#include "test.h"

#include <CGAL/Complex_construction/grow_domain.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/interface_flows_2.h>

#include <CGAL/Bbox_2.h>

namespace test_planar_domain {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;
using Curve = DSC::Labeled_curve_2<Point>;
using CGAL::Deformable_simplicial_complexes::Domain_rule;
using CGAL::Deformable_simplicial_complexes::Error;

const double pi = std::acos(-1.);

// A disk of radius 1 about the origin with label 1.
Complex disk(const CGAL::Bbox_2& box) {
  constexpr int n = 40;
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    points.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n));
  Curve curve;
  curve.add_polyline(points);
  curve.label = 1;
  return DSC::make_deformable_simplicial_complex_2<Complex>(std::vector<Curve>{curve},
                                                            parameters::enclosing_box(box));
}

TEST(Domain_boundary_2, stops_an_offset_without_loss_of_area) {
  Complex dsc = disk({-1.5, -1.5, 1.5, 1.5});
  std::size_t stopped = 0;
  double area = dsc.area(1);
  for (int step = 0; step < 12; ++step) {
    const auto report = DSC::advect_interface(dsc, DSC::Normal_offset{.1}, step, 1,
                                              parameters::domain_rule(Domain_rule::stop));
    ASSERT_TRUE(dsc.is_valid(true));
    EXPECT_GE(dsc.area(1), area * (1 - 1e-12)) << step;
    area = dsc.area(1);
    stopped += report.stopped_at_boundary;
  }
  EXPECT_GT(stopped, 0u);
  EXPECT_GT(area, .9 * 9);
  EXPECT_NEAR(dsc.area(0) + area, 9, 1e-12);
}

TEST(Domain_boundary_2, moves_away_from_the_interface_if_asked) {
  Complex dsc = disk({-1.5, -1.5, 1.5, 1.5});
  const double area = dsc.area(1), apothem = std::cos(pi / 40);
  EXPECT_THROW(DSC::advect_interface(dsc, DSC::Normal_offset{1.}, 0, 1), Error);
  dsc = disk({-1.5, -1.5, 1.5, 1.5});
  EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{1.}, 0, 1,
                                    parameters::domain_rule(Domain_rule::grow))
                  .complete);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(1) / area, std::pow(1 + 1 / apothem, 2), .01);
}

TEST(Domain_boundary_2, lets_nothing_stop_inside) {
  Complex dsc = disk({-3, -3, 3, 3});
  EXPECT_EQ(DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, 1).stopped_at_boundary, 0u);
}

// A layer of label 1 at the lower side, below label 0.
TEST(Domain_boundary_2, takes_a_phase_that_is_pressed_onto_it) {
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      CGAL::Bbox_2(0, 0, 4, 4), .5, [](const auto& p) { return p.y() < .6 ? 1 : 0; });
  ASSERT_GT(dsc.area(1), 1.);
  for (int step = 0; step < 4 && dsc.number_of_cells(1) > 0; ++step) {
    DSC::deform_interface(dsc, [&](Complex::Vertex_handle v) {
      const auto p = dsc.position(v);
      return Complex::Point_2(p.x(), p.y() - .3);
    });
    ASSERT_TRUE(dsc.is_valid(true));
  }
  EXPECT_EQ(dsc.number_of_cells(1), 0u);
  EXPECT_NEAR(dsc.area(0), 16, 1e-12);
}

// An interface that ends on the sides slides along them.
TEST(Domain_boundary_2, lets_images_fill_the_domain) {
  DSC::Labeled_image_2 image;
  image.width = image.height = 8;
  for (std::size_t i = 0; i < 64; ++i)
    image.labels.push_back(i % 8 + i / 8 < 7 ? 1 : 2);
  const Complex whole = DSC::make_deformable_simplicial_complex_2<Complex>(image);
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      image, 2.5, parameters::enclosing_box(image.bbox()));
  EXPECT_EQ(dsc.labels(), (std::vector<int>{1, 2}));
  EXPECT_EQ(dsc.area(1), whole.area(1));
  const double area = dsc.area(1);
  for (int step = 0; step < 5; ++step)
    DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(), .5 * step, .5);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_LT(dsc.area(1), area);
  EXPECT_NEAR(dsc.area(1) + dsc.area(2), 64, 1e-10);
  EXPECT_THROW(DSC::make_deformable_simplicial_complex_2<Complex>(
                   image, 2.5, parameters::enclosing_box(CGAL::Bbox_2(0, 0, 9, 9))),
               Error);
}

TEST(Grow_domain_2, keeps_the_interface_bit_for_bit) {
  Complex dsc = disk({-1.5, -1.25, 1.5, 1.5});
  DSC::advect_interface(dsc, DSC::Normal_offset{.1}, 0, 1);
  const auto positions = [&] {
    std::set<std::pair<double, double>> result;
    for (auto v : dsc.interface_vertices())
      result.emplace(dsc.position(v).x(), dsc.position(v).y());
    return result;
  };
  const auto before = positions();
  const double area = dsc.area(1), edge = dsc.mean_interface_edge();
  EXPECT_FALSE(DSC::has_room_around_interface(dsc));
  DSC::grow_domain(dsc, 2);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_TRUE(DSC::has_room_around_interface(dsc));
  EXPECT_EQ(positions(), before);
  EXPECT_NEAR(dsc.area(1), area, 1e-12);
  EXPECT_NEAR(dsc.area(0) + dsc.area(1), 6 * 5.5, 1e-12);
  EXPECT_EQ(dsc.mean_interface_edge(), edge);
  EXPECT_TRUE(DSC::advect_interface(dsc, DSC::Normal_offset{.3}, 0, 1).complete);
  EXPECT_THROW(DSC::grow_domain(dsc, 1), Error);
}

} // namespace test_planar_domain
