// Instantiates the part of the component Compiled for segmentation in space.
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Image_segmentation/compiled_3.h>
