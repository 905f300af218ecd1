// A rigid motion of an interface is exact and bitwise reproducible, and every cell stays positive.
#include "small_meshes.h"

#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Kernel::Point_3;

// Rotates a point about the z-axis and translates it.
Point destination(const Point& p) {
  const double c = std::cos(.1), s = std::sin(.1);
  return Point(c * p.x() - s * p.y() + .04, s * p.x() + c * p.y() - .03, p.z() + .02);
}

// Returns whether all cells are positively oriented, by the predicate of the kernel.
bool is_positive(const Complex& complex) {
  for (const Complex::Cell_handle c : complex.cells())
    if (CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                          c->vertex(3)->point()) != CGAL::POSITIVE)
      return false;
  return true;
}

int main() {
  const small_meshes::Labeled_mesh mesh = small_meshes::grid(8, small_meshes::two_boxes);
  std::vector<Complex> complexes(3);
  for (std::size_t i = 0; i < complexes.size(); ++i) {
    Complex& complex = complexes[i];
    complex.assign(mesh.points, mesh.tetrahedra, mesh.labels);
    assert(std::abs(complex.volume(1) - .5) < 1e-12 && std::abs(complex.area(1, 2) - 1) < 1e-12);
    const std::vector<Complex::Vertex_handle> vertices = complex.interface_vertices();
    std::vector<Point> destinations;
    for (const Complex::Vertex_handle v : vertices)
      destinations.push_back(destination(v->point()));
    const auto report = DSC::deform_interface(
        complex, [](Complex::Vertex_handle v) { return destination(v->point()); },
        CGAL::parameters::number_of_threads(i == 2 ? 3 : 1));

    // All vertices are exactly at their destinations, and nothing was lost.
    assert(report.complete && report.unfinished.empty() && report.relabeled == 0);
    assert(complex.interface_vertices() == vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      assert(vertices[k]->point() == destinations[k]);
    assert(is_positive(complex) && complex.is_valid());
    assert(std::abs(complex.volume(1) - .5) < 1e-12 && std::abs(complex.volume(2) - .5) < 1e-12);
    assert(complex.number_of_components(1) == 1 && complex.euler_characteristic(1) == 2);
  }
  // Neither the run nor the number of threads changes the result.
  assert(complexes[0].state() == complexes[1].state());
  assert(complexes[0].state() == complexes[2].state());
  return EXIT_SUCCESS;
}
