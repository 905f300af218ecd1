// Instantiates the part of the component Compiled that works on a torus of dimension 2.
#include <CGAL/Interface_flows/compiled_2.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Interface_flows/compiled_torus_2.h>
