// Simulates a bubble that rises in a heavier liquid in the plane: the benchmark of S. Hysing and
// others, "Quantitative benchmark computations of two-dimensional bubble dynamics", 2009.
//
// Usage: rising_bubble_2 [CASE [EDGE [TIME_STEP [END [PICTURE.svg]]]]], where CASE is 1 or 2
#include <CGAL/Bbox_2.h>
#include <CGAL/Complex_construction/Labeled_curve_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Incompressible_fluid_2.h>
#include <CGAL/Mesh_files/SVG_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_2<>;
using Fluid = CGAL::Incompressible_fluid_2<Complex>;

// The center, the velocity and the shape of the bubble, which has the label 1.
struct Bubble
{
  double center = 0, velocity = 0; // vertical
  double circularity = 0;          // perimeter of the circle of equal area over the perimeter

  explicit Bubble(const Fluid& fluid) {
    const Complex& complex = fluid.complex();
    double area = 0, perimeter = 0;
    for (auto c : complex.cells())
      if (c->subdomain_index() == 1) {
        const double share = complex.measure(c) / 3;
        area += 3 * share;
        for (int i = 0; i < 3; ++i) {
          center += share * complex.position(c->vertex(i)).y();
          velocity += share * fluid.velocity(c->vertex(i), 1).y();
        }
      }
    center /= area;
    velocity /= area;
    for (const auto& f : complex.interface_facets()) {
      const auto v = complex.facet_vertices(f);
      perimeter +=
          std::sqrt(CGAL::squared_distance(complex.position(v[0]), complex.position(v[1])));
    }
    circularity = 2 * std::sqrt(CGAL_PI * area) / perimeter;
  }
};

int main(int argc, char* argv[]) {
  const auto argument = [&](int i, double value) { return argc > i ? std::atof(argv[i]) : value; };
  const bool is_second = argument(1, 1) == 2;
  const double edge = argument(2, .06), dt = argument(3, .02), end = argument(4, .4);

  // A polygon with the area of a circle of radius 0.25.
  const int corners = int(2 * CGAL_PI * .25 / edge);
  const double angle = 2 * CGAL_PI / corners, radius = .25 * std::sqrt(angle / std::sin(angle));
  std::vector<Complex::Point_2> polygon;
  for (int i = 0; i < corners; ++i)
    polygon.emplace_back(.5 + radius * std::cos(i * angle), .5 + radius * std::sin(i * angle));
  DSC::Labeled_curve_2<Complex::Point_2> curve;
  curve.add_polyline(polygon);
  Complex complex = DSC::make_deformable_simplicial_complex_2<Complex>(
      {curve}, CGAL::parameters::enclosing_box(CGAL::Bbox_2(0, 0, 1, 2))
                   .spacing_per_segment(DSC::Construction_options<2>::fine_spacing));

  DSC::Fluid_properties properties;
  properties.set_liquid(0, {1000, 10}); // label, density, viscosity
  properties.set_liquid(1, is_second ? DSC::Liquid{1, .1} : DSC::Liquid{100, 1});
  properties.set_surface_tension(0, 1, is_second ? 1.96 : 24.5);
  properties.set_gravity({0, -.98, 0});
  Fluid fluid(complex, properties);
  for (const bool is_top : {false, true}) // liquids slip at the other two sides
    fluid.set_side(1, is_top, {{{0, 0, 0}}});

  double least_circularity = 1, time_of_circularity = 0, greatest_velocity = 0,
         time_of_velocity = 0;
  std::cout << " time  center  velocity  circularity  vertices\n" << std::fixed;
  for (int step = 1; fluid.time() < end * (1 - 1e-9); ++step) {
    const double limit = is_second ? fluid.largest_step(.5) : dt; // case 2 has thin filaments
    fluid.advance((std::min)({dt, limit, end - fluid.time()}));
    const Bubble bubble(fluid);
    if (bubble.circularity < least_circularity) {
      least_circularity = bubble.circularity;
      time_of_circularity = fluid.time();
    }
    if (bubble.velocity > greatest_velocity) {
      greatest_velocity = bubble.velocity;
      time_of_velocity = fluid.time();
    }
    if (step % 10 == 0 || fluid.time() >= end * (1 - 1e-9))
      std::cout << std::setprecision(2) << std::setw(5) << fluid.time() << std::setprecision(4)
                << std::setw(8) << bubble.center << std::setw(10) << bubble.velocity
                << std::setw(13) << bubble.circularity << std::setw(10)
                << complex.number_of_vertices() << '\n';
  }
  std::cout << "least circularity " << least_circularity << " at " << std::setprecision(2)
            << time_of_circularity << ", greatest velocity " << std::setprecision(4)
            << greatest_velocity << " at " << std::setprecision(2) << time_of_velocity << '\n';
  if (argc > 5)
    CGAL::IO::write_SVG(argv[5], complex);
}
