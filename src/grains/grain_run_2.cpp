// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/compiled_torus_2.h>

namespace dsc {
namespace {

template <class Complex, class Domain>
Grain_result grow_in_plane(const Domain& domain, const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  const auto make = [&](double edge, const auto& labels) {
    return DSC::make_deformable_simplicial_complex_2<Complex>(domain, edge, labels);
  };
  return grow_grains<Complex>(run, make, on);
}

} // namespace

Grain_result grow_grains_2(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  if (run.is_periodic)
    return grow_in_plane<DSC::internal::Torus_complex_2>(DSC::Torus_domain<2>(), run, on);
  return grow_in_plane<CGAL::Deformable_simplicial_complex_2<>>(CGAL::Bbox_2(0, 0, 1, 1), run, on);
}

} // namespace dsc
