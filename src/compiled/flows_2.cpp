// Instantiates the flows of the component Compiled that work in the plane.
#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Interface_flows/compiled_2.h>
