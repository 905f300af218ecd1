// A vertex reaches each point inside its star exactly, and never leaves the star.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#undef NDEBUG // the program checks its results by `assert()` in every build
#include <cassert>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Kernel::Point_3;

int main() {
  // An octahedron of eight tetrahedra around its center, which is the last point
  const std::vector<Point> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                     {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  const std::vector<std::array<std::size_t, 4>> tetrahedra = {
      {2, 0, 4, 6}, {1, 2, 4, 6}, {3, 1, 4, 6}, {0, 3, 4, 6},
      {0, 2, 5, 6}, {2, 1, 5, 6}, {1, 3, 5, 6}, {3, 0, 5, 6}};
  Complex complex;
  const Complex::Vertex_handle center =
      complex.assign(points, tetrahedra, {0, 0, 0, 0, 1, 1, 1, 1})[6];
  std::vector<Complex::Cell_handle> star;
  complex.star(center, star);
  assert(star.size() == 8 && complex.is_valid());

  // The facet of the star is the plane x + y + z = 1. A point of the plane is rejected. The next
  // double below it is accepted, although the volume of the cell is about 1e-17.
  const double above = std::nextafter(.5, 1.), below = std::nextafter(.5, 0.);
  assert(!complex.is_positive_star(center, star, Point(.25, .25, .5)));
  assert(!complex.is_positive_star(center, star, Point(.25, .25, above)));
  assert(complex.is_positive_star(center, star, Point(.25, .25, below)));

  assert(complex.move_vertex(center, Point(.25, .25, below)) == 1);
  assert(center->point() == Point(.25, .25, below) && complex.is_valid());

  // A destination outside stops the vertex before the facet.
  assert(complex.move_vertex(center, Point(0, 0, 0)) == 1);
  const double part = complex.move_vertex(center, Point(2, 2, 2));
  const Point stop = center->point();
  assert(part > 0 && part < 1. / 6 && complex.is_valid());
  assert(CGAL::orientation(points[0], points[2], points[4], stop) ==
         CGAL::orientation(points[0], points[2], points[4], points[6]));

  // The vertex returns to bitwise equal coordinates.
  assert(complex.move_vertex(center, points[6]) == 1 && center->point() == points[6]);
  return EXIT_SUCCESS;
}
