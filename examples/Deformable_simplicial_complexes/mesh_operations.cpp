// Changes a mesh by single operations: an edge removal, a vertex insertion and an edge collapse.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;
using Cavity = Complex::Cavity;

int main() {
  // A long octahedron of four tetrahedra around its axis, which joins the last two points
  const std::vector<Point> points = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                     {0, -1, 0}, {0, 0, 3}, {0, 0, -3}};
  Complex complex;
  const std::vector<Vertex_handle> v = complex.assign(
      points, {{1, 0, 4, 5}, {2, 1, 4, 5}, {3, 2, 4, 5}, {0, 3, 4, 5}}, {1, 1, 1, 1});
  Cavity cavity(complex);
  const auto print = [&](const char* what) {
    std::cout << what << ": " << cavity.removed().size() << " cells became "
              << cavity.created().size() << ", worst quality " << cavity.quality_before() << " -> "
              << cavity.quality_after() << std::endl;
  };

  // A proposal fills the cavity and does not change the complex; `replace()` commits it.
  Complex::Cell_handle c;
  int i, j;
  if (complex.triangulation().is_edge(v[4], v[5], c, i, j) &&
      DSC::propose_edge_removal(complex, c, i, j, cavity)) {
    complex.replace(cavity);
    print("edge removal");
  }

  // A user-defined cavity: a tetrahedron is replaced by four tetrahedra around a point inside it.
  c = complex.cells().front();
  cavity.clear();
  cavity.remove(c);
  std::array<Cavity::Index, 4> corners;
  for (int k = 0; k < 4; ++k)
    corners[k] = cavity.add(c->vertex(k));
  const Cavity::Index inserted =
      cavity.add(CGAL::centroid(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                c->vertex(3)->point()),
                 DSC::Boundary_class::inside);
  for (int k = 0; k < 4; ++k) {
    std::array<Cavity::Index, 4> tetrahedron = corners;
    tetrahedron[k] = inserted;
    cavity.create(tetrahedron, c);
  }
  if (cavity.is_positive()) {
    complex.replace(cavity);
    print("vertex insertion");
  }

  // The new vertex collapses into one of its neighbors.
  const Vertex_handle w = cavity.vertices()[inserted].handle;
  if (complex.triangulation().is_edge(w, v[0], c, i, j)) {
    if (c->vertex(i) != w)
      std::swap(i, j);
    if (DSC::propose_edge_collapse(complex, c, i, j, 0., cavity)) {
      complex.replace(cavity);
      print("edge collapse");
    }
  }
  return complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
