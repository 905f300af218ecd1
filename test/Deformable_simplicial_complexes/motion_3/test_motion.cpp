#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/internal/motion/collision_order.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

namespace test_motion {

using mesh_helpers::jittered_grid;
using mesh_helpers::Random;
using namespace small_meshes;
using Rational = CGAL::Exact_rational;

Point shifted(const Complex& dsc, Vertex_handle v, const Complex::Vector_3& by) {
  return dsc.position(v) + by;
}

// The box [-1,1]^3 as the star of its center.
small_meshes::Labeled_mesh box_with_center() {
  small_meshes::Labeled_mesh mesh = grid(1, small_meshes::uniform);
  const Complex box = make_complex(mesh);
  small_meshes::Labeled_mesh result;
  result.points.emplace_back(0, 0, 0);
  for (Vertex_handle v : box.vertices())
    result.points.push_back(v->point());
  const auto index = [&](Vertex_handle v) {
    return std::size_t(std::find(result.points.begin(), result.points.end(), v->point()) -
                       result.points.begin());
  };
  for (Cell_handle c : box.cells())
    for (int i = 0; i < 4; ++i)
      if (box.is_infinite(c->neighbor(i))) {
        const auto v = box.facet_vertices({c, i});
        result.tetrahedra.push_back({0, index(v[0]), index(v[1]), index(v[2])});
        result.labels.push_back(0);
      }
  return result;
}

std::vector<Vertex_handle> inner_vertices(const Complex& dsc) {
  std::vector<Vertex_handle> result;
  for (Vertex_handle v : dsc.vertices())
    if (!dsc.is_boundary(v))
      result.push_back(v);
  return result;
}

// Returns the largest fraction of the segment from v to q for which the star of v stays positive.
// Computed by bisection with exact orientations.
double brute_force_way(const Complex& dsc, Vertex_handle v, const Point& q) {
  using Dyadic = CGAL::MP_Float; // without GMP, rational numbers are slow
  using Exact = CGAL::Simple_cartesian<Dyadic>;
  const auto exact = [](const Point& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
  std::vector<Cell_handle> star;
  dsc.triangulation().finite_incident_cells(v, std::back_inserter(star));
  const auto is_positive_at = [&](const Dyadic& way) {
    const Exact::Point_3 from = exact(v->point()), p = from + way * (exact(q) - from);
    for (Cell_handle c : star) {
      std::vector<Exact::Point_3> x;
      for (int i = 0; i < 4; ++i)
        x.push_back(c->vertex(i) == v ? p : exact(c->vertex(i)->point()));
      if (CGAL::orientation(x[0], x[1], x[2], x[3]) != CGAL::POSITIVE)
        return false;
    }
    return true;
  };
  if (is_positive_at(1))
    return 1;
  Dyadic low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const Dyadic middle = (low + high) * Dyadic(.5);
    (is_positive_at(middle) ? low : high) = middle;
  }
  return CGAL::to_double(low);
}

TEST(Move_vertex, arrives_if_and_only_if_the_star_is_positive_there) {
  Complex dsc = jittered_grid(3, small_meshes::uniform, .3, 1);
  Random random(2);
  int arrived = 0, blocked = 0;
  for (int round = 0; round < 20; ++round)
    for (Vertex_handle v : inner_vertices(dsc)) {
      const Point before = v->point(), q = shifted(dsc, v, random.vector<Complex>(.6));
      const bool is_free = mesh_helpers::is_positive_with(dsc, v, q);
      const double way = dsc.move_vertex(v, q);
      EXPECT_EQ(way == 1, is_free);
      EXPECT_EQ(v->point() == q, is_free);
      EXPECT_GE(way, 0);
      EXPECT_TRUE(mesh_helpers::is_positive_with(dsc, v, v->point()));
      ++(is_free ? arrived : blocked);
      dsc.move_vertex(v, before); // moves back, so that the stars stay large
    }
  EXPECT_GT(arrived, 20);
  EXPECT_GT(blocked, 20);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Move_vertex, stops_just_before_the_first_flat_cell) {
  Complex dsc = jittered_grid(3, small_meshes::uniform, .3, 3);
  Random random(4);
  int blocked = 0;
  for (int round = 0; round < 8; ++round)
    for (Vertex_handle v : inner_vertices(dsc)) {
      const Point before = v->point(), q = shifted(dsc, v, random.vector<Complex>(1.5));
      const double possible = brute_force_way(dsc, v, q), way = dsc.move_vertex(v, q);
      if (possible < 1) {
        ++blocked;
        EXPECT_LT(way, possible);
        EXPECT_GT(way, .998 * possible);
        EXPECT_LT((v->point() - (before + way * (q - before))).squared_length(), 1e-30);
      } else {
        EXPECT_EQ(way, 1);
      }
      EXPECT_TRUE(mesh_helpers::is_positive_with(dsc, v, v->point()));
      EXPECT_EQ(dsc.move_vertex(v, before), 1);
    }
  EXPECT_GT(blocked, 20);
  EXPECT_TRUE(dsc.is_valid());
}

// At the returned fraction, a cell is exactly degenerate.
TEST(Collision_order, first_collision_is_exact) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  Complex dsc = jittered_grid(3, small_meshes::uniform, .3, 3);
  Random random(4);
  std::vector<Cell_handle> star;
  int blocked = 0;
  for (Vertex_handle v : inner_vertices(dsc)) {
    const Point q = shifted(dsc, v, random.vector<Complex>(1.5));
    internal::Destinations<Complex> destinations(dsc);
    destinations.add(v, q);
    dsc.star(v, star);
    const Rational way = internal::first_collision(dsc, destinations, v, star);
    EXPECT_LT(CGAL::abs(way - Rational(brute_force_way(dsc, v, q))), Rational(1e-9));
    using Exact = CGAL::Simple_cartesian<Rational>;
    const auto exact = [](const Point& p) { return Exact::Point_3(p.x(), p.y(), p.z()); };
    const Exact::Point_3 p = exact(v->point()) + way * (exact(q) - exact(v->point()));
    const bool is_flat = std::any_of(star.begin(), star.end(), [&](Cell_handle c) {
      const auto f = dsc.facet_vertices({c, c->index(v)});
      return CGAL::coplanar(exact(f[0]->point()), exact(f[1]->point()), exact(f[2]->point()), p);
    });
    EXPECT_EQ(is_flat, way < 1);
    blocked += is_flat;
  }
  EXPECT_GT(blocked, 3);
}

TEST(Collision_order, is_increasing_and_stable) {
  namespace internal = CGAL::Deformable_simplicial_complexes::internal;
  Complex dsc = jittered_grid(4, small_meshes::uniform, .3, 3);
  Random random(4);
  std::vector<Vertex_handle> vertices = inner_vertices(dsc), sorted = vertices;
  internal::Destinations<Complex> destinations(dsc);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    destinations.add(vertices[i], i % 2 == 0
                                      ? vertices[i]->point()
                                      : shifted(dsc, vertices[i], random.vector<Complex>(1.5)));
  internal::sort_by_first_collision(dsc, destinations, sorted);
  EXPECT_TRUE(std::is_permutation(sorted.begin(), sorted.end(), vertices.begin()));
  std::vector<std::pair<Rational, std::size_t>> keys;
  for (Vertex_handle v : sorted) {
    std::vector<Cell_handle> star;
    dsc.star(v, star);
    keys.emplace_back(internal::first_collision(dsc, destinations, v, star), v->time_stamp());
  }
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  EXPECT_LT(keys.front().first, 1);
  EXPECT_EQ(keys.back().first, 1);
}

TEST(Move_vertex, goes_anywhere_in_a_convex_star_and_never_out_of_any) {
  Complex dsc = make_complex(box_with_center());
  const Vertex_handle v = inner_vertices(dsc).at(0);
  EXPECT_EQ(dsc.move_vertex(v, Point(.9, -.8, .7)), 1);
  EXPECT_EQ(v->point(), Point(.9, -.8, .7));
  EXPECT_LT(dsc.move_vertex(v, Point(.9, -.8, 1)), 1); // on the boundary
  EXPECT_LT(dsc.move_vertex(v, Point(1e100, 0, 0)), 1e-99);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Move_vertex, without_room_keeps_coordinates_bit_for_bit) {
  Complex dsc = jittered_grid(2, small_meshes::uniform, .2, 5);
  const Vertex_handle v = inner_vertices(dsc).at(0);
  const Point q(1.1, 1.2, 1.3);
  int moves = 0;
  for (double way = 1; way > 0; ++moves) {
    const Point before = v->point();
    way = dsc.move_vertex(v, q);
    EXPECT_EQ(way == 0, v->point() == before);
    ASSERT_LT(moves, 100);
  }
  const auto state = dsc.state();
  EXPECT_EQ(dsc.move_vertex(v, q), 0);
  EXPECT_TRUE(dsc.state() == state);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.move_vertex(v, Point(0, 0, 0)), 1); // and it can move back
}

TEST(Move_vertex, to_where_it_is_changes_nothing) {
  Complex dsc = jittered_grid(3, small_meshes::ball, .3, 6);
  const auto state = dsc.state();
  for (Vertex_handle v : dsc.vertices())
    EXPECT_EQ(dsc.move_vertex(v, v->point()), 1);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Move_vertex, keeps_vertices_of_a_box_on_their_sides) {
  Complex dsc = jittered_grid(3, small_meshes::uniform, .2, 7);
  Random random(8);
  int moved = 0;
  for (int round = 0; round < 10; ++round)
    for (Vertex_handle v : dsc.vertices()) {
      const auto before = dsc.position(v);
      const Point q = shifted(dsc, v, random.vector<Complex>(.5));
      const Point admissible = dsc.admissible_destination(v, q);
      dsc.move_vertex(v, q);
      const auto after = dsc.position(v);
      for (int axis = 0; axis < 3; ++axis)
        if (DSC::Boundary_class::fixes(v->boundary_class(), axis)) {
          EXPECT_EQ(after[axis], before[axis]);
          EXPECT_EQ(admissible[axis], before[axis]);
        } else {
          EXPECT_EQ(admissible[axis], q[axis]);
          EXPECT_LE(after[axis], 1);
          EXPECT_GE(after[axis], -1);
        }
      moved += dsc.is_boundary(v) && after != before ? 1 : 0;
    }
  EXPECT_GT(moved, 100);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(0), 8, 1e-14);
}

TEST(Move_vertex, updates_what_the_complex_caches) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  for (Vertex_handle v : dsc.interface_vertices())
    if (dsc.position(v).x() == .5) {
      EXPECT_EQ(dsc.move_vertex(v, shifted(dsc, v, {.25, 0, 0})), 1);
    }
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(1), 1.25, 1e-14);
  EXPECT_NEAR(dsc.area(1), 7, 1e-12);
}

TEST(Move_vertex, random_walks_stay_valid) {
  for (int domain = 0; domain < 2; ++domain) {
    Complex dsc = domain == 0 ? make_complex(grid(2, small_meshes::four_phases))
                              : make_complex(grid(3, small_meshes::two_boxes));
    Random random(9);
    for (int round = 0; round < 3; ++round)
      for (Vertex_handle v : dsc.vertices()) {
        dsc.move_vertex(v, shifted(dsc, v, random.vector<Complex>(1)));
        ASSERT_TRUE(dsc.is_valid());
      }
  }
}

TEST(Set_points, moves_vertices_together_that_could_not_move_alone) {
  Complex dsc = make_complex(grid(4, small_meshes::cube));
  std::vector<Vertex_handle> vertices;
  std::vector<Point> points;
  for (Vertex_handle v : dsc.vertices()) { // most pass where their neighbors were
    const auto p = dsc.position(v);
    vertices.push_back(v);
    points.push_back(
        dsc.admissible_destination(v, Point(2 * std::cbrt((p.x() + 1) / 2) - 1, p.y(), p.z())));
  }
  const auto backwards = [](std::size_t n, const auto& function, std::size_t = 0) {
    while (n > 0)
      function(--n);
  };
  const auto shapes = mesh_helpers::shapes_with(dsc, dsc.cells(), vertices, points);
  dsc.set_points(vertices, points, dsc.cells(), shapes.measures, shapes.qualities, backwards);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(0) + dsc.volume(1), 8, 1e-14);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(vertices[i]->point(), points[i]);
}

// If the motion stops early, the distance of the destination does not matter.
TEST(Move_vertex, comes_to_the_link_from_any_distance) {
  for (double distant : {1e3, 1e13, 1e100}) {
    Complex dsc = make_complex(box_with_center());
    Vertex_handle center;
    for (Vertex_handle v : dsc.vertices())
      if (!dsc.is_boundary(v))
        center = v;
    dsc.move_vertex(center, Point(distant, .9 * distant, .7 * distant));
    EXPECT_GT(dsc.position(center).x(), .99) << distant;
    EXPECT_TRUE(dsc.is_valid());
  }
}

} // namespace test_motion
