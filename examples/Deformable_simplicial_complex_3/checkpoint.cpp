#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/IO/checkpoint_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/interface_flows_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Surface = CGAL::Labelled_surface_3<Complex::Point_3>;

// Ten steps of a flow, from the given one on
void run(Complex& complex, int first_step) {
  const double dt = .01;
  for (int step = first_step; step < first_step + 10; ++step)
    CGAL::advect_interface(complex, CGAL::Normal_offset_3{1.}, step * dt, dt);
}

int main() {
  const std::vector<Surface> octahedron = {
      {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
       {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
       1}};
  Complex complex = CGAL::make_deformable_simplicial_complex_3<Complex>(
      octahedron, CGAL::Tetgen_tetrahedralizer_3());

  // What the program needs besides the complex goes along as text.
  run(complex, 0);
  CGAL::IO::write_checkpoint("octahedron.checkpoint", complex.state(), std::to_string(10));
  run(complex, 10);

  // In most cases this is another program, some other day.
  const CGAL::IO::Checkpoint_3 checkpoint = CGAL::IO::read_checkpoint("octahedron.checkpoint");
  Complex restored;
  restored.restore(checkpoint.state);
  run(restored, std::stoi(checkpoint.metadata));

  const bool same = complex.state() == restored.state();
  std::cout.precision(17);
  std::cout << "volume " << complex.volume(1) << ", after the interruption " << restored.volume(1)
            << (same ? ": the same bits" : ": different") << std::endl;
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
