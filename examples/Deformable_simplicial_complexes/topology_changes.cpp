// Merges two growing spheres, shrinks the result, and prints the topology changes that the reports
// contain.
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/interface_flows_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Point = Complex::Point_3;
using Report = DSC::Deformation_report<Complex>;

void print(int step, const Complex& complex, const Report& report) {
  std::cout << "step " << step << ": " << report.passes << " passes, " << report.relabeled
            << " cells relabeled\n";
  for (const auto& [vertex, distance] : report.unfinished)
    std::cout << "  the vertex at " << complex.position(vertex) << " is " << distance
              << " from its destination\n";
  for (const Report::Label_change& change : report.labels)
    if (change.merged + change.split + change.vanished + change.appeared > 0)
      std::cout << "  label " << change.label << ": " << change.before << " -> " << change.after
                << " components; " << change.merged << " merged, " << change.split << " split, "
                << change.vanished << " vanished, " << change.appeared << " appeared\n";
}

int main() {
  // One surface with two connected components; both enclose label 1
  CGAL::Surface_mesh<Point> spheres;
  CGAL::make_icosahedron(spheres, Point(-.7, 0, 0), .5);
  CGAL::make_icosahedron(spheres, Point(.7, 0, 0), .5);
  CGAL::Subdivision_method_3::Loop_subdivision(spheres, CGAL::parameters::number_of_iterations(2));
  Complex complex =
      DSC::make_deformable_simplicial_complex_3<Complex>(spheres, CGAL::Tetgen_tetrahedralizer_3());

  // The spheres grow and merge, then the merged solid shrinks.
  const double dt = .3 * complex.mean_interface_edge();
  for (int step = 0; step < 30; ++step) {
    const DSC::Normal_offset offset{step < 15 ? 1. : -1.};
    const Report report = DSC::advect_interface(complex, offset, step * dt, dt);
    if (!report.complete || report.relabeled > 0)
      print(step, complex, report);
  }
  std::cout << "volume " << complex.volume(1) << ", area " << complex.area(1)
            << ", Euler characteristic of the surface " << complex.euler_characteristic(1)
            << std::endl;
  return complex.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
