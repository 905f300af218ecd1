#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;

// The compiler finds the extension of CGAL's list of named parameters.
static_assert(CGAL::Deformable_simplicial_complexes::is_given<
              decltype(CGAL::parameters::visitor(1).quality_threshold(.3)),
              CGAL::internal_np::quality_threshold_t>);

// The unit cube in six tetrahedra about a diagonal. The bits of i are the coordinates (x, y, z) of
// vertex i. Label 1 is the part x > y.
int main() {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  const std::vector<std::array<std::size_t, 4>> tetrahedra = {
      {0, 1, 3, 7}, {0, 5, 1, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}};

  Complex complex;
  complex.assign(points, tetrahedra, {1, 1, 1, 0, 0, 0});

  const bool right = complex.is_valid() && complex.number_of_cells() == 6 &&
                     std::abs(complex.volume(1) - .5) < 1e-12 &&
                     std::abs(complex.area(0, 1) - std::sqrt(2.)) < 1e-12;
  std::cout << "volume " << complex.volume(1) << ", area " << complex.area(0, 1) << '\n';
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
