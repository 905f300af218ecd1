// Junctions of more than three phases, and curvature flow that remeshes its interface.

#include "test.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_remeshing/junction_split_2.h>

#include <CGAL/determinant.h>
#include <CGAL/number_utils.h>

namespace test_junctions {

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Vertex_handle = Complex::Vertex_handle;

// Returns a square of n times n pixels with labels of a function.
template <class LabelAt> Complex square(std::size_t n, const LabelAt& label_at) {
  DSC::Labeled_image_2 image;
  image.width = image.height = n;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      image.labels.push_back(label_at(2 * i < n, 2 * j < n));
  Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(image);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

int four_labels(bool left, bool top) { return 1 + left + 2 * top; }
int two_labels(bool left, bool top) { return 1 + (left == top); }

// Returns the vertices inside the domain with the largest number of incident interface facets, and
// this number.
std::vector<Vertex_handle> junctions(const Complex& dsc, std::size_t degree) {
  std::vector<Vertex_handle> result;
  for (Vertex_handle v : dsc.interface_vertices())
    if (!dsc.is_boundary(v) && v->interface_degree() == degree)
      result.push_back(v);
  return result;
}

double length(const Complex& dsc) {
  double result = 0;
  for (const auto& f : dsc.interface_facets())
    result += dsc.measure(f);
  return result;
}

TEST(Junction_split_2, makes_two_junctions_of_three_phases) {
  Complex dsc = square(12, four_labels);
  ASSERT_EQ(junctions(dsc, 4).size(), 1u);
  CGAL::Deformable_simplicial_complexes::Cavity<Complex> cavity(dsc);
  const double before = length(dsc);
  ASSERT_TRUE(DSC::propose_junction_split(dsc, junctions(dsc, 4).front(), cavity));
  dsc.replace(cavity);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_LT(length(dsc), before);
  EXPECT_EQ(junctions(dsc, 4).size(), 0u);
  ASSERT_EQ(junctions(dsc, 3).size(), 2u);
  for (int label = 1; label <= 4; ++label)
    EXPECT_EQ(dsc.number_of_components(label), 1u);
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_FALSE(DSC::propose_junction_split(dsc, v, cavity));
}

// Two walls end at one vertex of a side. If the angle between them is small, they join, and the
// sector between them leaves the side. Otherwise, they part along the side.
TEST(Junction_split_2, separates_walls_at_a_side) {
  for (const double x : {.2, 1.}) {
    std::vector<Complex::Point_2> points = {{0, 0}, {1, 0}, {x, 1}, {-x, 1}, {-1, 0}};
    std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    std::vector<int> labels = {1, 3, 2};
    if (x < 1) { // the corners of the box
      points.insert(points.end(), {{1, 1}, {-1, 1}});
      triangles.insert(triangles.end(), {{1, 5, 2}, {3, 6, 4}});
      labels.insert(labels.end(), {1, 2});
    }
    Complex dsc = DSC::make_deformable_simplicial_complex_2<Complex>(points, triangles, labels,
                                                                     parameters::improve(false));
    const auto find = [&dsc](unsigned walls) {
      std::vector<Vertex_handle> result;
      for (Vertex_handle v : dsc.interface_vertices())
        if (v->interface_degree() == walls && dsc.position(v).y() == 0)
          result.push_back(v);
      return result;
    };
    ASSERT_EQ(find(2).size(), 1u);
    DSC::Cavity<Complex> cavity(dsc);
    const double before = length(dsc);
    ASSERT_TRUE(DSC::propose_junction_split(dsc, find(2).front(), cavity));
    dsc.replace(cavity);
    EXPECT_TRUE(dsc.is_valid(true));
    EXPECT_LT(length(dsc), before);
    EXPECT_EQ(find(2).size(), 0u);
    EXPECT_EQ(find(1).size(), x < 1 ? 1u : 2u);
    for (Vertex_handle v : dsc.interface_vertices())
      EXPECT_FALSE(DSC::propose_junction_split(dsc, v, cavity));
  }
}

TEST(Junction_split_2, does_not_join_parts_of_a_phase) {
  const Complex dsc = square(12, two_labels);
  CGAL::Deformable_simplicial_complexes::Cavity<Complex> cavity(dsc);
  for (Vertex_handle v : dsc.interface_vertices())
    EXPECT_FALSE(DSC::propose_junction_split(dsc, v, cavity));
}

TEST(Junction_split_2, is_a_part_of_curvature_flow) {
  Complex fit = square(12, four_labels), as_it_is = fit;
  const DSC::Mean_curvature_flow flow;
  for (int i = 0; i < 3; ++i) {
    DSC::advect_adaptively(fit, flow, .2 * i, .2);
    DSC::advect_adaptively(as_it_is, flow, .2 * i, .2, parameters::interface_tolerance(0.));
  }
  EXPECT_TRUE(fit.is_valid(true));
  EXPECT_EQ(junctions(fit, 4).size(), 0u);
  EXPECT_EQ(junctions(fit, 3).size(), 2u);
  EXPECT_EQ(junctions(as_it_is, 4).size(), 1u);
}

// An ellipse with half-axes 3 and 1.
Complex ellipse() {
  std::vector<Complex::Point_2> points;
  constexpr int n = 60;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    points.emplace_back(3 * std::cos(angle), std::sin(angle));
  }
  DSC::Labeled_curve_2<Complex::Point_2> curve;
  curve.add_polyline(points);
  curve.label = 1;
  return DSC::make_deformable_simplicial_complex_2<Complex>(
      std::vector<DSC::Labeled_curve_2<Complex::Point_2>>{curve});
}

// dA/dt = -2 pi, for any shape.
TEST(Curvature_flow_2, keeps_its_interface_fit) {
  Complex dsc = ellipse();
  const double before = dsc.area(1), dt = .01;
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i)
    ASSERT_TRUE(DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(), i * dt, dt).complete);
  EXPECT_TRUE(dsc.is_valid(true));
  const double rate = (dsc.area(1) - before) / (steps * dt), exact = -2 * std::acos(-1.);
  EXPECT_NEAR(rate, exact, .01 * std::abs(exact));
}

// An image of Voronoi cells: a pixel has the label of the nearest seed.
Complex foam(std::size_t n, std::size_t cells) {
  std::uint32_t state = 2;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return double(n) * double(state >> 8) / double(1u << 24);
  };
  std::vector<std::array<double, 2>> seeds(cells);
  for (auto& seed : seeds)
    seed = {next(), next()};
  DSC::Labeled_image_2 image;
  image.width = image.height = n;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const auto nearest =
          std::min_element(seeds.begin(), seeds.end(), [&](const auto& a, const auto& b) {
            const double x = double(i) + .5, y = double(j) + .5;
            return std::hypot(a[0] - x, a[1] - y) < std::hypot(b[0] - x, b[1] - y);
          });
      image.labels.push_back(1 + int(nearest - seeds.begin()));
    }
  return DSC::make_deformable_simplicial_complex_2<Complex>(image);
}

// Returns the smallest angle of all triangles, in degrees.
double smallest_angle(const Complex& dsc) {
  double result = 180;
  for (const auto c : dsc.finite_cells())
    for (int i = 0; i < 3; ++i) {
      const auto a = dsc.displacement(c->vertex(i), c->vertex((i + 1) % 3)),
                 b = dsc.displacement(c->vertex(i), c->vertex((i + 2) % 3));
      result = (std::min)(result, std::atan2(CGAL::determinant(a, b), a * b) * 180 / CGAL_PI);
    }
  return result;
}

TEST(Curvature_flow_2, leaves_no_small_angles) {
  Complex dsc = foam(100, 20);
  const double dt = .4;
  for (int i = 0; i < 60; ++i) {
    DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(), i * dt, dt);
    EXPECT_GE(smallest_angle(dsc), 5) << "after step " << i + 1;
  }
  EXPECT_TRUE(dsc.is_valid(true));
}

TEST(Curvature_flow_2, restores_volumes_that_the_adaptation_changes) {
  Complex dsc = ellipse();
  const double before = dsc.area(1), dt = .05;
  for (int i = 0; i < 10; ++i)
    DSC::advect_adaptively(dsc, DSC::Mean_curvature_flow(true), i * dt, dt);
  EXPECT_TRUE(dsc.is_valid(true));
  EXPECT_NEAR(dsc.area(1), before, 1e-8 * before);
}

} // namespace test_junctions
