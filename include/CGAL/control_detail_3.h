// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONTROL_DETAIL_3_H
#define CGAL_CONTROL_DETAIL_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Own_operations_3.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Improvement_report
run_detail_control(Default_complex_3&, const Detail_thresholds&,
                   const Edge_unit<Default_complex_3>&, const Edge_unit<Default_complex_3>&,
                   unsigned, const std::function<bool(Default_complex_3::Cell_handle)>&,
                   Any_visitor<Default_complex_3>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_CONTROL_DETAIL_3_H
