// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_REPORT_H
#define DSC_FLUID_REPORT_H

#include "fluids/fluid_of_dimension.h"
#include "fluids/fluid_scene.h"
#include "output/report_json.h"

namespace dsc {

/// Returns the report of a state: after a step, or before the first step if there is no `report`.
/// Points and vectors have three coordinates, also in the plane.
template <class Complex>
Json step_json(const Fluid<Complex>& fluid, const Fluid_scene& scene, unsigned step,
               const std::optional<DSC::Fluid_report<Complex>>& report);

/// A counter of repeated steps, and of rejected attempts by their cause.
class Repetitions
{
public:
  void add(const std::vector<DSC::Fluid_repetition>& repetitions);
  Json json() const { return {{"steps", m_steps}, {"attempts", m_attempts}}; }
  /// Returns the text for the summary; empty if no step was repeated.
  std::string text() const;

private:
  unsigned m_steps = 0;
  std::map<std::string, unsigned> m_attempts; // number by cause
};

/// Returns the values of the probes of a scene by name. A value that does not exist is null.
template <class Complex> Json probes_json(const Fluid_scene& scene, const Fluid<Complex>& fluid);

} // namespace dsc

#endif // DSC_FLUID_REPORT_H
