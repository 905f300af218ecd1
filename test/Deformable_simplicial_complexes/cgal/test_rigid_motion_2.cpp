// A square moves in the plane: its vertices arrive exactly, and every triangle stays positive.
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

// The square [-1,1]^2 in n^2 squares of two triangles. The square [-1/2,1/2]^2 has the label 1.
Complex square(std::size_t n) {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
  for (std::size_t i = 0; i < (n + 1) * (n + 1); ++i)
    points.emplace_back(2. * double(i % (n + 1)) / double(n) - 1,
                        2. * double(i / (n + 1)) / double(n) - 1);
  for (std::size_t i = 0; i < n * n; ++i) {
    const std::size_t a = i / n * (n + 1) + i % n, b = a + 1, c = a + n + 1, d = c + 1;
    triangles.push_back({a, b, d});
    triangles.push_back({a, d, c});
    const Point p = CGAL::midpoint(points[a], points[d]);
    labels.insert(labels.end(), 2, std::abs(p.x()) < .5 && std::abs(p.y()) < .5);
  }
  Complex complex;
  complex.assign(points, triangles, labels);
  return complex;
}

int main() {
  Complex complex = square(8), again = square(8);
  const std::vector<Complex::Vertex_handle> vertices = complex.interface_vertices();
  const Vector shift(.0625, .03125); // sums with the coordinates are exact
  for (int step = 0; step < 4; ++step) {
    std::vector<Point> destinations;
    for (const Complex::Vertex_handle v : vertices)
      destinations.push_back(v->point() + shift);
    const auto destination = [&](Complex::Vertex_handle v) { return v->point() + shift; };
    const auto report = DSC::deform_interface(complex, destination);
    DSC::deform_interface(again, destination);
    assert(report.complete && complex.interface_vertices() == vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      assert(vertices[k]->point() == destinations[k]);
    for (const Complex::Cell_handle c : complex.cells())
      assert(CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(),
                               c->vertex(2)->point()) == CGAL::LEFT_TURN);
    assert(complex.is_valid() && complex.state() == again.state());
  }
  assert(std::abs(complex.area(1) - 1) < 1e-12 && std::abs(complex.length(1) - 4) < 1e-12);
  assert(complex.euler_characteristic(1) == 1);
  return EXIT_SUCCESS;
}
