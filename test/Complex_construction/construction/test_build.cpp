#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>

namespace test_build {

using namespace small_surfaces;
using Tetrahedra = std::vector<std::array<std::size_t, 4>>;
using CGAL::Deformable_simplicial_complexes::Error;
using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using CGAL::Deformable_simplicial_complexes::Tetrahedralization_error;

template <class Input, class NP = parameters::Default_named_parameters>
Complex build(const Input& input, const NP& np = NP()) {
  Complex dsc = DSC::make_deformable_simplicial_complex_3<Complex>(
      input, CGAL::Tetgen_tetrahedralizer_3(), np);
  EXPECT_TRUE(dsc.is_valid(true));
  return dsc;
}

// A cube about a center.
Surface cube(double half_side, int label, const Point& center = Point(0, 0, 0)) {
  std::array<double, 3> low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = center[axis] - half_side;
    high[axis] = center[axis] + half_side;
  }
  return box(low, high, label);
}

Surface inside_out(Surface s) {
  for (auto& t : s.triangles)
    std::swap(t[0], t[1]);
  return s;
}

using Triangle = std::array<Point, 3>;

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

std::vector<Triangle> triangles(const Surfaces& surfaces) {
  std::vector<Triangle> result;
  for (const Surface& s : surfaces)
    for (const auto& t : s.triangles)
      result.push_back(sorted({s.points[t[0]], s.points[t[1]], s.points[t[2]]}));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Triangle> triangles(const Complex& dsc) {
  std::vector<Triangle> result;
  for (const auto& f : dsc.interface_facets()) {
    const auto v = dsc.facet_vertices(f);
    result.push_back(sorted({v[0]->point(), v[1]->point(), v[2]->point()}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_volume(const Complex& dsc, int label, double volume) {
  const double scale = dsc.normalization().scale;
  EXPECT_NEAR(dsc.volume(label) * scale * scale * scale, volume, 1e-12) << "label " << label;
}

TEST(Build, an_octahedron) {
  const Surfaces surfaces = {octahedron(1, 1)};
  const Complex dsc = build(surfaces);
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1}));
  expect_volume(dsc, 1, 4. / 3.);
  expect_volume(dsc, 0, 125 - 4. / 3.); // the box is [-2.5,2.5]^3
  EXPECT_EQ(dsc.euler_characteristic(1), 2);
  EXPECT_EQ(triangles(dsc), triangles(surfaces));
  EXPECT_EQ(dsc.normalization().scale, 1);
}

TEST(Build, a_cube_is_not_retriangulated) {
  const Surfaces surfaces = {cube(1, 1)};
  const Complex dsc = build(surfaces, parameters::improve(false));
  expect_volume(dsc, 1, 8);
  EXPECT_EQ(triangles(dsc), triangles(surfaces));
}

TEST(Build, improvement_keeps_the_interface) {
  const Surfaces surfaces = {cube(1, 3), octahedron(.5, 4)};
  const Complex raw = build(surfaces, parameters::improve(false)), improved = build(surfaces);
  EXPECT_EQ(triangles(raw), triangles(surfaces));
  EXPECT_EQ(triangles(improved), triangles(surfaces));
  const auto worst = [](const Complex& dsc) {
    double quality = 1;
    for (auto c : dsc.cells())
      quality = (std::min)(quality, dsc.quality(c));
    return quality;
  };
  EXPECT_GE(worst(improved), worst(raw));
}

TEST(Build, nested_surfaces_in_any_order) {
  Surfaces surfaces = {cube(1, 5), cube(.5, -2), octahedron(.25, 7)};
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    const Complex dsc =
        build(Surfaces{surfaces[order[0]], inside_out(surfaces[order[1]]), surfaces[order[2]]});
    EXPECT_EQ(dsc.labels(), (std::vector<int>{-2, 0, 5, 7}));
    expect_volume(dsc, 5, 8 - 1);
    expect_volume(dsc, -2, 1 - 1. / 48.);
    expect_volume(dsc, 7, 1. / 48.);
    EXPECT_EQ(triangles(dsc), triangles(surfaces));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Build, a_surface_nested_in_itself_bounds_a_cavity) {
  for (bool turn : {false, true}) {
    Surface shell = cube(1, 1);
    append(shell, turn ? inside_out(cube(.5, 1)) : cube(.5, 1));
    const Complex dsc = build(Surfaces{shell, octahedron(.25, 2)});
    expect_volume(dsc, 1, 8 - 1);
    expect_volume(dsc, 2, 1. / 48.);
    EXPECT_EQ(dsc.number_of_components(0), 2u);

    append(shell, cube(.375, 1));
    const Complex island = build(Surfaces{shell, octahedron(.25, 2)});
    expect_volume(island, 1, 8 - 1 + .421875 - 1. / 48.);
    EXPECT_EQ(island.number_of_components(1), 2u);
  }
}

TEST(Build, a_cavity_that_spans_two_surfaces) {
  // The inner cube of surface 0 ends surface 0 inside surface 1, which continues.
  Surface shell = cube(1, 1);
  append(shell, cube(.25, 1));
  const Complex dsc = build(Surfaces{shell, cube(.5, 2)});
  expect_volume(dsc, 1, 8 - 1);
  expect_volume(dsc, 2, 1);
  EXPECT_EQ(dsc.interface_facets().size(), 24u); // both sides of the third cube have label 2
}

TEST(Build, label_zero_cuts_a_hole) {
  const Complex dsc = build(Surfaces{cube(1, 1), cube(.5, 0)});
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1}));
  expect_volume(dsc, 1, 8 - 1);
}

TEST(Build, parts_side_by_side) {
  Surface two = cube(.5, 1, Point(-1, 0, 0));
  append(two, cube(.5, 1, Point(1, 0, 0)));
  const Complex dsc = build(Surfaces{two, octahedron(.25, 1)});
  expect_volume(dsc, 1, 2 + 1. / 48.);
  EXPECT_EQ(dsc.number_of_components(1), 3u);
}

TEST(Build, orientations_do_not_matter) {
  std::mt19937 random(1);
  for (int i = 0; i < 5; ++i) {
    Surface s = cube(1, 1);
    for (auto& t : s.triangles)
      std::shuffle(t.begin(), t.end(), random);
    std::shuffle(s.triangles.begin(), s.triangles.end(), random);
    const Complex dsc = build(Surfaces{s});
    expect_volume(dsc, 1, 8);
    EXPECT_EQ(triangles(dsc), triangles(Surfaces{s}));
  }
}

TEST(Build, separate_triangles_are_connected) {
  const Surface connected = cube(1, 1);
  Surface soup;
  soup.points.emplace_back(100, 0, 0); // belongs to no triangle
  for (const auto& t : connected.triangles) {
    soup.triangles.push_back({soup.points.size(), soup.points.size() + 1, soup.points.size() + 2});
    for (std::size_t i : t)
      soup.points.push_back(connected.points[i]);
  }
  const Complex dsc = build(Surfaces{soup});
  expect_volume(dsc, 1, 8);
  EXPECT_EQ(dsc.interface_vertices().size(), 8u);
}

TEST(Build, normalization_and_back) {
  const Surfaces surfaces = {octahedron(3, 1), cube(.1, 2, Point(.5, .25, -.125))};
  Surfaces moved = surfaces;
  for (Surface& s : moved)
    for (Point& p : s.points)
      p = p + Complex::Geom_traits::Vector_3(1000, -50, 7);
  const Complex dsc = build(moved, parameters::normalize(true));

  double farthest = 0;
  CGAL::Bbox_3 box;
  for (auto v : dsc.vertices())
    box += dsc.position(v).bbox();
  EXPECT_EQ(box, CGAL::Bbox_3(-1, -1, -1, 1, 1, 1));
  std::vector<Point> expected, found;
  for (const Surface& s : moved)
    expected.insert(expected.end(), s.points.begin(), s.points.end());
  Complex::Vector_3 sum(0, 0, 0);
  for (auto v : dsc.interface_vertices()) {
    const auto p = dsc.user_position(v);
    found.emplace_back(p.x(), p.y(), p.z());
    const auto radius = dsc.position(v) - CGAL::ORIGIN;
    farthest = (std::max)(farthest, std::sqrt(radius.squared_length()));
    sum = sum + radius;
  }
  EXPECT_NEAR(farthest, 1 / 2.5, 1e-12);
  EXPECT_NEAR(sum.squared_length(), 0, 1e-20);
  ASSERT_EQ(found.size(), expected.size());
  for (const Point& p : expected) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& q : found)
      nearest = (std::min)(nearest, CGAL::squared_distance(p, q));
    EXPECT_LT(nearest, 1e-24);
  }
  const double scale = dsc.normalization().scale;
  EXPECT_NEAR(dsc.volume(2) * scale * scale * scale, .008, 1e-12);
}

TEST(Build, the_box_that_was_asked_for) {
  using Iso_cuboid = Complex::Geom_traits::Iso_cuboid_3;
  const CGAL::Bbox_3 box(-1.5, -2, -3, 1.25, 1.5, 1.1);
  const Iso_cuboid cuboid(box);
  const auto vertices_on_box = [](const Complex& dsc) {
    const auto vertices = dsc.vertices();
    return std::count_if(vertices.begin(), vertices.end(),
                         [&](Complex::Vertex_handle v) { return dsc.is_boundary(v); });
  };
  for (unsigned n : {1u, 2u, 3u, 5u}) {
    const auto np = parameters::enclosing_box(box).box_subdivision(n).improve(false);
    const Complex dsc = build(Surfaces{cube(1, 1)}, np);
    expect_volume(dsc, 0, 2.75 * 3.5 * 4.1 - 8);
    EXPECT_EQ(vertices_on_box(dsc), long(6 * n * n + 2));
    const Complex same =
        build(Surfaces{cube(1, 1)}, parameters::enclosing_box(cuboid).box_subdivision(n));
    expect_volume(same, 0, 2.75 * 3.5 * 4.1 - 8);
  }
  const Complex normalized =
      build(Surfaces{cube(1, 1)}, parameters::normalize(true).enclosing_box(box));
  EXPECT_NEAR(normalized.volume(0) * std::pow(normalized.normalization().scale, 3),
              2.75 * 3.5 * 4.1 - 8, 1e-11);
}

TEST(Build, no_cell_has_three_facets_on_the_box) {
  for (unsigned n : {2u, 3u, 4u}) {
    const Complex dsc = build(Surfaces{cube(1, 1)}, parameters::box_subdivision(n).improve(false));
    for (auto c : dsc.cells()) {
      int infinite_neighbors = 0;
      for (int i = 0; i < 4; ++i)
        infinite_neighbors += dsc.is_infinite(c->neighbor(i));
      EXPECT_LE(infinite_neighbors, 2);
    }
  }
}

TEST(Build, any_size_and_place) {
  for (int exponent : {-90, -30, 30, 90}) {
    const double scale = std::ldexp(1., exponent);
    const Complex dsc = build(Surfaces{cube(scale, 1)}, parameters::improve(false));
    EXPECT_EQ(triangles(dsc), triangles(Surfaces{cube(scale, 1)})) << exponent;
  }
  for (int exponent : {-300, 300}) { // volumes and qualities would overflow
    const Surfaces extreme = {cube(std::ldexp(1., exponent), 1)};
    EXPECT_THROW(build(extreme), CGAL::Deformable_simplicial_complexes::Error);
    EXPECT_EQ(build(extreme, parameters::normalize(true)).interface_facets().size(), 12u);
  }
  const Surfaces distant = {cube(1, 1, Point(1e12, -1e12, 1e11))};
  EXPECT_EQ(triangles(build(distant)), triangles(distant));
}

TEST(Build, refuses_what_normalization_makes_equal) {
  const Surfaces surfaces = {cube(1e-20, 1), cube(1, 2, Point(3, 3, 3))};
  const auto e =
      thrown_by<Invalid_surface_error>([&] { build(surfaces, parameters::normalize(true)); });
  EXPECT_EQ(e.reason(), Invalid_surface_error::Reason::too_fine);
  EXPECT_EQ(e.surface(), 0u);
  EXPECT_THROW(build(Surfaces{cube(8e307, 1)}, parameters::normalize(true)), Error);
}

TEST(Build, a_mesh) {
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_icosahedron<CGAL::Surface_mesh<Point>, Point>(mesh);
  mesh.remove_vertex(mesh.add_vertex(Point(50, 0, 0))); // the indices have a gap now
  const Complex dsc = build(mesh);
  EXPECT_EQ(dsc.interface_facets().size(), 20u);
  EXPECT_EQ(dsc.number_of_cells(1) > 0, true);

  auto tripled =
      mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, Point>("v:tripled").first;
  for (auto v : mesh.vertices())
    tripled[v] = CGAL::ORIGIN + 3 * (mesh.point(v) - CGAL::ORIGIN);
  const Complex large = build(mesh, CGAL::parameters::vertex_point_map(tripled));
  EXPECT_NEAR(large.volume(1), 27 * dsc.volume(1), 1e-10);
}

TEST(Build, twice_the_same) {
  const Surfaces surfaces = {cube(1, 1), octahedron(.5, 2)};
  const auto a = build(surfaces).state(), b = build(surfaces).state();
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.cell_labels, b.cell_labels);
}

TEST(Build, bounds_of_the_tetrahedralizer) {
  const Surfaces surfaces = {octahedron(1, 1)};
  const auto cells = [&](const CGAL::Tetgen_tetrahedralizer_3& tetrahedralizer) {
    return DSC::make_deformable_simplicial_complex_3<Complex>(surfaces, tetrahedralizer,
                                                              parameters::improve(false));
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const std::size_t few = cells(CGAL::Tetgen_tetrahedralizer_3(infinity, 0)).number_of_cells();
  EXPECT_LE(few, cells(CGAL::Tetgen_tetrahedralizer_3(1.2, 0)).number_of_cells());
  EXPECT_LE(10 * few, cells(CGAL::Tetgen_tetrahedralizer_3(2, 0, .01)).number_of_cells());

  EXPECT_THROW(CGAL::Tetgen_tetrahedralizer_3(1), Error);
  EXPECT_THROW(CGAL::Tetgen_tetrahedralizer_3(std::nan("")), Error);
  EXPECT_THROW(CGAL::Tetgen_tetrahedralizer_3(2, -1), Error);
  EXPECT_THROW(CGAL::Tetgen_tetrahedralizer_3(2, 19), Error);
  EXPECT_THROW(CGAL::Tetgen_tetrahedralizer_3(2, 10, 0), Error);
}

TEST(Build, the_tetrahedralizer_fails_with_words) {
  // The same triangle twice.
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<std::size_t, 3>> triangles = {
      {0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2}};
  const auto e = thrown_by<Tetrahedralization_error>(
      [&] { CGAL::Tetgen_tetrahedralizer_3()(points, triangles); });
  EXPECT_EQ(e.code(), 3);
  EXPECT_PRED2(contains, std::string(e.what()), "TetGen");
}

// Models of ConstrainedTetrahedralizer_3 that violate their postconditions.

struct Moving_tetrahedralizer
{
  template <class Points, class Triangles>
  DSC::Tetrahedralization_3 operator()(const Points& points, const Triangles& triangles) const {
    auto result = CGAL::Tetgen_tetrahedralizer_3()(points, triangles);
    result.points[3][0] += 1e-9;
    return result;
  }
};

struct Forgetful_tetrahedralizer
{
  template <class Points, class Triangles>
  DSC::Tetrahedralization_3 operator()(const Points& points, const Triangles& triangles) const {
    auto result = CGAL::Tetgen_tetrahedralizer_3()(points, triangles);
    const auto t = triangles.front();
    const auto has_triangle = [&](const std::array<std::size_t, 4>& v) {
      return std::all_of(t.begin(), t.end(),
                         [&](std::size_t i) { return std::count(v.begin(), v.end(), i) > 0; });
    };
    result.tetrahedra.erase(
        std::find_if(result.tetrahedra.begin(), result.tetrahedra.end(), has_triangle));
    return result;
  }
};

TEST(Build, the_tetrahedralizer_is_checked) {
  const Surfaces surfaces = {cube(1, 1)};
  EXPECT_THROW(
      DSC::make_deformable_simplicial_complex_3<Complex>(surfaces, Moving_tetrahedralizer()),
      Tetrahedralization_error);
  EXPECT_THROW(
      DSC::make_deformable_simplicial_complex_3<Complex>(surfaces, Forgetful_tetrahedralizer()),
      Tetrahedralization_error);
}

// Labeled tetrahedra

const std::vector<Point> bipyramid = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};

Complex build(const std::vector<Point>& points, const Tetrahedra& tetrahedra,
              const std::vector<int>& labels) {
  return DSC::make_deformable_simplicial_complex_3<Complex>(points, tetrahedra, labels);
}

std::vector<std::size_t> refused(const std::vector<Point>& points, const Tetrahedra& tetrahedra) {
  try {
    build(points, tetrahedra, std::vector<int>(tetrahedra.size(), 0));
  } catch (const Invalid_cells_error& e) {
    return e.tetrahedra().empty() ? e.vertices() : e.tetrahedra();
  }
  return {};
}

TEST(Build, labeled_tetrahedra_are_turned) {
  for (const Tetrahedra& tetrahedra :
       {Tetrahedra{{0, 1, 2, 3}, {0, 2, 1, 4}}, Tetrahedra{{1, 0, 2, 3}, {0, 1, 2, 4}}}) {
    const Complex dsc = build(bipyramid, tetrahedra, {4, 9});
    EXPECT_TRUE(dsc.is_valid(true));
    EXPECT_NEAR(dsc.volume(4), 1. / 6., 1e-15);
    EXPECT_NEAR(dsc.volume(9), 1. / 6., 1e-15);
    EXPECT_EQ(dsc.interface_facets().size(), 1u);
  }
}

TEST(Build, tetrahedra_that_are_refused) {
  using Indices = std::vector<std::size_t>;
  const Tetrahedra good = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  auto points = bipyramid;
  points[1] = Point(std::nan(""), 0, 0);
  EXPECT_EQ(refused(points, good), Indices{1});
  EXPECT_EQ(refused(bipyramid, {{0, 1, 2, 3}, {0, 2, 1, 5}}), Indices{1});
  EXPECT_EQ(refused(bipyramid, {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 2, 1, 4}}), Indices{1}); // flat
  EXPECT_THROW(build(bipyramid, good, {1}), Invalid_cells_error);
  EXPECT_THROW(build(bipyramid, {}, {}), Invalid_cells_error);
}

TEST(Build, tetrahedra_that_are_no_ball_are_refused) {
  const auto is_refused = [](const std::vector<Point>& points, const Tetrahedra& tetrahedra) {
    try {
      build(points, tetrahedra, std::vector<int>(tetrahedra.size(), 0));
    } catch (const Invalid_cells_error&) {
      return true;
    }
    return false;
  };
  // Two tetrahedra whose intersection is an edge, a vertex, empty, or the same side of a facet.
  EXPECT_TRUE(is_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}},
                         {{0, 1, 2, 3}, {0, 1, 4, 5}}));
  EXPECT_TRUE(
      is_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                 {{0, 1, 2, 3}, {0, 4, 5, 6}}));
  EXPECT_TRUE(is_refused(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_TRUE(is_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}},
                         {{0, 1, 2, 3}, {0, 1, 2, 4}}));

  // A ring of eight cubes, and a hollow cube of 26 cubes: blocks of 3^3 cubes with cubes removed.
  for (bool ring : {false, true}) {
    std::vector<Point> points;
    Tetrahedra tetrahedra;
    std::vector<std::size_t> index(64, 64);
    for (std::size_t cube = 0; cube < 27; ++cube) {
      const std::array<std::size_t, 3> lowest = {cube % 3, cube / 3 % 3, cube / 9};
      const bool is_middle = lowest[0] == 1 && lowest[1] == 1;
      if (ring ? lowest[2] > 0 || is_middle : is_middle && lowest[2] == 1)
        continue;
      std::array<std::size_t, 3> axes = {0, 1, 2};
      do {
        std::array<std::size_t, 4> tetrahedron;
        std::array<std::size_t, 3> corner = lowest;
        for (std::size_t step = 0; step < 4; ++step) {
          std::size_t& i = index[corner[0] + 4 * corner[1] + 16 * corner[2]];
          if (i == 64) {
            i = points.size();
            points.emplace_back(corner[0], corner[1], corner[2]);
          }
          tetrahedron[step] = i;
          if (step < 3)
            ++corner[axes[step]];
        }
        tetrahedra.push_back(tetrahedron);
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
    EXPECT_TRUE(is_refused(points, tetrahedra)) << (ring ? "ring" : "hollow");
  }
}

} // namespace test_build
