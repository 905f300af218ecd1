// What the component Compiled has of the plane: headers declare it where CGAL_DSC_EXTERN says
// `extern`, and define it here.
#define CGAL_DSC_EXTERN

#include <CGAL/control_detail_2.h>
#include <CGAL/deform_interface_2.h>
#include <CGAL/improve_interface_2.h>
#include <CGAL/improve_mesh_2.h>
#include <CGAL/make_deformable_simplicial_complex_2.h>
