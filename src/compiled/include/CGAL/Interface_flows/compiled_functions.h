// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The flows that the component Compiled instantiates for the complex CGAL_DSC_COMPILED_COMPLEX. No
// include guard: a header of the component includes this list for each complex.

CGAL_DSC_INSTANTIATION template void
Normal_offset::operator()(const Interface_snapshot<CGAL_DSC_COMPILED_COMPLEX>&,
                          const std::vector<CGAL_DSC_COMPILED_COMPLEX::Point>&, double,
                          std::vector<CGAL_DSC_COMPILED_COMPLEX::Vector>&) const;
CGAL_DSC_INSTANTIATION template internal::Opened_corners<CGAL_DSC_COMPILED_COMPLEX>
Normal_offset::open_corners(CGAL_DSC_COMPILED_COMPLEX&,
                            const Interface_snapshot<CGAL_DSC_COMPILED_COMPLEX>&, double,
                            Deformation_visitor<CGAL_DSC_COMPILED_COMPLEX>&) const;
CGAL_DSC_INSTANTIATION template void
Mean_curvature_velocity::operator()(const Interface_snapshot<CGAL_DSC_COMPILED_COMPLEX>&,
                                    const std::vector<CGAL_DSC_COMPILED_COMPLEX::Point>&, double,
                                    std::vector<CGAL_DSC_COMPILED_COMPLEX::Vector>&) const;
CGAL_DSC_INSTANTIATION template double
Mean_curvature_flow::operator()(const Interface_snapshot<CGAL_DSC_COMPILED_COMPLEX>&,
                                const std::vector<CGAL_DSC_COMPILED_COMPLEX::Point>&, double,
                                double, std::vector<CGAL_DSC_COMPILED_COMPLEX::Point>&) const;
CGAL_DSC_INSTANTIATION template Volume_report<CGAL_DSC_COMPILED_COMPLEX>
internal::restore_all_volumes(CGAL_DSC_COMPILED_COMPLEX&,
                              const std::map<CGAL_DSC_COMPILED_COMPLEX::Label, double>&,
                              const Volume_restoration_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Deformation_report<CGAL_DSC_COMPILED_COMPLEX>
internal::advect(CGAL_DSC_COMPILED_COMPLEX&,
                 const internal::Step_velocity<CGAL_DSC_COMPILED_COMPLEX>&, double, double,
                 const Advection_options<CGAL_DSC_COMPILED_COMPLEX>&);
CGAL_DSC_INSTANTIATION template Deformation_report<CGAL_DSC_COMPILED_COMPLEX>
internal::adapt_and_advect(CGAL_DSC_COMPILED_COMPLEX&,
                           const internal::Step_velocity<CGAL_DSC_COMPILED_COMPLEX>&, double,
                           double, const Adaptive_advection_options<CGAL_DSC_COMPILED_COMPLEX>&);
