// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_MOTION_OPTIONS_H
#define DSC_MOTION_OPTIONS_H

#include "motions/motion.h"

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>

#include <map>
#include <optional>

namespace dsc {

/// Sets the options of all motions. The run itself lets the domain grow.
template <class Complex>
void complete(CGAL::Deformable_simplicial_complexes::Advection_options<Complex>& options,
              const Step_options& step, unsigned threads) {
  options.deformation.number_of_threads = threads;
  options.deformation.domain_rule = CGAL::Deformable_simplicial_complexes::Domain_rule::stop;
  options.largest_displacement = step.largest_displacement.value_or(options.largest_displacement);
}

/// Returns the options of a motion that does not adapt the interface.
template <class Complex>
CGAL::Deformable_simplicial_complexes::Advection_options<Complex>
advection_options(const Step_options& step, unsigned threads) {
  CGAL::Deformable_simplicial_complexes::Advection_options<Complex> result;
  complete(result, step, threads);
  return result;
}

/// Completes the options of an adaptive motion. An interface that is improved before each step
/// needs mesh adaptation in each step, but no other changes of the interface.
/// \param tolerance of the interface; the default of the library if not set
template <class Complex>
void complete(CGAL::Deformable_simplicial_complexes::Adaptive_advection_options<Complex>& options,
              const std::optional<double>& tolerance, const Step_options& step, unsigned threads) {
  complete(options.advection, step, threads);
  options.interface_tolerance =
      step.improves_interface ? 0 : tolerance.value_or(options.interface_tolerance);
  if (step.improves_interface)
    options.adaptation_interval = 1;
}

/// Moves the interface by a little until each label has the volume that it had at the start of the
/// run. The smallest label takes the rest.
/// \param volumes in the unit of the input, of labels that may have vanished since
/// \param unit volume of the unit of the complex, in the unit of the input
/// \param visitor visitor of the changes; none if null
/// \param report of the step, which tells of the changes
template <class Complex>
void restore_start_volumes(
    Complex& complex, const std::map<int, double>& volumes, double unit, unsigned threads,
    CGAL::Deformable_simplicial_complexes::Any_visitor<Complex>* visitor,
    CGAL::Deformable_simplicial_complexes::Deformation_report<Complex>& report) {
  std::map<typename Complex::Label, double> kept;
  for (const auto& [label, volume] : volumes)
    if (complex.number_of_cells(label) > 0)
      kept.emplace(label, volume / unit);
  if (!kept.empty() && kept.begin()->first == complex.labels().front())
    kept.erase(kept.begin());
  CGAL::Deformable_simplicial_complexes::Volume_restoration_options<Complex> options;
  options.deformation.number_of_threads = threads;
  options.deformation.forbid_topology_changes();
  options.deformation.visitor = visitor;
  options.volume_tolerance = 1e-6; // errors of steps do not add up
  const unsigned parts = report.steps;
  for (const auto& next : restore_volumes(complex, kept, options).deformations)
    report.append(next);
  report.steps = parts;
}

/// Adapts the mesh before an offset in the plane or of whole faces, which stretches the interface.
template <class Complex>
void make_room(Complex& complex,
               CGAL::Deformable_simplicial_complexes::Any_visitor<Complex>* visitor) {
  CGAL::Deformable_simplicial_complexes::Detail_options<Complex> options;
  options.collapse_length = 2;
  options.visitor = visitor;
  CGAL::Deformable_simplicial_complexes::control_detail(complex, options);
}

} // namespace dsc

#endif // DSC_MOTION_OPTIONS_H
