// Simulates a ball of liquid that falls onto a floor and spreads there.
#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Incompressible_fluid_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace DSC = CGAL::Deformable_simplicial_complexes;

using Complex = CGAL::Deformable_simplicial_complex_3<>;
using Fluid = CGAL::Incompressible_fluid_3<Complex>;

int main() {
  // Label 1 in a ball of radius 0.5, label 0 around it. The domain extends below the floor, so the
  // floor is not a boundary of the domain.
  const auto label_at = [](const Complex::Point& p) {
    return (p - CGAL::ORIGIN).squared_length() < .25 ? 1 : 0;
  };
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      CGAL::Bbox_3(-1.2, -1.2, -.9, 1.2, 1.2, .9), .2, label_at);

  DSC::Fluid_properties properties;
  properties.set_liquid(1, {1, .1}); // label, density, viscosity; label 0 is void
  properties.set_surface_tension(0, 1, .1);
  properties.set_gravity({0, 0, -1});

  Fluid fluid(complex, properties);
  DSC::Wall_behavior behavior;
  behavior.contact_angle = 60; // degrees
  behavior.separates = false;  // wet parts stay wet
  fluid.add_solid(DSC::Plane_solid_3(Fluid::Point(0, 0, -.6), Fluid::Vector(0, 0, 1)), behavior);
  fluid.set_velocities([](Complex::Vertex_handle) { return Fluid::Vector(0, 0, -.5); });

  std::cout << " time   energy      volume  contacts\n" << std::fixed;
  for (int step = 0; step < 20; ++step) {
    // The implicit scheme takes the forces at the end of the time step. It damps fast oscillations,
    // so the drop comes to rest.
    const double dt = (std::min)(.05, fluid.largest_step(.5));
    const Fluid::Report report = fluid.advance(dt, CGAL::parameters::implicitness(1.));
    std::cout << std::setw(5) << std::setprecision(3) << report.time << std::setw(9)
              << std::setprecision(5) << report.after.energy() << std::setw(12)
              << std::setprecision(9) << report.after.volume << std::setw(10) << report.contacts
              << '\n';
  }
}
