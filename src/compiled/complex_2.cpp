// Instantiates the part of the component Compiled that works in the plane.
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>
