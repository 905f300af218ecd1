// Instantiates the part of the component Compiled that works on a torus of dimension 2.
#define CGAL_DSC_TORUS_INSTANTIATION

#include <CGAL/Interface_flows/compiled_torus_2.h>
