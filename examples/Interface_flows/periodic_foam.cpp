// Relaxes foams that fill space: the foam of Kelvin, whose cells are truncated octahedra, and the
// foam of Weaire and Phelan, which has less area.
// Usage: periodic_foam [kelvin|weaire-phelan [EDGE [STEPS]]]
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<3>;
using Complex = CGAL::Deformable_simplicial_complex_3<CGAL::Epick, CGAL::Default,
                                                      DSC::Volume_length_ratio_3, Domain>;
using Point = Complex::Point_3;

struct Angles
{
  double sum = 0, number = 0;
};

// Returns the smallest and the largest angle of a phase along a triple line, in degrees. Each angle
// is a mean over the lines of the same three labels. By Plateau's law, all angles are 120 degrees.
std::pair<double, double> plateau_angles(const Complex& foam) {
  using Edge = std::pair<std::size_t, std::size_t>; // by time stamps
  std::map<Edge, std::map<int, double>> angles;     // the labels around an edge
  for (Complex::Cell_handle c : foam.finite_cells())
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) {
        const int k = (i + 1) % 4 != j ? (i + 1) % 4 : (i + 2) % 4, l = 6 - i - j - k;
        const auto corner = [&](int m) { return foam.corner(c, m); };
        angles[std::minmax(c->vertex(i)->time_stamp(), c->vertex(j)->time_stamp())]
              [foam.label(c)] +=
            std::abs(CGAL::approximate_dihedral_angle(corner(i), corner(j), corner(k), corner(l)));
      }
  std::map<std::pair<std::vector<int>, int>, Angles> lines;
  for (const auto& [edge, around] : angles) {
    if (around.size() != 3)
      continue;
    std::vector<int> labels;
    for (const auto& [label, angle] : around)
      labels.push_back(label);
    for (const auto& [label, angle] : around) {
      Angles& line = lines[{labels, label}];
      line.sum += angle;
      ++line.number;
    }
  }
  std::pair<double, double> result(180, 0);
  for (const auto& [line, a] : lines)
    result = {(std::min)(result.first, a.sum / a.number),
              (std::max)(result.second, a.sum / a.number)};
  return result;
}

int main(int argc, char** argv) {
  const bool is_kelvin = argc < 2 || std::string(argv[1]) == "kelvin";
  const double edge = argc > 2 ? std::atof(argv[2]) : .25;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 10;

  // Centers of the cells. Kelvin: cells of volume 1/2 in a box of two periods of the body-centered
  // lattice, because in one period a cell is its own neighbor. Weaire and Phelan: cells of volume
  // 1/8 in one period of the structure A15.
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
  Complex foam = DSC::make_deformable_simplicial_complex_3<Complex>(
      domain, edge * period / 2, [&](const Point& p) {
        int label = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < centers.size(); ++i)
          if (const double d = (domain.nearest_image(p, centers[i]) - p).squared_length();
              d < least) {
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
      DSC::improve_interface(foam);
      DSC::restore_volumes(foam, volumes);
    }
    DSC::advect_interface(foam, DSC::Mean_curvature_flow(true), 0, dt);
  }
  DSC::restore_volumes(foam, volumes);

  double area = 0;
  for (const Complex::Facet& f : foam.interface_facets())
    area += foam.area(f);
  std::cout << "area of a cell / volume^(2/3): "
            << 2 * area / double(centers.size()) / std::pow(volume, 2. / 3) << "\n";
  const auto [least, largest] = plateau_angles(foam);
  std::cout << "angles of cells along lines where three meet: " << least << " to " << largest
            << " degrees in the mean\n";
  return foam.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
