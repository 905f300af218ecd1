#include "mesh_helpers.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_traits_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/improve_mesh.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace {

using Rational = CGAL::Exact_rational;
using mesh_helpers::Random;
using Integers = std::array<double, 3>; // coordinates without rounding

// Defines a star about the origin by its link: facets counterclockwise as seen from outside, with
// integer coordinates.
struct Link
{
  std::vector<Integers> vertices;
  std::vector<std::array<std::size_t, 3>> facets;
};

Link octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// A star that is far from convex: facets of an octahedron are split repeatedly at points on random
// rays through them.
Link random_link(Random& random) {
  Link link = octahedron();
  for (Integers& v : link.vertices) {
    const double radius = double(1 + random.below(20));
    for (double& coordinate : v)
      coordinate *= radius;
  }
  for (int split = 0; split < 12; ++split) {
    const std::size_t f = random.below(link.facets.size());
    const auto corners = link.facets[f];
    Integers v = {0, 0, 0};
    for (std::size_t corner : corners) {
      const double weight = double(1 + random.below(3));
      for (int k = 0; k < 3; ++k)
        v[k] += weight * link.vertices[corner][k];
    }
    const std::size_t added = link.vertices.size();
    link.vertices.push_back(v);
    link.facets[f] = {corners[0], corners[1], added};
    link.facets.push_back({corners[1], corners[2], added});
    link.facets.push_back({corners[2], corners[0], added});
  }
  return link;
}

Rational determinant(const Integers& a, const Integers& b, const Integers& c) {
  const auto r = [](double x) { return Rational(x); };
  return r(a[0]) * (r(b[1]) * r(c[2]) - r(b[2]) * r(c[1])) -
         r(a[1]) * (r(b[0]) * r(c[2]) - r(b[2]) * r(c[0])) +
         r(a[2]) * (r(b[0]) * r(c[1]) - r(b[1]) * r(c[0]));
}

// Returns where the ray from the origin in direction d meets the link: d is a combination of the
// corners of each facet.
CGAL::Star_exit_3 brute_force_exit(const Link& link, const Integers& d) {
  for (std::size_t f = 0; f < link.facets.size(); ++f) {
    const Integers &a = link.vertices[link.facets[f][0]], &b = link.vertices[link.facets[f][1]],
                   &c = link.vertices[link.facets[f][2]];
    const Rational whole = determinant(a, b, c);
    const std::array<Rational, 3> weights = {
        determinant(d, b, c) / whole, determinant(a, d, c) / whole, determinant(a, b, d) / whole};
    int dimension = 2;
    bool is_hit = true;
    for (const Rational& w : weights) {
      is_hit = is_hit && w >= 0;
      dimension -= w == 0 ? 1 : 0;
    }
    if (is_hit)
      return {f, dimension, CGAL::to_double(1 / (weights[0] + weights[1] + weights[2]))};
  }
  return {link.facets.size(), 2, 0.};
}

template <class Kernel> class Traits_on_kernel : public testing::Test
{
protected:
  using Traits = CGAL::Deformable_simplicial_complex_traits_3<Kernel>;
  using Point = typename Traits::Point_3;

  // Returns the exit of the star with this link about the point `center`.
  CGAL::Star_exit_3 exit(const Link& link, const Integers& d, const Integers& center = {0, 0, 0}) {
    const auto point = [&](const Integers& v) {
      return Point(center[0] + v[0], center[1] + v[1], center[2] + v[2]);
    };
    std::vector<std::array<Point, 3>> facets;
    for (const auto& f : link.facets)
      facets.push_back(
          {point(link.vertices[f[0]]), point(link.vertices[f[1]]), point(link.vertices[f[2]])});
    return traits.link_intersection_3_object()(point({0, 0, 0}), point(d), facets);
  }

  void expect_same(const CGAL::Star_exit_3& a, const CGAL::Star_exit_3& b) {
    EXPECT_EQ(a.facet, b.facet);
    EXPECT_EQ(a.dimension, b.dimension);
    EXPECT_NEAR(a.parameter, b.parameter, 1e-12 * b.parameter);
  }

  Traits traits;
  Random random{3};
};

using Kernels = testing::Types<CGAL::Exact_predicates_inexact_constructions_kernel,
                               CGAL::Exact_predicates_exact_constructions_kernel,
                               CGAL::Simple_cartesian<Rational>>;
TYPED_TEST_SUITE(Traits_on_kernel, Kernels);

} // namespace

TYPED_TEST(Traits_on_kernel, orientation_is_exact) {
  using Point = typename TestFixture::Point;
  const auto orientation = this->traits.orientation_3_object();
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(orientation(o, x, y, z), CGAL::POSITIVE);
  EXPECT_EQ(orientation(x, o, y, z), CGAL::NEGATIVE);
  const double third = 1. / 3, smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation(o, x, y, Point(third, third, 0)), CGAL::COPLANAR);
  EXPECT_EQ(orientation(o, x, y, Point(third, third, smallest)), CGAL::POSITIVE);
  EXPECT_EQ(orientation(o, x, y, Point(third, third, -smallest)), CGAL::NEGATIVE);
  // 0.1 + 0.2 differs from 0.3: the four points do not lie in the plane x + y = z
  EXPECT_NE(orientation(o, Point(1, 1, 2), Point(1, 0, 1), Point(.1, .2, .3)), CGAL::COPLANAR);
}

TYPED_TEST(Traits_on_kernel, constructions_keep_double_coordinates) {
  using Approximate = typename TestFixture::Traits::Approximate_point_3;
  const auto exact = this->traits.construct_exact_point_3_object();
  const auto approximate = this->traits.construct_approximate_point_3_object();
  for (int i = 0; i < 100; ++i) {
    const Approximate p(this->random(-1, 1), this->random(-1e9, 1e9), this->random(0, 1e-300));
    EXPECT_EQ(approximate(exact(p)), p);
  }
  const auto volume = this->traits.compute_approximate_volume_3_object();
  const Approximate o(0, 0, 0), x(2, 0, 0), y(0, 3, 0), z(0, 0, 4);
  EXPECT_EQ(volume(o, x, y, z), 4);
  EXPECT_EQ(volume(x, o, y, z), -4);
}

TYPED_TEST(Traits_on_kernel, ray_through_a_facet) {
  this->expect_same(this->exit(octahedron(), {1, 2, 3}), {0, 2, 1. / 6});
  this->expect_same(this->exit(octahedron(), {-1, -2, -3}), {6, 2, 1. / 6});
}

TYPED_TEST(Traits_on_kernel, ray_through_an_edge_takes_the_first_facet) {
  this->expect_same(this->exit(octahedron(), {1, 1, 0}), {0, 1, .5});
  this->expect_same(this->exit(octahedron(), {0, -3, -1}), {6, 1, .25});
}

TYPED_TEST(Traits_on_kernel, ray_through_a_vertex_takes_the_first_facet) {
  this->expect_same(this->exit(octahedron(), {0, 0, 2}), {0, 0, .5});
  this->expect_same(this->exit(octahedron(), {0, -1, 0}), {2, 0, 1});
}

TYPED_TEST(Traits_on_kernel, parameter_tells_whether_a_segment_leaves_the_star) {
  const double inside = this->exit(octahedron(), {.25, .25, .25}).parameter,
               outside = this->exit(octahedron(), {.5, .5, .5}).parameter;
  EXPECT_DOUBLE_EQ(inside, 4. / 3);
  EXPECT_DOUBLE_EQ(outside, 2. / 3);
}

TYPED_TEST(Traits_on_kernel, ray_that_points_out_of_the_domain) {
  Link upper = octahedron(); // the star of a vertex at the bottom of the domain
  upper.facets.resize(4);
  EXPECT_EQ(this->exit(upper, {1, 2, -3}).facet, upper.facets.size());
  EXPECT_EQ(this->exit(upper, {0, 0, -1}).facet, upper.facets.size());
  EXPECT_EQ(this->exit(upper, {0, 0, -1}).parameter, 0);
  this->expect_same(this->exit(upper, {1, 2, 3}), {0, 2, 1. / 6});
  this->expect_same(this->exit(upper, {1, 2, 0}), {0, 1, 1. / 3}); // along the bottom
  this->expect_same(this->exit(upper, {2, 0, 0}), {0, 0, .5});
}

TYPED_TEST(Traits_on_kernel, random_stars_agree_with_brute_force) {
  for (int i = 0; i < 8; ++i) {
    const Link link = random_link(this->random);
    const Integers center = {double(this->random.below(9)), double(this->random.below(9)), 7.};
    const auto vertex = [&] { return link.vertices[this->random.below(link.vertices.size())]; };
    for (int ray = 0; ray < 8; ++ray) {
      Integers d = {double(this->random.below(41)) - 20, double(this->random.below(41)) - 20,
                    double(this->random.below(40)) + 1};
      this->expect_same(this->exit(link, d, center), brute_force_exit(link, d));
      d = vertex();
      ASSERT_EQ(brute_force_exit(link, d).dimension, 0);
      this->expect_same(this->exit(link, d, center), brute_force_exit(link, d));
      const auto f = link.facets[this->random.below(link.facets.size())];
      for (int k = 0; k < 3; ++k)
        d[k] = 2 * link.vertices[f[0]][k] + 5 * link.vertices[f[1]][k];
      ASSERT_EQ(brute_force_exit(link, d).dimension, 1);
      this->expect_same(this->exit(link, d, center), brute_force_exit(link, d));
    }
  }
}

// All operations run with any kernel and give bitwise equal results.
TYPED_TEST(Traits_on_kernel, complex_does_not_depend_on_the_kernel) {
  using Complex = CGAL::Deformable_simplicial_complex_3<typename TestFixture::Traits>;
  const auto mesh = small_meshes::grid(4, small_meshes::two_boxes);
  const auto run = [&](auto& dsc) {
    mesh_helpers::jitter(dsc, .2, 5);
    DSC::deform_interface(dsc, [&](auto v) {
      const auto p = dsc.position(v);
      return mesh_helpers::exact_point(
          dsc, p + .1 * typename Complex::Approximate_vector_3(p.y(), -p.x(), 1));
    });
    DSC::improve_mesh(dsc);
    EXPECT_TRUE(dsc.is_valid());
    return dsc.state();
  };
  Complex dsc;
  std::vector<typename Complex::Point_3> points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  dsc.assign(points, mesh.tetrahedra, mesh.labels);
  EXPECT_NEAR(dsc.volume(1), .5, 1e-14);
  small_meshes::Complex reference = small_meshes::make_complex(mesh);
  EXPECT_TRUE(run(dsc) == run(reference));
}
