#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Surface = DSC::Labeled_surface_3<Complex::Point_3>;

int main() {
  const Surface octahedron = {
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      1};
  // Several threads at the same time: each thread runs TetGen in a separate process.
  std::vector<Complex> complexes(4);
  std::vector<std::thread> threads;
  for (Complex& complex : complexes)
    threads.emplace_back([&] {
      complex = DSC::make_deformable_simplicial_complex_3<Complex>(
          std::vector<Surface>{octahedron}, CGAL::Tetgen_tetrahedralizer_3());
    });
  for (std::thread& thread : threads)
    thread.join();

  bool right = true;
  for (const Complex& complex : complexes)
    right = right && complex.is_valid() && std::abs(complex.volume(1) - 4. / 3.) < 1e-9 &&
            complex.euler_characteristic(1) == 2 &&
            complex.number_of_cells() == complexes[0].number_of_cells();
  std::cout << "volume " << complexes[0].volume(1) << '\n';
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
