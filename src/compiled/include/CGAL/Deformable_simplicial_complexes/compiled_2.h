// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_2_H

/// \file
/// Declares the contents of the component `Compiled` for the plane: the class
/// `CGAL::Deformable_simplicial_complex_2<>` and the functions that change it. A source file that
/// includes this header uses the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled`.

#include <CGAL/Complex_construction/internal/building/Planar_filling_2.h>
#include <CGAL/Complex_construction/internal/images/Image_filling_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>

#ifndef CGAL_DSC_INSTANTIATION // defined where the component instantiates the templates
#define CGAL_DSC_INSTANTIATION extern
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {
using Default_complex_2 = Deformable_simplicial_complex_2<>;
CGAL_DSC_INSTANTIATION template Planar_filling_2
fill_planar_box<Planar_kernel>(const Curve_soup_2&, const Bbox_2&, double);
CGAL_DSC_INSTANTIATION template Planar_filling_2
fill_box_between<Planar_kernel>(const Curve_soup_2&, const Bbox_2&, double);
CGAL_DSC_INSTANTIATION template Image_filling_2
fill_image<Planar_kernel>(const Labeled_image_2&, double, const std::optional<Bbox_2>&);
} // namespace Deformable_simplicial_complexes::internal

CGAL_DSC_INSTANTIATION template class Deformable_simplicial_complex_2<>;

namespace Deformable_simplicial_complexes {
#define CGAL_DSC_COMPILED_COMPLEX internal::Default_complex_2
#include <CGAL/Deformable_simplicial_complexes/compiled_functions.h>
#undef CGAL_DSC_COMPILED_COMPLEX
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_2_H
