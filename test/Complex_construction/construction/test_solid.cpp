#include "test.h"

#include <CGAL/Complex_construction/assign_solid_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

namespace test_solid {

using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default, DSC::Volume_length_ratio_3,
                                          DSC::Solid_domain>;
using Point = Complex::Point_3;
using DSC::Invalid_cells_error;

// Cubes of six tetrahedra each.
struct Cubes
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;

  // Adds the cubes of an n x n x n grid with labels that are not negative.
  template <class Label> Cubes(int n, const Label& label) {
    std::map<std::array<int, 3>, std::size_t> numbers;
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z) {
          if (label(x, y, z) < 0)
            continue;
          std::array<std::size_t, 3> axes = {0, 1, 2};
          do {
            std::array<int, 3> corner = {x, y, z};
            auto& tetrahedron = tetrahedra.emplace_back();
            for (std::size_t i = 0; i < 4; ++i) {
              const auto [known, is_new] = numbers.emplace(corner, points.size());
              if (is_new)
                points.emplace_back(corner[0], corner[1], corner[2]);
              tetrahedron[i] = known->second;
              if (i < 3)
                ++corner[axes[i]];
            }
            labels.push_back(label(x, y, z));
          } while (std::next_permutation(axes.begin(), axes.end()));
        }
  }

  std::map<int, double> volumes() const {
    std::map<int, double> result;
    for (const int label : labels)
      result[label] += 1. / 6;
    return result;
  }
};

// Checks that a complex consists of cubes, also after an improvement.
void expect_complex(const Cubes& cubes, std::size_t copies, std::size_t components) {
  Complex dsc;
  const auto vertices = DSC::assign_solid_3(dsc, cubes.points, cubes.tetrahedra, cubes.labels);
  ASSERT_EQ(vertices.size(), cubes.points.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(vertices[i]->point(), cubes.points[i]);
  EXPECT_EQ(dsc.number_of_vertices(), cubes.points.size() + copies);
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(dsc.is_valid(true));
    std::size_t sum = 0;
    for (const auto& [label, volume] : cubes.volumes()) {
      EXPECT_NEAR(dsc.volume(label), volume, 1e-9);
      sum += dsc.number_of_components(label);
    }
    EXPECT_EQ(sum, components);
    for (const auto v : dsc.vertices())
      EXPECT_TRUE(v->boundary_class() == 0 || v->boundary_class() == DSC::Boundary_class::fixed);
    const Complex copy = dsc;
    EXPECT_TRUE(copy.is_valid(true));
    EXPECT_TRUE(copy.state() == dsc.state());
    DSC::improve_mesh(dsc, CGAL::parameters::aggressive(true));
  }
}

int distance(int center, int x, int y, int z) {
  return (std::max)({std::abs(x - center), std::abs(y - center), std::abs(z - center)});
}

TEST(Solid, may_have_handles_parts_and_cavities) {
  const auto ring = [](int x, int y, int z) { return z > 0 || (x == 1 && y == 1) ? -1 : x > 1; };
  expect_complex(Cubes(3, ring), 0, 2);
  const auto parts = [](int x, int, int) { return x % 2 == 0 ? x : -1; };
  expect_complex(Cubes(5, parts), 0, 3);
  const auto shell = [](int x, int y, int z) { return distance(1, x, y, z) - 1; };
  expect_complex(Cubes(3, shell), 0, 1);
  const auto nested = [](int x, int y, int z) {
    const int d = distance(4, x, y, z);
    return d % 2 == 1 ? -1 : d;
  };
  expect_complex(Cubes(9, nested), 0, 3);
}

TEST(Solid, may_touch_itself) {
  const auto vertex = [](int x, int y, int z) { return x == y && y == z ? 1 : -1; };
  expect_complex(Cubes(2, vertex), 1, 2);
  const auto edge = [](int x, int y, int z) { return x == y && z == 0 ? 1 : -1; };
  expect_complex(Cubes(2, edge), 2, 2);
  // a ring of cubes that is closed by an edge
  const auto closed = [](int x, int y, int z) {
    return z == 0 && (x == 0 || y == 2 || (y == 0 && x == 1) || (x == 2 && y == 1)) ? 1 : -1;
  };
  expect_complex(Cubes(3, closed), 2, 1);
  const auto checkerboard = [](int x, int y, int z) { return (x + y + z) % 2 == 0 ? 1 : -1; };
  expect_complex(Cubes(4, checkerboard), 32 * 8 - Cubes(4, checkerboard).points.size(), 32);
}

TEST(Solid, slides_in_the_sides_of_a_box) {
  const Cubes cubes(3, [](int x, int, int) { return x; });
  Complex dsc;
  DSC::assign_solid_3(dsc, cubes.points, cubes.tetrahedra, cubes.labels);
  EXPECT_TRUE(dsc.is_valid());
  for (const auto v : dsc.vertices())
    EXPECT_EQ(v->boundary_class() & DSC::Boundary_class::fixed, 0);
}

TEST(Solid, refuses_cells_inside_others) {
  Complex dsc;
  Cubes cubes(1, [](int, int, int) { return 1; });
  const std::size_t n = cubes.points.size();
  cubes.points.insert(cubes.points.end(),
                      {{.3, .2, .1}, {.31, .2, .1}, {.3, .21, .1}, {.3, .2, .11}});
  cubes.tetrahedra.push_back({n, n + 1, n + 2, n + 3});
  cubes.labels.push_back(2);
  EXPECT_THROW(DSC::assign_solid_3(dsc, cubes.points, cubes.tetrahedra, cubes.labels),
               Invalid_cells_error);
}

TEST(Solid, refuses_cells_that_overlap) {
  const auto assign = [](const Cubes& cubes) {
    Complex dsc;
    DSC::assign_solid_3(dsc, cubes.points, cubes.tetrahedra, cubes.labels);
  };
  const Cubes cube(1, [](int, int, int) { return 1; });
  Cubes twice = cube;
  twice.tetrahedra.push_back(twice.tetrahedra.front());
  twice.labels.push_back(2);
  EXPECT_THROW(assign(twice), Invalid_cells_error);
  Cubes crossing = cube;
  for (const Point& p : cube.points)
    crossing.points.emplace_back(p.x() + .5, p.y() + .25, p.z() + .125);
  for (auto tetrahedron : cube.tetrahedra) {
    for (std::size_t& v : tetrahedron)
      v += cube.points.size();
    crossing.tetrahedra.push_back(tetrahedron);
    crossing.labels.push_back(1);
  }
  EXPECT_THROW(assign(crossing), Invalid_cells_error);
  Cubes unused = cube;
  unused.points.emplace_back(5, 5, 5);
  EXPECT_THROW(assign(unused), Invalid_cells_error);
  Cubes unlabeled = cube;
  unlabeled.labels.pop_back();
  EXPECT_THROW(assign(unlabeled), Invalid_cells_error);
}

} // namespace test_solid
