// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONTROL_DETAIL_2_H
#define CGAL_CONTROL_DETAIL_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/improvement/Own_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>

#ifdef CGAL_DSC_EXTERN // see the component Compiled
#include <CGAL/Deformable_simplicial_complex_2.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {
CGAL_DSC_EXTERN template Improvement_report
run_detail_control(Default_complex_2&, const Detail_thresholds&,
                   const Edge_unit<Default_complex_2>&, const Edge_unit<Default_complex_2>&,
                   unsigned, const std::function<bool(Default_complex_2::Cell_handle)>&,
                   Any_visitor<Default_complex_2>&);
} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL
#endif

#endif // CGAL_CONTROL_DETAIL_2_H
