#include "small_surfaces.h"
#include "test.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <optional>

namespace test_surfaces {

using namespace small_surfaces;
using Vector = Complex::Geom_traits::Vector_3;
using CGAL::Deformable_simplicial_complexes::Invalid_surface_error;
using Reason = Invalid_surface_error::Reason;
using Indices = std::vector<std::size_t>;

// Thrown if a surface is accepted and reaches the tetrahedralizer.
struct Accepted
{
};
struct Accept_tetrahedralizer
{
  DSC::Tetrahedralization_3 operator()(const std::vector<std::array<double, 3>>&,
                                       const std::vector<std::array<std::size_t, 3>>&) const {
    throw Accepted();
  }
};

template <class Input, class NP = parameters::Default_named_parameters>
std::optional<Invalid_surface_error> refusal(const Input& input, const NP& np = NP()) {
  try {
    DSC::make_deformable_simplicial_complex_3<Complex>(input, Accept_tetrahedralizer(), np);
  } catch (const Accepted&) {
  } catch (const Invalid_surface_error& e) {
    return e;
  }
  return std::nullopt;
}

std::optional<Invalid_surface_error> refusal(const Surface& surface) {
  return refusal(std::vector<Surface>{surface});
}

// Returns the error for one surface.
void expect_refusal(const Surface& surface, Reason reason, const Indices& facets,
                    const Indices& vertices) {
  const auto e = refusal(surface);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), reason) << e->what();
  EXPECT_EQ(e->surface(), 0u);
  EXPECT_EQ(e->other_surface(), 0u);
  EXPECT_EQ(e->facets(), facets);
  EXPECT_EQ(e->vertices(), vertices);
}

Surface tetrahedron(const Point& corner = Point(0, 0, 0), double size = 1) {
  return {{corner, corner + Vector(size, 0, 0), corner + Vector(0, size, 0),
           corner + Vector(0, 0, size)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
          1};
}

TEST(Surfaces, a_tetrahedron_is_accepted) { EXPECT_FALSE(refusal(tetrahedron())); }

TEST(Surfaces, any_orientation_is_accepted) {
  for (unsigned flips = 0; flips < 16; ++flips) {
    Surface s = tetrahedron();
    for (unsigned t = 0; t < 4; ++t)
      if (flips >> t & 1)
        std::swap(s.triangles[t][0], s.triangles[t][1]);
    EXPECT_FALSE(refusal(s)) << flips;
  }
}

TEST(Surfaces, triangles_need_not_share_points) {
  const Surface connected = tetrahedron();
  Surface s;
  s.points.push_back(Point(9, 9, 9)); // in no triangle
  for (const auto& t : connected.triangles) {
    s.triangles.push_back({s.points.size(), s.points.size() + 1, s.points.size() + 2});
    for (std::size_t i : t)
      s.points.push_back(connected.points[i]);
  }
  EXPECT_FALSE(refusal(s));
}

TEST(Surfaces, zeros_of_both_signs_are_equal) {
  Surface s = tetrahedron();
  s.points.push_back(Point(-0., 0., -0.));
  s.triangles[3][0] = 4;
  EXPECT_FALSE(refusal(s));
}

TEST(Surfaces, nested_surfaces_are_accepted) {
  Surface outer = tetrahedron(), inner = tetrahedron(Point(.1, .1, .1), .25);
  EXPECT_FALSE(refusal(std::vector<Surface>{outer, inner}));
  append(outer, inner);
  EXPECT_FALSE(refusal(outer));
}

TEST(Surfaces, no_surface) {
  const auto e = refusal(std::vector<Surface>());
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::empty);
}

TEST(Surfaces, a_surface_without_facets) {
  const auto e = refusal(std::vector<Surface>{tetrahedron(), Surface()});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::empty);
  EXPECT_EQ(e->surface(), 1u);
}

TEST(Surfaces, coordinates_that_are_not_finite) {
  Surface s = tetrahedron();
  s.points[1] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  s.points[3] = Point(0, 0, std::numeric_limits<double>::infinity());
  expect_refusal(s, Reason::not_finite, {}, {1, 3});
}

TEST(Surfaces, indices_that_do_not_exist) {
  Surface s = tetrahedron();
  s.triangles[1][2] = 4;
  s.triangles[3][0] = std::size_t(-1);
  expect_refusal(s, Reason::bad_index, {1, 3}, {});
}

TEST(Surfaces, a_facet_with_a_vertex_twice) {
  Surface s = tetrahedron();
  s.triangles.push_back({1, 2, 2});
  expect_refusal(s, Reason::degenerate_facet, {4}, {});
}

TEST(Surfaces, a_facet_with_two_equal_points) {
  Surface s = tetrahedron();
  s.points.push_back(s.points[2]);
  s.triangles.push_back({1, 2, 4});
  expect_refusal(s, Reason::degenerate_facet, {4}, {});
}

TEST(Surfaces, a_facet_with_collinear_points) {
  Surface s = tetrahedron();
  s.points.push_back(CGAL::midpoint(s.points[0], s.points[1]));
  s.triangles.push_back({0, 4, 1});
  s.triangles[0] = {0, 2, 4};
  s.triangles.push_back({4, 2, 1});
  expect_refusal(s, Reason::degenerate_facet, {4}, {});
  // A subnormal area is sufficient.
  s.points[4] = Point(.5, std::numeric_limits<double>::denorm_min(), 0);
  EXPECT_FALSE(refusal(s));
}

TEST(Surfaces, an_open_surface) {
  Surface s = tetrahedron();
  s.triangles.pop_back();
  expect_refusal(s, Reason::open, {0, 1, 2}, {0, 2, 0, 3, 2, 3});
}

// Two tetrahedra with a common vertex; one is the mirror image of the other.
Surface tetrahedra_at_a_vertex() {
  Surface s = tetrahedron();
  append(s, {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}, {0, 0, -1}}, s.triangles, 1});
  return s;
}

TEST(Surfaces, parts_may_touch_in_a_vertex) { EXPECT_FALSE(refusal(tetrahedra_at_a_vertex())); }

TEST(Surfaces, parts_may_touch_in_an_edge) {
  Surface s = tetrahedron();
  append(s, {{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, s.triangles, 1});
  EXPECT_FALSE(refusal(s));
}

TEST(Surfaces, a_wall_between_parts) {
  Surface s = tetrahedron();
  append(s, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 1});
  expect_refusal(s, Reason::non_manifold_edge, {0, 1, 2, 3, 4, 5, 6}, {0, 1, 0, 2, 1, 2});
}

TEST(Surfaces, a_vertex_on_a_facet) {
  Surface s = tetrahedron();
  append(s, tetrahedron(Point(-1, .25, .25))); // one of its vertices lies on facet 3
  expect_refusal(s, Reason::self_intersection, {3, 4, 3, 5, 3, 6}, {});
}

TEST(Surfaces, a_vertex_on_an_edge) {
  Surface s = tetrahedron();
  append(s, tetrahedron(Point(-1, .5, 0)));
  expect_refusal(s, Reason::self_intersection, {0, 4, 0, 5, 0, 6, 3, 4, 3, 5, 3, 6}, {});
}

TEST(Surfaces, a_facet_twice) {
  Surface s = tetrahedron();
  s.triangles.push_back({0, 1, 2});
  expect_refusal(s, Reason::non_manifold_edge, {0, 1, 2, 3, 4}, {0, 1, 0, 2, 1, 2});
}

TEST(Surfaces, two_equal_facets_enclose_nothing) {
  expect_refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, 1},
                 Reason::self_intersection, {0, 1}, {});
}

TEST(Surfaces, facets_that_overlap_beside_a_common_edge) {
  const Surface flat = {{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 0}},
                        {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                        1};
  expect_refusal(flat, Reason::self_intersection, {0, 1, 0, 2, 0, 3}, {});
}

TEST(Surfaces, facets_that_cross_at_a_common_vertex) {
  // The top vertex of the octahedron is moved through two facets at the bottom.
  Surface s = octahedron();
  s.points[4] = Point(.75, .25, -.5);
  const auto e = refusal(s);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::self_intersection);
}

TEST(Surfaces, a_part_that_pokes_through_a_facet) {
  Surface s = tetrahedron();
  append(s, {{{.25, .25, .25}, {.25, .25, -1}, {.5, .25, -1}, {.25, .5, -1}},
             {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
             1});
  expect_refusal(s, Reason::self_intersection, {0, 4, 0, 5, 0, 6}, {});
}

TEST(Surfaces, a_projective_plane) {
  const Surface s = {{{0, 0, 0}, {4, 0, 1}, {1, 4, 0}, {-3, 2, 1}, {-3, -2, 0}, {1, -4, 1}},
                     {{0, 1, 2},
                      {0, 2, 3},
                      {0, 3, 4},
                      {0, 4, 5},
                      {0, 5, 1},
                      {1, 2, 4},
                      {2, 3, 5},
                      {3, 4, 1},
                      {4, 5, 2},
                      {5, 1, 3}},
                     1};
  const auto e = refusal(s);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::self_intersection);
}

TEST(Surfaces, intersections_agree_with_polygon_mesh_processing) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(-3, 3); // many degenerate positions
  int refused = 0, accepted = 0;
  for (int i = 0; i < 1000; ++i) {
    Surface s = octahedron();
    for (Point& p : s.points)
      p = Point(coordinate(random), coordinate(random), coordinate(random));
    const bool has_equal_points =
        std::set<Point>(s.points.begin(), s.points.end()).size() < s.points.size();
    const auto e = refusal(s);
    if (has_equal_points || (e && e->reason() != Reason::self_intersection))
      continue;

    namespace PMP = CGAL::Polygon_mesh_processing;
    CGAL::Surface_mesh<Point> mesh;
    PMP::polygon_soup_to_polygon_mesh(s.points, s.triangles, mesh);
    std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> found;
    PMP::self_intersections(mesh, std::back_inserter(found));
    std::vector<std::pair<std::size_t, std::size_t>> expected, pairs;
    for (const auto& pair : found)
      expected.push_back(std::minmax<std::size_t>({pair.first, pair.second}));
    std::sort(expected.begin(), expected.end());
    for (std::size_t j = 0; e && j < e->facets().size(); j += 2)
      pairs.emplace_back(e->facets()[j], e->facets()[j + 1]);
    EXPECT_EQ(pairs, expected) << i;
    ++(e ? refused : accepted);
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(accepted, 20);
}

TEST(Surfaces, two_surfaces_that_cross) {
  const Surface needle = {{{.25, .25, .25}, {.25, .25, -1}, {.5, .25, -1}, {.25, .5, -1}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}},
                          2};
  const Surface distant = tetrahedron(Point(5, 5, 5));
  const auto e = refusal(std::vector<Surface>{distant, tetrahedron(), distant, needle});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::crossing_surfaces);
  EXPECT_EQ(e->surface(), 0u); // equal surfaces intersect in all facets
  EXPECT_EQ(e->other_surface(), 2u);

  const auto f = refusal(std::vector<Surface>{distant, tetrahedron(), needle});
  ASSERT_TRUE(f);
  EXPECT_EQ(f->reason(), Reason::crossing_surfaces);
  EXPECT_EQ(f->surface(), 1u);
  EXPECT_EQ(f->other_surface(), 2u);
  EXPECT_EQ(f->facets(), (Indices{0, 0, 0, 1, 0, 2}));
}

TEST(Surfaces, two_surfaces_may_touch_in_a_point) {
  EXPECT_FALSE(refusal(std::vector<Surface>{tetrahedron(), tetrahedron(Point(0, 0, 1))}));
}

TEST(Surfaces, two_surfaces_that_share_a_facet) {
  Surface below = tetrahedron();
  below.points[3] = Point(0, 0, -1);
  const auto e = refusal(std::vector<Surface>{tetrahedron(), below});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::crossing_surfaces);
  EXPECT_EQ(e->facets(), (Indices{0, 0}));
}

// Two tetrahedra without their common facet.
Surface bipyramid(double bottom, double top) {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, bottom}, {1, 1, top}},
          {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
          1};
}

TEST(Surfaces, two_surfaces_may_touch_but_not_cross_in_common_edges) {
  for (double bottom : {-4, -3, -2, -1, 1, 2, 3, 4})
    for (double top : {-4, -3, -2, -1, 1, 2, 3, 4}) {
      if (bottom >= top || bottom == -3 || bottom == 3 || top == -3 || top == 3)
        continue; // not a bipyramid, or a common facet
      const bool cross = (-3 < bottom && bottom < 3) != (-3 < top && top < 3);
      for (bool swap : {false, true}) {
        std::vector<Surface> surfaces = {bipyramid(-3, 3), bipyramid(bottom, top)};
        if (swap)
          std::swap(surfaces[0], surfaces[1]);
        const auto e = refusal(surfaces);
        EXPECT_EQ(bool(e), cross) << bottom << ' ' << top;
        if (e) {
          EXPECT_EQ(e->reason(), Reason::crossing_surfaces);
          EXPECT_EQ(e->facets().size(), 2u * 3u * 3u); // three alternating pairs at each edge
        }
      }
    }
}

TEST(Surfaces, three_surfaces_at_common_edges) {
  EXPECT_FALSE(refusal(std::vector<Surface>{bipyramid(-3, 3), bipyramid(-1, 1), bipyramid(-2, 2)}));
  const auto e =
      refusal(std::vector<Surface>{bipyramid(-3, 3), bipyramid(-1, 2), bipyramid(-2, 1)});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->surface(), 1u);
  EXPECT_EQ(e->other_surface(), 2u);
}

TEST(Surfaces, a_surface_that_is_invalid_by_itself_comes_first) {
  Surface invalid = tetrahedron(Point(10, 0, 0));
  append(invalid, tetrahedron(Point(10.1, .1, .1)));
  const auto e = refusal(std::vector<Surface>{tetrahedron(), tetrahedron(), invalid});
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::self_intersection);
  EXPECT_EQ(e->surface(), 2u);
}

TEST(Surfaces, the_box_must_be_around_them) {
  const auto np = parameters::enclosing_box(CGAL::Bbox_3(-1, -1, -1, 1, 2, .5));
  const auto e = refusal(std::vector<Surface>{tetrahedron(Point(0, 0, 0), .25), tetrahedron()}, np);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::crossing_surfaces); // they share a corner where three facets meet

  const auto f =
      refusal(std::vector<Surface>{tetrahedron(Point(-.5, -.5, -.5), .25), tetrahedron()}, np);
  ASSERT_TRUE(f);
  EXPECT_EQ(f->reason(), Reason::outside_enclosing_box);
  EXPECT_EQ(f->surface(), 1u);
  EXPECT_EQ(f->vertices(), (Indices{1, 3})); // one touches the box
}

TEST(Surfaces, bad_boxes) {
  using CGAL::Deformable_simplicial_complexes::Error;
  const std::vector<Surface> surfaces = {tetrahedron()};
  const double infinity = std::numeric_limits<double>::infinity();
  const CGAL::Bbox_3 space(-infinity, -infinity, -infinity, infinity, infinity, infinity);
  EXPECT_THROW(refusal(surfaces, parameters::enclosing_box(space)), Error);
  EXPECT_THROW(refusal(surfaces, parameters::box_subdivision(0u)), Error);
  EXPECT_THROW(refusal(surfaces, parameters::box_subdivision(-1)), Error);
}

TEST(Surfaces, a_mesh_with_quadrangles) {
  using CGAL::Deformable_simplicial_complexes::Error;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  EXPECT_THROW(refusal(mesh), Error);
}

TEST(Surfaces, an_open_mesh) {
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), mesh);
  const auto e = refusal(mesh);
  ASSERT_TRUE(e);
  EXPECT_EQ(e->reason(), Reason::open);
  EXPECT_EQ(e->facets(), Indices{0});
}

} // namespace test_surfaces
