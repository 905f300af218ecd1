// Instantiates the part of the component Compiled for soups of segments and triangles, and for
// polygons; see complex_2.cpp.
#define CGAL_DSC_EXTERN

#include <CGAL/Deformable_simplicial_complexes/internal/IO/triangulated_polygon_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Planar_filling_2_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/images/Image_filling_2_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_intersections_3_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/soup_rays_3_impl.h>
#include <CGAL/Deformable_simplicial_complexes/internal/soups/split_at_crossings_3_impl.h>
