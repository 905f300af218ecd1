// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/compiled_torus_3.h>

namespace dsc {
namespace {

template <class Complex, class Domain>
Grain_result grow_in_space(const Domain& domain, const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  const auto make = [&](double edge, const auto& labels) {
    return DSC::make_deformable_simplicial_complex_3<Complex>(domain, edge, labels);
  };
  return grow_grains<Complex>(run, make, on);
}

} // namespace

Grain_result grow_grains_3(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  if (run.is_periodic)
    return grow_in_space<DSC::internal::Torus_complex_3>(DSC::Torus_domain<3>(), run, on);
  return grow_in_space<CGAL::Deformable_simplicial_complex_3<>>(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), run,
                                                                on);
}

} // namespace dsc
