// What most programs here include: precompiled.
#include <CGAL/Curvature_size_field_3.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_3.h>
#include <CGAL/advect_interface_2.h>
#include <CGAL/advect_interface_3.h>
#include <CGAL/control_detail_2.h>
#include <CGAL/control_detail_3.h>
#include <CGAL/deform_interface_2.h>
#include <CGAL/improve_interface_2.h>
#include <CGAL/improve_interface_3.h>
#include <CGAL/improve_mesh_3.h>
#include <CGAL/make_deformable_simplicial_complex_2.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>
#include <CGAL/velocity_fields_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>
