#include "mesh_helpers.h"
#include "test.h"

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

namespace test_complex {

using CGAL::Deformable_simplicial_complexes::Invalid_cells_error;
using mesh_helpers::interface_triangles;
using mesh_helpers::jittered_grid;
using namespace small_meshes;
using Indices = std::vector<std::size_t>;

constexpr double tolerance = 1e-14;

double infinity_norm(double x, double y, double z) {
  return (std::max)({std::abs(x), std::abs(y), std::abs(z)});
}

// Unions of grid cubes for n = 8.

int two_cubes(const Point& p) {
  return infinity_norm(std::abs(p.x()) - .5, p.y(), p.z()) < .25 ? 1 : 0;
}

int square_ring(const Point& p) {
  return std::abs(p.z()) < .25 && infinity_norm(p.x(), p.y(), 0) < .75 &&
                 infinity_norm(p.x(), p.y(), 0) > .25
             ? 1
             : 0;
}

int hollow_cube(const Point& p) {
  const double r = infinity_norm(p.x(), p.y(), p.z());
  return r < .75 && r > .25 ? 1 : 0;
}

int cubes_with_a_common_edge(const Point& p) {
  return infinity_norm(p.x(), p.y(), p.z()) < .5 && p.x() * p.y() > 0 ? 1 : 0;
}

int cubes_with_a_common_vertex(const Point& p) {
  return infinity_norm(p.x(), p.y(), p.z()) < .5 && (p.x() > 0) == (p.y() > 0) &&
                 (p.y() > 0) == (p.z() > 0)
             ? 1
             : 0;
}

// Returns the tetrahedra whose barycenters satisfy a condition, with their points.
template <class Condition> Labeled_mesh part(const Labeled_mesh& mesh, Condition condition) {
  Labeled_mesh result;
  std::vector<std::size_t> rank(mesh.points.size(), mesh.points.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    auto v = mesh.tetrahedra[t];
    if (!condition(CGAL::centroid(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]],
                                  mesh.points[v[3]])))
      continue;
    for (std::size_t& i : v) {
      if (rank[i] == mesh.points.size()) {
        rank[i] = result.points.size();
        result.points.push_back(mesh.points[i]);
      }
      i = rank[i];
    }
    result.tetrahedra.push_back(v);
    result.labels.push_back(mesh.labels[t]);
  }
  return result;
}

// Returns the error message of assign() for a mesh, and checks that the complex is unchanged.
Invalid_cells_error refusal(const Labeled_mesh& mesh) {
  Complex dsc = make_complex(grid(2, small_meshes::uniform));
  const auto before = dsc.state();
  try {
    dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  } catch (const Invalid_cells_error& e) {
    EXPECT_TRUE(dsc.state() == before);
    return e;
  }
  ADD_FAILURE() << "accepted";
  return Invalid_cells_error("");
}

Indices sorted(Indices indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

Labeled_mesh corner_tetrahedron() {
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)}, {{0, 1, 2, 3}}, {0}};
}

// Creation

TEST(Assign, keeps_points_tetrahedra_and_labels) {
  const Labeled_mesh mesh = grid(4, small_meshes::two_boxes);
  Complex dsc;
  const std::vector<Vertex_handle> handles = dsc.assign(mesh.points, mesh.tetrahedra, mesh.labels);
  ASSERT_EQ(handles.size(), mesh.points.size());
  for (std::size_t i = 0; i < handles.size(); ++i)
    EXPECT_EQ(handles[i]->point(), mesh.points[i]);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto& v = mesh.tetrahedra[t];
    Cell_handle c;
    ASSERT_TRUE(
        dsc.triangulation().is_cell(handles[v[0]], handles[v[1]], handles[v[2]], handles[v[3]], c));
    EXPECT_EQ(dsc.label(c), mesh.labels[t]);
  }
  EXPECT_EQ(dsc.number_of_vertices(), mesh.points.size());
  EXPECT_EQ(dsc.number_of_cells(), mesh.tetrahedra.size());
  EXPECT_TRUE(dsc.is_valid());
}

TEST(Assign, a_single_tetrahedron_is_a_complex) {
  Complex dsc = make_complex(corner_tetrahedron());
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_NEAR(dsc.volume(0), 1. / 6, tolerance);
}

TEST(Assign, refuses_arrays_that_do_not_fit) {
  EXPECT_NE(std::string(refusal({}).what()), "");
  Labeled_mesh mesh = grid(2, small_meshes::uniform);
  mesh.labels.pop_back();
  EXPECT_NE(std::string(refusal(mesh).what()), "");
}

TEST(Assign, refuses_points_that_do_not_exist_or_are_not_used) {
  Labeled_mesh mesh = grid(2, small_meshes::uniform);
  mesh.tetrahedra[5][2] = 99;
  EXPECT_EQ(refusal(mesh).tetrahedra(), Indices{5});
  EXPECT_EQ(refusal(mesh).vertices(), Indices{99});
  mesh = grid(2, small_meshes::uniform);
  mesh.points.insert(mesh.points.begin() + 3, Point(0, 0, 0));
  for (auto& t : mesh.tetrahedra)
    for (std::size_t& i : t)
      i += i >= 3 ? 1 : 0;
  EXPECT_EQ(refusal(mesh).vertices(), Indices{3});
}

TEST(Assign, refuses_flat_and_inverted_tetrahedra) {
  Labeled_mesh mesh = grid(2, small_meshes::uniform);
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  EXPECT_EQ(refusal(mesh).tetrahedra(), Indices{7});
  mesh = corner_tetrahedron();
  mesh.points[3] = Point(.5, .5, 0);
  EXPECT_EQ(refusal(mesh).tetrahedra(), Indices{0});
  EXPECT_EQ(sorted(refusal(mesh).vertices()), (Indices{0, 1, 2, 3}));
}

TEST(Assign, refuses_coordinates_that_are_not_finite) {
  for (double x : {std::nan(""), HUGE_VAL}) {
    Labeled_mesh mesh = corner_tetrahedron();
    mesh.points[2] = Point(0, x, 0);
    EXPECT_EQ(refusal(mesh).vertices(), Indices{2});
  }
}

TEST(Assign, refuses_what_cannot_be_measured) {
  for (double x : {1e-120, 1e-31, 1e31, 1e120}) {
    Labeled_mesh mesh = corner_tetrahedron();
    for (Point& p : mesh.points)
      p = Point(x * p.x(), x * p.y(), x * p.z());
    EXPECT_PRED2(contains, std::string(refusal(mesh).what()), "extent") << x;
  }
}

TEST(Assign, refuses_three_tetrahedra_at_a_facet) {
  Labeled_mesh mesh = grid(2, small_meshes::uniform);
  // Returns a tetrahedron next to an inner facet of the tetrahedra 0 and 1, which share their first
  // vertex.
  std::size_t third = mesh.tetrahedra.size();
  const auto t = mesh.tetrahedra[0];
  mesh.points.push_back(
      CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]));
  std::size_t other = third;
  int opposite = 0;
  for (int i = 0; i < 4 && other == third; ++i)
    for (std::size_t u = 1; u < third; ++u) {
      int common = 0;
      for (int j = 0; j < 4; ++j)
        common += j != i && std::count(mesh.tetrahedra[u].begin(), mesh.tetrahedra[u].end(), t[j]);
      if (common == 3) {
        other = u;
        opposite = i;
      }
    }
  ASSERT_LT(other, third);
  auto added = t;
  added[opposite] = mesh.points.size() - 1;
  mesh.tetrahedra.push_back(added);
  mesh.labels.push_back(0);
  EXPECT_EQ(refusal(mesh).tetrahedra(), (Indices{0, other, third}));
}

TEST(Assign, refuses_domains_that_are_no_ball) {
  const Labeled_mesh cubes = grid(3, small_meshes::uniform);
  const auto refuse = [&](auto condition) { return refusal(part(cubes, condition)); };
  const double third = 1. / 3;
  // the two cubes share an edge, a vertex, nothing
  refuse([&](const Point& p) {
    return p.z() < -third && p.x() < third && p.y() < third && (p.x() < -third) == (p.y() < -third);
  });
  refuse([&](const Point& p) {
    return infinity_norm(p.x() + .5, p.y() + .5, p.z() + .5) < .85 &&
           (p.x() < -third) == (p.y() < -third) && (p.z() < -third) == (p.y() < -third);
  });
  refuse([&](const Point& p) { return std::abs(p.x()) > third; });
  // a cavity and a tunnel
  refuse([&](const Point& p) { return infinity_norm(p.x(), p.y(), p.z()) > third; });
  refuse([&](const Point& p) { return infinity_norm(p.x(), p.y(), 0) > third; });
}

TEST(Assign, names_the_edge_or_vertex_where_the_domain_is_pinched) {
  Labeled_mesh mesh = corner_tetrahedron();
  mesh.points.insert(mesh.points.end(), {Point(0, -1, 0), Point(0, 0, -1), Point(-1, 0, 0)});
  mesh.tetrahedra.push_back({0, 4, 5, 1}); // shares the edge from 0 to 1
  mesh.labels.push_back(0);
  mesh.points.pop_back();
  ASSERT_EQ(CGAL::orientation(mesh.points[0], mesh.points[4], mesh.points[5], mesh.points[1]),
            CGAL::POSITIVE);
  EXPECT_EQ(sorted(refusal(mesh).vertices()), (Indices{0, 1}));
  mesh.points.push_back(Point(-1, 0, 0));
  mesh.tetrahedra[1] = {0, 5, 4, 6}; // shares the vertex 0
  EXPECT_EQ(refusal(mesh).vertices(), Indices{0});
}

TEST(Assign, refuses_neighbors_that_overlap) {
  Labeled_mesh mesh = corner_tetrahedron();
  mesh.points.push_back(Point(.25, .25, 2)); // on the side of the facet where the tetrahedron lies
  mesh.tetrahedra.push_back({0, 1, 2, 4});
  mesh.labels.push_back(0);
  EXPECT_NE(std::string(refusal(mesh).what()), "");
  mesh = corner_tetrahedron();
  mesh.tetrahedra.push_back({1, 2, 0, 3}); // the same tetrahedron again
  mesh.labels.push_back(0);
  EXPECT_NE(std::string(refusal(mesh).what()), "");
}

// Labels and interface

TEST(Interface, of_pairs_of_labels) {
  const Complex dsc = make_complex(grid(4, small_meshes::two_boxes));
  EXPECT_EQ(dsc.labels(), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(dsc.interface_facets(1, 2).size(), 8u);
  EXPECT_EQ(dsc.interface_facets(0, 1).size(), 24u);
  EXPECT_EQ(dsc.interface_facets(2, 0).size(), 24u);
  EXPECT_TRUE(dsc.interface_facets(1, 1).empty());
  EXPECT_TRUE(dsc.interface_facets(1, 5).empty());
  EXPECT_EQ(dsc.interface_facets().size(), 56u);
  for (const auto& f : dsc.interface_facets()) {
    EXPECT_TRUE(dsc.is_interface(f));
    EXPECT_GT(f.first->subdomain_index(), f.first->neighbor(f.second)->subdomain_index());
  }
  for (const auto& f : dsc.interface_facets(1, 2)) {
    const auto v = dsc.facet_vertices(f);
    EXPECT_EQ(f.first->subdomain_index(), 2);
    // normals point out of label 2, where x is positive
    EXPECT_LT(CGAL::normal(v[0]->point(), v[1]->point(), v[2]->point()).x(), 0);
  }
}

TEST(Interface, edges_and_vertices_are_those_of_its_facets) {
  const Complex dsc = make_complex(grid(4, small_meshes::four_phases));
  std::vector<Vertex_handle> vertices;
  using Stamps = std::pair<std::size_t, std::size_t>;
  std::vector<Stamps> edges;
  const auto stamps = [](Vertex_handle v, Vertex_handle w) {
    return Stamps(std::minmax(v->time_stamp(), w->time_stamp()));
  };
  for (const auto& f : dsc.interface_facets())
    for (int i = 0; i < 3; ++i) {
      const auto v = dsc.facet_vertices(f);
      vertices.push_back(v[i]);
      edges.push_back(stamps(v[i], v[(i + 1) % 3]));
    }
  for (Vertex_handle v : dsc.vertices())
    EXPECT_EQ(dsc.is_interface(v), std::count(vertices.begin(), vertices.end(), v) > 0);
  for (const auto& e : dsc.triangulation().finite_edges())
    EXPECT_EQ(dsc.is_interface(e),
              std::count(edges.begin(), edges.end(),
                         stamps(e.first->vertex(e.second), e.first->vertex(e.third))) > 0);
  // the planes x = 0 and y = 0 have 25 vertices each, of which five are common
  EXPECT_EQ(dsc.interface_vertices().size(), 45u);
  EXPECT_NEAR(dsc.mean_interface_edge(), .5 * (2 + std::sqrt(2.)) / 3, tolerance);
  EXPECT_EQ(dsc.minimum_interface_edge(), .5);
}

TEST(Interface, labels_are_any_numbers) {
  static constexpr int smallest = (std::numeric_limits<int>::min)(),
                       largest = (std::numeric_limits<int>::max)();
  const auto label = [](const Point& p) {
    return small_meshes::cube(p) == 0 ? -7 : p.x() < 0 ? smallest : largest;
  };
  const Complex dsc = make_complex(grid(4, label));
  EXPECT_TRUE(dsc.is_valid());
  EXPECT_EQ(dsc.labels(), (std::vector<int>{smallest, -7, largest}));
  EXPECT_EQ(dsc.interface_facets().size(), 56u);
  EXPECT_EQ(dsc.interface_facets(smallest, largest).size(), 8u);
  EXPECT_NEAR(dsc.volume(-7), 7, tolerance);
  EXPECT_NEAR(dsc.area(-7, smallest), 3, 1e-12);
  EXPECT_EQ(dsc.number_of_components(largest), 1u);
}

// Measures

TEST(Measures, of_unions_of_boxes) {
  const auto expect = [](const Labeled_mesh& mesh, double volume, double area, int euler,
                         std::size_t components, std::size_t outer_components = 1) {
    const Complex dsc = make_complex(mesh);
    EXPECT_TRUE(dsc.is_valid());
    EXPECT_NEAR(dsc.volume(1), volume, tolerance);
    EXPECT_NEAR(dsc.volume(0), 8 - volume, tolerance);
    EXPECT_NEAR(dsc.area(1), area, 1e-12);
    EXPECT_NEAR(dsc.area(0, 1), area, 1e-12);
    EXPECT_EQ(dsc.euler_characteristic(1), euler);
    EXPECT_EQ(dsc.number_of_components(1), components);
    EXPECT_EQ(dsc.number_of_components(0), outer_components);
    EXPECT_EQ(dsc.number_of_components(7), 0u);
    EXPECT_EQ(dsc.number_of_cells(0) + dsc.number_of_cells(1), mesh.tetrahedra.size());
  };
  expect(grid(4, small_meshes::cube), 1, 6, 2, 1);
  expect(grid(8, two_cubes), .25, 3, 4, 2);
  expect(grid(8, square_ring), 1, 8, 0, 1); // a torus
  expect(grid(8, hollow_cube), 3.375 - .125, 15, 4, 1, 2);
  // the common edge is counted once, with its two vertices; the vertex is counted once
  expect(grid(4, cubes_with_a_common_edge), .5, 5, 2 + 2 - (3 - 2), 2);
  expect(grid(4, cubes_with_a_common_vertex), .25, 3, 2 + 2 - 1, 2);
}

TEST(Measures, of_several_labels) {
  const Complex boxes = make_complex(grid(4, small_meshes::two_boxes));
  EXPECT_NEAR(boxes.volume(1), .5, tolerance);
  EXPECT_NEAR(boxes.volume(2), .5, tolerance);
  EXPECT_NEAR(boxes.area(1, 2), 1, 1e-12);
  EXPECT_NEAR(boxes.area(1), 4, 1e-12);
  EXPECT_NEAR(boxes.area(0), 6, 1e-12);
  for (int label : {0, 1, 2})
    EXPECT_EQ(boxes.euler_characteristic(label), 2);
  const Complex phases = make_complex(grid(4, small_meshes::four_phases));
  for (int label : {0, 1, 2, 3}) {
    EXPECT_NEAR(phases.volume(label), 2, tolerance);
    EXPECT_NEAR(phases.area(label), 4, 1e-12);        // two half planes
    EXPECT_EQ(phases.euler_characteristic(label), 1); // that form a disk
  }
  EXPECT_EQ(phases.area(0, 3), 0);
}

TEST(Measures, of_all_labels_at_once_are_those_of_each) {
  const auto expect = [](const Labeled_mesh& mesh) {
    const Complex dsc = make_complex(mesh);
    std::vector<int> labels;
    for (const auto& measures : dsc.label_interfaces()) {
      labels.push_back(measures.label);
      EXPECT_EQ(measures.area, dsc.area(measures.label));
      EXPECT_EQ(measures.euler_characteristic, dsc.euler_characteristic(measures.label));
    }
    EXPECT_EQ(labels, dsc.labels());
  };
  expect(grid(2, small_meshes::uniform));
  expect(grid(4, small_meshes::ball));
  expect(grid(8, square_ring));
  expect(grid(4, cubes_with_a_common_edge));
  expect(grid(4, small_meshes::eight_phases));
  EXPECT_TRUE(Complex().label_interfaces().empty());
}

TEST(Normalization, maps_to_user_coordinates) {
  Complex dsc = make_complex(grid(2, small_meshes::uniform));
  dsc.set_normalization({Complex::Vector_3(1, 2, 3), 10});
  for (Vertex_handle v : dsc.vertices()) {
    const auto p = dsc.position(v), q = dsc.user_position(v);
    EXPECT_EQ(q, Complex::Point_3(1 + 10 * p.x(), 2 + 10 * p.y(), 3 + 10 * p.z()));
  }
  EXPECT_NEAR(dsc.volume(0), 8, tolerance);
}

// Boundary

TEST(Boundary, sides_of_a_box) {
  const Complex dsc = make_complex(grid(4, small_meshes::uniform));
  for (Vertex_handle v : dsc.vertices()) {
    const auto p = dsc.position(v);
    int expected = 0;
    for (int axis = 0; axis < 3; ++axis)
      expected |= (p[axis] == -1 ? 1 : p[axis] == 1 ? 2 : 0) << (2 * axis);
    EXPECT_EQ(v->boundary_class(), expected);
    EXPECT_EQ(dsc.is_boundary(v), expected != 0);
  }
}

TEST(Boundary, of_another_domain_is_fixed) {
  const Labeled_mesh without_corner = part(grid(2, small_meshes::uniform), [](const Point& p) {
    return p.x() < 0 || p.y() < 0 || p.z() < 0;
  });
  Complex dsc = make_complex(without_corner);
  EXPECT_TRUE(dsc.is_valid());
  for (Vertex_handle v : dsc.vertices()) {
    EXPECT_EQ(v->boundary_class(), DSC::Boundary_class::fixed);
    const Point before = v->point();
    EXPECT_EQ(dsc.admissible_destination(v, Point(5, 6, 7)), before);
    EXPECT_EQ(dsc.move_vertex(v, Point(.1, .1, .1)), 1);
    EXPECT_EQ(v->point(), before);
  }
}

} // namespace test_complex
