// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_3_H

/// \file
/// Declares the contents of the component `Compiled` for space: the class
/// `CGAL::Deformable_simplicial_complex_3<>` and the functions that change it, intersections of
/// triangle soups and triangulations of polygons. A source file that
/// includes this header uses the compiled code and does not instantiate these templates again.
/// \pre The program links with `Deformable_simplicial_complex::Compiled`.

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/improve_mesh.h>
#include <CGAL/Mesh_files/internal/surfaces/triangulated_polygon.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/split_at_crossings_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_intersections_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/soup_rays_3.h>

#ifndef CGAL_DSC_INSTANTIATION // defined where the component instantiates the templates
#define CGAL_DSC_INSTANTIATION extern
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {
using Default_complex_3 = Deformable_simplicial_complex_3<>;
CGAL_DSC_INSTANTIATION template std::vector<std::pair<std::size_t, std::size_t>>
crossing_triangles<Predicates_kernel>(const Triangle_soup_3&);
CGAL_DSC_INSTANTIATION template std::vector<Soup_ray_3>
shoot_rays<Exact_predicates_exact_constructions_kernel>(const Triangle_soup_3&,
                                                        const std::vector<std::size_t>&);
CGAL_DSC_INSTANTIATION template std::optional<Split_soup_3>
split_at_crossings<Exact_predicates_exact_constructions_kernel>(
    const Triangle_soup_3&, const std::function<bool(Split_soup_3&, int)>&);
CGAL_DSC_INSTANTIATION template Places_of_triangles
triangulated_simple_polygon<Polygon_kernel>(const std::vector<Polygon_kernel::Point_2>&);
} // namespace Deformable_simplicial_complexes::internal

CGAL_DSC_INSTANTIATION template class Deformable_simplicial_complex_3<>;

namespace Deformable_simplicial_complexes {
#define CGAL_DSC_COMPILED_COMPLEX internal::Default_complex_3
#include <CGAL/Deformable_simplicial_complexes/compiled_functions.h>
#undef CGAL_DSC_COMPILED_COMPLEX
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPILED_3_H
