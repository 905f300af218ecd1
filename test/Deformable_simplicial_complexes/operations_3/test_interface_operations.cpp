#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Operations that change the interface: edge flips and relabeling.

namespace test_interface_operations {

using mesh_helpers::interface_triangles;
using mesh_helpers::jittered_grid;
using mesh_helpers::minimum_quality;
using namespace operation_helpers;

bool is_interface_edge(const Complex& dsc, Vertex_handle v, Vertex_handle w) {
  const Edge_in_cell e = find_edge(dsc, v, w);
  return dsc.is_interface(Complex::Edge(e.cell, e.i, e.j));
}

std::size_t number_of_interface_facets(const Complex& dsc, const Edge_in_cell& e) {
  std::size_t facets = 0;
  auto f = dsc.triangulation().incident_facets(e.cell, e.i, e.j), done = f;
  do
    facets += dsc.is_interface(*f) ? 1u : 0u;
  while (++f != done);
  return facets;
}

// Returns the number of triangles of the interface a that the interface b does not contain.
template <class Triangles> std::size_t missing(const Triangles& a, const Triangles& b) {
  Triangles difference;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(difference));
  return difference.size();
}

TEST(Interface_flip, is_best_with_the_other_diagonal) {
  Random random(5);
  for (std::size_t n = 4; n <= 7; ++n)
    for (std::size_t arc = 2; arc + 2 <= n; ++arc) {
      int accepted = 0;
      for (int trial = 0; trial < 40; ++trial) {
        Complex dsc;
        const Labeled_mesh mesh = random_ring(n, arc, random);
        const auto v = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
        const auto state = dsc.state();
        const double before = minimum_quality(dsc);
        std::vector<Vertex_handle> ring(v.begin() + 2, v.end());
        ring.push_back(ring.front());
        const double best = (std::min)(best_triangulation(dsc, v[0], v[1], ring, 0, arc),
                                       best_triangulation(dsc, v[0], v[1], ring, arc, n));
        const Edge_in_cell e = find_edge(dsc, v[0], v[1]);
        Cavity cavity(dsc);
        const bool proposed = propose_interface_edge_flip(dsc, e.cell, e.i, e.j, cavity);
        ASSERT_EQ(proposed, best > before);
        if (!proposed) {
          EXPECT_TRUE(dsc.state() == state);
          continue;
        }
        ++accepted;
        EXPECT_NEAR(cavity.quality_after(), best, tolerance);
        const double volume = dsc.volume(1);
        const double gain =
            -CGAL::volume(v[0]->point(), v[1]->point(), ring[0]->point(), ring[arc]->point());
        expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
        EXPECT_NEAR(dsc.volume(1), volume + gain, tolerance);
        EXPECT_EQ(dsc.interface_facets().size(), 2u);
        EXPECT_TRUE(is_interface_edge(dsc, ring[0], ring[arc]));
      }
      EXPECT_GT(accepted, 1) << n << ' ' << arc;
    }
}

TEST(Interface_flip, changes_two_triangles_and_no_topology) {
  int accepted = 0, at_lines = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Complex dsc = seed == 0 ? jittered_grid(4, small_meshes::two_boxes, .4, seed)
                                  : jittered_grid(4, small_meshes::ball, .4, seed);
    const auto triangles = interface_triangles(dsc);
    const auto state = dsc.state();
    for (const auto& edge : dsc.triangulation().finite_edges()) {
      const Edge_in_cell e = {edge.first, edge.second, edge.third};
      Complex copy = dsc;
      Cavity cavity(copy);
      const Cell_handle cell = in_copy(copy, e.cell);
      const Vertex_handle a = cell->vertex(e.i), b = cell->vertex(e.j);
      const bool proposed = propose_interface_edge_flip(copy, cell, e.i, e.j, cavity);
      if (number_of_interface_facets(dsc, e) != 2) {
        EXPECT_FALSE(proposed);
        at_lines += number_of_interface_facets(dsc, e) > 2 ? 1 : 0;
      }
      if (!proposed) {
        EXPECT_TRUE(copy.state() == state);
        continue;
      }
      ++accepted;
      std::vector<Vertex_handle> diagonal; // the vertices opposite to the edge
      auto f = copy.triangulation().incident_facets(cell, e.i, e.j), done = f;
      do
        for (Vertex_handle v : copy.facet_vertices(*f))
          if (copy.is_interface(*f) && v != a && v != b)
            diagonal.push_back(v);
      while (++f != done);
      const double moved = std::abs(
          CGAL::volume(a->point(), b->point(), diagonal.at(0)->point(), diagonal.at(1)->point()));
      expect_valid_commit(copy, cavity, 8);
      EXPECT_TRUE(is_interface_edge(copy, diagonal[0], diagonal[1]));
      EXPECT_EQ(missing(triangles, interface_triangles(copy)), 2u);
      EXPECT_EQ(missing(interface_triangles(copy), triangles), 2u);
      double change = 0;
      for (int label : dsc.labels()) {
        change += std::abs(copy.volume(label) - dsc.volume(label));
        EXPECT_EQ(copy.euler_characteristic(label), dsc.euler_characteristic(label));
        EXPECT_EQ(copy.number_of_components(label), dsc.number_of_components(label));
      }
      EXPECT_NEAR(change, 2 * moved, tolerance);
    }
  }
  EXPECT_GT(accepted, 10);
  EXPECT_GT(at_lines, 5);
}

// Relabeling

// Returns twice the area of the interface on the facets of a cell, if the cell had this label.
double area_around(const Complex& dsc, Cell_handle c, int label) {
  double area = 0;
  for (int i = 0; i < 4; ++i) {
    const auto v = dsc.facet_vertices({c, i});
    if (!dsc.is_infinite(c->neighbor(i)) && c->neighbor(i)->subdomain_index() != label)
      area += std::sqrt(
          CGAL::cross_product(v[1]->point() - v[0]->point(), v[2]->point() - v[0]->point())
              .squared_length());
  }
  return area;
}

// Returns the largest interface facet of a cell that the opposite vertex, which is also on the
// interface, touches. Tolerances: .01 in barycentric coordinates, 2 % of the largest area. Returns
// -1 if there is none.
int facet_of_contact(const Complex& dsc, Cell_handle c) {
  double areas[4], largest_area = 0;
  for (int i = 0; i < 4; ++i) {
    const auto v = dsc.facet_vertices({c, i});
    areas[i] = std::sqrt(CGAL::squared_area(v[0]->point(), v[1]->point(), v[2]->point()));
    largest_area = (std::max)(largest_area, areas[i]);
  }
  int result = -1;
  for (int i = 0; i < 4; ++i) {
    if (!dsc.is_interface(Complex::Facet(c, i)) ||
        !(c->vertex(i)->is_interface() || dsc.is_boundary(c->vertex(i))) ||
        !(areas[i] > .98 * largest_area) || (result >= 0 && areas[i] <= areas[result]))
      continue;
    const auto v = dsc.facet_vertices({c, i});
    const Point p = v[0]->point(), q = c->vertex(i)->point();
    const auto a = v[1]->point() - p, b = v[2]->point() - p, n = CGAL::cross_product(a, b);
    const double s = CGAL::cross_product(q - p, b) * n / n.squared_length(),
                 t = CGAL::cross_product(a, q - p) * n / n.squared_length();
    if (s >= -.01 && t >= -.01 && s + t <= 1.01)
      result = i;
  }
  return result;
}

// The threshold is far above all qualities, so each cell is examined.
TEST(Relabeling, follows_the_two_rules) {
  Random random(6);
  const auto random_label = [&](const Point&) { return int(random.below(3)); };
  const Complex dsc = jittered_grid(4, random_label, .4, 7);
  const auto state = dsc.state();
  int by_projection = 0, by_area = 0, none = 0;
  for (Cell_handle c : dsc.cells()) {
    int label = -1;
    const bool proposed = propose_relabeling(dsc, c, 10., label);
    const int facet = facet_of_contact(dsc, c);
    if (facet >= 0) {
      EXPECT_TRUE(proposed);
      EXPECT_EQ(label, c->neighbor(facet)->subdomain_index());
      ++by_projection;
      continue;
    }
    int best = c->subdomain_index();
    for (int i = 0; i < 4; ++i)
      if (!dsc.is_infinite(c->neighbor(i)) &&
          area_around(dsc, c, c->neighbor(i)->subdomain_index()) <
              area_around(dsc, c, best) - tolerance)
        best = c->neighbor(i)->subdomain_index();
    EXPECT_EQ(proposed, best != c->subdomain_index());
    if (proposed) {
      EXPECT_EQ(label, best);
      Complex copy = dsc;
      copy.relabel(in_copy(copy, c), label);
      EXPECT_TRUE(copy.is_valid());
      EXPECT_LT(copy.area(0) + copy.area(1) + copy.area(2),
                dsc.area(0) + dsc.area(1) + dsc.area(2));
    }
    ++(proposed ? by_area : none);
  }
  EXPECT_GT(by_projection, 10);
  EXPECT_GT(by_area, 10);
  EXPECT_GT(none, 10);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Relabeling, considers_cells_below_its_thresholds_only) {
  Random random(8);
  const auto random_label = [&](const Point&) { return int(random.below(3)); };
  const Complex dsc = jittered_grid(4, random_label, .4, 8);
  int by_second_rule = 0;
  for (Cell_handle c : dsc.cells()) {
    int label = -1;
    const double quality = dsc.quality(c);
    EXPECT_FALSE(propose_relabeling(dsc, c, quality, label));
    EXPECT_EQ(label, -1);
    const bool above_half = propose_relabeling(dsc, c, 1.5 * quality, label),
               below_half = propose_relabeling(dsc, c, 2.5 * quality, label);
    EXPECT_LE(above_half, below_half);
    by_second_rule += above_half != below_half ? 1 : 0;
  }
  EXPECT_GT(by_second_rule, 0);
}

// A cap with its base on phase 1; the cell on the other side has label 1 or 2.
TEST(Relabeling, gives_a_trapped_cap_to_the_phase_behind_it) {
  const double height = 1e-4;
  Complex dsc;
  const auto v = dsc.assign({Point(1, 0, 0), Point(-.5, .8, 0), Point(-.5, -.8, 0),
                             Point(0, 0, height), Point(0, 0, 1), Point(0, 0, -1)},
                            {{0, 1, 2, 3}, {5, 0, 1, 2}, {3, 0, 1, 4}, {3, 1, 2, 4}, {3, 2, 0, 4}},
                            {0, 1, 2, 2, 2});
  Cell_handle cap;
  ASSERT_TRUE(dsc.triangulation().is_cell(v[0], v[1], v[2], v[3], cap));
  int label = -1;
  ASSERT_TRUE(propose_relabeling(dsc, cap, .01, label));
  EXPECT_EQ(label, 1);
  dsc.relabel(cap, label);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_TRUE(dsc.is_interface(v[3]));
  EXPECT_EQ(dsc.labels(), (std::vector<int>{1, 2}));
  EXPECT_EQ(dsc.number_of_components(1), 1u);
  EXPECT_FALSE(propose_relabeling(dsc, cap, 1e-9, label)); // not that bad
}

} // namespace test_interface_operations
