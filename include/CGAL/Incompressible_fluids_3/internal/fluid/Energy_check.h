// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_ENERGY_CHECK_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_ENERGY_CHECK_H

#include <CGAL/Incompressible_fluids_3/Fluid_report.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>

#include <sstream>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The energy that liquids may have at the end of a time step: the initial energy, plus the energy
// that moving walls and sources supply. The potential of gravity is 0 at the vertex that is lowest
// at the beginning. So the result does not depend on the position of the origin.
class Energy_budget
{
public:
  // The bound on the unexplained rise by the motion, in units of the scale of energies. It is
  // larger than the error of a step that resolves the flow, and much smaller than the growth of an
  // unstable flow.
  static constexpr double tolerance = 1e-3;
  // The bound on the unexplained rise by changes of the mesh, in the same unit. At a contact line
  // on a coarse mesh, such changes wet or dry whole facets.
  static constexpr double tolerance_of_mesh = .05;

  // Constructs the budget at the beginning of a step. `energy_of_springs` is the sum of pressure
  // times volume over compressible gases.
  Energy_budget(const Fluid_balance& before, const Eigen::Vector3d& gravity,
                const Vectors_3& positions, double energy_of_springs)
      : m_gravity(gravity), m_springs(energy_of_springs), m_given(before.energy()) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : positions)
      if (const double potential = -gravity.dot(p); potential < least) {
        least = potential;
        m_level = p;
      }
    m_begin = energy(before);
    m_scale = scale(before);
  }

  // Returns the vertex at which the potential of gravity is 0.
  const Eigen::Vector3d& level() const { return m_level; }

  // Adds an energy supplied by walls or sources.
  void supply(double energy) { m_supplied += energy; }

  double supplied() const { return m_supplied; }
  // Returns the initial energy, as defined by `Fluid_balance::energy()`.
  double energy_at_begin() const { return m_given; }

  // Returns the unexplained rise of the energy, relative to the scale of energies. The scale is the
  // sum of the kinetic energy, the absolute surface energy, the absolute potential and the energy
  // of springs, at the beginning or now, whichever is larger. Returns infinity if numbers are not
  // finite.
  //
  // A relative error of volumes causes an error of the energies of gases. A pressure can be
  // arbitrarily large without an effect, so this error can exceed all other energies. It is not
  // counted as a rise.
  double rise(const Fluid_balance& now, double error_of_volumes) const {
    static constexpr double rounding = 1e-10; // of sums over cells, relative
    const double excess = energy(now) - m_begin - m_supplied,
                 size = (std::max)(m_scale, scale(now)),
                 noise = rounding * (size + std::abs(now.potential_energy)) +
                         (rounding + error_of_volumes) * std::abs(now.gas_energy);
    if (!std::isfinite(excess) || !std::isfinite(size))
      return std::numeric_limits<double>::infinity();
    return excess > noise ? excess / size : 0;
  }

private:
  double potential(const Fluid_balance& balance) const {
    return balance.potential_energy + balance.mass * m_gravity.dot(m_level);
  }
  double energy(const Fluid_balance& balance) const {
    return balance.kinetic_energy + potential(balance) + balance.surface_energy +
           balance.gas_energy;
  }
  double scale(const Fluid_balance& balance) const {
    return balance.kinetic_energy + std::abs(potential(balance)) +
           std::abs(balance.surface_energy) + m_springs;
  }

  Eigen::Vector3d m_gravity, m_level = Eigen::Vector3d::Zero();
  double m_springs, m_given, m_begin = 0, m_scale = 0, m_supplied = 0;
};

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
