#include "betti_numbers.h"
#include "operation_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

// Splits and collapses of edges.

namespace test_edge_collapse {

using DSC::Boundary_class;
using mesh_helpers::Coordinates;
using mesh_helpers::jittered_grid;
using namespace operation_helpers;

void expect_same_topology(const Complex& a, const Complex& b) {
  EXPECT_EQ(a.labels(), b.labels());
  for (int label : a.labels()) {
    EXPECT_EQ(a.euler_characteristic(label), b.euler_characteristic(label));
    EXPECT_EQ(a.number_of_components(label), b.number_of_components(label));
  }
}

bool has_same_topology(const Complex& a, const Complex& b) {
  return a.labels() == b.labels() && betti_numbers::of_complex(a) == betti_numbers::of_complex(b);
}

// Returns whether a facet is on the interface or on the domain boundary.
bool is_wall(const Complex& dsc, const Complex::Facet& f) {
  return dsc.is_interface(f) ||
         dsc.is_infinite(f.first) != dsc.is_infinite(f.first->neighbor(f.second));
}

// Returns 3 if the edge is inside a label, 2 if it is in a wall, 1 if more than two walls meet
// there.
int stratum(const Complex& dsc, const Edge_in_cell& e) {
  int walls = 0;
  auto f = dsc.triangulation().incident_facets(e.cell, e.i, e.j), done = f;
  do
    walls += is_wall(dsc, *f) ? 1 : 0;
  while (++f != done);
  return walls == 0 ? 3 : walls == 2 ? 2 : 1;
}

// Returns 0 if the vertex is not inside a label, in a wall, or on a line where walls meet.
int stratum(const Complex& dsc, Vertex_handle v) {
  std::vector<Complex::Edge> edges;
  dsc.triangulation().finite_incident_edges(v, std::back_inserter(edges));
  int count[4] = {0, 0, 0, 0};
  for (const auto& e : edges)
    ++count[stratum(dsc, Edge_in_cell{e.first, e.second, e.third})];
  return count[1] == 2 ? 1 : count[1] > 0 ? 0 : count[2] > 0 ? 2 : 3;
}

// Returns the complex after the collapse of v into w, built from scratch; an empty complex if the
// collapse is impossible.
Complex collapsed_from_scratch(const Complex& dsc, Vertex_handle v, Vertex_handle w) {
  Labeled_mesh mesh;
  std::vector<Vertex_handle> vertices = dsc.vertices();
  vertices.erase(std::find(vertices.begin(), vertices.end(), v));
  for (Vertex_handle u : vertices)
    mesh.points.push_back(u->point());
  for (Cell_handle c : dsc.cells()) {
    if (c->has_vertex(v) && c->has_vertex(w))
      continue;
    std::array<std::size_t, 4> t;
    for (int i = 0; i < 4; ++i) {
      const Vertex_handle u = c->vertex(i) == v ? w : c->vertex(i);
      t[i] = std::size_t(std::find(vertices.begin(), vertices.end(), u) - vertices.begin());
    }
    mesh.tetrahedra.push_back(t);
    mesh.labels.push_back(c->subdomain_index());
  }
  Complex result;
  try {
    result.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  } catch (const CGAL::Deformable_simplicial_complexes::Invalid_cells_error&) {
  }
  return result;
}

// Returns all cells as coordinates of their vertices, with labels.
using Cell = std::pair<std::array<Coordinates, 4>, int>;

std::vector<Cell> cells(const Complex& dsc) {
  std::vector<Cell> result;
  for (Cell_handle c : dsc.cells()) {
    Cell cell;
    for (int i = 0; i < 4; ++i)
      cell.first[i] = mesh_helpers::coordinates(dsc, c->vertex(i));
    std::sort(cell.first.begin(), cell.first.end());
    cell.second = c->subdomain_index();
    result.push_back(cell);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Proposes collapses of every `every`-th edge, and compares the results with complexes built from
// scratch.
void expect_exact_collapses(const Complex& dsc, int every, int minimum_accepted) {
  const auto state = dsc.state();
  int accepted = 0, impossible = 0, away = 0, index = 0;
  Cavity cavity(dsc);
  for (const auto& edge : dsc.triangulation().finite_edges()) {
    if (index++ % every != 0)
      continue;
    for (const Edge_in_cell& e : {Edge_in_cell{edge.first, edge.second, edge.third},
                                  Edge_in_cell{edge.first, edge.third, edge.second}}) {
      const Vertex_handle v = e.cell->vertex(e.i), w = e.cell->vertex(e.j);
      const bool proposed = propose_edge_collapse(dsc, e.cell, e.i, e.j, 0, cavity);
      const Complex expected = collapsed_from_scratch(dsc, v, w);
      const bool is_possible = expected.number_of_cells() > 0 && has_same_topology(expected, dsc),
                 stays_on_side =
                     Boundary_class::contains(w->boundary_class(), v->boundary_class()) &&
                     v->boundary_class() != Boundary_class::fixed,
                 stays_in_stratum = stratum(dsc, v) > 0 && stratum(dsc, v) == stratum(dsc, e);
      EXPECT_EQ(proposed, is_possible && stays_on_side && stays_in_stratum)
          << v->point() << " to " << w->point();
      impossible += is_possible ? 0 : 1;
      away += stays_on_side && stays_in_stratum ? 0 : 1;
      if (!proposed)
        continue;
      ++accepted;
      Complex copy = dsc;
      Cavity cavity_of_copy(copy);
      ASSERT_TRUE(propose_edge_collapse(copy, in_copy(copy, e.cell), e.i, e.j, 0, cavity_of_copy));
      expect_valid_commit(copy, cavity_of_copy, volume_of_domain(dsc));
      EXPECT_EQ(cells(copy), cells(expected));
      expect_same_topology(copy, dsc);
    }
  }
  EXPECT_GE(accepted, minimum_accepted);
  EXPECT_GT(impossible, 0);
  EXPECT_GT(away, 0);
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Edge_split, makes_two_cells_of_each) {
  const Complex dsc = jittered_grid(2, small_meshes::four_phases, .2, 1);
  int on_boundary = 0, on_interface = 0;
  for (const auto& edge : dsc.triangulation().finite_edges()) {
    Complex copy = dsc;
    const Cell_handle cell = in_copy(copy, edge.first);
    const Vertex_handle v = cell->vertex(edge.second), w = cell->vertex(edge.third);
    const bool is_interface = copy.is_interface(Complex::Edge(cell, edge.second, edge.third));
    const auto p = copy.position(v), q = copy.position(w);
    Cavity cavity(copy);
    ASSERT_TRUE(propose_edge_split(copy, cell, edge.second, edge.third, .25, cavity));
    EXPECT_EQ(cavity.tetrahedra().size(), 2 * cavity.removed().size());
    const bool is_boundary = std::any_of(cavity.removed().begin(), cavity.removed().end(),
                                         [&](Cell_handle c) { return copy.is_infinite(c); });
    const std::size_t before = copy.number_of_vertices();
    copy.replace(cavity);
    ASSERT_TRUE(copy.is_valid());
    EXPECT_EQ(copy.number_of_vertices(), before + 1);
    const Vertex_handle middle = cavity.vertices().back().handle;
    EXPECT_LT((copy.position(middle) - (p + .25 * (q - p))).squared_length(), 1e-30);
    EXPECT_EQ(middle->is_interface(), is_interface);
    EXPECT_EQ(middle->boundary_class(),
              is_boundary ? v->boundary_class() & w->boundary_class() : Boundary_class::inside);
    on_boundary += is_boundary ? 1 : 0;
    on_interface += is_interface ? 1 : 0;
    expect_same_topology(copy, dsc);
    for (int label : dsc.labels()) {
      EXPECT_NEAR(copy.volume(label), dsc.volume(label), tolerance);
      EXPECT_NEAR(copy.area(label), dsc.area(label), tolerance);
    }
  }
  EXPECT_GT(on_boundary, 20);
  EXPECT_GT(on_interface, 20);
}

TEST(Edge_split, without_a_number_between_its_ends_is_refused) {
  Complex dsc;
  const auto v = dsc.assign(
      {Point(1, 0, 0), Point(std::nextafter(1, 2), 0, 0), Point(1, 1, 0), Point(1, 0, 1)},
      {{0, 1, 2, 3}}, {0});
  const auto state = dsc.state();
  const Edge_in_cell e = find_edge(dsc, v[0], v[1]);
  Cavity cavity(dsc);
  EXPECT_FALSE(propose_edge_split(dsc, e.cell, e.i, e.j, .5, cavity));
  EXPECT_TRUE(dsc.state() == state);
}

TEST(Edge_collapse, in_one_label_is_possible_where_the_result_is_valid) {
  expect_exact_collapses(jittered_grid(3, small_meshes::uniform, .3, 2), 1, 50);
}

TEST(Edge_collapse, keeps_vertices_of_a_sheet_in_the_sheet) {
  expect_exact_collapses(jittered_grid(4, small_meshes::cube, .2, 3), 7, 20);
}

TEST(Edge_collapse, keeps_vertices_of_triple_lines_on_their_line) {
  expect_exact_collapses(jittered_grid(4, small_meshes::two_boxes, .2, 4), 7, 20);
}

TEST(Edge_collapse, keeps_lines_that_meet_the_boundary) {
  expect_exact_collapses(jittered_grid(4, small_meshes::four_phases, .2, 5), 7, 20);
}

TEST(Edge_collapse, keeps_the_topology_of_labels_that_touch) {
  Random random(6);
  expect_exact_collapses(jittered_grid(
                             3, [&](const Point&) { return int(random.below(2)); }, .2, 7),
                         2, 1);
}

// Four sectors meet around the edge, two of them of label 1. At its first vertex, label 1 has only
// one sector, and label 0 has one that the collapse would connect with label 0 at the other vertex.
TEST(Edge_collapse, keeps_vertices_where_other_sectors_meet_than_around_the_edge) {
  Complex dsc = jittered_grid(
      4, [](const Point&) { return 1; }, .2, 7);
  std::map<int, Vertex_handle> vertices; // by their numbers along x, y and z, as digits
  const auto digit = [](double x) { return int(std::lround(2 * x + 2)); };
  for (Vertex_handle v : dsc.vertices()) {
    const Point p = dsc.position(v);
    vertices[100 * digit(p.x()) + 10 * digit(p.y()) + digit(p.z())] = v;
  }
  const int a = 322, b = 333;
  const std::pair<std::array<int, 4>, int> others[] = {
      {{a, b, 332, 222}, 3},   {{a, 332, 222, 221}, 3}, {{a, b, 433, 323}, 5},
      {{a, 433, 323, 423}, 5}, {{a, 212, 222, 211}, 0}, {{b, 344, 444, 334}, 0}};
  Cell_handle c;
  for (const auto& [v, label] : others) {
    ASSERT_TRUE(dsc.triangulation().is_cell(vertices[v[0]], vertices[v[1]], vertices[v[2]],
                                            vertices[v[3]], c));
    dsc.relabel(c, label);
  }
  int i, j;
  ASSERT_TRUE(dsc.triangulation().is_edge(vertices[a], vertices[b], c, i, j));
  ASSERT_FALSE(has_same_topology(collapsed_from_scratch(dsc, vertices[a], vertices[b]), dsc));
  Cavity cavity(dsc);
  EXPECT_FALSE(propose_edge_collapse(dsc, c, i, j, 0, cavity));
}

TEST(Edge_collapse, makes_no_cell_below_the_quality_asked_for) {
  const Complex dsc = jittered_grid(3, small_meshes::uniform, .3, 8);
  Cavity cavity(dsc);
  int refused = 0;
  for (const auto& e : dsc.triangulation().finite_edges())
    if (propose_edge_collapse(dsc, e.first, e.second, e.third, 0, cavity)) {
      const double quality = cavity.quality_after();
      EXPECT_TRUE(propose_edge_collapse(dsc, e.first, e.second, e.third, quality, cavity));
      EXPECT_FALSE(propose_edge_collapse(dsc, e.first, e.second, e.third, 1.01 * quality, cavity));
      ++refused;
    }
  EXPECT_GT(refused, 20);
}

// An edge across a thin layer between two sheets of one interface.
TEST(Edge_collapse, does_not_glue_two_sheets) {
  const auto layer = [](const Point& p) { return std::abs(p.x()) < .25 ? 1 : 0; };
  const Complex dsc = small_meshes::make_complex(small_meshes::grid(8, layer));
  Cavity cavity(dsc);
  for (const auto& e : dsc.triangulation().finite_edges()) {
    const Vertex_handle v = e.first->vertex(e.second), w = e.first->vertex(e.third);
    if (v->is_interface() && w->is_interface() && dsc.position(v).x() != dsc.position(w).x()) {
      EXPECT_FALSE(propose_edge_collapse(dsc, e.first, e.second, e.third, 0, cavity));
    }
  }
}

// Two phases that share a disk: the boundary of the disk cannot become shorter than a triangle.
TEST(Edge_collapse, does_not_separate_phases_that_touch_in_a_facet) {
  Complex dsc = small_meshes::make_complex(small_meshes::grid(6, small_meshes::uniform));
  Vertex_handle center;
  for (Vertex_handle v : dsc.vertices())
    if (dsc.position(v) == Complex::Point_3(0, 0, 0))
      center = v;
  // Label 1 is a star, and label 2 is one cell next to it: they share one facet.
  std::vector<Cell_handle> star;
  dsc.star(center, star);
  for (Cell_handle c : star)
    dsc.relabel(c, 1);
  const Cell_handle inner = star.front(), outer = inner->neighbor(inner->index(center));
  std::vector<Cell_handle> cap;
  dsc.star(outer->vertex(outer->index(inner)), cap);
  for (Cell_handle c : cap) {
    int shared = 0;
    for (int i = 0; i < 4; ++i)
      shared += c->neighbor(i)->subdomain_index() == 1;
    if (c->subdomain_index() == 0 && (c == outer || shared == 0))
      dsc.relabel(c, 2);
  }
  Cavity cavity(dsc);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j && outer->vertex(i)->is_interface() && outer->vertex(j)->is_interface() &&
          inner->has_vertex(outer->vertex(i)) && inner->has_vertex(outer->vertex(j))) {
        EXPECT_FALSE(propose_edge_collapse(dsc, outer, i, j, 0, cavity));
      }
}

} // namespace test_edge_collapse
