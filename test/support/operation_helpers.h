#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_OPERATION_HELPERS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_OPERATION_HELPERS_H

#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/number_utils.h>

// Functions that the tests of mesh operations share.
namespace operation_helpers {

using mesh_helpers::Random;
using small_meshes::Complex;
using small_meshes::Labeled_mesh;
using small_meshes::Point;
using Cavity = Complex::Cavity;
using Vertex_handle = Complex::Vertex_handle;
using Cell_handle = Complex::Cell_handle;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-12;

inline double quality(const Complex& dsc, Vertex_handle p, Vertex_handle q, Vertex_handle r,
                      Vertex_handle s) {
  return dsc.quality_measure()(dsc.position(p), dsc.position(q), dsc.position(r), dsc.position(s));
}

// Returns the ends of a vertical edge inside a ring of n more points, counterclockwise. The edge is
// not in the center, so that some of the incident tetrahedra are thin.
inline std::vector<Point> apices_and_ring(std::size_t n, double disorder, double height,
                                          Random& random) {
  std::vector<Point> points;
  const double x = random(0, .8);
  for (double z : {-height, height}) {
    const double y = random(-disorder, disorder);
    points.emplace_back(x + random(-disorder, disorder), y, z);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double radius = 1 + random(-disorder, disorder),
                 angle = 2 * CGAL_PI * (double(k) + random(-disorder, disorder)) / double(n);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        height * random(-disorder, disorder));
  }
  return points;
}

inline bool is_positive(const Labeled_mesh& mesh) {
  return std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](const auto& t) {
    return CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                             mesh.points[t[3]]) == CGAL::POSITIVE;
  });
}

// A random ring of n tetrahedra around the edge from point 0 up to point 1. The points of the ring
// follow counterclockwise. If `first_arc` is not zero, two arcs of the ring have different labels.
inline Labeled_mesh random_ring(std::size_t n, std::size_t first_arc, Random& random) {
  Labeled_mesh mesh;
  do {
    const double disorder = random(0, .3), height = random(.1, 1.2);
    mesh = {apices_and_ring(n, disorder, height, random), {}, {}};
    for (std::size_t k = 0; k < n; ++k) {
      mesh.tetrahedra.push_back({0, 1, 2 + k, 2 + (k + 1) % n});
      mesh.labels.push_back(k < first_arc ? 1 : 0);
    }
  } while (!is_positive(mesh));
  return mesh;
}

// Returns the worst quality of the best triangulation of the ring polygon from p to q, with
// tetrahedra to a below and b above.
inline double best_triangulation(const Complex& dsc, Vertex_handle a, Vertex_handle b,
                                 const std::vector<Vertex_handle>& ring, std::size_t p,
                                 std::size_t q) {
  if (q - p < 2)
    return infinity;
  double best = -infinity;
  for (std::size_t k = p + 1; k < q; ++k)
    best = (std::max)(best, (std::min)({quality(dsc, ring[p], ring[k], ring[q], b),
                                        quality(dsc, ring[k], ring[p], ring[q], a),
                                        best_triangulation(dsc, a, b, ring, p, k),
                                        best_triangulation(dsc, a, b, ring, k, q)}));
  return best;
}

using Triangle = std::array<std::size_t, 3>;

// Returns a random triangulation of the polygon of points p, ..., q.
inline void triangulate(std::size_t p, std::size_t q, Random& random,
                        std::vector<Triangle>& triangles) {
  if (q - p < 2)
    return;
  const std::size_t k = p + 1 + random.below(q - p - 1);
  triangles.push_back({p, k, q});
  triangulate(p, k, random, triangles);
  triangulate(k, q, random, triangles);
}

// m triangles between point 0 below and point 1 above, each with one tetrahedron to either point.
struct Sandwich
{
  explicit Sandwich(std::size_t m, Random& random) {
    do {
      const std::size_t n = m + 2;
      const double disorder = random(0, .3), height = random(.2, 1.2);
      triangles.clear();
      mesh = {apices_and_ring(n, disorder, height, random), {}, {}};
      triangulate(2, n + 1, random, triangles);
      for (const Triangle& t : triangles) {
        mesh.tetrahedra.push_back({0, t[0], t[1], t[2]});
        mesh.tetrahedra.push_back({t[0], t[1], t[2], 1});
        mesh.labels.insert(mesh.labels.end(), {0, 0});
      }
    } while (!is_positive(mesh));
  }

  // Gives the label 1 to the cells of one triangle, or to none. Returns the index of the triangle,
  // or a larger number.
  std::size_t relabel_one(Random& random) {
    const std::size_t t = random.below(3 * triangles.size());
    if (t < triangles.size())
      mesh.labels[2 * t] = mesh.labels[2 * t + 1] = 1;
    return t;
  }

  // Returns the boundary edges of a set of triangles, counterclockwise. Their number shows whether
  // the set is connected.
  std::vector<std::array<std::size_t, 2>> boundary(unsigned set) const {
    std::vector<std::array<std::size_t, 2>> edges, result;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3 && (set >> t & 1) != 0; ++k)
        edges.push_back({triangles[t][k], triangles[t][(k + 1) % 3]});
    for (const auto& e : edges)
      if (std::count(edges.begin(), edges.end(), std::array<std::size_t, 2>{e[1], e[0]}) == 0)
        result.push_back(e);
    return result;
  }

  Labeled_mesh mesh;
  std::vector<Triangle> triangles;
};

struct Edge_in_cell
{
  Cell_handle cell;
  int i, j;
};

inline Edge_in_cell find_edge(const Complex& dsc, Vertex_handle v, Vertex_handle w) {
  Edge_in_cell e;
  EXPECT_TRUE(dsc.triangulation().is_edge(v, w, e.cell, e.i, e.j));
  return e;
}

template <class Visit> void for_each_edge(const Complex& dsc, Visit visit) {
  for (Cell_handle c : dsc.cells())
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j)
          visit(Edge_in_cell{c, i, j});
}

inline double volume_of_domain(const Complex& dsc) {
  double sum = 0;
  for (int label : dsc.labels())
    sum += dsc.volume(label);
  return sum;
}

// Commits a proposal and checks the result; `volume` is the volume of the domain.
inline void expect_valid_commit(Complex& dsc, Cavity& cavity, double volume) {
  dsc.replace(cavity);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(volume_of_domain(dsc), volume, tolerance);
  double created = infinity;
  for (Cell_handle c : cavity.created())
    created = (std::min)(created, dsc.quality(c));
  EXPECT_EQ(created, cavity.quality_after());
  EXPECT_EQ(cavity.created().size(), cavity.tetrahedra().size());
}

// Commits the proposals for all cells one after the other and checks each result. Returns the
// number of proposals. propose(cell, cavity) returns whether there is a proposal.
template <class Propose> int expect_improvement(Complex& dsc, const Propose& propose) {
  const auto interface_before = mesh_helpers::interface_triangles(dsc);
  const double volume = volume_of_domain(dsc);
  std::vector<std::pair<int, double>> volumes;
  for (int label : dsc.labels())
    volumes.emplace_back(label, dsc.volume(label));
  std::vector<std::pair<Cell_handle, std::size_t>> cells;
  for (Cell_handle c : dsc.cells())
    cells.emplace_back(c, c->time_stamp());

  int committed = 0;
  Cavity cavity(dsc);
  for (const auto& cell : cells) {
    if (!dsc.is_alive(cell.first, cell.second))
      continue;
    const auto state = dsc.state();
    const double worst = mesh_helpers::minimum_quality(dsc);
    const bool proposed = propose(cell.first, cavity);
    EXPECT_TRUE(dsc.state() == state);
    if (!proposed)
      continue;
    EXPECT_GT(cavity.quality_after(), cavity.quality_before());
    expect_valid_commit(dsc, cavity, volume);
    EXPECT_GE(mesh_helpers::minimum_quality(dsc), worst);
    ++committed;
  }
  for (const auto& before : volumes)
    EXPECT_NEAR(dsc.volume(before.first), before.second, tolerance);
  EXPECT_TRUE(mesh_helpers::interface_triangles(dsc) == interface_before);
  return committed;
}

// Commits proposals in random meshes of one label and of the labels of `label`. Returns their
// number.
template <class Label, class Propose>
int improvements_of_random_meshes(const Label& label, const Propose& propose) {
  int committed = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    Complex dsc = seed % 2 == 0 ? mesh_helpers::jittered_grid(3, small_meshes::uniform, .45, seed)
                                : mesh_helpers::jittered_grid(4, label, .45, seed);
    committed += expect_improvement(
        dsc, [&](Cell_handle c, Cavity& cavity) { return propose(dsc, c, cavity); });
  }
  return committed;
}

// Checks that proposals for the facets of cells leave the interface and the boundary alone. Returns
// their number.
template <class Propose> int proposals_within_labels(const Complex& dsc, const Propose& propose) {
  const auto state = dsc.state();
  Cavity cavity(dsc);
  int proposals = 0;
  for (Cell_handle c : dsc.cells())
    for (int i = 0; i < 4; ++i) {
      const bool proposed = propose(dsc, c, i, cavity);
      const Cell_handle n = c->neighbor(i);
      if (dsc.is_infinite(n) || n->subdomain_index() != c->subdomain_index()) {
        EXPECT_FALSE(proposed);
      }
      if (!proposed)
        continue;
      ++proposals;
      EXPECT_GT(cavity.quality_after(), cavity.quality_before());
      for (Cell_handle d : cavity.removed())
        EXPECT_EQ(d->subdomain_index(), c->subdomain_index());
    }
  EXPECT_TRUE(dsc.state() == state);
  return proposals;
}

// Returns the cell of a copy that corresponds to a cell of the original.
inline Cell_handle in_copy(const Complex& copy, Cell_handle c) {
  for (Cell_handle d : copy.triangulation().finite_cell_handles())
    if (d->time_stamp() == c->time_stamp())
      return d;
  ADD_FAILURE() << "no copy";
  return Cell_handle();
}

} // namespace operation_helpers

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_OPERATION_HELPERS_H
