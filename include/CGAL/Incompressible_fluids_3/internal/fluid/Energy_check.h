// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_ENERGY_CHECK_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_ENERGY_CHECK_H

#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Energy_budget.h>

#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The check of an attempt at a time step by its energy.
struct Energy_check
{
  std::optional<Energy_budget> budget;
  std::optional<Fluid_failure> failure; // none if the rise of the energy is within its bound
  double rise = 0; // the unexplained rise, see `Energy_budget::rise()`, or the jump of a wall
  std::optional<Fluid_repetition::Point> place; // of the jump

  // Compares the present energy with the budget. The motion and changes of the mesh share the
  // unexplained rise, and the larger share determines the bound and the cause.
  // \pre There is a budget.
  template <class Report> void check(const Report& report, const Fluid_balance& now) {
    rise = budget->rise(now, report.volume_error);
    if (rise <= Energy_budget::tolerance)
      return;
    const double by_motion = report.moved.energy() - report.before.energy() - budget->supplied(),
                 by_mesh = now.energy() - report.moved.energy() + report.before.energy() -
                           budget->energy_at_begin();
    if (by_mesh <= by_motion)
      failure = Fluid_failure::motion;
    else if (rise > Energy_budget::tolerance_of_mesh)
      failure = Fluid_failure::mesh;
  }
};

// Returns a message of one line about the last failure of a step.
inline std::string message_of(const Fluid_repetition& failure, std::uint64_t step) {
  const auto cause = [&]() -> std::string {
    switch (failure.cause) {
    case Fluid_failure::equations:
      return "the equations of the flow have no accurate solution, with a relative residual of ";
    case Fluid_failure::motion:
      return "the motion increases the energy without a cause, by a fraction of ";
    case Fluid_failure::volume:
      return "the volume of a component cannot be restored, with a relative error of ";
    case Fluid_failure::walls:
      return "a wall moves by another displacement than its velocity gives, and the difference in "
             "edges is ";
    case Fluid_failure::mesh:
      break;
    }
    return "remeshing increases the energy without a cause, by a fraction of ";
  }();
  std::ostringstream message;
  message << "step " << step << " of the fluid at time " << failure.time << " failed: " << cause
          << failure.amount << ", near (" << failure.place.x() << ", " << failure.place.y() << ", "
          << failure.place.z() << "), even after remeshing and with a time step of " << failure.dt
          << (failure.cause == Fluid_failure::walls
                  ? "; use motions without jumps, with velocities that are their derivatives"
                  : "; use shorter time steps, shorter edges or another mesh");
  return message.str();
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_ENERGY_CHECK_H
