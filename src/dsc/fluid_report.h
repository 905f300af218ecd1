// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_REPORT_H
#define DSC_FLUID_REPORT_H

#include "fluid_scene.h"
#include "fluid_start.h"
#include "report_json.h"

#include <map>
#include <optional>
#include <string>

namespace dsc {

/// Returns the report of a state: after a step, or before the first step if there is no `report`.
Json step_json(const Fluid& fluid, const Fluid_scene& scene, unsigned step,
               const std::optional<Fluid::Report>& report);

/// A counter of repeated steps, and of rejected attempts by their cause.
class Repetitions
{
public:
  void add(const Fluid::Report& report);
  Json json() const { return {{"steps", m_steps}, {"attempts", m_attempts}}; }
  /// Returns the text for the summary; empty if no step was repeated.
  std::string text() const;

private:
  unsigned m_steps = 0;
  std::map<std::string, unsigned> m_attempts; // number by cause
};

} // namespace dsc

#endif // DSC_FLUID_REPORT_H
