// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>

namespace dsc {

Grain_result grow_grains_3(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  using namespace CGAL::Deformable_simplicial_complexes;
  using Domain = Torus_domain<3>;
  using Complex =
      CGAL::Deformable_simplicial_complex_3<CGAL::Deformable_simplicial_complex_traits_3<>,
                                            CGAL::Default, Volume_length_ratio_3, Domain>;
  Grain_files files(run);
  Complex complex = voronoi_grains<Complex>(run, [](double edge, const auto& labels) {
    return make_deformable_simplicial_complex_3<Complex>(Domain(), edge, labels);
  });
  return grow_grains(run, files, complex, on);
}

} // namespace dsc
