#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Edge removal and multi-face removal compared with brute force.

namespace test_operations {

using mesh_helpers::jittered_grid;
using mesh_helpers::minimum_quality;
using namespace operation_helpers;

// Returns the vertices around the edge ij of a cell, in the order of the cells. Returns no vertices
// if the ring contains an infinite cell.
std::vector<Vertex_handle> ring_of(const Complex& dsc, Cell_handle cell, int i, int j) {
  const Vertex_handle a = cell->vertex(i), b = cell->vertex(j);
  std::vector<Vertex_handle> ring;
  auto c = dsc.triangulation().incident_cells(cell, i, j), done = c;
  do {
    if (dsc.is_infinite(Cell_handle(c)))
      return {};
    for (int k = 0; k < 4; ++k) { // the first of the two other vertices in counterclockwise order
      const int l = 6 - c->index(a) - c->index(b) - k;
      if (c->vertex(k) != a && c->vertex(k) != b &&
          CGAL::orientation(a->point(), b->point(), c->vertex(k)->point(), c->vertex(l)->point()) ==
              CGAL::POSITIVE)
        ring.push_back(c->vertex(k));
    }
  } while (++c != done);
  // The circulator may have either direction.
  const std::size_t n = ring.size();
  Cell_handle ignored;
  if (!dsc.triangulation().is_cell(a, b, ring[0], ring[1 % n], ignored) ||
      CGAL::orientation(a->point(), b->point(), ring[0]->point(), ring[1 % n]->point()) !=
          CGAL::POSITIVE)
    std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST(Edge_removal, is_best_of_all_triangulations_of_a_ring) {
  Random random(1);
  for (std::size_t n = 3; n <= 7; ++n) {
    int accepted = 0;
    for (int trial = 0; trial < 60; ++trial) {
      Complex dsc;
      const Labeled_mesh mesh = random_ring(n, 0, random);
      auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
      const auto state = dsc.state();
      const double before = minimum_quality(dsc), volume = volume_of_domain(dsc);
      const double best = best_triangulation(dsc, v[0], v[1], {v.begin() + 2, v.end()}, 0, n - 1);
      Edge_in_cell e = find_edge(dsc, v[0], v[1]);
      if (random.below(2) == 0)
        std::swap(e.i, e.j);
      Cavity cavity(dsc);
      const bool proposed = propose_edge_removal(dsc, e.cell, e.i, e.j, cavity);
      ASSERT_EQ(proposed, best > before);
      if (!proposed) {
        EXPECT_TRUE(dsc.state() == state);
        continue;
      }
      ++accepted;
      EXPECT_EQ(cavity.removed().size(), n);
      EXPECT_EQ(cavity.tetrahedra().size(), 2 * (n - 2));
      EXPECT_EQ(cavity.quality_before(), before);
      EXPECT_NEAR(cavity.quality_after(), best, tolerance);
      EXPECT_TRUE(cavity.is_positive());
      expect_valid_commit(dsc, cavity, volume);
      EXPECT_FALSE(dsc.triangulation().is_edge(v[0], v[1], e.cell, e.i, e.j));
      EXPECT_EQ(dsc.number_of_vertices(), n + 2);
    }
    EXPECT_GT(accepted, 3) << n;
    EXPECT_LT(accepted, 60) << n;
  }
}

TEST(Edge_removal, agrees_with_brute_force_in_a_grid) {
  const Complex dsc = jittered_grid(3, small_meshes::ball, .35, 2);
  const auto state = dsc.state();
  Cavity cavity(dsc);
  int accepted = 0;
  for_each_edge(dsc, [&](const Edge_in_cell& e) {
    const Vertex_handle a = e.cell->vertex(e.i), b = e.cell->vertex(e.j);
    const bool proposed = propose_edge_removal(dsc, e.cell, e.i, e.j, cavity);
    const auto ring = ring_of(dsc, e.cell, e.i, e.j);
    double before = infinity;
    bool is_allowed = !ring.empty();
    auto c = dsc.triangulation().incident_cells(e.cell, e.i, e.j), done = c;
    do {
      is_allowed = is_allowed && c->subdomain_index() == e.cell->subdomain_index();
      before = (std::min)(before, c->quality());
    } while (++c != done);
    const double best =
        is_allowed ? best_triangulation(dsc, a, b, ring, 0, ring.size() - 1) : -infinity;
    EXPECT_EQ(proposed, best > before);
    if (proposed) {
      ++accepted;
      EXPECT_NEAR(cavity.quality_after(), best, tolerance);
    }
  });
  EXPECT_GT(accepted, 20);
  EXPECT_TRUE(dsc.state() == state);
}

// Multi-face removal

int count_bits(unsigned set) { return set == 0 ? 0 : int(set & 1) + count_bits(set >> 1); }

TEST(Multi_face_removal, is_best_of_all_sets_of_facets) {
  Random random(3);
  std::vector<int> accepted(6, 0);
  for (std::size_t m = 1; m <= 5; ++m)
    for (int trial = 0; trial < 60; ++trial) {
      Sandwich s(m, random);
      const std::size_t other = s.relabel_one(random);
      Complex dsc;
      const auto v = dsc.assign(s.mesh.points, s.mesh.tetrahedra, s.mesh.labels);
      const auto state = dsc.state();
      const auto old_quality = [&](std::size_t t) {
        const auto& f = s.triangles[t];
        return (std::min)(quality(dsc, v[0], v[f[0]], v[f[1]], v[f[2]]),
                          quality(dsc, v[f[0]], v[f[1]], v[f[2]], v[1]));
      };
      for (std::size_t first = 0; first < m; ++first) {
        Cell_handle cell;
        const auto& f = s.triangles[first];
        ASSERT_TRUE(dsc.triangulation().is_cell(v[0], v[f[0]], v[f[1]], v[f[2]], cell));
        const int i = cell->index(v[0]);
        Cavity cavity(dsc);
        const bool proposed =
            random.below(2) == 0
                ? propose_multi_face_removal(dsc, cell, i, cavity)
                : propose_multi_face_removal(dsc, cell->neighbor(i), cell->neighbor(i)->index(cell),
                                             cavity);
        EXPECT_TRUE(dsc.state() == state);

        // Returns the worst quality for the best set and for the proposed set.
        double best = -infinity, of_proposal = -infinity;
        bool is_improvable = false;
        unsigned proposal = 0;
        for (std::size_t t = 0; proposed && t < m; ++t)
          for (Cell_handle c : cavity.removed())
            if (c->has_vertex(v[0]) && c->has_vertex(v[s.triangles[t][0]]) &&
                c->has_vertex(v[s.triangles[t][1]]) && c->has_vertex(v[s.triangles[t][2]]))
              proposal |= 1u << t;
        for (unsigned set = 1; set < 1u << m; ++set) {
          const auto edges = s.boundary(set);
          if ((set >> first & 1) == 0 || int(edges.size()) != count_bits(set) + 2 ||
              (other < m && (set >> other & 1) != 0 && set != 1u << other))
            continue;
          double after = infinity, before = infinity, rest = infinity;
          for (const auto& e : edges)
            after = (std::min)(after, quality(dsc, v[0], v[1], v[e[0]], v[e[1]]));
          for (std::size_t t = 0; t < m; ++t)
            if (other >= m || (t == other) == (first == other)) {
              double& side = (set >> t & 1) != 0 ? before : rest;
              side = (std::min)(side, old_quality(t));
            }
          is_improvable = is_improvable || after > before;
          best = (std::max)(best, (std::min)(after, rest));
          if (set == proposal) {
            of_proposal = (std::min)(after, rest);
            EXPECT_NEAR(cavity.quality_after(), after, tolerance);
            EXPECT_NEAR(cavity.quality_before(), before, tolerance);
          }
        }
        ASSERT_EQ(proposed, is_improvable);
        if (!proposed)
          continue;
        const std::size_t removed = std::size_t(count_bits(proposal));
        ++accepted[removed];
        EXPECT_NEAR(of_proposal, best, tolerance);
        EXPECT_EQ(cavity.removed().size(), 2 * removed);
        EXPECT_EQ(cavity.tetrahedra().size(), removed + 2);
        Complex copy = dsc;
        Cavity cavity_of_copy(copy);
        ASSERT_TRUE(propose_multi_face_removal(copy, in_copy(copy, cell), i, cavity_of_copy));
        expect_valid_commit(copy, cavity_of_copy, volume_of_domain(dsc));
      }
    }
  for (std::size_t m = 1; m <= 4; ++m)
    EXPECT_GT(accepted[m], 3) << m;
}

// A cavity stays valid until the complex changes; other proposals and queries may come between.
TEST(Cavity, survives_everything_that_does_not_change_the_complex) {
  Random random(9);
  Labeled_mesh mesh;
  Complex dsc;
  Cavity first(dsc), second(dsc);
  Edge_in_cell e;
  do {
    mesh = random_ring(5, 0, random);
    const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    e = find_edge(dsc, v[0], v[1]);
  } while (!propose_edge_removal(dsc, e.cell, e.i, e.j, first));
  propose_edge_removal(dsc, e.cell, e.j, e.i, second);
  dsc.state();
  expect_valid_commit(dsc, first, volume_of_domain(dsc));
}

TEST(Multi_face_removal, leaves_interface_and_boundary_alone) {
  EXPECT_GT(proposals_within_labels(jittered_grid(3, small_meshes::four_phases, .35, 4),
                                    DSC::propose_multi_face_removal<Complex>),
            20);
}

// Two apices over a disk of rings of triangles. Each facet can be reached on very many paths.
TEST(Multi_face_removal, looks_at_each_facet_once) {
  static constexpr std::size_t sectors = 32, rings = 3;
  std::vector<Point> points = {Point(0, 0, 1), Point(0, 0, -1), Point(0, 0, 0)};
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t s = 0; s < sectors; ++s) {
      const double angle = 2 * CGAL_PI * double(s) / sectors;
      points.emplace_back(double(ring) * std::cos(angle), double(ring) * std::sin(angle), 0);
    }
  const auto index = [](std::size_t ring, std::size_t s) {
    return ring == 0 ? 2 : 3 + (ring - 1) * sectors + s % sectors;
  };
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    tetrahedra.push_back({a, b, c, 0});
    tetrahedra.push_back({a, c, b, 1});
  };
  for (std::size_t s = 0; s < sectors; ++s) {
    add(2, index(1, s), index(1, s + 1));
    for (std::size_t ring = 1; ring < rings; ++ring) {
      add(index(ring, s), index(ring + 1, s), index(ring + 1, s + 1));
      add(index(ring, s), index(ring + 1, s + 1), index(ring, s + 1));
    }
  }
  Complex dsc;
  dsc.assign(points, tetrahedra, std::vector<int>(tetrahedra.size(), 0));
  Cavity cavity(dsc);
  std::size_t proposals = 0;
  for (Cell_handle c : dsc.cells())
    for (int i = 0; i < 4; ++i)
      proposals += propose_multi_face_removal(dsc, c, i, cavity);
  EXPECT_LE(proposals, 4 * dsc.number_of_cells());
}

} // namespace test_operations
