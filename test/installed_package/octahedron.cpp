#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Surface = CGAL::Labelled_surface_3<Complex::Point_3>;

int main() {
  const Surface octahedron = {
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      1};
  const auto complex = CGAL::make_deformable_simplicial_complex_3<Complex>(
      std::vector<Surface>{octahedron}, CGAL::Tetgen_tetrahedralizer_3());

  const bool right = complex.is_valid() && std::abs(complex.volume(1) - 4. / 3.) < 1e-9 &&
                     complex.euler_characteristic(1) == 2;
  std::cout << "volume " << complex.volume(1) << '\n';
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
