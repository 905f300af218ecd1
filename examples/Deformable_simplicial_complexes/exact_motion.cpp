// Moves a vertex within its star by exact predicates, and computes admissible destinations.
#include <CGAL/Deformable_simplicial_complex_3.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vertex_handle = Complex::Vertex_handle;

int main() {
  // An octahedron of eight tetrahedra around its center, which is the last point
  const std::vector<Point> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                     {0, 0, 1}, {0, 0, -1}, {0, 0, 0}};
  const std::vector<std::array<std::size_t, 4>> tetrahedra = {
      {2, 0, 4, 6}, {1, 2, 4, 6}, {3, 1, 4, 6}, {0, 3, 4, 6},
      {0, 2, 5, 6}, {2, 1, 5, 6}, {1, 3, 5, 6}, {3, 0, 5, 6}};
  Complex complex;
  const std::vector<Vertex_handle> vertices =
      complex.assign(points, tetrahedra, {0, 0, 0, 0, 1, 1, 1, 1});
  const Vertex_handle center = vertices[6];

  const auto print = [&](double way) {
    double worst = 1;
    for (const auto c : complex.cells())
      worst = (std::min)(worst, complex.quality(c));
    std::cout << "went " << way << " of its way, to " << center->point() << "; worst quality "
              << worst << std::endl;
  };
  std::cout.precision(17);

  // A vertex reaches every destination inside its star.
  print(complex.move_vertex(center, Point(.25, .25, .25)));

  // The vertex stays strictly inside its star: it stops before the facet x + y + z = 1, and no
  // tetrahedron becomes degenerate.
  print(complex.move_vertex(center, Point(2, 2, 2)));

  // The star can be tested for a point without moving the vertex.
  std::vector<Complex::Cell_handle> star;
  complex.star(center, star);
  for (const Point& q : {Point(0, 0, .999), Point(0, 0, 1)})
    std::cout << "at " << q << (complex.is_positive_star(center, star, q) ? ": valid" : ": invalid")
              << std::endl;

  // A boundary vertex of a domain that is not a box cannot move: its admissible destination is its
  // position.
  std::cout << "admissible destination: "
            << complex.admissible_destination(vertices[0], Point(3, 0, 0)) << std::endl;

  // The vertex returns to exactly the same coordinates.
  print(complex.move_vertex(center, points[6]));
  return center->point() == points[6] && complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
