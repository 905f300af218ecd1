// Instantiates the part of the component Compiled for fluids in space. The complex itself is
// instantiated in complex_3.cpp.
#define CGAL_DSC_FLUID_INSTANTIATION

#include <CGAL/Incompressible_fluids_3/compiled_3.h>
