// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_COMPILED_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_COMPILED_3_H

/// \file
/// Declares the contents of the component `Compiled` for reconstruction: the implementation of
/// `CGAL::Deformable_simplicial_complexes::reconstruct_point_set_3()` with the default complex, and
/// the declarations of `<CGAL/Deformable_simplicial_complexes/compiled_3.h>`. A source file that
/// includes this header uses the compiled code and does not instantiate these templates again. If
/// it is the first header that includes the function, the function can be called with the default
/// complex only.
/// \pre The program links with `Deformable_simplicial_complex::Compiled_reconstruction`.

#define CGAL_DSC_RECONSTRUCTION_IS_COMPILED

#include <CGAL/Deformable_simplicial_complexes/compiled_3.h>
#include <CGAL/Solid_reconstruction_3/reconstruct_point_set_3.h>

namespace CGAL::Deformable_simplicial_complexes::internal {
CGAL_DSC_INSTANTIATION template Default_complex_3
reconstruct_collected(const Collected_points&, const Reconstruction_options_3<Default_complex_3>&);
} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_SOLID_RECONSTRUCTION_3_COMPILED_3_H
