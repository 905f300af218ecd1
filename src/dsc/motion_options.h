// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_OPTIONS_H
#define DSC_MOTION_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/control_detail.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>

#include <optional>

namespace dsc {

/// Returns the options of a motion that does not adapt the interface.
template <class Complex>
CGAL::Deformable_simplicial_complexes::Advection_options<Complex>
advection_options(unsigned threads) {
  CGAL::Deformable_simplicial_complexes::Advection_options<Complex> result;
  result.deformation.number_of_threads = threads;
  return result;
}

/// Completes the options of an adaptive motion. An interface that is improved before each step
/// needs mesh adaptation in each step, but no other changes of the interface.
/// \param tolerance of the interface; the default of the library if not set
template <class Complex>
void complete(CGAL::Deformable_simplicial_complexes::Adaptive_advection_options<Complex>& options,
              const std::optional<double>& tolerance, bool improves_interface, unsigned threads) {
  options.advection.deformation.number_of_threads = threads;
  options.interface_tolerance =
      improves_interface ? 0 : tolerance.value_or(options.interface_tolerance);
  if (improves_interface)
    options.adaptation_interval = 1;
}

/// Adapts the mesh before an offset, which stretches the interface.
template <class Complex> void make_room(Complex& complex) {
  CGAL::Deformable_simplicial_complexes::Detail_options<Complex> options;
  options.collapse_length = 2;
  CGAL::Deformable_simplicial_complexes::control_detail(complex, options);
}

} // namespace dsc

#endif // DSC_MOTION_OPTIONS_H
