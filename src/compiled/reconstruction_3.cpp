// Instantiates the part of the component Compiled for reconstruction. The complex itself is
// instantiated in complex_3.cpp.
#define CGAL_DSC_RECONSTRUCTION_INSTANTIATION

#include <CGAL/Solid_reconstruction_3/compiled_3.h>
