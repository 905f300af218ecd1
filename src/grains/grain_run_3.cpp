// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_flows/compiled_torus_3.h>

namespace dsc {

Grain_result grow_grains_3(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  using namespace DSC;
  using Box_complex = CGAL::Deformable_simplicial_complex_3<>;
  using Torus_complex = internal::Torus_complex_3;
  if (run.is_periodic)
    return grow_grains<Torus_complex>(
        run,
        [](double edge, const auto& labels) {
          return make_deformable_simplicial_complex_3<Torus_complex>(Torus_domain<3>(), edge,
                                                                     labels);
        },
        on);
  return grow_grains<Box_complex>(
      run,
      [](double edge, const auto& labels) {
        return make_deformable_simplicial_complex_3<Box_complex>(CGAL::Bbox_3(0, 0, 0, 1, 1, 1),
                                                                 edge, labels);
      },
      on);
}

} // namespace dsc
