#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Smart Laplacian and optimization-based smoothing of vertices.

namespace test_smoothing {

using mesh_helpers::jittered_grid;
using namespace operation_helpers;
using Position = Complex::Point_3;

// Returns the worst quality of the star of v if v were at p.
double worst_quality(const Complex& dsc, Vertex_handle v, const Position& p) {
  std::vector<Cell_handle> star;
  dsc.triangulation().finite_incident_cells(v, std::back_inserter(star));
  double worst = infinity;
  for (Cell_handle c : star) {
    const auto x = [&](int i) { return c->vertex(i) == v ? p : dsc.position(c->vertex(i)); };
    worst = (std::min)(worst, dsc.quality_measure()(x(0), x(1), x(2), x(3)));
  }
  return worst;
}

Position barycenter_of_neighbors(const Complex& dsc, Vertex_handle v) {
  std::vector<Vertex_handle> neighbors;
  dsc.triangulation().finite_adjacent_vertices(v, std::back_inserter(neighbors));
  Complex::Vector_3 sum(0, 0, 0);
  for (Vertex_handle w : neighbors)
    sum = sum + (dsc.position(w) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / double(neighbors.size());
}

// Returns the largest possible worst quality of the star of v, by sampling smaller and smaller
// boxes. The positions with at least a given quality form a convex set, so there is only one
// maximum.
double optimum(const Complex& dsc, Vertex_handle v) {
  static constexpr int samples = 5;
  Position best = dsc.position(v);
  double best_quality = worst_quality(dsc, v, best);
  for (double size = .6; size > 1e-4; size *= .6) {
    const Position center = best;
    for (int x = -samples; x <= samples; ++x)
      for (int y = -samples; y <= samples; ++y)
        for (int z = -samples; z <= samples; ++z) {
          const Position p = center + size / samples * Complex::Vector_3(x, y, z);
          const double quality = worst_quality(dsc, v, p);
          if (quality > best_quality) {
            best_quality = quality;
            best = p;
          }
        }
  }
  return best_quality;
}

struct Proposal
{
  bool is_made;
  std::vector<Cell_handle> star;
  Point target;
};

// Returns the proposal of `propose` for a vertex. It must not change the complex.
template <class Propose>
Proposal proposal_of(const Propose& propose, const Complex& dsc, Vertex_handle v) {
  const auto state = dsc.state();
  Proposal result;
  dsc.star(v, result.star);
  result.is_made = propose(dsc, v, result.star, result.target);
  EXPECT_TRUE(dsc.state() == state);
  return result;
}

TEST(Smart_laplacian, goes_all_or_half_the_way_if_that_is_better) {
  Complex dsc = jittered_grid(4, small_meshes::ball, .4, 1);
  int all = 0, half = 0, none = 0;
  for (Vertex_handle v : dsc.vertices()) {
    const auto [proposed, star, target] =
        proposal_of(DSC::propose_smart_laplacian<Complex>, dsc, v);
    if (dsc.is_interface(v)) {
      EXPECT_FALSE(proposed);
      continue;
    }
    const Position from = dsc.position(v), to = barycenter_of_neighbors(dsc, v);
    const auto admissible = [&](const Position& p) {
      const Point q = dsc.admissible_destination(v, p);
      return Position(q.x(), q.y(), q.z());
    };
    const Position whole_way = admissible(to), half_way = admissible(from + .5 * (to - from));
    const double before = worst_quality(dsc, v, from);
    const bool whole_is_better = worst_quality(dsc, v, whole_way) > before + tolerance,
               half_is_better = worst_quality(dsc, v, half_way) > before + tolerance;
    EXPECT_EQ(proposed, whole_is_better || half_is_better);
    ++(!proposed ? none : whole_is_better ? all : half);
    if (!proposed)
      continue;
    const Position expected = whole_is_better ? whole_way : half_way;
    EXPECT_LT((Position(target.x(), target.y(), target.z()) - expected).squared_length(), 1e-28);
    dsc.set_point(v, star, target);
    ASSERT_TRUE(dsc.is_valid());
    EXPECT_GT(worst_quality(dsc, v, dsc.position(v)), before);
  }
  EXPECT_GT(all, 5);
  EXPECT_GT(half, 2);
  EXPECT_GT(none, 5);
}

TEST(Optimal_position, never_lowers_the_worst_quality) {
  Complex dsc = jittered_grid(4, small_meshes::four_phases, .45, 2);
  int moved = 0;
  for (Vertex_handle v : dsc.vertices()) {
    const auto [proposed, star, target] =
        proposal_of(DSC::propose_optimal_position<Complex>, dsc, v);
    if (dsc.is_interface(v) || dsc.is_boundary(v)) {
      EXPECT_FALSE(proposed); // the interface is planar nowhere
    }
    if (!proposed)
      continue;
    const double before = worst_quality(dsc, v, dsc.position(v));
    dsc.set_point(v, star, target);
    EXPECT_GT(worst_quality(dsc, v, dsc.position(v)), before);
    ++moved;
  }
  EXPECT_GT(moved, 8);
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Optimal_position, comes_near_the_optimum) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Complex dsc = jittered_grid(2, small_meshes::uniform, .45, seed);
    const auto vertices = dsc.vertices();
    const Vertex_handle v = *std::find_if(vertices.begin(), vertices.end(),
                                          [&](Vertex_handle w) { return !dsc.is_boundary(w); });
    const double before = worst_quality(dsc, v, dsc.position(v)), best = optimum(dsc, v);
    std::vector<Cell_handle> star;
    dsc.star(v, star);
    Point target;
    for (int i = 0; i < 10 && propose_optimal_position(dsc, v, star, target); ++i)
      dsc.set_point(v, star, target);
    const double after = worst_quality(dsc, v, dsc.position(v));
    EXPECT_LE(after, best + 1e-3);
    EXPECT_GT(after - before, .8 * (best - before)) << seed << ' ' << before << ' ' << best;
  }
}

// A positive cell may have a quality of at most zero because of rounding.
TEST(Optimal_position, survives_cells_flat_up_to_rounding) {
  for (const Point& p : {Point(.58, .31, .11), Point(.09, .33, .58)}) {
    Complex dsc;
    const auto v = dsc.assign({Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0),
                               Point(0, 0, 1), Point(0, 0, -1), Point(0, 0, 0)},
                              {{2, 0, 4, 6},
                               {1, 2, 4, 6},
                               {3, 1, 4, 6},
                               {0, 3, 4, 6},
                               {0, 2, 5, 6},
                               {2, 1, 5, 6},
                               {1, 3, 5, 6},
                               {3, 0, 5, 6}},
                              std::vector<int>(8, 0));
    ASSERT_EQ(dsc.move_vertex(v[6], p), 1);
    ASSERT_LE(mesh_helpers::minimum_quality(dsc), 0);
    std::vector<Cell_handle> star;
    dsc.star(v[6], star);
    Point target;
    ASSERT_TRUE(DSC::propose_optimal_position(dsc, v[6], star, target));
    dsc.set_point(v[6], star, target);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GT(mesh_helpers::minimum_quality(dsc), 0);
  }
}

// Two boxes with a common wall. Vertices on a side or on the wall move within the plane, vertices
// on edges move along the edge, and vertices at corners do not move. The triple line around the
// wall is treated as an edge.
TEST(Optimal_position, keeps_planes_and_lines_of_the_interface) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(8, small_meshes::two_boxes));
  const double volume_1 = dsc.volume(1), volume_2 = dsc.volume(2), area = dsc.area(0);
  // Displaces the vertices within their planes and lines.
  mesh_helpers::Random random(3);
  const auto planes = [](const Position& p) {
    return std::array<bool, 3>{std::abs(p.x()) == .5 || p.x() == 0, std::abs(p.y()) == .5,
                               std::abs(p.z()) == .5};
  };
  std::vector<Cell_handle> star;
  for (Vertex_handle v : dsc.interface_vertices()) {
    const Position p = dsc.position(v);
    const auto is_on = planes(p);
    const auto shift = random.vector<Complex>(.1);
    dsc.move_vertex(v, Point(p.x() + (is_on[0] ? 0 : shift.x()), p.y() + (is_on[1] ? 0 : shift.y()),
                             p.z() + (is_on[2] ? 0 : shift.z())));
  }
  std::array<int, 4> moved = {}; // by the number of planes
  for (Vertex_handle v : dsc.interface_vertices()) {
    const Position before = dsc.position(v);
    const auto is_on = planes(before);
    dsc.star(v, star);
    const double quality = worst_quality(dsc, v, before);
    Point target;
    if (!propose_optimal_position(dsc, v, star, target))
      continue;
    ++moved[std::size_t(is_on[0]) + is_on[1] + is_on[2]];
    dsc.set_point(v, star, target);
    const Position after = dsc.position(v);
    EXPECT_GT(worst_quality(dsc, v, after), quality);
    EXPECT_TRUE(!is_on[0] || after.x() == before.x());
    EXPECT_TRUE(!is_on[1] || after.y() == before.y());
    EXPECT_TRUE(!is_on[2] || after.z() == before.z());
  }
  EXPECT_GT(moved[1], 20);
  EXPECT_GT(moved[2], 5);
  EXPECT_EQ(moved[0] + moved[3], 0);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(1), volume_1, 1e-14);
  EXPECT_NEAR(dsc.volume(2), volume_2, 1e-14);
  EXPECT_NEAR(dsc.area(0), area, 1e-13);
}

} // namespace test_smoothing
