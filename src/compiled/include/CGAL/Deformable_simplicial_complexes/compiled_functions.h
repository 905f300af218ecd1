// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The base of the complex CGAL_DSC_COMPILED_COMPLEX and the functions that change it, which the
// component Compiled instantiates. No include guard: a header of the component includes this list
// for each complex.

CGAL_DSC_INSTANTIATION template class Labeled_complex<
    CGAL_DSC_COMPILED_COMPLEX, CGAL_DSC_COMPILED_COMPLEX::Space,
    CGAL_DSC_COMPILED_COMPLEX::Quality_measure, CGAL_DSC_COMPILED_COMPLEX::Domain>;
CGAL_DSC_INSTANTIATION template void
internal::improve_new_mesh(CGAL_DSC_COMPILED_COMPLEX&,
                           const Construction_options<CGAL_DSC_COMPILED_COMPLEX::dimension>&);
CGAL_DSC_INSTANTIATION template Improvement_report
internal::run_detail_control(CGAL_DSC_COMPILED_COMPLEX&,
                             const Detail_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Improvement_report
internal::remesh_interface(CGAL_DSC_COMPILED_COMPLEX&,
                           const Interface_improvement_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Improvement_report
internal::improve_whole_mesh(CGAL_DSC_COMPILED_COMPLEX&,
                             const Mesh_improvement_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Deformation_report<CGAL_DSC_COMPILED_COMPLEX>
internal::deform(CGAL_DSC_COMPILED_COMPLEX&,
                 const std::vector<CGAL_DSC_COMPILED_COMPLEX::Vertex_handle>&,
                 const std::vector<CGAL_DSC_COMPILED_COMPLEX::Point>&,
                 const Deformation_options<CGAL_DSC_COMPILED_COMPLEX>&);
