// Certificates of a reconstruction: empty balls whose sides are known, and handles that are too
// small to be real.

#include "test.h"

#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Misplaced_balls_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Small_handles_3.h>
#include <CGAL/number_utils.h>

namespace test_reconstruction_certificate {

namespace internal = CGAL::Deformable_simplicial_complexes::internal;
using Point = internal::Cloud_kernel::Point_3;
using Vector = internal::Cloud_kernel::Vector_3;
using Triangles = internal::Closed_triangles_3::Triangles;

// Points of the unit sphere along a spiral.
std::vector<Point> sphere(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
    points.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return points;
}

// An octahedron about a point, with its corners at a given distance.
Triangles octahedron(const Point& center, double radius) {
  Triangles result;
  for (const double x : {-radius, radius})
    for (const double y : {-radius, radius})
      for (const double z : {-radius, radius})
        result.emplace_back(center + Vector(x, 0, 0), center + Vector(0, y, 0),
                            center + Vector(0, 0, z));
  return result;
}

struct Facet
{
  std::array<std::size_t, 3> vertices;
};

// A torus about the z axis with n by n vertices. The center line of its tube is at distance 1 from
// the axis.
struct Torus
{
  std::vector<Point> positions;
  std::vector<Facet> facets;

  Torus(std::size_t n, double tube) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double a = 2 * CGAL_PI * double(i) / double(n),
                     b = 2 * CGAL_PI * double(j) / double(n), r = 1 + tube * std::cos(b);
        positions.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
        const std::size_t k = (i + 1) % n, l = (j + 1) % n;
        facets.push_back({{{n * i + j, n * k + j, n * k + l}}});
        facets.push_back({{{n * i + j, n * k + l, n * i + l}}});
      }
  }
  std::size_t number_of_handles(double radius) const {
    return internal::Small_handles_3(facets, positions)
        .find(std::vector<double>(positions.size(), radius))
        .size();
  }
};

TEST(Reconstruction_certificate, finds_balls_on_the_wrong_side) {
  const internal::Sampled_surface_3 surface(sphere(1000), {}, 1);
  EXPECT_GT(surface.known_balls().size(), 100);
  EXPECT_TRUE(internal::misplaced_balls(surface, octahedron(Point(0, 0, 0), 1.2)).empty());
  // A solid at another position does not contain the ball.
  const auto lost = internal::misplaced_balls(surface, octahedron(Point(0, 0, 30), 1));
  ASSERT_FALSE(lost.empty());
  EXPECT_LT(std::sqrt((lost.front() - Point(0, 0, 0)).squared_length()), .1);
  // A solid with a void that the points do not have.
  Triangles with_void = octahedron(Point(0, 0, 0), 1.2);
  for (const auto& t : octahedron(Point(0, 0, 0), .3))
    with_void.push_back(t);
  EXPECT_EQ(internal::misplaced_balls(surface, with_void).size(), 1);
}

TEST(Reconstruction_certificate, does_not_know_balls_in_holes) {
  std::vector<Point> points;
  for (const Point& p : sphere(2000))
    if (p.z() < .8)
      points.push_back(p);
  const internal::Sampled_surface_3 surface(points, {}, 1);
  const auto balls = surface.known_balls();
  EXPECT_FALSE(balls.empty());
  for (const auto& ball : balls) {
    const double radius = std::sqrt(ball.ball.squared_radius);
    EXPECT_TRUE(ball.ball.center.z() + radius < .85 || ball.ball.center.z() - radius > .75 ||
                std::hypot(ball.ball.center.x(), ball.ball.center.y()) > .6);
  }
}

TEST(Reconstruction_certificate, finds_small_handles) {
  const Torus torus(12, .4);
  EXPECT_EQ(torus.number_of_handles(.3), 0);  // disks
  EXPECT_EQ(torus.number_of_handles(1.), 0);  // pieces of the tube
  EXPECT_EQ(torus.number_of_handles(2.9), 1); // the whole torus
  EXPECT_EQ(torus.number_of_handles(0), 0);
}

} // namespace test_reconstruction_certificate
