// Instantiates the part of the component Compiled for fluids in the plane.
#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Incompressible_fluids_3/compiled_2.h>
