#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Multi-face retriangulation compared with brute force.

namespace test_retriangulation {

using mesh_helpers::jittered_grid;
using namespace operation_helpers;

// Returns the triangles that are connected with a triangle without a change of label, as a bit set.
unsigned connected_set(const Sandwich& s, std::size_t first) {
  const auto label = [&](std::size_t t) { return s.mesh.labels[2 * t]; };
  unsigned set = 1u << first;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
      const bool is_neighbor = s.boundary(set | 1u << t).size() < s.boundary(set).size() + 3;
      if ((set >> t & 1) == 0 && is_neighbor && label(t) == label(first)) {
        set |= 1u << t;
        has_grown = true;
      }
    }
  }
  return set;
}

// The cell between a triangle and point 0.
Cell_handle cell_of(const Complex& dsc, const std::vector<Vertex_handle>& v, const Triangle& t) {
  Cell_handle cell;
  EXPECT_TRUE(dsc.triangulation().is_cell(v[0], v[t[0]], v[t[1]], v[t[2]], cell));
  return cell;
}

bool propose(const Complex& dsc, Cell_handle cell, Vertex_handle a, Cavity& cavity) {
  return propose_multi_face_retriangulation(dsc, cell, cell->index(a), cavity);
}

// Triangles between point 0 below and point 1 above.
Labeled_mesh two_sided(std::vector<Point> points, const std::vector<Triangle>& triangles,
                       const std::vector<int>& labels) {
  Labeled_mesh mesh = {std::move(points), {}, {}};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [p, q, r] = triangles[t];
    mesh.tetrahedra.push_back({0, p, q, r});
    mesh.tetrahedra.push_back({p, q, r, 1});
    mesh.labels.insert(mesh.labels.end(), {labels[t], labels[t]});
  }
  return mesh;
}

// Checks that there is no proposal for any triangle of `two_sided()`.
void expect_refusals(const Complex& dsc, const std::vector<Vertex_handle>& v,
                     const std::vector<Triangle>& triangles) {
  Cavity cavity(dsc);
  for (const Triangle& t : triangles)
    EXPECT_FALSE(propose(dsc, cell_of(dsc, v, t), v[0], cavity));
}

TEST(Multi_face_retriangulation, is_best_of_all_triangulations_of_a_loop) {
  Random random(1);
  for (std::size_t m = 1; m <= 6; ++m) {
    int accepted = 0, refused = 0;
    for (int trial = 0; trial < 40; ++trial) {
      Sandwich s(m, random);
      s.relabel_one(random);
      Complex dsc;
      const auto v = dsc.assign(s.mesh.points, s.mesh.tetrahedra, s.mesh.labels);
      const auto state = dsc.state();
      for (std::size_t first = 0; first < m; ++first) {
        const unsigned set = connected_set(s, first);
        std::vector<std::size_t> loop; // in the order of the polygon
        double before = infinity;
        for (std::size_t t = 0; t < m; ++t)
          if ((set >> t & 1) != 0) {
            const auto& f = s.triangles[t];
            loop.insert(loop.end(), f.begin(), f.end());
            before = (std::min)({before, quality(dsc, v[0], v[f[0]], v[f[1]], v[f[2]]),
                                 quality(dsc, v[f[0]], v[f[1]], v[f[2]], v[1])});
          }
        std::sort(loop.begin(), loop.end());
        loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
        std::vector<Vertex_handle> ring;
        for (std::size_t p : loop)
          ring.push_back(v[p]);
        const double best = best_triangulation(dsc, v[0], v[1], ring, 0, ring.size() - 1);

        const Cell_handle below = cell_of(dsc, v, s.triangles[first]),
                          above = below->neighbor(below->index(v[0]));
        Cavity cavity(dsc), from_above(dsc);
        const bool proposed = propose(dsc, below, v[0], cavity);
        EXPECT_EQ(propose(dsc, above, v[1], from_above), proposed);
        EXPECT_TRUE(dsc.state() == state);
        ASSERT_EQ(proposed, best > before + tolerance);
        if (!proposed) {
          ++refused;
          continue;
        }
        ++accepted;
        EXPECT_EQ(cavity.removed().size(), 2 * (loop.size() - 2));
        EXPECT_EQ(cavity.tetrahedra().size(), cavity.removed().size());
        EXPECT_NEAR(cavity.quality_before(), before, tolerance);
        EXPECT_NEAR(cavity.quality_after(), best, tolerance);
        EXPECT_NEAR(from_above.quality_after(), best, tolerance);
        for (Cell_handle c : cavity.removed())
          EXPECT_EQ(c->subdomain_index(), below->subdomain_index());

        Complex copy = dsc;
        Cavity of_copy(copy);
        const Cell_handle c = in_copy(copy, below);
        ASSERT_TRUE(propose_multi_face_retriangulation(copy, c, below->index(v[0]), of_copy));
        expect_valid_commit(copy, of_copy, volume_of_domain(dsc));
        EXPECT_EQ(copy.number_of_vertices(), dsc.number_of_vertices());
        // An optimal triangulation has no further proposal. The first two cells share a triangle of
        // the loop.
        Cavity again(copy);
        const Cell_handle created = of_copy.created()[1];
        EXPECT_FALSE(propose_multi_face_retriangulation(
            copy, created, created->index(of_copy.created()[0]), again));
      }
    }
    EXPECT_GT(refused, 3) << m;
    if (m == 1) {
      EXPECT_EQ(accepted, 0);
    } else {
      EXPECT_GT(accepted, 3) << m;
    }
  }
}

// Without its center, the fan would have a better triangulation.
TEST(Multi_face_retriangulation, refuses_a_set_with_a_vertex_inside) {
  static constexpr std::size_t n = 5;
  std::vector<Point> points = {Point(0, 0, -1), Point(0, 0, 1), Point(.8, 0, 0)};
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * CGAL_PI * double(k) / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    triangles.push_back({2, 3 + k, 3 + (k + 1) % n});
  }
  const Labeled_mesh mesh = two_sided(points, triangles, std::vector<int>(n, 0));
  Complex dsc;
  const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  const std::vector<Vertex_handle> ring(v.begin() + 3, v.end());
  ASSERT_GT(best_triangulation(dsc, v[0], v[1], ring, 0, n - 1),
            mesh_helpers::minimum_quality(dsc));
  expect_refusals(dsc, v, triangles);
}

// Triangles around a triangle of another label. This triangle shares no vertex or one vertex with
// the outer loop. With one common vertex, the number of boundary edges equals the number for a
// disk.
TEST(Multi_face_retriangulation, refuses_a_set_with_a_hole) {
  std::vector<Point> points = {Point(0, 0, -1),   Point(0, 0, 1),    Point(1, 0, 0),
                               Point(0, 1, 0),    Point(-1, 0, 0),   Point(0, -1, 0),
                               Point(-.3, .2, 0), Point(-.3, -.2, 0)};
  std::vector<Triangle> triangles = {{2, 6, 7}, {2, 3, 6}, {3, 4, 6},
                                     {6, 4, 7}, {4, 5, 7}, {5, 2, 7}};
  std::vector<int> labels = {1, 0, 0, 0, 0, 0};
  for (bool touches : {true, false}) {
    if (!touches) {
      points.emplace_back(.3, 0, 0);
      const std::size_t corner = points.size() - 1;
      triangles = {{corner, 6, 7}, {2, 3, corner}, {corner, 3, 6}, {3, 4, 6},
                   {6, 4, 7},      {4, 5, 7},      {5, corner, 7}, {5, 2, corner}};
      labels = {1, 0, 0, 0, 0, 0, 0, 0};
    }
    const Labeled_mesh mesh = two_sided(points, triangles, labels);
    Complex dsc;
    const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    expect_refusals(dsc, v, triangles);
  }
}

TEST(Multi_face_retriangulation, leaves_interface_and_boundary_alone) {
  proposals_within_labels(jittered_grid(3, small_meshes::four_phases, .4, 2),
                          DSC::propose_multi_face_retriangulation<Complex>);
}

TEST(Multi_face_retriangulation, improves_random_meshes) {
  const auto propose = [](const Complex& dsc, Cell_handle c, Cavity& cavity) {
    for (int i = 0; i < 4; ++i)
      if (propose_multi_face_retriangulation(dsc, c, i, cavity))
        return true;
    return false;
  };
  EXPECT_GT(improvements_of_random_meshes(small_meshes::two_boxes, propose), 10);
}

} // namespace test_retriangulation
