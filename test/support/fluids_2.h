#ifndef INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_2_H
#define INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_2_H

#include "planar_regions.h"
#include "test.h"

#include <CGAL/Incompressible_fluid_2.h>
#if __has_include(<CGAL/Incompressible_fluids_3/compiled_2.h>) // if the component Compiled is used
#include <CGAL/Incompressible_fluids_3/compiled_2.h>
#endif

// Fluids in the plane.
namespace fluids_2 {

using planar_regions::Complex;
using Fluid = CGAL::Incompressible_fluid_2<Complex>;
using Vertex_handle = Complex::Vertex_handle;

// Returns a liquid with label 1 and density 1. Gravity acts downward.
inline DSC::Fluid_properties liquid(double viscosity, double gravity) {
  DSC::Fluid_properties result;
  result.set_liquid(1, {1, viscosity});
  result.set_gravity({0, -gravity, 0});
  return result;
}

} // namespace fluids_2

#endif // INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_2_H
