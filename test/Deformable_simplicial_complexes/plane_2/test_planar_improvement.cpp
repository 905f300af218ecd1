#include "carried_values_2.h"
#include "plane.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Interface_remeshing/remove_degeneracies.h>

namespace test_planar_improvement {

using CGAL::Deformable_simplicial_complexes::Error;
using plane::Complex;
using plane::Point;
using Cavity = CGAL::Deformable_simplicial_complexes::Cavity<Complex>;

template <class C> double worst_quality(const C& dsc) {
  double worst = 1;
  for (auto c : dsc.cells())
    worst = (std::min)(worst, c->quality());
  return worst;
}

// A grid with disturbed vertices. Vertices of the interface are disturbed less, along the line x =
// 0.
template <class C> void disturb(C& dsc, double size, unsigned seed) {
  std::mt19937 generator(seed);
  const auto random = [&] { return size * (2. * generator() / 4294967296. - 1); };
  std::vector<typename C::Vertex_handle> vertices;
  for (auto v : dsc.vertices())
    vertices.push_back(v);
  for (auto v : vertices) {
    const auto p = dsc.position(v);
    const double x = random(), y = random();
    if (!dsc.is_boundary(v))
      dsc.move_vertex(v, v->is_interface() ? typename C::Point_2(p.x(), p.y() + .3 * y)
                                           : typename C::Point_2(p.x() + x, p.y() + y));
  }
}

// The square [-1, 1]^2 with two labels.
Complex halves(int n, double size, unsigned seed) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  const auto index = [n](int i, int j) { return std::size_t(i * (n + 1) + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      points.emplace_back(2. * i / n - 1, 2. * j / n - 1);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (bool is_first : {true, false}) {
        if (is_first)
          triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
        else
          triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        labels.push_back(2 * i < n ? 1 : 0);
      }
  Complex dsc;
  dsc.assign(points, triangles, labels);
  disturb(dsc, size, seed);
  return dsc;
}

TEST(Improve_mesh_2, makes_triangles_better_and_leaves_the_interface) {
  for (unsigned seed : {1u, 2u, 3u}) {
    Complex dsc = halves(10, .19, seed);
    const double before = worst_quality(dsc);
    const double length = dsc.length(1);
    const auto report = DSC::improve_mesh(dsc, parameters::quality_threshold(.6));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_LT(before, .2);
    EXPECT_GT(worst_quality(dsc), .45) << seed;
    EXPECT_GT(report.flipped + report.smoothed + report.inserted, 0u);
    EXPECT_NEAR(dsc.length(1), length, 1e-14);
    for (auto v : dsc.interface_vertices())
      EXPECT_EQ(dsc.position(v).x(), 0);
  }
}

TEST(Improve_mesh_2, refuses_what_is_out_of_range) {
  Complex dsc = halves(4, 0, 1);
  EXPECT_THROW(DSC::improve_mesh(dsc, parameters::quality_threshold(2.)), Error);
  EXPECT_THROW(DSC::remove_degeneracies(dsc, parameters::degenerate_cosine(.1)), Error);
  EXPECT_EQ(DSC::improve_mesh(dsc, parameters::quality_threshold(.3).aggressive(true)).smoothed,
            0u);
}

// A square with a vertex in the middle and a needle: two vertices of its lower edge are close to
// each other.
Complex square_with(const std::vector<Point>& inner,
                    const std::vector<std::array<std::size_t, 3>>& triangles,
                    const std::vector<int>& labels) {
  std::vector<Point> points = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  points.insert(points.end(), inner.begin(), inner.end());
  Complex dsc;
  dsc.assign(points, triangles, labels);
  return dsc;
}

// Label 1 has a thin spike towards a = (-1, 0), a cap with its tip at c = (0, 0).
Complex spike(double height) {
  const std::vector<Point> inner = {{-1, 0}, {1, -height}, {0, 0}, {1, 1}};
  const std::size_t a = 4, b = 5, c = 6, d = 7;
  return square_with(inner,
                     {{a, b, c},
                      {b, d, c},
                      {a, 0, b},
                      {0, 1, b},
                      {1, 2, b},
                      {2, d, b},
                      {2, 3, d},
                      {3, c, d},
                      {3, a, c},
                      {3, 0, a}},
                     {1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
}

TEST(Cap_flip_2, moves_the_interface_to_the_tip) {
  Complex dsc = spike(.01);
  const double before = worst_quality(dsc);
  Cavity cavity(dsc);
  Complex::Cell_handle cap;
  for (auto c : dsc.cells())
    if (c->quality() == before)
      cap = c;
  int longest = 0;
  for (int i = 0; i < 3; ++i)
    if (dsc.measure(Complex::Facet(cap, i)) > dsc.measure(Complex::Facet(cap, longest)))
      longest = i;
  ASSERT_TRUE(propose_cap_flip(dsc, cap, longest, cavity));
  EXPECT_FALSE(propose_cap_flip(dsc, cap, (longest + 1) % 3, cavity) &&
               propose_cap_flip(dsc, cap, (longest + 2) % 3, cavity));
  EXPECT_FALSE(propose_edge_flip(dsc, cap, longest, cavity));
  const auto report = DSC::remove_degeneracies(dsc, parameters::degenerate_cosine(.99));
  EXPECT_EQ(report.flipped, 1u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_GT(worst_quality(dsc), 10 * before);
  EXPECT_NEAR(dsc.area(1), .505, 1e-12); // the triangle b d c
  EXPECT_EQ(dsc.number_of_components(1), 1u);
}

TEST(Remove_degeneracies_2, leaves_caps_within_the_threshold) {
  Complex dsc = spike(1);
  const auto report = DSC::remove_degeneracies(dsc);
  EXPECT_EQ(report.flipped + report.collapsed, 0u);
}

// A square of long, thin triangles between two rows of vertices. A vertex is inserted because no
// flip improves the triangles.
TEST(Vertex_insertion_2, breaks_up_needles) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  const std::size_t n = 12;
  for (std::size_t i = 0; i <= n; ++i)
    for (double y : {-1., 1.})
      points.emplace_back(2. * double(i) / n - 1, y);
  for (std::size_t i = 0; i < n; ++i) {
    triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  Complex dsc;
  dsc.assign(points, triangles, std::vector<int>(triangles.size(), 0));
  const double before = worst_quality(dsc);
  Cavity cavity(dsc);
  Complex::Cell_handle middle;
  for (auto c : dsc.cells())
    if (middle == Complex::Cell_handle() ||
        std::abs(dsc.corner(c, 0).x() + .01) < std::abs(dsc.corner(middle, 0).x() + .01))
      middle = c;
  ASSERT_TRUE(propose_vertex_insertion(dsc, middle, cavity));
  EXPECT_GT(cavity.quality_after(), cavity.quality_before());
  const auto report = DSC::improve_mesh(dsc, parameters::quality_threshold(.6));
  EXPECT_GT(report.inserted, 0u);
  EXPECT_GT(worst_quality(dsc), 1.5 * before);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Carried_values_2, linear_functions_constants_and_integrals_stay) {
  for (unsigned seed : {1u, 2u})
    carried_values_2::expect_carried(halves(8, .2, seed),
                                     [](const auto& p) { return 1 + 2 * p.x() - 3 * p.y(); });
}

} // namespace test_planar_improvement
