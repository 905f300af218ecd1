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

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>
#include <CGAL/Deformable_simplicial_complexes/improve_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Planar_filling_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/images/Image_filling_2.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_2.h>

#include <functional>
#include <optional>
#include <vector>

#ifndef CGAL_DSC_INSTANTIATION // defined where the component instantiates the templates
#define CGAL_DSC_INSTANTIATION extern
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
using Default_complex_2 = Deformable_simplicial_complex_2<>;
}

CGAL_DSC_INSTANTIATION template class Labelled_complex<
    internal::Default_complex_2, internal::Default_complex_2::Space,
    internal::Default_complex_2::Quality_measure, internal::Default_complex_2::Domain>;
} // namespace Deformable_simplicial_complexes

CGAL_DSC_INSTANTIATION template class Deformable_simplicial_complex_2<>;

namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_INSTANTIATION template Planar_filling_2 fill_planar_box<Planar_kernel>(const Curve_soup_2&,
                                                                                const Bbox_2&);
CGAL_DSC_INSTANTIATION template Planar_filling_2
fill_box_between<Planar_kernel>(const Curve_soup_2&, const Bbox_2&);
CGAL_DSC_INSTANTIATION template Image_filling_2
fill_image<Planar_kernel>(const Labelled_image_2&, double, const std::optional<Bbox_2>&);
CGAL_DSC_INSTANTIATION template void improve_new_mesh(Default_complex_2&, const New_mesh_options&);
CGAL_DSC_INSTANTIATION template Improvement_report
run_detail_control(Default_complex_2&, const Detail_thresholds&,
                   const Edge_unit<Default_complex_2>&, const Edge_unit<Default_complex_2>&,
                   unsigned, const std::function<bool(Default_complex_2::Cell_handle)>&,
                   Any_visitor<Default_complex_2>&);
CGAL_DSC_INSTANTIATION template Improvement_report
remesh_interface(Default_complex_2&, const Interface_thresholds&,
                 const Edge_unit<Default_complex_2>&, unsigned, Any_visitor<Default_complex_2>&);
CGAL_DSC_INSTANTIATION template Improvement_report
improve_whole_mesh(Default_complex_2&, const Mesh_improvement_options&,
                   Any_visitor<Default_complex_2>&);
CGAL_DSC_INSTANTIATION template Deformation_report<Default_complex_2>
deform(Default_complex_2&, const std::vector<Default_complex_2::Vertex_handle>&,
       const std::vector<Default_complex_2::Point>&, const Deformation_options<Default_complex_2>&,
       unsigned, unsigned, Any_visitor<Default_complex_2>&, const std::function<bool(unsigned)>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_2_H
