// Moves a surface in a velocity field that is a lambda.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Vector = Complex::Vector_3;
using Mesh = CGAL::Surface_mesh<Complex::Point_3>;

namespace DSC = CGAL::Deformable_simplicial_complexes;

int main(int argc, char* argv[]) {
  Mesh surface;
  if (argc > 1) {
    if (!CGAL::IO::read_polygon_mesh(argv[1], surface)) {
      std::cerr << "cannot read " << argv[1] << std::endl;
      return EXIT_FAILURE;
    }
  } else {
    CGAL::make_icosahedron(surface, Complex::Point_3(0, 0, 0), 1.);
    CGAL::Subdivision_method_3::Loop_subdivision(surface,
                                                 CGAL::parameters::number_of_iterations(2));
  }
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      surface, CGAL::Tetgen_tetrahedralizer_3(), CGAL::parameters::normalize(true));

  // A vortex about the z-axis, faster near the axis, that reverses at half of the period. It
  // preserves volumes, and each point returns to its start.
  const double period = 2;
  const auto vortex = [=](const Point& p, double t) {
    const double angular =
        std::cos(CGAL_PI * t / period) * std::exp(-p.x() * p.x() - p.y() * p.y());
    return 2 * angular * Vector(-p.y(), p.x(), 0);
  };

  std::cout.precision(10);
  std::cout << "time 0: volume " << complex.volume(1) << std::endl;
  const int steps = 20;
  const double dt = period / steps;
  for (int i = 0; i < steps; ++i) {
    const auto report = DSC::advect_interface(
        complex, vortex, i * dt, dt,
        CGAL::parameters::scheme(DSC::Integration_scheme::rk4).maximum_number_of_passes(10));
    if ((i + 1) % 5 == 0 || !report.complete)
      std::cout << "time " << (i + 1) * dt << ": volume " << complex.volume(1) << ", "
                << report.unfinished.size() << " vertices fell short" << std::endl;
  }
  return EXIT_SUCCESS;
}
