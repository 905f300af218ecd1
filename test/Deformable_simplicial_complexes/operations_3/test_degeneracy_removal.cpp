#include "short_edge.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/remove_degeneracies.h>

// Removal of degenerate tetrahedra, facets and edges.

namespace test_degeneracy_removal {

using mesh_helpers::jittered_grid;
using mesh_helpers::minimum_quality;
using small_meshes::grid;
using small_meshes::make_complex;
using namespace short_edge;

constexpr double flat = 1e-3; // height of degenerate cells
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Returns a complex of tetrahedra of any orientation.
std::vector<Vertex_handle> assign(Complex& dsc, Labeled_mesh mesh) {
  for (auto& t : mesh.tetrahedra)
    if (CGAL::orientation(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                          mesh.points[t[3]]) == CGAL::NEGATIVE)
      std::swap(t[0], t[1]);
  return dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
}

// A degenerate cell 0123 whose vertex 3 lies over the facet 012, and one cell on this facet.
Labeled_mesh flat_cap() {
  return {{Point(1, 0, 0), Point(-.5, .8, 0), Point(-.5, -.8, 0), Point(0, 0, flat), Point(0, 0, 1),
           Point(0, 0, -1)},
          {{0, 1, 2, 3}, {0, 1, 2, 5}, {3, 0, 1, 4}, {3, 1, 2, 4}, {3, 2, 0, 4}},
          {0, 0, 0, 0, 0}};
}

// A degenerate cell 0123 whose edges 01 and 23 nearly intersect; two cells below edge 01 and two
// cells above edge 23.
Labeled_mesh flat_square(double top, double bottom) {
  return {{Point(-1, 0, 0), Point(1, 0, 0), Point(0, -1, flat), Point(0, 1, flat), Point(0, 0, top),
           Point(0, 0, bottom)},
          {{0, 1, 2, 3}, {2, 3, 0, 4}, {2, 3, 1, 4}, {0, 1, 2, 5}, {0, 1, 3, 5}},
          {0, 0, 0, 0, 0}};
}

// A ring of four cells around the edge 01; the vertex 3 lies close to the midpoint of the edge.
Labeled_mesh flat_roof() {
  return {{Point(-1, 0, 0), Point(1, 0, 0), Point(0, -1.5, 0), Point(0, 0, flat), Point(0, 1.5, 0),
           Point(0, 0, -1.5)},
          {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}, {0, 1, 5, 2}},
          {0, 0, 0, 0}};
}

Cell_handle find_cell(const Complex& dsc, const std::vector<Vertex_handle>& v) {
  Cell_handle c;
  EXPECT_TRUE(dsc.triangulation().is_cell(v[0], v[1], v[2], v[3], c));
  return c;
}

Complex::Facet find_facet(const Complex& dsc, Vertex_handle u, Vertex_handle v, Vertex_handle w) {
  Cell_handle c;
  int i = 0, j = 0, k = 0;
  EXPECT_TRUE(dsc.triangulation().is_facet(u, v, w, c, i, j, k));
  return {c, 6 - i - j - k};
}

void expect_all_created_have(const Cavity& cavity, Vertex_handle v, Vertex_handle w) {
  for (Cell_handle c : cavity.created())
    EXPECT_TRUE(c->has_vertex(v) && c->has_vertex(w));
}

// Tetrahedra

TEST(Degenerate_tetrahedron, over_its_facet_becomes_three_facets) {
  Complex dsc;
  const auto v = assign(dsc, flat_cap());
  const Cell_handle c = find_cell(dsc, v);
  const auto state = dsc.state();
  Cavity cavity(dsc);
  EXPECT_FALSE(propose_degenerate_tetrahedron_removal(dsc, c, dsc.quality(c), cavity));
  ASSERT_TRUE(propose_degenerate_tetrahedron_removal(dsc, c, .005, cavity));
  EXPECT_TRUE(dsc.state() == state);
  EXPECT_EQ(cavity.removed().size(), 2u);
  EXPECT_EQ(cavity.tetrahedra().size(), 3u);
  EXPECT_NEAR(cavity.quality_after(),
              (std::min)(std::abs(quality(dsc, v[3], v[5], v[0], v[1])),
                         std::abs(quality(dsc, v[3], v[5], v[1], v[2]))),
              tolerance);
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  expect_all_created_have(cavity, v[3], v[5]);
}

TEST(Degenerate_tetrahedron, over_a_facet_of_the_interface_is_left_to_relabeling) {
  Labeled_mesh mesh = flat_cap();
  mesh.labels[1] = 1;
  Complex dsc;
  const auto v = assign(dsc, mesh);
  Cavity cavity(dsc);
  EXPECT_FALSE(propose_degenerate_tetrahedron_removal(dsc, find_cell(dsc, v), .005, cavity));
}

// The edge on the side of the nearer apex is removed, because the new cells there are better.
TEST(Degenerate_tetrahedron, with_crossing_edges_loses_the_better_one) {
  for (bool is_top_near : {false, true}) {
    Complex dsc;
    const auto v = assign(dsc, is_top_near ? flat_square(1, -2) : flat_square(2, -1));
    Cavity cavity(dsc);
    ASSERT_TRUE(propose_degenerate_tetrahedron_removal(dsc, find_cell(dsc, v), .005, cavity));
    EXPECT_EQ(cavity.removed().size(), 3u);
    EXPECT_EQ(cavity.tetrahedra().size(), 2u);
    EXPECT_GT(cavity.quality_after(), .75);
    expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
    EXPECT_EQ(dsc.number_of_cells(), 4u);
    expect_all_created_have(cavity, v[is_top_near ? 0 : 2], v[is_top_near ? 4 : 5]);
  }
}

// The cell gets the label of the cell below, which ends at its two lower facets.
TEST(Degenerate_tetrahedron, in_a_bend_of_the_interface_changes_the_side) {
  Labeled_mesh mesh = flat_square(2, -1);
  mesh.labels = {1, 1, 1, 2, 2};
  Complex dsc;
  const auto v = assign(dsc, mesh);
  const double before = dsc.volume(1);
  Cavity cavity(dsc);
  ASSERT_TRUE(propose_degenerate_tetrahedron_removal(dsc, find_cell(dsc, v), .005, cavity));
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  expect_all_created_have(cavity, v[2], v[3]);
  EXPECT_NEAR(before - dsc.volume(1), 2. / 3 * flat, tolerance);
  EXPECT_EQ(dsc.interface_facets().size(), 2u);
  const Edge_in_cell e = find_edge(dsc, v[2], v[3]);
  EXPECT_TRUE(dsc.is_interface(Complex::Edge(e.cell, e.i, e.j)));
}

TEST(Degenerate_tetrahedron, at_an_edge_becomes_two_facets) {
  Complex dsc;
  const auto v = assign(dsc, flat_roof());
  Cavity cavity(dsc);
  ASSERT_TRUE(propose_degenerate_tetrahedron_removal(dsc, find_cell(dsc, v), .005, cavity));
  EXPECT_EQ(cavity.removed().size(), 4u);
  EXPECT_EQ(cavity.tetrahedra().size(), 4u);
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  expect_all_created_have(cavity, v[3], v[5]);
}

TEST(Degenerate_tetrahedron, at_a_vertex_collapses) {
  Grid_with_short_edge mesh(small_meshes::uniform);
  const Edge_in_cell e = find_edge(mesh.dsc, mesh.v, mesh.w);
  Cavity cavity(mesh.dsc);
  ASSERT_TRUE(propose_degenerate_tetrahedron_removal(mesh.dsc, e.cell, .005, cavity));
  EXPECT_TRUE(cavity.vanishing_vertex() == mesh.v || cavity.vanishing_vertex() == mesh.w);
  EXPECT_TRUE(cavity.kept_vertex() == mesh.v || cavity.kept_vertex() == mesh.w);
  EXPECT_FALSE(cavity.kept_vertex() == cavity.vanishing_vertex());
  expect_valid_commit(mesh.dsc, cavity, 8);
}

// The kind of the proposal for a cell, if any, and the quality of its result.
using Outcome = std::pair<bool, double>;

Outcome outcome(bool proposed, const Cavity& cavity) {
  return {proposed, proposed ? cavity.quality_after() : -infinity};
}

Outcome edge_removal(const Complex& dsc, Cell_handle c, int i, int j) {
  bool is_bend = true;
  for (int k = 0; k < 4; ++k)
    is_bend = is_bend && (k == i || k == j || dsc.is_interface(Complex::Facet(c, k)));
  Cavity cavity(dsc);
  return outcome(is_bend ? propose_interface_edge_flip(dsc, c, i, j, cavity)
                         : propose_edge_removal(dsc, c, i, j, cavity),
                 cavity);
}

// Returns the number of edges of the largest facet on which the opposite vertex projects, or -1 if
// the projection is outside beyond one edge. Sets the expected outcome.
int expected_outcome(const Complex& dsc, Cell_handle c, double threshold, Outcome& expected) {
  double largest_area = 0;
  int apex = -1;
  for (int i = 0; i < 4; ++i) {
    const auto v = dsc.facet_vertices({c, i});
    const double area = CGAL::squared_area(v[0]->point(), v[1]->point(), v[2]->point());
    if (area > largest_area) {
      largest_area = area;
      apex = i;
    }
  }
  const auto v = dsc.facet_vertices({c, apex});
  const Point p = v[0]->point(), q = c->vertex(apex)->point();
  const auto a = v[1]->point() - p, b = v[2]->point() - p, n = CGAL::cross_product(a, b);
  const double s = CGAL::cross_product(q - p, b) * n / n.squared_length(),
               t = CGAL::cross_product(a, q - p) * n / n.squared_length();
  const std::array<double, 3> coordinates = {1 - s - t, s, t};
  std::vector<int> at, beyond, rest; // indices in the cell
  for (int k = 0; k < 3; ++k)
    (std::abs(coordinates[k]) <= .1 ? at
     : coordinates[k] < 0           ? beyond
                                    : rest)
        .push_back(c->index(v[k]));

  Cavity cavity(dsc);
  if (at.size() == 2) {
    expected = outcome(propose_edge_collapse(dsc, c, apex, rest.at(0), threshold, cavity) ||
                           propose_edge_collapse(dsc, c, rest.at(0), apex, threshold, cavity),
                       cavity);
    return 2;
  }
  if (at.size() == 1) {
    EXPECT_EQ(rest.size(), 2u);
    expected = edge_removal(dsc, c, rest.at(0), rest.at(1));
    return 1;
  }
  if (beyond.size() == 1) {
    expected = (std::max)(edge_removal(dsc, c, rest.at(0), rest.at(1)),
                          edge_removal(dsc, c, beyond[0], apex));
    return -1;
  }
  EXPECT_EQ(rest.size(), 3u);
  expected = outcome(propose_multi_face_removal(dsc, c, apex, cavity), cavity);
  return 0;
}

// The threshold is larger than the quality of the cell, so each cell is examined.
TEST(Degenerate_tetrahedron, is_removed_by_where_its_vertex_projects) {
  std::array<int, 4> cases = {0, 0, 0, 0};
  int accepted = 0;
  for (auto label : {small_meshes::uniform, small_meshes::two_boxes}) {
    const Complex dsc = jittered_grid(4, label, .45, 3);
    const auto state = dsc.state();
    for (Cell_handle c : dsc.cells()) {
      const double threshold = 1.01 * dsc.quality(c);
      Outcome expected;
      ++cases[std::size_t(1 + expected_outcome(dsc, c, threshold, expected))];
      Complex copy = dsc;
      Cavity cavity(copy);
      const bool proposed =
          propose_degenerate_tetrahedron_removal(copy, in_copy(copy, c), threshold, cavity);
      EXPECT_TRUE(copy.state() == state);
      ASSERT_EQ(proposed, expected.first);
      if (!proposed)
        continue;
      ++accepted;
      EXPECT_NEAR(cavity.quality_after(), expected.second, tolerance);
      expect_valid_commit(copy, cavity, volume_of_domain(dsc));
      EXPECT_EQ(copy.labels(), dsc.labels());
      for (int l : dsc.labels())
        EXPECT_EQ(copy.euler_characteristic(l), dsc.euler_characteristic(l));
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_GT(cases[i], 10) << i;
  EXPECT_GT(accepted, 5);
}

// Facets

TEST(Degenerate_facet, that_is_a_cap_loses_its_longest_edge) {
  Complex dsc;
  const auto v = assign(dsc, flat_roof());
  const Cell_handle c = find_cell(dsc, v);
  const auto state = dsc.state();
  Cavity cavity(dsc);
  const auto propose = [&](int opposite, double cosine) {
    return propose_degenerate_facet_removal(dsc, c, c->index(v[opposite]), cosine, 0, cavity);
  };
  EXPECT_FALSE(propose(3, .999));
  EXPECT_FALSE(propose(2, std::cos(.99 * flat))); // its angles are slightly larger
  EXPECT_TRUE(propose(2, std::cos(1.01 * flat)));
  ASSERT_TRUE(propose(2, .999));
  EXPECT_TRUE(dsc.state() == state);
  EXPECT_EQ(cavity.tetrahedra().size(), 4u);
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  expect_all_created_have(cavity, v[3], v[5]);
}

// The vertex 5 lies in the plane of the cap, so the interface moves within this plane.
TEST(Degenerate_facet, that_is_a_cap_of_the_interface_is_flipped) {
  Labeled_mesh mesh = flat_roof();
  mesh.labels = {1, 2, 2, 1};
  Complex dsc;
  const auto v = assign(dsc, mesh);
  const double volumes[2] = {dsc.volume(1), dsc.volume(2)};
  const auto f = find_facet(dsc, v[0], v[1], v[3]);
  ASSERT_TRUE(dsc.is_interface(f));
  Cavity cavity(dsc);
  ASSERT_TRUE(propose_degenerate_facet_removal(dsc, f.first, f.second, .999, 0, cavity));
  expect_valid_commit(dsc, cavity, volume_of_domain(dsc));
  expect_all_created_have(cavity, v[3], v[5]);
  EXPECT_NEAR(dsc.volume(1), volumes[0], tolerance);
  EXPECT_NEAR(dsc.volume(2), volumes[1], tolerance);
  EXPECT_EQ(dsc.interface_facets().size(), 2u);
}

// Of the two facets at the short edge, one has a right angle and the other has an angle of 135
// degrees: both are needles.
TEST(Degenerate_facet, that_is_a_needle_collapses) {
  for (const Point& tip : {Point(0, .5, .5), Point(0, 0, -.5)}) {
    Grid_with_short_edge mesh(half_space);
    Complex& dsc = mesh.dsc;
    const std::size_t facets = dsc.interface_facets().size(), vertices = dsc.number_of_vertices();
    const auto f = find_facet(dsc, mesh.v, mesh.w, vertex_at(dsc, tip));
    ASSERT_TRUE(dsc.is_interface(f));
    Cavity cavity(dsc);
    EXPECT_FALSE(propose_degenerate_facet_removal(dsc, f.first, f.second, .999, .9, cavity));
    ASSERT_TRUE(propose_degenerate_facet_removal(dsc, f.first, f.second, .999, .25, cavity));
    expect_valid_commit(dsc, cavity, 8);
    EXPECT_EQ(dsc.number_of_vertices(), vertices - 1);
    EXPECT_EQ(dsc.interface_facets().size(), facets - 2);
    EXPECT_NEAR(dsc.volume(0), 4, tolerance);
    EXPECT_NEAR(dsc.volume(1), 4, tolerance);
  }
}

// Edges

TEST(Degenerate_edge, is_collapsed_if_it_is_short) {
  Grid_with_short_edge mesh(half_space);
  Complex& dsc = mesh.dsc;
  const auto state = dsc.state();
  const Edge_in_cell e = find_edge(dsc, mesh.v, mesh.w);
  Cavity cavity(dsc);
  const auto propose = [&](double minimum_length, double minimum_quality) {
    return propose_degenerate_edge_removal(dsc, e.cell, e.i, e.j, minimum_length, minimum_quality,
                                           cavity);
  };
  EXPECT_FALSE(propose(.99e-4, .25));
  EXPECT_FALSE(propose(1.01e-4, .9));
  ASSERT_TRUE(propose(1.01e-4, .25));
  EXPECT_TRUE(dsc.state() == state);
  EXPECT_GE(cavity.quality_after(), .25);
  expect_valid_commit(dsc, cavity, 8);
  EXPECT_NEAR(dsc.volume(0), 4, tolerance);
  EXPECT_NEAR(dsc.volume(1), 4, tolerance);
}

// One end is on the edge of a wedge, and the other one on its side. The wedge keeps its shape,
// whichever end is given first.
TEST(Degenerate_edge, collapses_onto_a_sharp_edge) {
  for (const bool swaps : {false, true}) {
    Grid_with_short_edge mesh([](const Point& p) { return p.x() < 0 && p.y() < .5 ? 1 : 0; });
    Complex& dsc = mesh.dsc;
    const double volume = dsc.volume(1);
    const Edge_in_cell e = find_edge(dsc, mesh.v, mesh.w);
    Cavity cavity(dsc);
    ASSERT_TRUE(propose_degenerate_edge_removal(dsc, e.cell, swaps ? e.j : e.i, swaps ? e.i : e.j,
                                                1.01e-4, 0, cavity));
    expect_valid_commit(dsc, cavity, 8);
    EXPECT_NEAR(dsc.volume(1), volume, tolerance);
  }
}

// An edge across a layer of another label must stay, even if it is very short.
TEST(Degenerate_edge, between_two_sheets_stays) {
  const auto layer = [](const Point& p) { return p.x() > 0 && p.x() < .5 ? 1 : 0; };
  const Complex dsc = make_complex(grid(4, layer));
  Cavity cavity(dsc);
  int across = 0;
  for_each_edge(dsc, [&](const Edge_in_cell& e) {
    const Vertex_handle v = e.cell->vertex(e.i), w = e.cell->vertex(e.j);
    if (v->is_interface() && w->is_interface() && dsc.position(v).x() != dsc.position(w).x()) {
      EXPECT_FALSE(propose_degenerate_edge_removal(dsc, e.cell, e.i, e.j, 10, 0, cavity));
      ++across;
    }
  });
  EXPECT_GT(across, 100);
}

// The driver

TEST(Remove_degeneracies, removes_what_the_paper_calls_degenerate) {
  Grid_with_short_edge mesh(half_space);
  const auto report = DSC::remove_degeneracies(mesh.dsc);
  EXPECT_EQ(report.collapsed, 1u);
  EXPECT_EQ(number_of_changes(report), 1u);
  EXPECT_TRUE(mesh.dsc.is_valid());
  EXPECT_NEAR(mesh.dsc.volume(0), 4, tolerance);
  EXPECT_NEAR(mesh.dsc.volume(1), 4, tolerance);
  EXPECT_GT(minimum_quality(mesh.dsc), .25);

  Complex dsc;
  assign(dsc, flat_square(1, -2));
  EXPECT_EQ(DSC::remove_degeneracies(dsc).flipped, 1u);
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.number_of_cells(), 4u);
}

TEST(Remove_degeneracies, leaves_a_good_mesh_alone) {
  Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  const auto state = dsc.state();
  EXPECT_EQ(number_of_changes(DSC::remove_degeneracies(dsc)), 0u);
  EXPECT_TRUE(dsc.state() == state);
  Complex empty;
  EXPECT_EQ(number_of_changes(DSC::remove_degeneracies(empty)), 0u);
}

TEST(Remove_degeneracies, measures_edges_by_the_sizing_field) {
  const auto edges_only = parameters::degenerate_quality(0.).degenerate_cosine(1.);
  const auto with_length = [&](double length) {
    Complex dsc = Grid_with_short_edge(small_meshes::uniform).dsc;
    const auto size = [length](const Point& p) { return p.y() > .4 ? length : 1e-9; };
    return DSC::remove_degeneracies(dsc, edges_only.sizing_field(size)).collapsed;
  };
  EXPECT_EQ(with_length(1.9e-4), 0u);
  EXPECT_EQ(with_length(2.1e-4), 1u);
  // Without an interface, there is no reference length for short edges.
  Complex dsc = Grid_with_short_edge(small_meshes::uniform).dsc;
  EXPECT_EQ(number_of_changes(DSC::remove_degeneracies(dsc, edges_only)), 0u);
}

TEST(Remove_degeneracies, keeps_labels_valid_in_a_random_mesh) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Complex dsc = jittered_grid(4, small_meshes::two_boxes, .45, seed);
    const Complex before = dsc;
    DSC::remove_degeneracies(
        dsc, parameters::degenerate_quality(.1).degenerate_cosine(.95).degenerate_length(.7));
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_GE(minimum_quality(dsc), minimum_quality(before));
    EXPECT_NEAR(volume_of_domain(dsc), 8, tolerance);
    ASSERT_EQ(dsc.labels(), before.labels());
    for (int label : before.labels()) {
      EXPECT_EQ(dsc.euler_characteristic(label), before.euler_characteristic(label));
      EXPECT_EQ(dsc.number_of_components(label), before.number_of_components(label));
    }
  }
}

TEST(Remove_degeneracies, refuses_values_out_of_range) {
  const Complex dsc = make_complex(grid(2, small_meshes::four_phases));
  const auto refuses = [&](const auto& np) {
    expect_error(dsc, [&](Complex& copy) { DSC::remove_degeneracies(copy, np); });
  };
  for (double value : {-1., 2., not_a_number}) {
    refuses(parameters::degenerate_quality(value));
    refuses(parameters::degenerate_cosine(value));
  }
  refuses(parameters::degenerate_length(-1.));
  refuses(parameters::degenerate_length(not_a_number));
  refuses(parameters::number_of_iterations(-1));
  refuses(parameters::sizing_field([](const Point&) { return 0.; }));
}

} // namespace test_degeneracy_removal
