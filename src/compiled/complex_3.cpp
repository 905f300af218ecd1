// What the component Compiled has of space: see complex_2.cpp.
#define CGAL_DSC_EXTERN

#include <CGAL/control_detail_3.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/improve_mesh_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>
