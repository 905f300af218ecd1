// Instantiates the part of the component Compiled for fluids in space.
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Incompressible_fluids_3/compiled_3.h>
