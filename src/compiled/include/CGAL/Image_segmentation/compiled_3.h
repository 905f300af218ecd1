// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IMAGE_SEGMENTATION_COMPILED_3_H
#define CGAL_IMAGE_SEGMENTATION_COMPILED_3_H

/// \file
/// Declares the contents of the component `Compiled` for segmentation in space: the implementation
/// of `CGAL::Deformable_simplicial_complexes::segment_image()` with the default complex, and the
/// declarations of `<CGAL/Deformable_simplicial_complexes/compiled_3.h>`. A source file that
/// includes this header uses the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled_segmentation`.

#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
#include <CGAL/Image_segmentation/segment_image.h>

namespace CGAL::Deformable_simplicial_complexes::internal {
CGAL_DSC_INSTANTIATION template Segmentation_report segment(Default_complex_3&,
                                                            const Gray_image<3>&,
                                                            const Segmentation_options<3>&,
                                                            const Image_phases&, bool);
} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_IMAGE_SEGMENTATION_COMPILED_3_H
