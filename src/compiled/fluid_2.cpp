// Instantiates the part of the component Compiled for fluids in the plane. The complex itself is
// instantiated in complex_2.cpp.
#define CGAL_DSC_FLUID_INSTANTIATION

#include <CGAL/Incompressible_fluids_3/compiled_2.h>
