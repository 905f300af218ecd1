#include "test.h"

#include <CGAL/Cut_loci_2/Geodesic_distance_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/cut_locus_2.h>

namespace test_cut_locus {

using CGAL::Deformable_simplicial_complexes::Error;
using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Point = CGAL::Epick::Point_2;

constexpr double pi = 3.14159265358979324;

// A torus of revolution about a circle of radius 2.
struct Torus
{
  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    using std::sin;
    const T radius = 2. + cos(v);
    return {radius * cos(u), radius * sin(u), sin(v)};
  }
};

struct Tensor_of_torus
{
  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::cos;
    const T radius = 2. + cos(v);
    return {radius * radius, 0. * u, 1. + 0. * u};
  }
};

using Torus_metric = DSC::Embedded_surface_2<Torus>;

// A sheared flat torus: lengths are lengths of (u + v / 2, v).
struct Sheared_metric
{
  DSC::Metric_jet_2 operator()(double, double) const { return {1, .5, 1.25, 0, 0, 0, 0, 0, 0}; }
};

// All metrics of fronts and of cut loci have this type, so that the templates are instantiated
// once.
using Metric = std::function<DSC::Metric_jet_2(double, double)>;

Metric constant_metric(double E, double F, double G) {
  return [=](double, double) { return DSC::Metric_jet_2{E, F, G, 0, 0, 0, 0, 0, 0}; };
}

const Metric flat = constant_metric(1, 0, 1);

TEST(Riemannian_metric, of_an_embedding_is_differentiated) {
  const Torus_metric metric;
  const DSC::Metric_tensor_2<Tensor_of_torus> from_tensor;
  for (double u : {0., .3, 4.})
    for (double v : {0., .7, 2., 5.}) {
      const double radius = 2 + std::cos(v);
      for (const auto& g : {metric(u, v), from_tensor(u, v)}) {
        EXPECT_NEAR(g.E, radius * radius, 1e-14);
        EXPECT_NEAR(g.F, 0, 1e-14);
        EXPECT_NEAR(g.G, 1, 1e-14);
        EXPECT_NEAR(g.E_u, 0, 1e-14);
        EXPECT_NEAR(g.E_v, -2 * radius * std::sin(v), 1e-14);
        EXPECT_NEAR(g.F_u, 0, 1e-14);
        EXPECT_NEAR(g.F_v, 0, 1e-14);
        EXPECT_NEAR(g.G_u, 0, 1e-14);
        EXPECT_NEAR(g.G_v, 0, 1e-14);
      }
    }
}

// Provides the functions of <cmath> of one variable, and quotients.
struct Functions
{
  template <class T> std::array<T, 3> operator()(const T& u, const T& v) const {
    using std::acos;
    using std::asin;
    using std::atan;
    using std::atan2;
    using std::cbrt;
    using std::cosh;
    using std::exp;
    using std::log;
    using std::pow;
    using std::sinh;
    using std::sqrt;
    using std::tan;
    using std::tanh;
    return {exp(u) / (1 + v) + sqrt(2. + u * v) - log(v) + atan2(u - 2, v) + atan2(v, u - 3),
            tan(u) + asin(u * v) * acos(v) - atan(u) + pow(v, 2.5) + pow(v, u),
            sinh(u) * cosh(v) + tanh(v - u) + cbrt(u + v) + 1 / (u + 3.)};
  }
};

TEST(Riemannian_metric, has_the_derivatives_of_all_functions) {
  const DSC::Embedded_surface_2<Functions> metric;
  const Functions f;
  static constexpr double width = 1e-3, u = .4, v = .6;
  // Computes fourth-order central differences.
  const auto slope = [](const auto& value) {
    return (8 * (value(width) - value(-width)) - (value(2 * width) - value(-2 * width))) /
           (12 * width);
  };
  const auto g = metric(u, v);
  double E = 0, F = 0, G = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double by_u = slope([&](double t) { return f(u + t, v)[i]; }),
                 by_v = slope([&](double t) { return f(u, v + t)[i]; });
    E += by_u * by_u;
    F += by_u * by_v;
    G += by_v * by_v;
  }
  static constexpr double precision = 1e-8;
  EXPECT_NEAR(g.E, E, precision);
  EXPECT_NEAR(g.F, F, precision);
  EXPECT_NEAR(g.G, G, precision);
  EXPECT_NEAR(g.E_u, slope([&](double t) { return metric(u + t, v).E; }), precision);
  EXPECT_NEAR(g.E_v, slope([&](double t) { return metric(u, v + t).E; }), precision);
  EXPECT_NEAR(g.F_u, slope([&](double t) { return metric(u + t, v).F; }), precision);
  EXPECT_NEAR(g.F_v, slope([&](double t) { return metric(u, v + t).F; }), precision);
  EXPECT_NEAR(g.G_u, slope([&](double t) { return metric(u + t, v).G; }), precision);
  EXPECT_NEAR(g.G_v, slope([&](double t) { return metric(u, v + t).G; }), precision);
}

TEST(Geodesics, keep_their_speed_and_the_relation_of_Clairaut) {
  const CGAL::Deformable_simplicial_complexes::internal::Geodesics_2<Torus_metric> geodesics(
      Torus_metric(), Domain({2 * pi, 2 * pi}), Point(.2, .5));
  for (double angle : {.1, 1., 2.5, 4.}) {
    const auto begin = geodesics.shoot(angle, 0), end = geodesics.advance(begin, 5);
    const auto momentum = [](const auto& x) {
      return (2 + std::cos(x[1])) * (2 + std::cos(x[1])) * x[2];
    };
    EXPECT_NEAR(momentum(end), momentum(begin), 1e-9);
    EXPECT_NEAR(momentum(end) * end[2] + end[3] * end[3], 1, 1e-9);
  }
}

TEST(Geodesics, are_straight_in_a_sheared_chart) {
  const CGAL::Deformable_simplicial_complexes::internal::Geodesics_2<Sheared_metric> geodesics(
      Sheared_metric(), Domain(), Point(0, 0));
  const auto end = geodesics.shoot(.7, 2);
  EXPECT_NEAR(end[0] + end[1] / 2, 2 * std::cos(.7), 1e-12);
  EXPECT_NEAR(end[1], 2 * std::sin(.7), 1e-12);
}

TEST(Geodesic_front, is_a_circle_before_it_meets_itself) {
  DSC::Geodesic_front_2<Metric> front(flat, Domain(), Point(0, 0), .04);
  while (front.radius() < .4)
    EXPECT_TRUE(front.advance(.02));
  EXPECT_TRUE(front.complex().is_valid());
  for (auto v : front.complex().interface_vertices()) {
    const auto q = front.complex().domain().nearest_image(Point(0, 0), front.complex().position(v));
    EXPECT_NEAR(std::hypot(q.x(), q.y()), front.radius(), 1e-9);
  }
}

// Two lines that intersect where four geodesics meet.
TEST(Cut_locus, of_a_flat_torus) {
  const Point p(.2, .3);
  const DSC::Cut_locus_2 locus = DSC::cut_locus_2(flat, Domain(), p, .05, .025);
  std::size_t crossings = 0;
  for (const auto& v : locus.vertices) {
    const double u = std::abs(std::remainder(v.point.x() - p.x(), 1)),
                 w = std::abs(std::remainder(v.point.y() - p.y(), 1));
    EXPECT_NEAR((std::max)(u, w), .5, 1e-8);
    EXPECT_NEAR(v.distance, std::hypot(u, w), 1e-8);
    if (v.multiplicity != 2) {
      ++crossings;
      EXPECT_EQ(v.multiplicity, 4u);
      EXPECT_NEAR((std::min)(u, w), .5, 1e-8);
    }
  }
  EXPECT_EQ(crossings, 1u);
  EXPECT_EQ(locus.polylines.size(), 2u);
}

// A torus of revolution whose generator is an ellipse of height 2 b. It uses formulas, which are
// faster than automatic differentiation.
Metric torus_by_formulas(double b) {
  return [b](double, double v) {
    const double radius = 2 + std::cos(v), s = std::sin(v), c = std::cos(v);
    return DSC::Metric_jet_2{
        radius * radius,        0, s * s + b * b * c * c, 0, -2 * radius * s, 0, 0, 0,
        2 * (1 - b * b) * s * c};
  };
}

// An end or a junction in the chart from -pi to pi.
struct Special_point
{
  double u, v, distance;
  std::size_t multiplicity;
};

// The cut locus is symmetric under exchange of u and -u, and of both halves of the opposite
// meridian.
void expect_cut_locus(double b, double v, double spacing, std::size_t arcs,
                      const std::vector<Special_point>& expected) {
  const DSC::Cut_locus_2 locus = DSC::cut_locus_2(torus_by_formulas(b), Domain({2 * pi, 2 * pi}),
                                                  Point(0, v), spacing, spacing / 2);
  EXPECT_EQ(locus.polylines.size(), arcs);
  std::vector<Special_point> found;
  for (const auto& p : locus.vertices)
    if (p.multiplicity != 2)
      found.push_back({std::abs(std::remainder(p.point.x(), 2 * pi)),
                       std::remainder(p.point.y(), 2 * pi), p.distance, p.multiplicity});
  EXPECT_EQ(found.size(), expected.size());
  for (const Special_point& e : expected)
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const Special_point& f) {
                              return std::abs(f.u - e.u) < 1e-3 &&
                                     std::abs(std::remainder(f.v - e.v, 2 * pi)) < 1e-3 &&
                                     std::abs(f.distance - e.distance) < 1e-3 &&
                                     f.multiplicity == e.multiplicity;
                            }))
        << e.u << ' ' << e.v;
}

TEST(Cut_locus, of_a_point_of_the_outer_equator_of_a_torus) {
  const double conjugate = pi * std::sqrt(1. / 3);
  expect_cut_locus(1, 0, .3, 5,
                   {{pi, pi, 5.47597569, 4},
                    {pi, 0, 7.63112309, 4},
                    {conjugate, 0, 3 * conjugate, 1},
                    {conjugate, 0, 3 * conjugate, 1}});
}

// The ends lie on the opposite parallel, where the parallel meets the closed curve around the
// torus.
TEST(Cut_locus, of_another_point_of_a_torus) {
  const double v = .1 * pi;
  expect_cut_locus(1, v, .2, 6,
                   {{pi, -.158299, 7.48836, 4},
                    {2.51091, -v, 6.80779, 3},
                    {2.51091, -v, 6.80779, 3},
                    {1.82135894, -v, 5.46388, 1},
                    {1.82135894, -v, 5.46388, 1}});
}

// The result does not depend on the initial mesh, nor on the positions of the forks of the
// remaining axis.
TEST(Cut_locus, of_a_torus_does_not_depend_on_the_mesh) {
  for (double v : {.09 * pi, .095 * pi, .105 * pi})
    for (double spacing : {.19, .21}) {
      const DSC::Cut_locus_2 locus = DSC::cut_locus_2(
          torus_by_formulas(1), Domain({2 * pi, 2 * pi}), Point(0, v), spacing, spacing / 2);
      EXPECT_TRUE(locus.is_complete);
      EXPECT_EQ(locus.polylines.size(), 6u) << v << ' ' << spacing;
    }
}

// The rims of a high torus focus geodesics: four additional arcs begin there.
TEST(Cut_locus, of_a_point_of_a_high_torus) {
  const double v = .1 * pi;
  expect_cut_locus(2, v, .15, 9,
                   {{pi, -2.03121, 7.41805, 4},
                    {pi, -v, 9.23702, 4},
                    {2.99242, -v, 9.00772, 3},
                    {2.99242, -v, 9.00772, 3},
                    {2.09331, .671748, 5.9118, 1},
                    {2.09331, .671748, 5.9118, 1},
                    {2.24727, -1.02541, 6.78796, 1},
                    {2.24727, -1.02541, 6.78796, 1}});
}

// A torus of revolution with other radii.
Metric thin_torus(double large, double small) {
  return [=](double, double v) {
    const double radius = large + small * std::cos(v);
    return DSC::Metric_jet_2{
        radius * radius, 0, small * small, 0, -2 * radius * small * std::sin(v), 0, 0, 0, 0};
  };
}

// By the symmetry of v and -v, the cut locus of a point of the outer equator contains the inner
// equator, and the part of the outer equator beyond the conjugate points.
TEST(Cut_locus, of_a_thin_torus_is_symmetric) {
  const DSC::Cut_locus_2 locus =
      DSC::cut_locus_2(thin_torus(2, .5), Domain({2 * pi, 2 * pi}), Point(0, 0), .157, .078);
  EXPECT_TRUE(locus.is_complete);
  EXPECT_EQ(locus.polylines.size(), 5u);
  const double conjugate = pi * std::sqrt(.5 / 2.5);
  for (const auto& vertex : locus.vertices) {
    const double u = std::abs(std::remainder(vertex.point.x(), 2 * pi)),
                 v = std::abs(std::remainder(vertex.point.y(), 2 * pi));
    EXPECT_LT((std::min)({pi - u, pi - v, v}), 1e-6) << u << ' ' << v;
    if (pi - u > 1e-6 && v < 1e-6) {
      EXPECT_GT(u, conjugate - 1e-6);
    }
  }
}

// Geodesics near the inner equator: directions of geodesics to distant points on the equator differ
// by only 1e-6.
TEST(Cut_locus, of_a_point_of_the_outer_equator_of_a_thin_torus) {
  const DSC::Cut_locus_2 locus =
      DSC::cut_locus_2(thin_torus(2, .4), Domain({2 * pi, 2 * pi}), Point(0, 0), .2, .04);
  EXPECT_TRUE(locus.is_complete);
  EXPECT_EQ(locus.polylines.size(), 5u);
}

// Geodesics along the inner side diverge by a factor of thousands.
TEST(Cut_locus, of_a_torus_is_reached_by_no_shorter_way) {
  const Domain domain({2 * pi, 2 * pi});
  for (const Metric& torus : {thin_torus(3, 1), thin_torus(2, .3)}) {
    const DSC::Cut_locus_2 locus = DSC::cut_locus_2(torus, domain, Point(.7, 1.1), .157, .078);
    EXPECT_TRUE(locus.is_complete);
    EXPECT_EQ(locus.polylines.size(), 2u);
    for (const auto& vertex : locus.vertices)
      EXPECT_LT(vertex.distance, 9.37);
  }
}

DSC::Geodesic_distance_2<Metric> distance_field(const Metric& metric, const Domain& domain,
                                                const Point& source, double spacing) {
  DSC::Geodesic_front_2<Metric> front(metric, domain, source, spacing);
  while (front.advance(spacing / 2)) {
  }
  return DSC::Geodesic_distance_2<Metric>(front);
}

TEST(Geodesic_distance, on_a_flat_torus) {
  const Point source(.2, .3);
  const auto distance = distance_field(flat, Domain(), source, .05);
  EXPECT_EQ(distance(source), 0);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      const Point p(.1 * i + .003, .1 * j + .007);
      EXPECT_NEAR(
          distance(p),
          std::hypot(std::remainder(p.x() - source.x(), 1), std::remainder(p.y() - source.y(), 1)),
          1e-8);
    }
}

// The other values are computed with 8000 geodesics.
TEST(Geodesic_distance, on_tori_of_revolution) {
  const Domain domain({2 * pi, 2 * pi});
  const auto equator = distance_field(torus_by_formulas(1), domain, Point(0, 0), .2);
  EXPECT_NEAR(equator(Point(0, pi)), pi, 1e-8);
  EXPECT_NEAR(equator(Point(pi, 0)), 7.63112309, 1e-7);
  EXPECT_NEAR(equator(Point(pi, pi)), 5.47597569, 1e-7);
  EXPECT_NEAR(equator(Point(.001, -.002)), std::hypot(.003, .002), 1e-5);
  const auto above = distance_field(torus_by_formulas(1), domain, Point(0, .3 * pi), .2);
  EXPECT_NEAR(above(Point(1.95, -.3 * pi)), 5.17309, 1e-4);
  const auto high = distance_field(torus_by_formulas(2), domain, Point(0, .1 * pi), .15);
  EXPECT_NEAR(high(Point(3.05, -.1 * pi)), 9.09745, 1e-4);
}

// The points that are conjugate to the source, and their neighborhoods.
TEST(Geodesic_distance, at_an_end_of_the_cut_locus) {
  const auto distance =
      distance_field(torus_by_formulas(1), Domain({2 * pi, 2 * pi}), Point(0, 0), .2);
  const double conjugate = pi * std::sqrt(1. / 3);
  for (double way : {0., 1e-9, -1e-9, 1e-7, -1e-7, -1e-4})
    EXPECT_NEAR(distance(Point(conjugate + way, 0)), 3 * (conjugate + way), 1e-7) << way;
}

TEST(Geodesic_distance, is_infinite_where_the_front_did_not_come) {
  DSC::Geodesic_front_2<Metric> front(flat, Domain(), Point(0, 0), .04);
  while (front.radius() < .2)
    front.advance(.02);
  const DSC::Geodesic_distance_2<Metric> distance(front);
  EXPECT_NEAR(distance(Point(.1, 0)), .1, 1e-9);
  EXPECT_EQ(distance(Point(.5, .5)), std::numeric_limits<double>::infinity());
}

struct Ellipsoid
{
  std::array<double, 3> axes; // halves

  template <class T> std::array<T, 3> operator()(const std::array<T, 3>& n) const {
    return {axes[0] * n[0], axes[1] * n[1], axes[2] * n[2]};
  }
};

using Ellipsoid_surface = DSC::Sphere_like_surface_2<Ellipsoid>;

struct Case
{
  std::array<double, 3> axes, source;
};

TEST(Geodesics, of_a_sphere_are_great_circles) {
  const Ellipsoid_surface sphere(Ellipsoid{{1, 1, 1}}, {1, 2, 2});
  const CGAL::Deformable_simplicial_complexes::internal::Geodesics_2<Ellipsoid_surface> geodesics(
      sphere);
  for (double angle : {.1, 1., 2.5, 4.})
    for (double length : {.2, 1., 3., 4.}) {
      const auto end = geodesics.shoot(angle, length);
      const auto n = sphere.image(Point(end[0], end[1]));
      EXPECT_NEAR((n[0] + 2 * n[1] + 2 * n[2]) / 3, std::cos(length), 1e-9);
    }
}

// The cut locus is the part of the equator between the points that are conjugate to the source
// along the equator, where the curvature is 1 / h^2. A meridian arc leads to the middle.
TEST(Cut_locus, of_a_point_of_the_equator_of_an_oblate_spheroid) {
  const double h = .8, conjugate = pi * h;
  const Ellipsoid_surface spheroid(Ellipsoid{{1, 1, h}}, {3, 0, 0});
  const DSC::Cut_locus_2 locus = DSC::cut_locus_2(spheroid, .2, .1);
  ASSERT_EQ(locus.polylines.size(), 1u);
  for (const auto& v : locus.vertices) {
    const auto p = spheroid.image(v.point);
    EXPECT_NEAR(p[2], 0, 1e-8);
    EXPECT_GE(std::abs(std::atan2(p[1], p[0])), conjugate - 1e-7);
    if (v.multiplicity == 1) {
      EXPECT_NEAR(std::abs(std::atan2(p[1], p[0])), conjugate, 1e-7);
      EXPECT_NEAR(v.distance, conjugate, 1e-7);
    }
  }
}

// The cut locus is a part of a line of curvature, which a confocal quadric cuts out of the
// ellipsoid. (J. Itoh, K. Kiyohara, The cut loci and the conjugate loci on ellipsoids, Manuscripta
// Math. 114, 2004.)
TEST(Cut_locus, of_an_ellipsoid_is_on_a_line_of_curvature) {
  const std::array<double, 3> axes = {1, .8, .6};
  const Ellipsoid_surface ellipsoid(Ellipsoid{axes}, {1, 1, 1});
  const DSC::Cut_locus_2 locus = DSC::cut_locus_2(ellipsoid, .1, .05);
  ASSERT_EQ(locus.polylines.size(), 1u);
  EXPECT_GT(locus.vertices.size(), 10u);
  const auto confocal = [&](const std::array<double, 3>& p, double parameter) {
    double sum = -1;
    for (std::size_t i = 0; i < 3; ++i)
      sum += p[i] * p[i] / (axes[i] * axes[i] - parameter);
    return sum;
  };
  // The confocal hyperboloid of one sheet through the source; its parameter is between the squares
  // of the two shorter axes.
  double low = .36 + 1e-9, high = .64 - 1e-9;
  const double third = std::sqrt(1. / 3);
  const std::array<double, 3> source = {third, .8 * third, .6 * third};
  while (high - low > 1e-15)
    (confocal(source, (low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  for (const auto& v : locus.vertices)
    EXPECT_NEAR(confocal(ellipsoid.image(v.point), low), 0, 1e-6);
}

TEST(Cut_locus, of_a_sphere_is_a_point) {
  for (const std::array<double, 3>& axes : {std::array<double, 3>{1, 1, 1}, {1, 1, .6}}) {
    const Ellipsoid_surface surface(Ellipsoid{axes}, {0, 0, 2});
    const DSC::Cut_locus_2 locus = DSC::cut_locus_2(surface, .1, .05);
    EXPECT_TRUE(locus.is_complete);
    EXPECT_TRUE(locus.polylines.empty());
    ASSERT_EQ(locus.vertices.size(), 1u);
    EXPECT_EQ(locus.vertices[0].multiplicity, 0u);
    EXPECT_NEAR(surface.image(locus.vertices[0].point)[2], -axes[2], 1e-9);
  }
}

TEST(Cut_locus, of_ellipsoids_of_any_shape) {
  for (const Case& c : {Case{{1, .99, .98}, {1, 1, 1}}, Case{{1, .5, .4}, {.3, -1, .4}}}) {
    const Ellipsoid_surface surface(Ellipsoid{c.axes}, c.source);
    const DSC::Cut_locus_2 locus = DSC::cut_locus_2(surface, .2, .04);
    EXPECT_TRUE(locus.is_complete) << c.axes[1] << ' ' << c.source[1];
    EXPECT_EQ(locus.polylines.size(), 1u);
  }
}

// In the chart of a sphere, the metric has ratios of up to 100, and conjugate points are near the
// source.
TEST(Cut_locus, of_long_and_flat_ellipsoids) {
  for (const Case& c : {Case{{1, .3, .1}, {1, 1, 1}}, Case{{1, .3, .1}, {.3, -1, .4}},
                        Case{{1, .1, .1}, {.3, -1, .4}}}) {
    const Ellipsoid_surface surface(Ellipsoid{c.axes}, c.source);
    const double middle = surface.half_width;
    const auto g = surface(middle, middle);
    EXPECT_NEAR(g.F, 0, 1e-9 * g.E); // at the point opposite to the source, the metric is isotropic
    EXPECT_NEAR(g.G, g.E, 1e-9 * g.E);
    const DSC::Cut_locus_2 locus = DSC::cut_locus_2(surface, .1, .05 * std::sqrt(g.E));
    EXPECT_TRUE(locus.is_complete) << c.axes[1] << ' ' << c.source[1];
    EXPECT_EQ(locus.polylines.size(), 1u);
  }
}

TEST(Geodesic_distance, on_a_sphere) {
  const Ellipsoid_surface sphere(Ellipsoid{{1, 1, 1}}, {0, 0, 1});
  DSC::Geodesic_front_2<Ellipsoid_surface> front(sphere, .2);
  while (front.radius() < 1.6)
    front.advance(.1);
  const DSC::Geodesic_distance_2<Ellipsoid_surface> distance(front);
  for (const Point& p : {Point(5.5, 4), Point(2, 3), Point(7, 1), Point(.5, 4)})
    EXPECT_NEAR(distance(p), std::acos(sphere.direction(p)[2]), 1e-8);
  EXPECT_EQ(distance(Point(4, 4)), std::numeric_limits<double>::infinity());
}

TEST(Sphere_like_surface, has_a_source) {
  EXPECT_THROW(Ellipsoid_surface(Ellipsoid{{1, 1, 1}}, {0, 0, 0}), Error);
  EXPECT_THROW(Ellipsoid_surface(Ellipsoid{{1, 1, 1}}, {0, std::nan(""), 1}), Error);
  EXPECT_THROW(DSC::cut_locus_2(Ellipsoid_surface(Ellipsoid{{1, 1, 0}}, {1, 0, 0}), .2, .1), Error);
}

// A torus of period 1 in any unit: chart and surface may have different units.
TEST(Cut_locus, does_not_depend_on_units) {
  for (double period : {1e-14, 1., 1e10})
    for (double scale : {1e-8, 1e8}) {
      const Domain domain({period, period});
      const DSC::Cut_locus_2 locus =
          DSC::cut_locus_2(constant_metric(scale * scale, 0, scale * scale), domain,
                           Point(.2 * period, .3 * period), .05 * period, .025 * period * scale);
      EXPECT_TRUE(locus.is_complete);
      EXPECT_EQ(locus.polylines.size(), 2u);
      for (const auto& v : locus.vertices) {
        const double u = std::abs(std::remainder(v.point.x() / period - .2, 1)),
                     w = std::abs(std::remainder(v.point.y() / period - .3, 1));
        EXPECT_NEAR((std::max)(u, w), .5, 1e-7);
        EXPECT_NEAR(v.distance / (period * scale), std::hypot(u, w), 1e-7);
      }
    }
}

TEST(Cut_locus, tells_whether_it_is_complete) {
  EXPECT_FALSE(DSC::cut_locus_2(flat, Domain(), Point(0, 0), .05, .025, .52).is_complete);
  EXPECT_TRUE(DSC::cut_locus_2(flat, Domain(), Point(0, 0), .05, .025, .8).is_complete);
}

// A step that is too long is divided.
TEST(Geodesic_front, goes_on_by_any_length) {
  DSC::Geodesic_front_2<Metric> front(flat, Domain(), Point(0, 0), .04);
  EXPECT_TRUE(front.advance(.3));
  EXPECT_TRUE(front.advance(1e-7));
  for (double length : {0., -1., std::nan(""), 1e-300, 1e10})
    EXPECT_THROW(front.advance(length), Error) << length;
  const DSC::Geodesic_distance_2<Metric> distance(front);
  EXPECT_NEAR(distance(Point(.1, .2)), std::hypot(.1, .2), 1e-9);
}

// Geodesics do not enter the region where the metric is not positive definite; the front keeps its
// previous state.
TEST(Geodesic_front, ends_where_the_metric_is_not_positive) {
  const Metric metric = [](double, double v) {
    const double G = std::abs(v - .5) < .2 ? -1 : 1;
    return DSC::Metric_jet_2{1, 0, G, 0, 0, 0, 0, 0, 0};
  };
  DSC::Geodesic_front_2<Metric> front(metric, Domain(), Point(.3, 0), .04);
  double last = front.radius();
  try {
    for (;; last = front.radius())
      front.advance(.02);
  } catch (const Error&) {
  }
  EXPECT_LT(last, .32);
  EXPECT_EQ(front.radius(), last);
  for (auto v : front.complex().interface_vertices())
    EXPECT_NEAR(front.ray(v).length, last, 1e-12);
}

TEST(Geodesic_distance, close_to_the_source) {
  DSC::Geodesic_front_2<Metric> front(flat, Domain(), Point(.3, .3), .04);
  const DSC::Geodesic_distance_2<Metric> at_once(front);
  EXPECT_NEAR(at_once(Point(.35, .3)), .05, 1e-12);
  front.advance(.2);
  const DSC::Geodesic_distance_2<Metric> distance(front);
  for (double radius : {1e-12, 1e-9, 1e-6, 1e-3, .03})
    for (double angle : {0., 1., 2., 3., 4., 5.})
      EXPECT_NEAR(distance(Point(.3 + radius * std::cos(angle), .3 + radius * std::sin(angle))),
                  radius, 1e-12 + 1e-6 * radius);
}

TEST(Cut_locus, refuses_what_it_cannot_do) {
  const auto find = [](double spacing, double step) {
    return DSC::cut_locus_2(flat, Domain(), Point(0, 0), spacing, step);
  };
  EXPECT_THROW(find(0, .1), Error);
  EXPECT_THROW(find(.1, .1), Error);
  EXPECT_THROW(find(.05, 0), Error);
  EXPECT_THROW(find(.05, std::nan("")), Error);
  EXPECT_THROW(find(.05, 1e-300), Error);
  EXPECT_THROW(find(.05, std::numeric_limits<double>::infinity()), Error);
  for (double distance : {0., -1., std::nan("")})
    EXPECT_THROW(DSC::cut_locus_2(flat, Domain(), Point(0, 0), .05, .02, distance), Error);
  for (double x : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(DSC::cut_locus_2(flat, Domain(), Point(x, 0), .05, .02), Error);
  EXPECT_TRUE(
      DSC::cut_locus_2(constant_metric(1, 0, 100), Domain(), Point(0, 0), .01, .005).is_complete);
  EXPECT_THROW(DSC::cut_locus_2(constant_metric(1, 1, 1), Domain(), Point(0, 0), .05, .02), Error);
}

} // namespace test_cut_locus
