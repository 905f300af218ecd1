// Coarsens a dry foam on a flat torus: the area of a cell of n sides grows at the rate (n - 6) pi /
// 3 (von Neumann, Mullins).
// Usage: planar_foam [CELLS [EDGE [STEPS [FILE.svg]]]]
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Mesh_files/SVG_2.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Domain = CGAL::Deformable_simplicial_complexes::Torus_domain<2>;
using Complex = CGAL::Deformable_simplicial_complex_2<CGAL::Epick, CGAL::Default, Domain>;
using Point = Complex::Point_2;
namespace parameters = CGAL::parameters;

// Returns the label of the nearest seed.
int nearest(const Domain& domain, const std::vector<Point>& seeds, const Point& p) {
  int label = 0;
  double least = 1;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (const double d = (domain.nearest_image(p, seeds[i]) - p).squared_length(); d < least) {
      least = d;
      label = int(i) + 1;
    }
  return label;
}

// Returns the number of sides of each cell. Cells at a vertex where four cells meet are left out,
// because one of them is about to change its number of sides.
std::map<int, int> numbers_of_sides(const Complex& foam) {
  std::map<int, int> result;
  std::set<int> undecided;
  std::vector<Complex::Cell_handle> star;
  for (auto v : foam.interface_vertices()) {
    foam.star(v, star);
    std::set<int> labels;
    for (auto c : star)
      labels.insert(c->subdomain_index());
    for (int label : labels)
      if (labels.size() == 3)
        ++result[label];
      else if (labels.size() > 3)
        undecided.insert(label);
  }
  for (int label : undecided)
    result.erase(label);
  return result;
}

int main(int argc, char** argv) {
  const std::size_t number_of_cells = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20;
  const double edge = argc > 2 ? std::atof(argv[2]) : .02;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 100;
  const char* const picture = argc > 4 ? argv[4] : nullptr;
  const double dt = edge * edge / 5;

  // Seeds with a minimum distance from each other
  const Domain domain({1, 1});
  std::mt19937 random(1);
  const auto coordinate = [&] { return double(random()) / 4294967296.; };
  std::vector<Point> seeds;
  while (seeds.size() < number_of_cells) {
    const Point p(coordinate(), coordinate());
    const int other = nearest(domain, seeds, p);
    if (other == 0 || (domain.nearest_image(p, seeds[other - 1]) - p).squared_length() >
                          .4 / double(number_of_cells))
      seeds.push_back(p);
  }
  Complex foam = DSC::make_deformable_simplicial_complex_2<Complex>(
      domain, edge, [&](const Point& p) { return nearest(domain, seeds, p); });

  // Rates of change of the areas by the numbers of sides, and their linear regression
  double xx = 0, xy = 0;
  std::size_t exchanged = 0, vanished = 0;
  for (int step = 0; step < steps; ++step) {
    DSC::control_detail(foam, parameters::change_interface(true)
                                  .sizing_field([&](const Point&) { return edge; })
                                  .interface_split_length(1.4));
    const auto sides = numbers_of_sides(foam);
    std::map<int, double> areas;
    for (int label : foam.labels())
      areas[label] = foam.area(label);
    const auto report = DSC::advect_interface(foam, DSC::Mean_curvature_flow(), 0, dt);
    exchanged += report.exchanges.size();
    for (const auto& event : report.events)
      vanished += event.kind == DSC::Component_event::Kind::vanished;
    const auto sides_after = numbers_of_sides(foam);
    for (const auto& [label, n] : sides)
      if (const auto after = sides_after.find(label);
          after != sides_after.end() && after->second == n) {
        xx += (n - 6) * (n - 6);
        xy += (n - 6) * (foam.area(label) - areas[label]) / dt;
      }
  }
  if (picture)
    CGAL::IO::write_SVG(picture, foam);
  const double pi = std::acos(-1.);
  std::cout << foam.labels().size() << " of " << number_of_cells << " cells are left; neighbors "
            << "exchanged " << exchanged << " times, " << vanished << " cells vanished\n"
            << "the growth for each side beyond six is " << xy / xx / (pi / 3) << " pi / 3\n";
  return foam.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
