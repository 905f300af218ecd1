// Surfaces whose components touch at vertices and along edges.

#include "mesh_helpers.h"
#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

namespace test_touching_surfaces {

using namespace small_surfaces;

template <class NP = parameters::Default_named_parameters>
Complex build(const Surfaces& surfaces, const NP& np = NP()) {
  Complex dsc = DSC::make_deformable_simplicial_complex_3<Complex>(
      surfaces, CGAL::Tetgen_tetrahedralizer_3(), np);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

Surface tetrahedron(const std::vector<Point>& corners) {
  return {corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, 1};
}

// A tetrahedron with three mutually orthogonal edges at the origin.
Surface corner(double x, double y, double z) {
  return tetrahedron({{0, 0, 0}, {x, 0, 0}, {0, y, 0}, {0, 0, z}});
}

Surface cube(const Point& p, double side) {
  return box({p.x(), p.y(), p.z()}, {p.x() + side, p.y() + side, p.z() + side});
}

// Two tetrahedra without their common facet; the volume is 8/3 (top - bottom).
Surface bipyramid(double bottom, double top, int label) {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, bottom}, {1, 1, top}},
          {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}},
          label};
}

Surface labeled(Surface s, int label) {
  s.label = label;
  return s;
}

// Merges surfaces; equal points become one point if requested.
Surface united(const Surfaces& parts, bool shares_points) {
  Surface result;
  result.label = parts.front().label;
  for (const Surface& part : parts)
    for (const auto& t : part.triangles) {
      std::array<std::size_t, 3> triangle;
      for (int i = 0; i < 3; ++i) {
        const auto first = shares_points ? result.points.begin() : result.points.end();
        const auto found = std::find(first, result.points.end(), part.points[t[i]]);
        triangle[i] = found - result.points.begin();
        if (found == result.points.end())
          result.points.push_back(part.points[t[i]]);
      }
      result.triangles.push_back(triangle);
    }
  return result;
}

std::size_t number_of_points(const Surfaces& surfaces) {
  std::set<Point> points;
  for (const Surface& s : surfaces)
    points.insert(s.points.begin(), s.points.end());
  return points.size();
}

std::size_t number_of_triangles(const Surfaces& surfaces) {
  std::size_t n = 0;
  for (const Surface& s : surfaces)
    n += s.triangles.size();
  return n;
}

void expect_interface(const Complex& dsc, const Surfaces& surfaces) {
  EXPECT_EQ(dsc.interface_vertices().size(), number_of_points(surfaces));
  EXPECT_EQ(dsc.interface_facets().size(), number_of_triangles(surfaces));
}

// Three steps of a quarter of the mean edge length.
void expect_growth(Complex& dsc) {
  const double speed = dsc.mean_interface_edge() / 4;
  for (int step = 0; step < 3; ++step) {
    const double outside = dsc.volume(0);
    DSC::advect_interface(dsc, DSC::Normal_offset{speed}, step, 1.,
                          parameters::domain_rule(DSC::Domain_rule::stop));
    EXPECT_TRUE(dsc.is_valid(true));
    EXPECT_LT(dsc.volume(0), outside);
  }
}

// Builds components of equal volume as one surface, and as separate surfaces.
void expect_parts(Surfaces parts, double volume) {
  for (bool shares_points : {true, false}) {
    const Surface surface = united(parts, shares_points);
    Complex dsc =
        build(Surfaces{surface}, parameters::enclosing_box(CGAL::Bbox_3(-4, -4, -4, 4, 4, 4)));
    EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1}));
    EXPECT_NEAR(dsc.volume(1), double(parts.size()) * volume, 1e-13);
    EXPECT_NEAR(dsc.volume(0) + dsc.volume(1), 512, 1e-10);
    EXPECT_EQ(dsc.number_of_components(1), parts.size());
    EXPECT_EQ(dsc.number_of_components(0), 1u);
    expect_interface(dsc, parts);
    expect_growth(dsc);
  }

  std::vector<int> labels = {0};
  for (Surface& part : parts) {
    labels.push_back(int(labels.size()));
    part.label = labels.back();
  }
  Complex dsc = build(parts);
  EXPECT_EQ(dsc.labels(), labels);
  for (std::size_t i = 1; i < labels.size(); ++i) {
    EXPECT_NEAR(dsc.volume(labels[i]), volume, 1e-13);
    EXPECT_EQ(dsc.number_of_components(labels[i]), 1u);
  }
  EXPECT_EQ(dsc.number_of_components(0), 1u);
  expect_interface(dsc, parts);
  expect_growth(dsc);
}

TEST(Touching_surfaces, tetrahedra_at_a_vertex) {
  expect_parts({corner(1, 1, 1), corner(-1, -1, -1)}, 1. / 6.);
}

TEST(Touching_surfaces, tetrahedra_at_an_edge) {
  expect_parts({corner(1, 1, 1), corner(1, -1, -1)}, 1. / 6.);
}

TEST(Touching_surfaces, cubes_at_a_vertex) {
  expect_parts({cube(Point(0, 0, 0), 1), cube(Point(1, 1, 1), 1)}, 1);
}

TEST(Touching_surfaces, cubes_at_an_edge) {
  expect_parts({cube(Point(0, 0, 0), 1), cube(Point(1, 1, 0), 1)}, 1);
}

TEST(Touching_surfaces, six_triangles_at_an_edge) {
  expect_parts({tetrahedron({{0, 0, 0}, {2, 0, 1}, {2, 1, 0}, {0, 0, 3}}),
                tetrahedron({{0, 0, 0}, {-1, 1, 1}, {-2, 0, 0}, {0, 0, 3}}),
                tetrahedron({{0, 0, 0}, {-1, -1, 1}, {0, -2, 0}, {0, 0, 3}})},
               1);
}

// Five of eight cubes; two of them have only an edge in common.
TEST(Touching_surfaces, an_edge_of_four_triangles_in_one_part) {
  std::vector<Point> lowest_corners = {{0, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}};
  using Triangle = std::array<Point, 3>;
  std::set<Triangle> boundary;
  for (const Point& p : lowest_corners) {
    const Surface s = cube(p, 1);
    for (const auto& t : s.triangles) {
      Triangle triangle = {s.points[t[0]], s.points[t[1]], s.points[t[2]]};
      std::sort(triangle.begin(), triangle.end());
      if (!boundary.insert(triangle).second)
        boundary.erase(triangle); // between two cubes
    }
  }
  Surface s;
  s.label = 1;
  for (const Triangle& triangle : boundary) {
    s.triangles.push_back({s.points.size(), s.points.size() + 1, s.points.size() + 2});
    s.points.insert(s.points.end(), triangle.begin(), triangle.end());
  }
  Complex dsc = build(Surfaces{s});
  EXPECT_NEAR(dsc.volume(1), 5, 1e-13);
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_EQ(dsc.number_of_components(0), 1u);
  expect_interface(dsc, {s});
  expect_growth(dsc);
}

TEST(Touching_surfaces, any_orientation) {
  Surface upside_down = corner(-1, -1, -1);
  for (auto& t : upside_down.triangles)
    std::swap(t[0], t[1]);
  const Complex dsc = build({united({corner(1, 1, 1), upside_down}, true)});
  EXPECT_NEAR(dsc.volume(1), 1. / 3., 1e-13);
}

TEST(Touching_surfaces, a_part_in_another_is_a_cavity) {
  for (bool shares_points : {true, false}) {
    // touching at a vertex
    const Surface inner =
        tetrahedron({{0, 0, 0}, {1.5, .25, .25}, {.25, 1.5, .25}, {.25, .25, 1.5}});
    Complex dsc = build({united({corner(3, 3, 3), inner}, shares_points)});
    EXPECT_NEAR(dsc.volume(1), 4.5 - 25. / 48., 1e-12);
    EXPECT_EQ(dsc.number_of_components(1), 1u);
    EXPECT_EQ(dsc.number_of_components(0), 2u);
    expect_growth(dsc);

    // touching along three edges: the two remaining components touch only there
    Complex shell = build({united({bipyramid(-3, 3, 1), bipyramid(-1, 1, 1)}, shares_points)});
    EXPECT_NEAR(shell.volume(1), 16 - 16. / 3., 1e-12);
    EXPECT_EQ(shell.number_of_components(1), 2u);
    EXPECT_EQ(shell.number_of_components(0), 2u);
    expect_growth(shell);

    // intersecting in three edges
    Complex crossing = build({united({bipyramid(-3, 3, 1), bipyramid(-2, 4, 1)}, shares_points)});
    EXPECT_NEAR(crossing.volume(1), 16. / 3., 1e-12);
    EXPECT_EQ(crossing.number_of_components(1), 2u);
    EXPECT_EQ(crossing.number_of_components(0), 2u);
  }
}

TEST(Touching_surfaces, nested_surfaces_in_any_order) {
  Surfaces surfaces = {bipyramid(-3, 3, 5), bipyramid(-2, 2, -2), bipyramid(-1, 1, 7)};
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    Complex dsc = build(Surfaces{surfaces[order[0]], surfaces[order[1]], surfaces[order[2]]});
    for (int label : {5, -2, 7})
      EXPECT_NEAR(dsc.volume(label), 16. / 3., 1e-12) << label;
    EXPECT_EQ(dsc.number_of_components(5), 2u);
    EXPECT_EQ(dsc.number_of_components(-2), 2u);
    EXPECT_EQ(dsc.number_of_components(7), 1u);
    EXPECT_EQ(dsc.interface_vertices().size(), 9u);
    expect_growth(dsc);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Touching_surfaces, the_box_counts_common_points_once) {
  const Surface a = corner(1, 1, 1), b = corner(1, -1, -1);
  const Complex together = build({united({a, b}, true)}), apart = build({a, b});
  EXPECT_EQ(together.volume(0) + together.volume(1), apart.volume(0) + apart.volume(1));
  EXPECT_EQ(mesh_helpers::interface_triangles(together), mesh_helpers::interface_triangles(apart));
}

TEST(Touching_surfaces, normalized) {
  const Surfaces surfaces = {cube(Point(0, 0, 0), 1), labeled(cube(Point(1, 1, 0), 1), 2)};
  const Complex dsc = build(surfaces, parameters::normalize(true));
  EXPECT_EQ(dsc.interface_vertices().size(), 14u);
}

} // namespace test_touching_surfaces
