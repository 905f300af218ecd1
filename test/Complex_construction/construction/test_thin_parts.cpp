// Thin parts that are given by few large triangles, and their resolution.
#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Complex_construction/refine_thin_parts.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

namespace test_thin_parts {

using namespace small_surfaces;
using Planar_complex = CGAL::Deformable_simplicial_complex_2<>;
using CGAL::Deformable_simplicial_complexes::Error;

template <class NP = parameters::Default_named_parameters>
Complex build(const Surfaces& surfaces, const NP& np = NP()) {
  return DSC::make_deformable_simplicial_complex_3<Complex>(surfaces,
                                                            CGAL::Tetgen_tetrahedralizer_3(), np);
}

double worst_quality(const Complex& dsc) {
  double result = 1;
  for (const auto c : dsc.cells())
    result = (std::min)(result, dsc.quality(c));
  return result;
}

double longest_interface_edge(const Complex& dsc) {
  double result = 0;
  for (const auto& facet : dsc.interface_facets()) {
    const auto v = dsc.facet_vertices(facet);
    for (int i = 0; i < 3; ++i)
      result = (std::max)(result, dsc.displacement(v[i], v[(i + 1) % 3]).squared_length());
  }
  return std::sqrt(result);
}

TEST(Thin_parts, of_plates_and_bars_are_resolved) {
  for (const std::array<double, 3>& size :
       {std::array<double, 3>{20, 20, 1}, {20, 1, 1}, {200, 1, 1}, {2e-3, 1e-4, 1e-4}}) {
    const Complex dsc = build({box({0, 0, 0}, size)});
    const double thickness = *std::min_element(size.begin(), size.end());
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_NEAR(dsc.volume(1) / (size[0] * size[1] * size[2]), 1, 1e-9);
    EXPECT_LE(longest_interface_edge(dsc), 3.01 * thickness) << size[0];
    EXPECT_GT(worst_quality(dsc), .1) << size[0];
    EXPECT_EQ(DSC::missing_facets(dsc, 3), 0u);
  }
}

TEST(Thin_parts, even_bodies_and_wedges_keep_their_triangles) {
  EXPECT_EQ(build({box({0, 0, 0}, {1, 1, 1})}).interface_facets().size(), 12u);
  EXPECT_EQ(build({box({0, 0, 0}, {2, 2, 1})}).interface_facets().size(), 12u);
  for (const double height : {.02, .2}) {
    Surface wedge;
    wedge.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, height}, {0, 1, height}};
    wedge.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 1, 3}, {4, 3, 5},
                       {0, 4, 5}, {0, 5, 2}, {0, 1, 4}, {2, 5, 3}};
    EXPECT_LT(build({wedge}).interface_facets().size(), 2000u) << height;
  }
}

// The gap is thin, not the boxes.
TEST(Thin_parts, gaps_are_resolved) {
  const Complex dsc = build({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 1.05}, {1, 1, 2}, 2)});
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(dsc.interface_facets().size(), 200u);
  EXPECT_EQ(DSC::missing_facets(dsc, 3), 0u);
  EXPECT_NEAR(dsc.volume(1), 1, 1e-12);
  EXPECT_NEAR(dsc.volume(2), .95, 1e-12);
}

// Below a small box, the upper side of a large one is refined, and the lower side is not.
TEST(Thin_parts, a_large_triangle_is_refined_where_it_is_thin) {
  const Complex dsc = build({box({-10, -10, -10}, {10, 10, 10}), box({0, 0, 10.1}, {1, 1, 11}, 2)});
  EXPECT_EQ(DSC::missing_facets(dsc, 3), 0u);
  std::size_t above = 0, below = 0;
  for (const auto v : dsc.interface_vertices()) {
    above += dsc.position(v).z() == 10;
    below += dsc.position(v).z() == -10;
  }
  EXPECT_GT(above, 30u);
  EXPECT_LT(above, 1000u);
  EXPECT_LT(below, 10u);
}

TEST(Thin_parts, the_bound_on_new_facets_is_kept_evenly) {
  const Surface plate = box({0, 0, 0}, {100, 100, 1});
  const Complex dsc = build({plate}, parameters::most_new_facets(500));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_LE(dsc.interface_facets().size(), 520u);
  EXPECT_GT(dsc.interface_facets().size(), 250u);
  EXPECT_GT(DSC::missing_facets(dsc, 3), 3000u);
  EXPECT_LT(longest_interface_edge(dsc), 20);
  EXPECT_NEAR(dsc.volume(1), 1e4, 1e-6);
  EXPECT_EQ(build({plate}, parameters::edge_per_thickness(0.)).interface_facets().size(), 12u);
  EXPECT_EQ(build({plate}, parameters::most_new_facets(0)).interface_facets().size(), 12u);
  EXPECT_THROW(build({plate}, parameters::edge_per_thickness(.5)), Error);
}

// A complex of given tetrahedra is bisected.
TEST(Thin_parts, of_given_cells_are_resolved) {
  Complex dsc = build({box({0, 0, 0}, {10, 10, 1})}, parameters::edge_per_thickness(0.));
  EXPECT_EQ(dsc.interface_facets().size(), 12u);
  const DSC::Thin_part_report report = DSC::refine_thin_parts(dsc);
  EXPECT_TRUE(report.is_complete);
  EXPECT_EQ(dsc.interface_facets().size(), 12 + report.new_facets);
  EXPECT_LE(longest_interface_edge(dsc), 3.01);
  EXPECT_NEAR(dsc.volume(1), 100, 1e-10);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(DSC::refine_thin_parts(dsc).new_facets, 0u);
}

TEST(Thin_parts, of_curves_are_resolved) {
  DSC::Labeled_curve_2<Planar_complex::Point_2> curve;
  curve.add_polyline(std::vector<Planar_complex::Point_2>{{0, 0}, {50, 0}, {50, 1}, {0, 1}});
  const std::vector<DSC::Labeled_curve_2<Planar_complex::Point_2>> curves = {curve};
  const auto dsc = DSC::make_deformable_simplicial_complex_2<Planar_complex>(curves);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GE(dsc.interface_facets().size(), 34u);
  EXPECT_EQ(DSC::missing_facets(dsc, 3), 0u);
  EXPECT_NEAR(dsc.area(1), 50, 1e-12);
  const auto coarse = DSC::make_deformable_simplicial_complex_2<Planar_complex>(
      curves, parameters::edge_per_thickness(0.));
  EXPECT_EQ(coarse.interface_facets().size(), 4u);
}

// Turned plates have coplanar triangles only up to rounding.
TEST(Thin_parts, of_random_turned_boxes_are_resolved) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(.5, 12), angle(0, 6);
  for (int run = 0; run < 8; ++run) {
    Surface s = box({0, 0, 0}, {side(random), side(random), .5});
    const double a = angle(random), b = angle(random), c = std::cos(a), d = std::sin(a),
                 e = std::cos(b), f = std::sin(b);
    for (Point& p : s.points) {
      const double x = c * p.x() - d * p.y(), y = d * p.x() + c * p.y();
      p = Point(x, e * y - f * p.z(), f * y + e * p.z());
    }
    const Complex coarse = build({s}, parameters::edge_per_thickness(0.)), dsc = build({s});
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_NEAR(dsc.volume(1) / coarse.volume(1), 1, 1e-9);
    EXPECT_EQ(DSC::missing_facets(dsc, 3), 0u);
    EXPECT_GT(worst_quality(dsc), .05);
  }
}

} // namespace test_thin_parts
