// Instantiates the part of the component Compiled for segmentation in the plane.
#include <CGAL/Deformable_simplicial_complexes/compiled_2.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Image_segmentation/compiled_2.h>
