// Instantiates the part of the component Compiled that works in space.
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
