// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The function templates that the component Compiled instantiates for each default complex,
// CGAL_DSC_COMPILED_COMPLEX. No include guard: compiled_2.h and compiled_3.h include this list.

CGAL_DSC_INSTANTIATION template void
improve_new_mesh(CGAL_DSC_COMPILED_COMPLEX&,
                 const Construction_options<CGAL_DSC_COMPILED_COMPLEX::dimension>&);
CGAL_DSC_INSTANTIATION template Improvement_report
run_detail_control(CGAL_DSC_COMPILED_COMPLEX&, const Detail_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Improvement_report
remesh_interface(CGAL_DSC_COMPILED_COMPLEX&,
                 const Interface_improvement_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Improvement_report
improve_whole_mesh(CGAL_DSC_COMPILED_COMPLEX&,
                   const Mesh_improvement_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Deformation_report<CGAL_DSC_COMPILED_COMPLEX>
deform(CGAL_DSC_COMPILED_COMPLEX&, const std::vector<CGAL_DSC_COMPILED_COMPLEX::Vertex_handle>&,
       const std::vector<CGAL_DSC_COMPILED_COMPLEX::Approximate_point>&,
       const Deformation_options<CGAL_DSC_COMPILED_COMPLEX>&);
