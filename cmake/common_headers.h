// Headers that most programs of the repository include, precompiled. They declare the templates
// that the component Compiled contains.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interface_flows/compiled_2.h>
#include <CGAL/Interface_flows/compiled_3.h>
#include <CGAL/Interface_flows/velocity_fields_3.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>
