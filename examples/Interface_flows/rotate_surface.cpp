// Rotates a solid by half a turn and writes each step as a frame of an animation.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Mesh_files/PVD_series.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[]) {
  // A closed surface from a file, or an ellipsoid
  Mesh surface;
  if (argc > 1) {
    if (!CGAL::IO::read_polygon_mesh(argv[1], surface)) {
      std::cerr << "cannot read " << argv[1] << std::endl;
      return EXIT_FAILURE;
    }
  } else {
    CGAL::make_icosahedron(surface, Point(0, 0, 0), 1.);
    CGAL::Subdivision_method_3::Loop_subdivision(surface,
                                                 CGAL::parameters::number_of_iterations(2));
    for (const auto v : surface.vertices()) {
      const Point p = surface.point(v);
      surface.point(v) = Point(p.x(), .6 * p.y(), .4 * p.z());
    }
  }

  // Label 1 inside, label 0 outside, in a box; the center of the surface becomes the origin
  namespace parameters = CGAL::parameters;
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      surface, CGAL::Tetgen_tetrahedralizer_3(), parameters::normalize(true));
  std::cout << complex.number_of_vertices() << " vertices, " << complex.number_of_cells()
            << " tetrahedra, volume of the solid " << complex.volume(1) << std::endl;

  // Half a turn about the z-axis in ten steps; each step is a frame of an animation
  const DSC::Rigid_rotation_3 rotation({0, 0, 0}, {0, 0, 1}, CGAL_PI);
  const double dt = .1;
  CGAL::IO::PVD_series animation("rotate_surface.pvd");
  for (int step = 0; step < 10; ++step) {
    const auto report = DSC::advect_interface(complex, rotation, step * dt, dt);
    const std::string file = "rotate_surface_" + std::to_string(step) + ".vtu";
    CGAL::IO::write_VTU(file, complex);
    animation.append((step + 1) * dt, file);
    std::cout << "step " << step << ": " << report.passes << " passes, volume " << complex.volume(1)
              << (report.complete ? "" : ", incomplete") << std::endl;
  }

  CGAL::IO::write_interface("rotate_surface.off", complex);
  return EXIT_SUCCESS;
}
