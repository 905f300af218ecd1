// Instantiates the part of the component Compiled for reconstruction.
#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/reconstruct_collected_impl.h>

#undef CGAL_DSC_INSTANTIATION
#define CGAL_DSC_INSTANTIATION

#include <CGAL/Solid_reconstruction_3/compiled_3.h>
