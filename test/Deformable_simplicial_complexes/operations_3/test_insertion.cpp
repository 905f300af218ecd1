#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Origin.h>
#include <CGAL/enum.h>

// Vertex insertion compared with brute force.

namespace test_insertion {

using mesh_helpers::jittered_grid;
using namespace operation_helpers;
using Position = Complex::Point_3;

Position barycenter(const Complex& dsc, Cell_handle c) {
  Complex::Vector_3 sum(0, 0, 0);
  for (int i = 0; i < 4; ++i)
    sum = sum + (dsc.position(c->vertex(i)) - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / 4;
}

// Returns the cells of one label that are connected with the seed; the seed is first.
std::vector<Cell_handle> component(const Complex& dsc, Cell_handle seed) {
  std::vector<Cell_handle> cells = {seed};
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const Cell_handle n = cells[k]->neighbor(i);
      if (!dsc.is_infinite(n) && n->subdomain_index() == seed->subdomain_index() &&
          std::find(cells.begin(), cells.end(), n) == cells.end())
        cells.push_back(n);
    }
  return cells;
}

// Returns the worst quality of the star of a point p that replaces a subset of some cells. Returns
// -infinity if p does not see a facet of the subset, or if a vertex has no facet.
class Stars
{
public:
  Stars(const Complex& dsc, const std::vector<Cell_handle>& cells, const Position& p)
      : m_cells(cells), m_facets(cells.size()) {
    const Point exact = p;
    for (std::size_t k = 0; k < cells.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        std::array<Point, 4> x;
        std::array<Position, 4> y;
        for (int j = 0; j < 4; ++j) {
          const Vertex_handle v = cells[k]->vertex(j);
          x[j] = j == i ? exact : v->point();
          y[j] = j == i ? p : dsc.position(v);
        }
        const bool is_seen = CGAL::orientation(x[0], x[1], x[2], x[3]) == CGAL::POSITIVE;
        m_facets[k][i].quality =
            is_seen ? dsc.quality_measure()(y[0], y[1], y[2], y[3]) : -infinity;
        m_facets[k][i].behind = std::size_t(
            std::find(cells.begin(), cells.end(), cells[k]->neighbor(i)) - cells.begin());
      }
  }

  double worst_quality(unsigned set) const {
    double worst = infinity;
    std::vector<Vertex_handle> inside, outside; // vertices of the cells and of the boundary facets
    for (std::size_t k = 0; k < m_cells.size(); ++k)
      for (int i = 0; i < 4 && (set >> k & 1) != 0; ++i) {
        inside.push_back(m_cells[k]->vertex(i));
        const Facet& f = m_facets[k][i];
        if (f.behind < m_cells.size() && (set >> f.behind & 1) != 0)
          continue;
        worst = (std::min)(worst, f.quality);
        for (int j = 0; j < 4; ++j)
          if (j != i)
            outside.push_back(m_cells[k]->vertex(j));
      }
    const auto has_facet = [&](Vertex_handle v) {
      return std::find(outside.begin(), outside.end(), v) != outside.end();
    };
    return worst > -infinity && std::all_of(inside.begin(), inside.end(), has_facet) ? worst
                                                                                     : -infinity;
  }

private:
  struct Facet
  {
    double quality;
    std::size_t behind; // index of the neighbor
  };
  const std::vector<Cell_handle>& m_cells;
  std::vector<std::array<Facet, 4>> m_facets;
};

// Compares the proposals for all cells with the best of all sets of cells, if there are few sets.
// Returns the number of proposals.
int compare_with_brute_force(const Complex& dsc) {
  static constexpr std::size_t few = 10;
  const auto state = dsc.state();
  int proposals = 0;
  Cavity cavity(dsc);
  for (Cell_handle seed : dsc.cells()) {
    const auto cells = component(dsc, seed);
    if (cells.size() > few || !propose_vertex_insertion(dsc, seed, cavity))
      continue;
    ++proposals;
    const Stars stars(dsc, cells, barycenter(dsc, seed));
    double best = -infinity;
    for (unsigned set = 1; set < 1u << cells.size(); set += 2) // the sets that contain the seed
      best = (std::max)(best, stars.worst_quality(set));
    unsigned proposal = 0;
    for (Cell_handle c : cavity.removed())
      proposal |= 1u << (std::find(cells.begin(), cells.end(), c) - cells.begin());
    EXPECT_NEAR(stars.worst_quality(proposal), best, tolerance);
    EXPECT_GE(cavity.quality_after(), best - tolerance);
    EXPECT_GT(cavity.quality_after(), cavity.quality_before());
    EXPECT_TRUE(cavity.is_positive());

    Complex copy = dsc;
    Cavity of_copy(copy);
    EXPECT_TRUE(propose_vertex_insertion(copy, in_copy(copy, seed), of_copy));
    expect_valid_commit(copy, of_copy, volume_of_domain(dsc));
    EXPECT_EQ(copy.number_of_vertices(), dsc.number_of_vertices() + 1);
    const Vertex_handle inserted = of_copy.vertices().back().handle;
    EXPECT_EQ(inserted->boundary_class(), DSC::Boundary_class::inside);
    EXPECT_FALSE(inserted->is_interface());
    for (Cell_handle c : of_copy.created()) {
      EXPECT_TRUE(c->has_vertex(inserted));
      EXPECT_EQ(c->subdomain_index(), seed->subdomain_index());
    }
  }
  EXPECT_TRUE(dsc.state() == state);
  return proposals;
}

// A sliver whose four vertices lie around the z-axis at the heights h and -h. It is joined to two
// vertices at the heights 1 and -1. The sliver is the first cell.
Labeled_mesh sliver_in_octahedron(double h) {
  return {{Point(1, 0, h), Point(-1, 0, h), Point(0, 1, -h), Point(0, -1, -h), Point(0, 0, 1),
           Point(0, 0, -1)},
          {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 3, 4}, {0, 3, 2, 5}, {1, 2, 3, 5}},
          {0, 0, 0, 0, 0}};
}

// Returns the quality of a tetrahedron with this volume and sum of squared edge lengths.
double volume_length_ratio(double volume, double squares) {
  return 6 * std::sqrt(2.) * volume / std::pow(squares / 6, 1.5);
}

TEST(Vertex_insertion, replaces_a_sliver_and_its_neighbors) {
  static constexpr double h = .05;
  Complex dsc;
  const Labeled_mesh mesh = sliver_in_octahedron(h);
  ASSERT_TRUE(is_positive(mesh));
  const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  Cell_handle sliver;
  ASSERT_TRUE(dsc.triangulation().is_cell(v[0], v[1], v[2], v[3], sliver));
  Cavity cavity(dsc);
  ASSERT_TRUE(propose_vertex_insertion(dsc, sliver, cavity));
  EXPECT_EQ(cavity.removed().size(), 5u);
  EXPECT_EQ(cavity.tetrahedra().size(), 8u);
  // All eight new tetrahedra are congruent, so the new vertex stays in the center.
  EXPECT_NEAR(cavity.quality_before(), volume_length_ratio(4 * h / 3, 16 + 16 * h * h), tolerance);
  EXPECT_NEAR(cavity.quality_after(), volume_length_ratio(1. / 6, 9 + 8 * h * h), tolerance);
  EXPECT_LT((cavity.vertices().back().position - CGAL::ORIGIN).squared_length(), 1e-20);
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  EXPECT_EQ(dsc.number_of_cells(), 8u);
}

TEST(Vertex_insertion, takes_no_cell_of_another_label) {
  Complex dsc;
  Labeled_mesh mesh = sliver_in_octahedron(.05);
  Cell_handle sliver;
  const auto assign = [&] {
    const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    ASSERT_TRUE(dsc.triangulation().is_cell(v[0], v[1], v[2], v[3], sliver));
  };
  // The sliver alone can only be divided into worse cells.
  mesh.labels = {1, 0, 0, 0, 0};
  assign();
  Cavity cavity(dsc);
  EXPECT_FALSE(propose_vertex_insertion(dsc, sliver, cavity));
  // With the cells below the sliver, the new vertex moves down.
  mesh.labels = {0, 1, 1, 0, 0};
  assign();
  const auto interface_before = mesh_helpers::interface_triangles(dsc);
  ASSERT_TRUE(propose_vertex_insertion(dsc, sliver, cavity));
  EXPECT_EQ(cavity.removed().size(), 3u);
  EXPECT_LT(cavity.vertices().back().position.z(), -.1);
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  EXPECT_EQ(mesh_helpers::interface_triangles(dsc), interface_before);
}

// Four cells around an edge of a regular octahedron are better than any star of an inner vertex.
TEST(Vertex_insertion, without_gain_is_refused) {
  Complex dsc;
  dsc.assign({Point(0, 0, -1), Point(0, 0, 1), Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0),
              Point(0, -1, 0)},
             {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}, {0, 1, 5, 2}}, {0, 0, 0, 0});
  Cavity cavity(dsc);
  for (Cell_handle c : dsc.cells())
    EXPECT_FALSE(propose_vertex_insertion(dsc, c, cavity));
}

TEST(Vertex_insertion, takes_the_best_of_all_sets_of_cells) {
  Random random(1);
  int proposals = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Labeled_mesh mesh;
    do {
      mesh = sliver_in_octahedron(.05);
      const double disorder = random(0, .4);
      for (Point& p : mesh.points) {
        const auto v = random.vector<Complex>(disorder);
        p = Point(p.x() + v.x(), p.y() + v.y(), p.z() + v.z());
      }
    } while (!is_positive(mesh));
    for (std::size_t k = 1; k < 5; ++k)
      mesh.labels[k] = random.below(5) == 0 ? 1 : 0;
    proposals += compare_with_brute_force(small_meshes::make_complex(mesh));
  }
  EXPECT_GT(proposals, 40);
}

TEST(Vertex_insertion, takes_the_best_of_all_sets_of_cells_of_a_ring) {
  Random random(2);
  int proposals = 0;
  for (std::size_t n = 4; n <= 8; ++n)
    for (int trial = 0; trial < 10; ++trial)
      proposals += compare_with_brute_force(
          small_meshes::make_complex(random_ring(n, random.below(2), random)));
  EXPECT_GT(proposals, 10);
}

// An inner vertex with four cells: at least one of the cells stays.
TEST(Vertex_insertion, leaves_every_vertex_a_cell) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const double x = random(0, 1), y = random(0, 1 - x), z = random(0, 1 - x - y);
    Complex dsc;
    dsc.assign({Point(x, y, z), Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
               {{0, 2, 3, 4}, {1, 0, 3, 4}, {1, 2, 0, 4}, {1, 2, 3, 0}}, {0, 0, 0, 0});
    compare_with_brute_force(dsc);
    Cavity cavity(dsc);
    for (Cell_handle c : dsc.cells())
      EXPECT_TRUE(!propose_vertex_insertion(dsc, c, cavity) || cavity.removed().size() < 4);
  }
}

TEST(Vertex_insertion, improves_random_meshes) {
  EXPECT_GT(improvements_of_random_meshes(small_meshes::four_phases,
                                          DSC::propose_vertex_insertion<Complex>),
            30);
}

} // namespace test_insertion
