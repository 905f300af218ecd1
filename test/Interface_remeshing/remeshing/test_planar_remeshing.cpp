#include "test.h"
#include "torus.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/velocity_fields_2.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>

namespace test_planar_remeshing {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Complex::Point_2;
using Curve = DSC::Labeled_curve_2<Point>;

constexpr double pi = 3.14159265358979323846;

// Returns points of an ellipse about the origin, at angles of a function on [0, 1).
template <class Angle>
Curve ellipse(double a, double b, std::size_t n, const Angle& angle, double x = 0, double y = 0) {
  Curve curve;
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * angle(double(i) / double(n));
    points.emplace_back(x + a * std::cos(t), y + b * std::sin(t));
  }
  curve.add_polyline(points);
  return curve;
}

double evenly(double t) { return t; }
double unevenly(double t) { return t + .05 * std::sin(2 * pi * t); }

Complex make(const Curve& curve) {
  return DSC::make_deformable_simplicial_complex_2<Complex>({curve});
}

template <class C> std::vector<double> lengths(const C& dsc) {
  std::vector<double> result;
  for (const auto& f : dsc.interface_facets())
    result.push_back(dsc.measure(f));
  return result;
}

template <class C> double worst_radius(const C& dsc, double radius) {
  double worst = 0;
  for (auto v : dsc.interface_vertices()) {
    const auto p = dsc.position(v);
    worst = (std::max)(worst, std::abs(std::hypot(p.x(), p.y()) - radius));
  }
  return worst;
}

// The cubic through four points has an error of fourth order in the edge length.
TEST(Improve_interface_2, curved_splits_stay_on_the_curve) {
  std::vector<double> errors;
  for (std::size_t n : {20, 40, 80}) {
    Complex dsc = make(ellipse(1, 1, n, unevenly));
    DSC::improve_interface(dsc, parameters::curved_splits(true)
                                    .aggressiveness(0.)
                                    .interface_collapse_length(0.)
                                    .interface_split_length(.6));
    EXPECT_TRUE(dsc.is_valid(true));
    EXPECT_GE(dsc.interface_vertices().size(), 2 * n);
    errors.push_back(worst_radius(dsc, 1));
  }
  EXPECT_LT(errors[1], errors[0] / 12);
  EXPECT_LT(errors[2], errors[1] / 12);
  EXPECT_LT(errors[2], 1e-5);
}

TEST(Improve_interface_2, straight_splits_change_nothing) {
  Complex dsc = make(ellipse(2, 1, 30, evenly));
  const double area = dsc.area(1);
  const auto report = DSC::improve_interface(
      dsc, parameters::aggressiveness(0.).interface_collapse_length(0.).interface_split_length(.6));
  EXPECT_GT(report.split, 20u);
  EXPECT_NEAR(dsc.area(1), area, 1e-14);
}

TEST(Improve_interface_2, collapses_keep_corners_and_little_is_swept) {
  Curve square;
  std::vector<Point> points;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 20; ++i) {
      const double t = i / 20. - .5;
      const double x = side == 0   ? t
                       : side == 1 ? .5
                       : side == 2 ? -t
                                   : -.5,
                   y = side == 0   ? -.5
                       : side == 1 ? t
                       : side == 2 ? .5
                                   : -t;
      points.emplace_back(x, y);
    }
  square.add_polyline(points);
  Complex dsc = make(square);
  const auto field = [](const auto&) { return 1.; };
  DSC::improve_interface(dsc, parameters::sizing_field(field)
                                  .interface_collapse_length(.6)
                                  .aggressiveness(0.)
                                  .swept_volume(1e-9)
                                  .number_of_iterations(5));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(1), 1, 1e-14);
  EXPECT_LT(dsc.interface_vertices().size(), 20u);
  int corners = 0;
  for (auto v : dsc.interface_vertices()) {
    const auto p = dsc.position(v);
    corners += std::abs(p.x()) == .5 && std::abs(p.y()) == .5;
  }
  EXPECT_EQ(corners, 4);
}

TEST(Improve_interface_2, smoothing_keeps_areas_and_evens_lengths) {
  Complex dsc = make(
      ellipse(1, 1, 100, [](double t) { return t + .003 * double(std::lround(100 * t) % 2); }));
  const double area = dsc.area(1);
  const auto spread = [&] {
    const auto l = lengths(dsc);
    return *std::max_element(l.begin(), l.end()) / *std::min_element(l.begin(), l.end());
  };
  const double before = spread();
  const auto report =
      DSC::improve_interface(dsc, parameters::interface_collapse_length(0.)
                                      .interface_split_length((std::numeric_limits<double>::max)())
                                      .number_of_iterations(5));
  EXPECT_GT(report.smoothed, 50u);
  EXPECT_NEAR(dsc.area(1), area, 1e-13);
  EXPECT_GT(before, 1.8);
  EXPECT_LT(spread(), 1.1);
  EXPECT_LT(worst_radius(dsc, 1), 2e-3);
}

// At the ends of its axes, an ellipse has the curvatures a / b^2 and b / a^2.
TEST(Curvature_sizing_field_2, tells_the_lengths_of_an_ellipse) {
  const double a = 2, b = 1, tolerance = 1e-3;
  const Complex dsc = make(ellipse(a, b, 400, evenly));
  const DSC::Curvature_sizing_field<2> size(dsc, tolerance, 1e-3, 10, 100);
  const auto length = [&](double curvature) { return std::sqrt(8 * tolerance / curvature); };
  using P = DSC::Curvature_sizing_field<2>::Point;
  EXPECT_NEAR(size(P(a, 0)), length(a / (b * b)), 1e-3 * length(2));
  EXPECT_NEAR(size(P(0, b)), length(b / (a * a)), 1e-2 * length(.25));
  EXPECT_THROW(DSC::Curvature_sizing_field<2>(dsc, 0, 1, 2),
               CGAL::Deformable_simplicial_complexes::Error);
}

TEST(Curvature_sizing_field_2, sees_across_the_seam_of_a_torus) {
  const auto disk_at = [](double x, double y) {
    return DSC::fill_torus<torus::Complex>(torus::Domain({1, 1}), .04, [=](const auto& p) {
      return std::hypot(std::remainder(p.x() - x, 1.), std::remainder(p.y() - y, 1.)) < .2 ? 1 : 0;
    });
  };
  const auto middle = disk_at(.5, .5), corner = disk_at(0, 0);
  const DSC::Curvature_sizing_field<2> of_middle(middle, 1e-3, 1e-3, .3),
      of_corner(corner, 1e-3, 1e-3, .3);
  using P = DSC::Curvature_sizing_field<2>::Point;
  for (double angle = 0; angle < 6; angle += .7) {
    const double x = .2 * std::cos(angle), y = .2 * std::sin(angle);
    const double wanted = std::sqrt(8 * 1e-3 * .2);
    EXPECT_NEAR(of_middle(P(.5 + x, .5 + y)), wanted, .3 * wanted);
    EXPECT_NEAR(of_corner(P(x, y)), wanted, .3 * wanted);
    EXPECT_EQ(of_corner(P(x, y)), of_corner(P(x + 1, y - 1)));
  }
}

TEST(Improve_interface_2, works_across_the_seam_of_a_torus) {
  auto dsc = DSC::fill_torus<torus::Complex>(torus::Domain({1, 1}), .06, [](const auto& p) {
    return std::hypot(std::remainder(p.x(), 1.), std::remainder(p.y(), 1.)) < .3 ? 1 : 0;
  });
  const double area = dsc.area(1);
  const DSC::Curvature_sizing_field<2> size(dsc, 1e-4, 1e-3, .3);
  DSC::improve_interface(dsc, parameters::sizing_field(std::cref(size)).curved_splits(true));
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_GT(dsc.interface_vertices().size(), 60u);
  EXPECT_NEAR(dsc.area(1), area, .01 * area);
}

// After the reversed flow, the error is below one percent of the error of volume-of-fluid methods.
TEST(Vortex_2, stays_smooth_where_it_is_stretched) {
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(
      {ellipse(.15, .15, 60, evenly, .5, .75)},
      parameters::enclosing_box(CGAL::Bbox_2(0, 0, 1, 1)));
  const double area = dsc.area(1), period = 2, dt = .02;
  const DSC::Single_vortex_velocity_2 field(period);
  const auto total = [&] {
    double sum = 0;
    for (double l : lengths(dsc))
      sum += l;
    return sum;
  };
  const double length = total();
  for (int i = 0; i < 100; ++i) {
    const DSC::Curvature_sizing_field<2> size(dsc, 1e-4, 1e-3, .05, .5, 60);
    DSC::improve_interface(dsc, parameters::sizing_field(std::cref(size))
                                    .aggressiveness(0.)
                                    .curved_splits(true)
                                    .interface_split_length(1.5)
                                    .interface_collapse_length(.5)
                                    .swept_volume(.01));
    DSC::control_detail(dsc, parameters::collapse_length(2.));
    const auto report = DSC::advect_interface(
        dsc, field, i * dt, dt,
        parameters::quality_threshold(.1).minimum_angle(.1).minimum_facet_angle(0.));
    ASSERT_TRUE(report.complete);
    EXPECT_NEAR(dsc.area(1), area, 2e-3 * area);
    if (i == 49) {
      EXPECT_NEAR(total() / length, 1.955576, .01);
    }
  }
  EXPECT_TRUE(dsc.is_valid(true));
  for (auto v : dsc.interface_vertices()) {
    const auto p = dsc.position(v);
    EXPECT_NEAR(std::hypot(p.x() - .5, p.y() - .75), .15, 5e-4);
  }
}

TEST(Curve_shortening_2, of_nothing_is_nothing) {
  Complex dsc = make(ellipse(1, 1, 20, evenly));
  for (auto c : dsc.cells())
    dsc.relabel(c, 0);
  const auto report = DSC::advect_interface(dsc, DSC::Mean_curvature_flow(), 0, .1);
  EXPECT_TRUE(report.complete);
}

// The enclosed area of any closed curve decreases at the rate 2 pi.
TEST(Curve_shortening_2, ellipses_lose_area_at_a_constant_rate) {
  Complex dsc = make(ellipse(1, .5, 240, evenly));
  double area = dsc.area(1);
  const double dt = .002;
  for (int i = 0; i < 20; ++i) {
    const auto report = DSC::advect_interface(dsc, DSC::Mean_curvature_flow(), i * dt, dt);
    ASSERT_TRUE(report.complete);
    EXPECT_NEAR((dsc.area(1) - area) / dt, -2 * pi, .005 * 2 * pi) << i;
    area = dsc.area(1);
  }
}

} // namespace test_planar_remeshing
