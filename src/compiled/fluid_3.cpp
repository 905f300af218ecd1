// As complex_3.cpp, but for what that has.
#define CGAL_DSC_EXTERN extern
#include <CGAL/control_detail_3.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/improve_mesh_3.h>
#undef CGAL_DSC_EXTERN
#define CGAL_DSC_EXTERN
#include <CGAL/Incompressible_fluid_3.h>
