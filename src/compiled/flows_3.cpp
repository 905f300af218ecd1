// Instantiates the flows of the component Compiled that work in space.
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Interface_flows/compiled_3.h>
