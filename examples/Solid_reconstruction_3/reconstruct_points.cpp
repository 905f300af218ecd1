// Reconstructs a solid from points on its surface: the points of a file, or random points of a
// torus.
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Mesh_files/point_set_3.h>
#include <CGAL/Random.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Report = CGAL::Deformable_simplicial_complexes::Reconstruction_report_3<Complex>;
using CGAL::IO::Point_and_normal_3;
namespace parameters = CGAL::parameters;

std::vector<Point_and_normal_3> torus() {
  std::vector<Point_and_normal_3> points;
  CGAL::Random random(1);
  while (points.size() < 3000) {
    const double u = random.uniform_real(0., 2 * CGAL_PI), v = random.uniform_real(0., 2 * CGAL_PI);
    const double radius = 2 + std::cos(v);
    if (random.uniform_real(0., 3.) < radius) // the density of the points is uniform on the surface
      points.push_back({{radius * std::cos(u), radius * std::sin(u), std::sin(v)},
                        CGAL::NULL_VECTOR}); // the normals are unknown
  }
  return points;
}

int main(int argc, char** argv) {
  const auto points = argc > 1 ? CGAL::IO::read_point_set(argv[1]) : torus();
  Report report;
  const Complex complex = DSC::reconstruct_point_set_3<Complex>(
      points, parameters::point_map(CGAL::First_of_pair_property_map<Point_and_normal_3>())
                  .normal_map(CGAL::Second_of_pair_property_map<Point_and_normal_3>())
                  .observer([](const Complex& c, std::size_t step) {
                    std::cout << "step " << step << ": volume " << c.volume(1) << '\n';
                    return true; // continue
                  })
                  .report(std::ref(report)));
  std::cout << "Euler characteristic " << complex.euler_characteristic(1) << ", points are "
            << report.root_mean_square / report.spacing << " spacings away, "
            << report.facets_without_points.size() << " facets close holes of the cloud\n";
  CGAL::IO::write_interface("reconstruct_points.off", complex);
  return report.is_complete ? EXIT_SUCCESS : EXIT_FAILURE;
}
