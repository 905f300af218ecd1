#include "small_meshes.h"
#include "test.h"

#include <CGAL/Interface_remeshing/Interface_graph_3.h>
#include <CGAL/Interface_remeshing/extract_interface_3.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

// The interface of a label as a face graph.

namespace test_interface_graph {

using small_meshes::Complex;
using small_meshes::grid;
using small_meshes::make_complex;
using small_meshes::Point;
using Graph = DSC::Interface_graph_3<Complex>;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PMP = CGAL::Polygon_mesh_processing;

BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraph<Graph>));
BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraph<Graph>));
BOOST_CONCEPT_ASSERT((CGAL::concepts::HalfedgeListGraph<Graph>));
BOOST_CONCEPT_ASSERT((CGAL::concepts::FaceListGraph<Graph>));
static_assert(CGAL::graph_has_property<Graph, CGAL::vertex_point_t>::value);

constexpr double tolerance = 1e-12;

// A cube of side 1/2 in each of two opposite octants; the cubes have the same label and share only
// the origin.
int cubes_at_a_vertex(const Point& p) {
  const auto is_inside = [](double x) { return 0 < x && x < .5; };
  return (is_inside(p.x()) && is_inside(p.y()) && is_inside(p.z())) ||
         (is_inside(-p.x()) && is_inside(-p.y()) && is_inside(-p.z()));
}

// The cubes share an edge of the length 1/2 or, with n = 4, one edge of the mesh.
int cubes_at_an_edge(const Point& p) {
  const auto is_inside = [](double x) { return 0 < x && x < .5; };
  return is_inside(p.z()) &&
         ((is_inside(p.x()) && is_inside(p.y())) || (is_inside(-p.x()) && is_inside(-p.y())));
}

std::size_t number_of_components(const Graph& g) {
  const auto map = get(CGAL::dynamic_face_property_t<std::size_t>(), g);
  return PMP::connected_components(g, map);
}

int euler_characteristic(const Graph& g) {
  return int(num_vertices(g)) - int(num_edges(g)) + int(num_faces(g));
}

// Checks what holds for each graph.
void check(const Complex& complex, int label) {
  const Graph g(complex, label);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(g));
  EXPECT_TRUE(CGAL::is_triangle_mesh(g));
  EXPECT_NEAR(PMP::area(g), complex.area(label), tolerance * (1 + complex.area(label)));

  // The ranges are sorted and complete, and all functions fit together.
  EXPECT_EQ(vertices(g).size(), num_vertices(g));
  EXPECT_EQ(halfedges(g).size(), num_halfedges(g));
  EXPECT_EQ(edges(g).size(), num_edges(g));
  EXPECT_EQ(faces(g).size(), num_faces(g));
  EXPECT_TRUE(std::is_sorted(vertices(g).begin(), vertices(g).end()));
  EXPECT_TRUE(std::is_sorted(faces(g).begin(), faces(g).end()));
  std::set<Graph::halfedge_descriptor> all;
  std::map<Graph::vertex_descriptor, std::size_t> degrees;
  for (const auto h : halfedges(g)) {
    all.insert(h);
    ++degrees[target(h, g)];
    EXPECT_EQ(opposite(opposite(h, g), g), h);
    EXPECT_EQ(prev(next(h, g), g), h);
    EXPECT_EQ(source(h, g), target(opposite(h, g), g));
    EXPECT_EQ(source(next(h, g), g), target(h, g));
    EXPECT_EQ(edge(h, g), edge(opposite(h, g), g));
    EXPECT_TRUE(halfedge(source(h, g), target(h, g), g).second);
    if (face(h, g) != boost::graph_traits<Graph>::null_face()) {
      const auto facet = g.facet(face(h, g));
      EXPECT_EQ(complex.label(facet.first), label);
      EXPECT_TRUE(complex.is_interface(facet));
    }
  }
  EXPECT_EQ(all.size(), num_halfedges(g));
  EXPECT_EQ(degrees.size(), num_vertices(g));
  for (const auto& [v, number] : degrees) {
    EXPECT_EQ(degree(v, g), number);
    EXPECT_EQ(target(halfedge(v, g), g), v);
    EXPECT_EQ(get(CGAL::vertex_point, g, v), g.vertex_handle(v)->point());
  }

  // A copy is a valid mesh of the same size.
  Mesh mesh;
  CGAL::copy_face_graph(g, mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.number_of_vertices(), num_vertices(g));
  EXPECT_EQ(mesh.number_of_edges(), num_edges(g));
  EXPECT_EQ(mesh.number_of_faces(), num_faces(g));
  EXPECT_EQ(CGAL::is_closed(mesh), CGAL::is_closed(g));
  EXPECT_NEAR(PMP::area(mesh), PMP::area(g), tolerance);
}

TEST(Interface_graph, of_a_ball_is_its_extracted_interface) {
  const Complex complex = make_complex(grid(8, small_meshes::ball));
  check(complex, 1);
  check(complex, 0);
  const Graph g(complex, 1);
  const auto surface = DSC::extract_interface(complex, 1, 0);
  ASSERT_EQ(num_vertices(g), surface.points.size());
  EXPECT_EQ(num_faces(g), surface.triangles.size());
  std::size_t i = 0;
  for (const auto v : vertices(g))
    EXPECT_EQ(g.vertex_handle(v), surface.vertices[i++]);
  ASSERT_TRUE(CGAL::is_closed(g));
  EXPECT_TRUE(PMP::is_outward_oriented(g));
  EXPECT_FALSE(PMP::is_outward_oriented(Graph(complex, 0)));
  EXPECT_NEAR(PMP::volume(g), complex.volume(1), tolerance);
  EXPECT_NEAR(PMP::volume(Graph(complex, 0)), -complex.volume(1), tolerance);
  EXPECT_EQ(euler_characteristic(g), complex.euler_characteristic(1));
  EXPECT_EQ(number_of_components(g), 1u);
}

TEST(Interface_graph, has_outward_normals) {
  const Complex complex = make_complex(grid(8, small_meshes::ball));
  const Graph g(complex, 1);
  const auto of_faces = get(CGAL::dynamic_face_property_t<Complex::Geom_traits::Vector_3>(), g);
  const auto of_vertices =
      get(CGAL::dynamic_vertex_property_t<Complex::Geom_traits::Vector_3>(), g);
  PMP::compute_normals(g, of_vertices, of_faces);
  for (const auto f : faces(g)) {
    const auto facet = g.facet(f);
    const Point inside = facet.first->vertex(facet.second)->point();
    EXPECT_LT(get(of_faces, f) * (inside - get(CGAL::vertex_point, g, target(halfedge(f, g), g))),
              0);
  }
  for (const auto v : vertices(g))
    EXPECT_GT(get(of_vertices, v) * (g.vertex_handle(v)->point() - CGAL::ORIGIN), 0);
}

TEST(Interface_graph, has_a_vertex_for_each_umbrella) {
  const Complex complex = make_complex(grid(4, cubes_at_a_vertex));
  for (const int label : {0, 1}) {
    check(complex, label);
    const Graph g(complex, label);
    std::size_t at_the_origin = 0;
    for (const auto v : vertices(g))
      at_the_origin += g.vertex_handle(v)->point() == Point(0, 0, 0);
    EXPECT_EQ(at_the_origin, 2u);
    EXPECT_EQ(euler_characteristic(g), complex.euler_characteristic(label) + 1);
    EXPECT_EQ(number_of_components(g), 2u);
    EXPECT_TRUE(CGAL::is_closed(g));
  }
  EXPECT_NEAR(PMP::volume(Graph(complex, 1)), .25, tolerance);
}

TEST(Interface_graph, has_two_edges_where_parts_share_an_edge) {
  for (const std::size_t n : {4, 8}) {
    const Complex complex = make_complex(grid(n, cubes_at_an_edge));
    check(complex, 1);
    check(complex, 0);
    const Graph inside(complex, 1), outside(complex, 0);
    EXPECT_EQ(number_of_components(inside), 2u);
    EXPECT_EQ(euler_characteristic(inside), 4);
    EXPECT_NEAR(PMP::volume(inside), complex.volume(1), tolerance);
    // Seen from outside, the two cubes are a ball with a handle.
    EXPECT_EQ(number_of_components(outside), 1u);
    EXPECT_EQ(euler_characteristic(outside), 2);
    EXPECT_NEAR(PMP::volume(outside), -complex.volume(1), tolerance);
  }
}

TEST(Interface_graph, of_each_of_several_labels_is_closed) {
  const Complex complex = make_complex(grid(8, small_meshes::eight_phases));
  for (const int label : complex.labels()) {
    check(complex, label);
    const Graph g(complex, label);
    ASSERT_TRUE(CGAL::is_closed(g));
    if (label != 0)
      EXPECT_NEAR(PMP::volume(g), complex.volume(label), tolerance);
    EXPECT_EQ(euler_characteristic(g), 2) << label;
  }
}

TEST(Interface_graph, has_a_border_on_the_boundary_of_the_domain) {
  const Complex complex = make_complex(grid(4, small_meshes::four_phases));
  for (const int label : {0, 1, 2, 3}) {
    check(complex, label);
    const Graph g(complex, label);
    EXPECT_FALSE(CGAL::is_closed(g));
    EXPECT_EQ(euler_characteristic(g), 1); // two half planes that share an edge
    std::size_t border = 0;
    for (const auto h : halfedges(g))
      if (CGAL::is_border(h, g)) {
        ++border;
        EXPECT_TRUE(complex.is_boundary(g.vertex_handle(target(h, g))));
      }
    EXPECT_EQ(border, 16u);
    EXPECT_NEAR(PMP::longest_border(g).second, 8, tolerance);
  }
}

TEST(Interface_graph, has_several_borders_at_a_vertex) {
  // Two boxes with the same label that share only an edge, which goes through the domain
  const Complex complex =
      make_complex(grid(4, [](const Point& p) { return int(p.x() * p.y() > 0); }));
  for (const int label : {0, 1}) {
    check(complex, label);
    const Graph g(complex, label);
    EXPECT_EQ(number_of_components(g), 2u);
    EXPECT_EQ(euler_characteristic(g), 2);
  }
}

TEST(Interface_graph, of_a_label_without_interface_is_empty) {
  const Complex complex = make_complex(grid(2, small_meshes::uniform));
  for (const int label : {0, 7}) {
    const Graph g(complex, label);
    EXPECT_TRUE(CGAL::is_empty(g));
    EXPECT_EQ(faces(g).size() + vertices(g).size() + edges(g).size() + halfedges(g).size(), 0u);
  }
}

TEST(Interface_graph, throws_after_a_change_of_the_complex) {
  Complex complex = make_complex(grid(4, small_meshes::cube));
  const Graph g(complex, 1);
  EXPECT_NO_THROW(faces(g));
  complex.relabel(complex.cells().front(), 1);
  EXPECT_THROW(faces(g), CGAL::Precondition_exception);
  EXPECT_THROW(vertices(g), CGAL::Precondition_exception);
  EXPECT_THROW(edges(g), CGAL::Precondition_exception);
  EXPECT_THROW(halfedges(g), CGAL::Precondition_exception);
}

} // namespace test_interface_graph
