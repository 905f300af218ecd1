#ifndef INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_3_H
#define INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_3_H

#include "small_meshes.h"
#include "test.h"

#include <CGAL/Incompressible_fluid_3.h>
#if __has_include(<CGAL/Incompressible_fluids_3/compiled_3.h>) // if the component Compiled is used
#include <CGAL/Incompressible_fluids_3/compiled_3.h>
#endif

// Fluids in space.
namespace fluids_3 {

using small_meshes::Complex;
using Fluid = CGAL::Incompressible_fluid_3<Complex>;

// Returns a liquid with label 1. Gravity acts downward.
inline DSC::Fluid_properties liquid(double density, double viscosity = 0, double tension = 0,
                                    double gravity = 0) {
  DSC::Fluid_properties result;
  result.set_liquid(1, {density, viscosity});
  result.set_surface_tension(0, 1, tension);
  result.set_gravity({0, 0, -gravity});
  return result;
}

} // namespace fluids_3

#endif // INCOMPRESSIBLE_FLUIDS_3_TEST_FLUIDS_3_H
