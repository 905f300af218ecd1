// Instantiates the part of the component Compiled for segmentation. The complex itself is
// instantiated in complex_3.cpp.
#define CGAL_DSC_SEGMENTATION_INSTANTIATION

#include <CGAL/Image_segmentation/compiled_3.h>
