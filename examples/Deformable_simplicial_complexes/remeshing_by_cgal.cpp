// A ball grows. In the middle of the flow, tetrahedral_isotropic_remeshing() of CGAL makes its
// cells larger.

#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/Normal_offset.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <iostream>
#include <utility>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;

int main() {
  const auto ball = [](const Complex::Point_3& p) {
    return (p - CGAL::ORIGIN).squared_length() < .25 ? 1 : 0;
  };
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), .15, ball);

  const double dt = .03;
  for (int step = 0; step < 6; ++step) {
    if (step == 3) {
      Complex::Triangulation triangulation = complex.release();
      CGAL::tetrahedral_isotropic_remeshing(triangulation, .25);
      complex.assign(std::move(triangulation));
      std::cout << "remeshed by CGAL\n";
    }
    const auto report = DSC::advect_interface(complex, DSC::Normal_offset{1.}, step * dt, dt);
    std::cout << complex.number_of_cells() << " cells, volume " << complex.volume(1)
              << (report.complete ? "\n" : " (incomplete)\n");
  }
  return complex.is_valid() ? 0 : 1;
}
