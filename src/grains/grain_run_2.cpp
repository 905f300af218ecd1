// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/compiled_torus_2.h>

namespace dsc {

Grain_result grow_grains_2(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  using On_torus = DSC::internal::Torus_complex_2;
  using In_box = CGAL::Deformable_simplicial_complex_2<>;
  const auto on_torus = [](double edge, const auto& labels) {
    return DSC::fill_torus<On_torus>(DSC::Torus_domain<2>(), edge, labels);
  };
  const auto in_box = [](double edge, const auto& labels) {
    return DSC::make_deformable_simplicial_complex_2<In_box>(CGAL::Bbox_2(0, 0, 1, 1), edge,
                                                             labels);
  };
  return run.is_periodic ? grow_grains<On_torus>(run, on_torus, on)
                         : grow_grains<In_box>(run, in_box, on);
}

} // namespace dsc
