#include "plane.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#include <numeric>

namespace test_plane {

using plane::Complex;
using plane::Point;
using Report = DSC::Deformation_report<Complex>;
constexpr double pi = 3.14159265358979323846;

Point rotated(const Point& p, double angle) {
  return Point(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
               std::sin(angle) * p.x() + std::cos(angle) * p.y());
}

TEST(Plane, disk_rotated_by_a_full_turn_is_back) {
  Complex complex = plane::disks_in_a_square({{.5, 0, .4, 1}}, 40, 2, 20);
  ASSERT_TRUE(complex.is_valid());
  std::map<std::size_t, Point> start;
  for (auto v : complex.interface_vertices())
    start[v->time_stamp()] = v->point();
  const double area = complex.area(1);
  static constexpr int steps = 72;
  for (int step = 0; step < steps; ++step) {
    const Report report = DSC::deform_interface(complex, [&](Complex::Vertex_handle v) {
      return rotated(start.at(v->time_stamp()), 2 * pi * (step + 1) / steps);
    });
    ASSERT_TRUE(report.complete) << step;
    ASSERT_TRUE(report.events.empty());
    ASSERT_TRUE(complex.is_valid(true)) << step;
  }
  ASSERT_EQ(complex.interface_vertices().size(), start.size());
  for (auto v : complex.interface_vertices())
    EXPECT_LT((v->point() - start.at(v->time_stamp())).squared_length(), 1e-24);
  EXPECT_NEAR(complex.area(1), area, 1e-12);
}

TEST(Plane, disks_that_meet_merge) {
  Complex complex = plane::disks_in_a_square({{-.6, 0, .4, 1}, {.6, 0, .4, 1}}, 40, 2, 20);
  ASSERT_TRUE(complex.is_valid());
  ASSERT_EQ(complex.number_of_components(1), 2u);
  std::size_t merged = 0, others = 0;
  for (int step = 0; step < 12; ++step) {
    const double way = .03;
    const Report report = DSC::deform_interface(complex, [&](Complex::Vertex_handle v) {
      const auto p = complex.position(v);
      return Point(p.x() > 0 ? p.x() - way : p.x() + way, p.y());
    });
    for (const auto& event : report.events)
      (event.kind == DSC::Component_event::Kind::merged ? merged : others) += 1;
    ASSERT_TRUE(complex.is_valid(true)) << step;
  }
  EXPECT_EQ(complex.number_of_components(1), 1u);
  EXPECT_EQ(merged, 1u);
  EXPECT_EQ(others, 0u);
}

// Returns the free vertices outside a disk whose distance to the disk is less than half its radius,
// with their positions.
std::map<Complex::Vertex_handle, Point> vertices_around(const Complex& complex, double radius) {
  std::map<Complex::Vertex_handle, Point> result;
  for (auto v : complex.vertices())
    if (!v->is_interface()) {
      const double distance = std::hypot(v->point().x(), v->point().y());
      if (distance > radius && distance < 1.5 * radius)
        result[v] = v->point();
    }
  return result;
}

TEST(Plane, space_without_flow_follows_the_interface) {
  Complex complex = plane::disks_in_a_square({{0, 0, .5, 1}}, 40, 2, 20);
  const auto around = vertices_around(complex, .5);
  ASSERT_GT(around.size(), 10u);
  const double way = .05;
  const auto flow = [&](Complex::Vertex_handle v) {
    const auto p = complex.position(v);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return p.x() * p.x() + p.y() * p.y() < .26 ? p + Complex::Vector_2(way, 0)
                                               : Complex::Point_2(unknown, unknown);
  };
  const Report report = DSC::deform_interface(
      complex,
      [&](Complex::Vertex_handle v) { return Point(v->point().x() + way, v->point().y()); },
      CGAL::parameters::flow(flow));
  EXPECT_TRUE(report.complete);
  double least = way;
  for (const auto& v : around)
    least = (std::min)(least, v.first->point().x() - v.second.x());
  EXPECT_GT(least, .2 * way);
}

// A band across the square. Its contact points move along two sides of the square.
TEST(Plane, free_vertices_on_the_boundary_move_with_the_interface) {
  const int n = 12;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  const auto index = [&](int i, int j) { return std::size_t(i * (n + 1) + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      points.emplace_back(j, i);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
      labels.insert(labels.end(), 2, j >= 5 && j < 7 ? 1 : 0);
    }
  Complex complex;
  const auto vertices = complex.assign(points, triangles, labels);
  const Report report = DSC::deform_interface(
      complex, [](Complex::Vertex_handle v) { return Point(v->point().x() + .6, v->point().y()); });
  EXPECT_TRUE(report.complete);
  EXPECT_TRUE(complex.is_valid(true));
  const Point beside = vertices[index(0, 8)]->point(), corner = vertices[index(0, 0)]->point();
  EXPECT_GT(beside.x(), 8.1);
  EXPECT_EQ(beside.y(), 0);
  EXPECT_EQ(corner, Point(0, 0));
}

// One cell of subnormal area must not disturb the displacements of other cells.
TEST(Plane, flat_cells_do_not_change_the_extension_of_the_displacement) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto index = [](int i, int j) { return std::size_t((i + 2) * 5 + j + 2); };
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      points.emplace_back(j, i);
  for (int i = -2; i < 2; ++i)
    for (int j = -2; j < 2; ++j) {
      triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  Complex complex;
  const auto vertices = complex.assign(points, triangles, std::vector<int>(triangles.size(), 0));
  ASSERT_EQ(complex.move_vertex(vertices[index(1, 0)], Point(0, 1e-310)), 1);
  std::vector<Complex::Vertex_handle> free;
  for (auto v : complex.vertices())
    if (!complex.is_boundary(v))
      free.push_back(v);
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  const DSC::For_each_index for_each_index;
  const internal::Moving_region<Complex> region(complex, free, for_each_index);
  std::vector<std::uint32_t> numbers(free.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const internal::Harmonic_extension<Complex> extension(
      region, numbers, [](std::size_t) { return Complex::Vector_2(1, 0); }, for_each_index);
  for (const auto& d : extension.solve())
    EXPECT_NEAR(d.x(), 1, .1);
}

// A linear field has constant gradient and divergence, and the masses sum up to the total area.
TEST(Plane, linear_elements_reproduce_linear_fields) {
  const Complex complex = plane::disks_in_a_square({{.3, .1, .8, 1}}, 24, 2, 12);
  using Vector = Complex::Vector_2;
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  double mass = 0;
  for (auto c : complex.cells()) {
    const DSC::Linear_element<Complex> element(complex, c);
    Vector gradient(0, 0);
    std::array<Vector, 3> field;
    for (int i = 0; i < 3; ++i) {
      const auto p = complex.corner(c, i);
      gradient = gradient + (3 * p.x() - 2 * p.y() + 1) * element.gradient(i);
      field[i] = Vector(4 * p.x() + p.y(), 5 * p.x() - p.y());
      mass += element.lumped_mass();
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(element.stiffness(i, j),
                    element.measure() * (element.gradient(i) * element.gradient(j)), 1e-12);
      const auto evened = element.evened_stiffness();
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(evened[element.edge(i, j)] * element.measure(), element.stiffness(i, j), 1e-9);
    }
    EXPECT_NEAR(gradient.x(), 3, 1e-10);
    EXPECT_NEAR(gradient.y(), -2, 1e-10);
    EXPECT_NEAR(element.divergence(field), 3 * element.measure(), 1e-12);
    EXPECT_NEAR(element.measure(), complex.measure(c), 1e-14);
  }
  EXPECT_NEAR(mass, 16, 1e-12);
}

} // namespace test_plane
