// Writes a checkpoint in the middle of a flow, reads it, and resumes the flow.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;

// Steps of a flow in which two spheres grow and merge
void run(Complex& complex, int first_step, int last_step) {
  const double dt = .04;
  for (int step = first_step; step < last_step; ++step)
    DSC::advect_interface(complex, DSC::Normal_offset{1.}, step * dt, dt);
}

int main() {
  CGAL::Surface_mesh<Point> spheres;
  CGAL::make_icosahedron(spheres, Point(-.7, 0, 0), .5);
  CGAL::make_icosahedron(spheres, Point(.7, 0, 0), .5);
  CGAL::Subdivision_method_3::Loop_subdivision(spheres, CGAL::parameters::number_of_iterations(2));
  Complex complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(spheres, CGAL::Tetgen_tetrahedralizer_3());

  // The checkpoint also stores a text of the program: here, the number of steps done.
  run(complex, 0, 6);
  CGAL::IO::write_checkpoint("spheres.checkpoint", complex.state(), std::to_string(6));
  run(complex, 6, 12);

  // In most cases, another program reads the checkpoint later.
  const CGAL::IO::Checkpoint_3 checkpoint = CGAL::IO::read_checkpoint("spheres.checkpoint");
  Complex restored;
  restored.restore(checkpoint.state);
  run(restored, std::stoi(checkpoint.metadata), 12);

  const bool same = complex.state() == restored.state();
  std::cout.precision(17);
  std::cout << "volume " << complex.volume(1) << " without, " << restored.volume(1)
            << " with the interruption" << (same ? ": the same bits" : ": different") << std::endl;
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
