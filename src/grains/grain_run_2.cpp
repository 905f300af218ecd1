// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "grain_run_impl.h"

#include <CGAL/Deformable_simplicial_complex_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/SVG_2.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_2.h>

namespace dsc {

Grain_result grow_grains_2(const Grain_run& run,
                           const std::function<void(const Grain_state&)>& on) {
  using namespace CGAL::Deformable_simplicial_complexes;
  using Domain = Torus_domain<2>;
  using Complex =
      CGAL::Deformable_simplicial_complex_2<CGAL::Deformable_simplicial_complex_traits_2<>,
                                            CGAL::Default, Domain>;
  Grain_files files(run);
  Complex complex = voronoi_grains<Complex>(run, [](double edge, const auto& labels) {
    return make_deformable_simplicial_complex_2<Complex>(Domain(), edge, labels);
  });
  const Grain_result result = grow_grains(run, files, complex, on);
  if (!run.picture.empty())
    CGAL::IO::write_SVG(run.picture, complex);
  return result;
}

} // namespace dsc
