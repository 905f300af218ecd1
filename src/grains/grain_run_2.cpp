// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_2.h>
#include <CGAL/Interface_flows/compiled_torus_2.h>

namespace dsc {

Grain_result grow_grains_2(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  using namespace DSC;
  using Box_complex = CGAL::Deformable_simplicial_complex_2<>;
  using Torus_complex = internal::Torus_complex_2;
  if (run.is_periodic)
    return grow_grains<Torus_complex>(
        run,
        [](double edge, const auto& labels) {
          return make_deformable_simplicial_complex_2<Torus_complex>(Torus_domain<2>(), edge,
                                                                     labels);
        },
        on);
  return grow_grains<Box_complex>(
      run,
      [](double edge, const auto& labels) {
        return make_deformable_simplicial_complex_2<Box_complex>(CGAL::Bbox_2(0, 0, 1, 1), edge,
                                                                 labels);
      },
      on);
}

} // namespace dsc
