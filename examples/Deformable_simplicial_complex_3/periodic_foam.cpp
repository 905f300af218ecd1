// Foams that fill space come to rest: that of Kelvin, whose cells are truncated octahedra, and that
// of Weaire and Phelan, which has less area.
// Usage: periodic_foam [kelvin|weaire-phelan [EDGE [STEPS]]]
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>
#include <CGAL/mean_curvature_flow_3.h>
#include <CGAL/restore_volumes_3.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<3>;
using Complex =
    CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                          CGAL::Default, CGAL::Volume_length_ratio_3, Domain>;
using Point = Complex::Approximate_point_3;

int main(int argc, char** argv) {
  const bool is_kelvin = argc < 2 || std::string(argv[1]) == "kelvin";
  const double edge = argc > 2 ? std::atof(argv[2]) : .25;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 10;

  // Centers of cells of the volume 1/2 in a box of two periods of the body-centered lattice, as a
  // cell is a neighbor of itself in one, or of cells of 1/8 in one period of the structure A15.
  std::vector<Point> centers;
  const double period = is_kelvin ? 2 : 1, volume = is_kelvin ? 1. / 2 : 1. / 8;
  if (is_kelvin)
    for (int i = 0; i < 8; ++i)
      for (double shift : {0., .5})
        centers.emplace_back(i % 2 + shift, i / 2 % 2 + shift, i / 4 + shift);
  else
    centers = {{0, 0, 0},    {.5, .5, .5}, {.25, .5, 0}, {.75, .5, 0},
               {0, .25, .5}, {0, .75, .5}, {.5, 0, .25}, {.5, 0, .75}};
  const Domain domain({period, period, period});
  Complex foam = CGAL::make_deformable_simplicial_complex_3<Complex>(
      domain, edge * period / 2, [&](const Point& p) {
        int label = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < centers.size(); ++i)
          if (const double d = (domain.near(p, centers[i]) - p).squared_length(); d < least) {
            least = d;
            label = int(i) + 1;
          }
        return label;
      });
  std::map<int, double> volumes;
  for (int label : foam.labels())
    volumes[label] = volume;

  const double dt = .004 * std::pow(volume, 2. / 3);
  for (int step = 0; step < steps; ++step) {
    if (step % 10 == 0) {
      CGAL::improve_interface(foam);
      CGAL::restore_volumes(foam, volumes);
    }
    CGAL::advect_interface(foam, CGAL::Mean_curvature_flow_3(true), 0, dt);
  }
  CGAL::restore_volumes(foam, volumes);

  double area = 0;
  for (const Complex::Facet& f : foam.interface_facets())
    area += foam.area(f);
  std::cout << "area of a cell / volume^(2/3): "
            << 2 * area / double(centers.size()) / std::pow(volume, 2. / 3) << "\n";
  return foam.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
