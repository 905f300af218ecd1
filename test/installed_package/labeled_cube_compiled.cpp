// labeled_cube.cpp with the compiled templates
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#include "labeled_cube.cpp"
