// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_STEP_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_STEP_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Component_momenta.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Fluid_mesh.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Gas_components.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/Open_sides.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_passage.h>
#include <CGAL/Incompressible_fluids_3/internal/sides/side_velocities.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/pressure_matrix.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/relative_residual.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_equations.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Fluid_sources.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Roughness_damper.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Body_equations.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Vertex_constraints.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/Wall_contacts.h>
#include <CGAL/Incompressible_fluids_3/internal/walls/slip_flux.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The solution of one time step. The velocities and pressures are solved with the vertices at
// positions near the midpoint of the step. These positions follow from the velocities, and the
// contacts with walls follow from the velocities and pressures.
template <class Complex, class Solver> class Fluid_step
{
public:
  using Mesh = Fluid_mesh<Complex>;
  using Equations = Fluid_equations<Complex>;
  using Contacts = Wall_contacts<Complex>;
  using System = Saddle_point_system;
  using Vector = Eigen::VectorXd;

  // The loads on the liquids, and their boundary conditions.
  struct Loads
  {
    const Fluid_properties& properties;
    const typename Contacts::Solids& solids;
    const Side_behaviors& sides;
    std::vector<Gas_component> gases; // at the beginning of the step
    Fluid_sources sources;
  };

  // The time step. If begin and end are equal and solids move, the step is a projection: solids and
  // inflows have their present velocities, but all places stay. If they are equal and solids do not
  // move, only liquids move, for the time of the step.
  struct Interval
  {
    double begin, end;
    typename Equations::Step step;
    bool solids_move;
  };

  // Prepares the step that begins with the given flow. The complex, the flow, the solver, the
  // properties, the solids and the sides must outlive the object.
  Fluid_step(const Complex& complex, const Liquid_flow<Complex>& flow, const Loads& loads,
             const Interval& interval, Solver& solver, unsigned number_of_threads)
      : m_mesh(flow.mesh), m_properties(loads.properties), m_solver(solver),
        m_number_of_threads(number_of_threads), m_for_each(number_of_threads),
        m_step(interval.step), m_begin(interval.begin), m_end(interval.end),
        m_solids_move(interval.solids_move), m_positions(flow.positions), m_before(flow.velocities),
        m_accelerations(flow.accelerations), m_sides(loads.sides), m_gases(loads.gases),
        m_sources(loads.sources),
        m_equations(m_for_each, m_mesh, m_properties, m_step, m_positions),
        m_contacts(m_mesh, loads.solids, complex, m_positions, m_begin), m_solids(loads.solids),
        m_velocities_of_bodies(m_contacts.velocities_of_bodies()),
        m_edge(complex.mean_interface_edge()) {
    if (m_solids_move)
      m_open = Open_sides(m_mesh, m_sides, m_positions, middle_time());
    if (!m_open.empty())
      m_contacts.set_open_sides([this](std::size_t side, const Eigen::Vector3d& p) {
        return m_sides[side].pressure &&
               m_sides[side].pressure({p.x(), p.y(), p.z()}, middle_time());
      });
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      m_velocities.push_back(m_before[v] + m_step.theta * m_step.dt * m_accelerations[v]);
    m_pressures = Vector::Zero(Eigen::Index(m_mesh.vertex_of_pressure.size()));
  }

  // Solves the equations of the step. If the accelerations of the previous step are not known, they
  // are determined by fixed-point iteration.
  // \throws Convergence_error if the equations have no solution, or if the solver does not find one
  void solve(bool knows_accelerations) {
    static constexpr unsigned geometries = 2; // the predicted one, and that of the first solution
    static constexpr unsigned most = 15;
    static constexpr double tolerance = 5e-12; // of the solver
    // The relative change at which accelerations have converged. It is larger than the error of
    // the solver.
    static constexpr double same = 1e-10;
    for (unsigned k = 0; k < geometries; ++k) {
      assemble();
      if (k > 0 || knows_accelerations) {
        solve_with_contacts(k + 1 < geometries ? tolerance_of_geometry() : tolerance);
        continue;
      }
      double change = 1, size = 0;
      for (unsigned i = 0; i < most && change > same * size; ++i) {
        const Vectors_3 before = m_accelerations;
        solve_with_contacts(tolerance);
        change = size = 0;
        for (std::size_t v = 0; v < before.size(); ++v) {
          change = (std::max)(change, (before[v] - m_accelerations[v]).norm());
          size = (std::max)(size, m_accelerations[v].norm());
        }
      }
    }
    check_residual();
    require_room();
    end();
  }

  const Contacts& contacts() const { return m_contacts; }
  unsigned iterations() const { return m_iterations; }
  unsigned solutions() const { return m_solutions; }
  // Returns whether the search for the constrained vertices converged.
  bool is_settled() const { return m_is_settled; }

  // Returns the true residual of the solution, relative to the largest term of the equations.
  double residual() const { return m_residual; }
  std::size_t number_of_flat_cells() const { return m_equations.number_of_flat_cells(); }

  // Returns an upper bound of the energy that moving walls and sides supply to liquids in the step.
  double work_of_walls() const {
    double power =
        m_contacts.power(m_reactions) + (std::max)(0., m_pressures.dot(m_slip_flux.of_walls));
    for (std::size_t v = 0; v < m_positions.size(); ++v)
      if (const auto velocity = velocity_of_side(v))
        power += (std::max)(0., velocity->dot(m_reactions.segment<3>(3 * Eigen::Index(v))));
    // Walls that set the velocities at the end can supply energy, too.
    const double by_stop = m_equations.kinetic_energy(m_final_velocities) -
                           m_equations.kinetic_energy(m_unstopped_velocities);
    return m_step.dt * power + (std::max)(0., by_stop);
  }

  // Returns the work of gravity on liquids in the step if they are on a torus, where gravity has no
  // potential. Otherwise, returns 0.
  double work_of_gravity() const {
    if (!Mesh::is_periodic)
      return 0;
    const Eigen::Vector3d gravity(m_properties.gravity().data());
    double power = 0;
    for (std::size_t v = 0; v < m_velocities.size(); ++v)
      power += m_equations.masses()[v] * gravity.dot(m_velocities[v]);
    return m_step.dt * power;
  }

  // Returns an upper bound of the energy that sources supply in the step, less the energy that
  // drains remove. It consists of the kinetic and potential energy of the new liquid, and of the
  // work of its pressure. The potential of gravity is 0 at `level`, and everywhere on a torus.
  double work_of_sources(const Eigen::Vector3d& level) const {
    const std::vector<double> gains = gains_without_open_sides();
    const Eigen::Vector3d gravity = Mesh::is_periodic
                                        ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                        : Eigen::Vector3d(m_properties.gravity().data());
    double power = m_pressures.dot(m_equations.sources(m_gains));
    for (std::size_t k = 0; k < gains.size(); ++k)
      power += m_mesh.cells[k].liquid->density * gains[k] *
               (m_mesh.middle(k, m_velocities).squaredNorm() / 2 -
                gravity.dot(m_mesh.middle(k, m_midpoint_positions) - level));
    // Relative to the power: the stabilization also affects sources.
    static constexpr double error = .25;
    return m_step.dt * (power + error * std::abs(power));
  }

  // Returns an upper bound of the energy that enters through open sides in the step: the work of
  // the pressure outside, and the kinetic and potential energy of the liquid that passes. The
  // potential of gravity is 0 at `level`.
  double work_of_open_sides(const Eigen::Vector3d& level) const {
    // Relative to the sum of absolute terms: the liquid at the vertices is the liquid that passes
    // up to the discretization.
    static constexpr double error = .25;
    const Eigen::Vector3d gravity(m_properties.gravity().data());
    double power = 0, size = 0;
    const auto add = [&](double term) {
      power += term;
      size += std::abs(term);
    };
    const Vector forces = forces_of_open_sides();
    for (std::size_t v = 0; v < m_velocities.size(); ++v)
      add(m_velocities[v].dot(forces.segment<3>(3 * Eigen::Index(v))));
    for_each_passage([&](std::size_t k, std::size_t v, double gain, std::size_t) {
      add(m_mesh.cells[k].liquid->density * gain *
          (m_velocities[v].squaredNorm() / 2 - gravity.dot(m_midpoint_positions[v] - level)));
    });
    return m_step.dt * (power + error * size);
  }

  // Returns the volume that enters through each side of the domain in a unit of time, less the
  // volume that leaves.
  std::array<double, 6> flux_through_sides() const {
    std::array<double, 6> result = {};
    for_each_passage(
        [&](std::size_t, std::size_t, double gain, std::size_t side) { result[side] += gain; });
    side_fluxes().for_each_inflow([&](double gain, std::size_t side) { result[side] += gain; });
    return result;
  }

  // Returns the pressures, in the order of the mesh.
  const Vector& pressures() const { return m_pressures; }

  const Vectors_3& destinations() const { return m_destinations; }

  // Returns the velocities at the end of the step.
  const Vectors_3& final_velocities() const { return m_final_velocities; }

  // Returns the mean accelerations of liquids in the step.
  const Vectors_3& final_accelerations() const { return m_final_accelerations; }

  // Returns whether liquid can pass a side of the domain at a vertex.
  bool is_passage(std::size_t v) const { return is_inflow(m_inflow, v) || m_open.sides(v) != 0; }

  // Returns a field at the end of the step, where vertices do not move with the liquid that
  // carries it. Where liquid enters, the field keeps its value. The field has one
  // value for each vertex of the mesh.
  std::vector<double> carried(std::vector<double> field) const {
    Vectors_3 shifts = shifts_in_liquid(), values;
    for (std::size_t v = 0; v < field.size(); ++v) {
      values.emplace_back(field[v], 0, 0);
      for (std::size_t side = 0; side < m_sides.size() && is_inflow(m_inflow, v); ++side)
        if (m_sides[side].inflow && m_mesh.vertices[v]->boundary_class() >> side & 1 &&
            m_inflow[v]->dot(normal_of_side(side)) > 0) // liquid leaves
          shifts[v] = -m_step.dt * *m_inflow[v];
    }
    for (const auto& change : changes_by_shifts(m_mesh, positions_of_liquid(), shifts, values))
      field[change.vertex] += change.velocity.x();
    return field;
  }

  // Returns the solution of the equations: the velocities at the time theta dt, at which forces
  // act.
  const Vectors_3& solved_velocities() const { return m_velocities; }

  // Returns the momentum of a set of masses at the end of the step, without the effects of
  // `Wall_contacts::constrain_at_end()` and of new liquid. It is the initial momentum plus the
  // impulses of gravity, gases and walls. The forces between the vertices of a set cancel.
  Momentum pushed_momentum(const Masses& masses) const {
    if (masses.of_vertices.empty())
      return {};
    Momentum result = momentum(m_mesh, masses, m_positions, m_before);
    // With lever arms at this time, the impulses change the angular momentum by the same amount as
    // the whole step.
    const double time_of_arms = (1 - m_step.theta) * m_step.dt;
    const Eigen::Vector3d gravity(m_properties.gravity().data());
    const Vectors_3 moving = m_mesh.common(m_velocities);
    for (const auto& [v, m] : masses.of_vertices) {
      const double mass = m / (1 - Mesh::part_at_middle), share = mass / m_equations.masses()[v];
      const Eigen::Vector3d pushed =
          m_step.dt * (mass * gravity + share * m_reactions.segment<3>(3 * Eigen::Index(v)));
      result.linear += pushed;
      const Eigen::Vector3d arm = is_inflow(m_inflow, v)
                                      ? m_positions[v]
                                      : Eigen::Vector3d(m_positions[v] + time_of_arms * moving[v]);
      result.angular += arm.cross(pushed);
      const Vector& pushes = m_equations.pushes();
      const Eigen::Vector3d push = m_step.dt * share * pushes.segment<3>(3 * Eigen::Index(v));
      result.linear += push;
      result.angular += m_midpoint_positions[v].cross(push);
    }
    return result;
  }

  // Returns the volume that each cell of the mesh gains in a unit of time, from sources, by inflow
  // and through open sides. The result is empty without all of them.
  std::vector<double> gains() const {
    std::vector<double> result = gains_without_open_sides();
    if (!m_open.empty())
      result.resize(m_mesh.cells.size(), 0);
    for_each_passage(
        [&](std::size_t k, std::size_t, double gain, std::size_t) { result[k] += gain; });
    return result;
  }

  // Returns the volume that each cell gains in a unit of time, from sources and by inflow. The
  // result is empty without both.
  std::vector<double> gains_without_open_sides() const {
    std::vector<double> result = m_gains;
    if (!m_inflow.empty())
      result.resize(m_mesh.cells.size(), 0);
    for (std::size_t k = 0; k < m_mesh.cells.size() && !m_inflow.empty(); ++k)
      for (std::size_t i = 0; i < Mesh::corners; ++i)
        result[k] += side_fluxes().by_inflow(k, i);
    return result;
  }

  // Returns the momentum of a set of masses at the end of the step, with the effects of
  // `Wall_contacts::constrain_at_end()` and of new liquid. Where liquid passes through an open
  // side, the liquid that passes takes the difference to the momentum at the end.
  Momentum final_momentum(const Masses& masses) const {
    if (masses.of_vertices.empty())
      return {};
    if (std::any_of(masses.of_vertices.begin(), masses.of_vertices.end(),
                    [this](const auto& entry) { return m_open.sides(entry.first) != 0; }))
      return momentum(m_mesh, masses_at(m_mesh, masses, m_destinations), m_destinations,
                      m_final_velocities);
    Momentum result = pushed_momentum(masses);
    const auto add = [&](std::size_t k, double gain, const Eigen::Vector3d& velocity,
                         const Eigen::Vector3d& position) {
      const Eigen::Vector3d brought = m_step.dt * m_mesh.cells[k].liquid->density * gain * velocity;
      result.linear += brought;
      result.angular += position.cross(brought);
    };
    for (const auto& of_middle : masses.of_middles) {
      const std::size_t k = of_middle.first;
      // New liquid has the velocity of the liquid around it.
      if (!m_gains.empty())
        add(k, m_gains[k], m_mesh.middle(k, m_velocities), m_mesh.middle(k, m_midpoint_positions));
      for (std::size_t i = 0; i < Mesh::corners && !m_inflow.empty(); ++i) {
        const std::size_t v = m_mesh.cells[k].vertices[i];
        if (m_inflow[v])
          add(k, side_fluxes().by_inflow(k, i), *m_inflow[v], m_midpoint_positions[v]);
      }
    }
    const Momentum stopped = momentum(m_mesh, masses, m_destinations, m_final_velocities),
                   unstopped = momentum(m_mesh, masses, m_destinations, m_unstopped_velocities);
    result.linear += stopped.linear - unstopped.linear;
    result.angular += stopped.angular - unstopped.angular;
    return result;
  }

  // Returns the energy that bodies lose in the step: the energy that they supply to liquids.
  double work_of_bodies() const {
    const Eigen::Vector3d gravity(m_properties.gravity().data());
    double result = 0;
    for (std::size_t k = 0; k < m_final_velocities_of_bodies.size(); ++k) {
      const Body_inertia inertia = inertia_of_body(k);
      const Body_velocity before = m_velocities_of_bodies[k];
      const Body_place from = m_contacts.place_of_body(k, m_begin),
                       to = m_contacts.place_of_body(k, m_end);
      result += inertia.energy(from.rotation, before) -
                inertia.energy(to.rotation, m_final_velocities_of_bodies[k]) +
                inertia.mass() * gravity.dot(to.center - from.center);
    }
    return result;
  }

  // Returns the velocities of bodies at the end of the step. They are numbered in the order of
  // solids. The result is empty if solids do not move.
  const std::vector<Body_velocity>& final_velocities_of_bodies() const {
    return m_final_velocities_of_bodies;
  }

  // Returns the mean force and torque of liquids on each solid in the step.
  std::vector<typename Contacts::Load> loads_on_solids() const {
    return m_contacts.loads(forces_on_vertices(), m_midpoint_positions);
  }

  // Returns the mean forces of walls and of sides of the domain on vertices in the step.
  Vector forces_on_vertices() const {
    Vector result = m_reactions;
    for (std::size_t v = 0; v < m_final_velocities.size(); ++v)
      result.segment<3>(3 * Eigen::Index(v)) +=
          m_equations.masses()[v] / m_step.dt * (m_final_velocities[v] - m_unstopped_velocities[v]);
    return result;
  }

private:
  // Returns the forces of the pressures and of the surfaces beyond open sides on vertices.
  Vector forces_of_open_sides() const {
    return m_open.forces(m_mesh, m_midpoint_positions) +
           m_open.forces_of_surfaces(m_mesh, m_midpoint_positions,
                                     [this](std::size_t f) { return m_contacts.tension(f); });
  }

  Side_fluxes<Complex> side_fluxes() const {
    return {m_mesh, m_sides, m_inflow, m_open, m_midpoint_positions};
  }

  // Calls `f(cell, vertex, gain, side)` for each gain of a cell through an open side.
  template <class Function> void for_each_passage(const Function& f) const {
    if (!m_open.empty())
      side_fluxes().for_each_passage(m_velocities, velocities_of_vertices(), f);
  }

  double middle_time() const { return (m_begin + m_end) / 2; }

  // Returns the velocities with which vertices move. They differ from the solved velocities at
  // inlets and near open sides, where vertices do not follow the liquid.
  Vectors_3 velocities_of_vertices() const {
    Vectors_3 result = m_mesh.common(m_velocities);
    const Vectors_3 returns = returns_of_vertices();
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] += returns[v] / m_step.dt;
    for (std::size_t v = 0; v < result.size(); ++v)
      if (is_inflow(m_inflow, v))
        result[v].setZero();
    return result;
  }

  // Returns the positions at the end of the step of vertices that would follow the liquid.
  Vectors_3 positions_of_liquid() const {
    Vectors_3 result = m_mesh.common(m_velocities);
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = m_positions[v] + m_step.dt * result[v];
    return result;
  }

  // Returns the displacements of vertices from the liquid. They keep vertices on open sides and in
  // front of them, and in front of the ends of walls.
  Vectors_3 returns_of_vertices() const {
    const Vectors_3 moved = positions_of_liquid();
    Vectors_3 result =
        returns_from_sides(m_mesh, {m_sides, m_open, middle_time(), m_edge}, m_positions, moved);
    const Vectors_3 from_ends = m_contacts.returns_from_ends(moved, m_step.dt);
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] += from_ends[v];
    for (const auto& slip : m_mesh.slips) // both occurrences of a vertex move together
      result[slip.second] = result[slip.first];
    return result;
  }

  // Returns the displacements of vertices from the liquid. They are zero where liquid enters.
  Vectors_3 shifts_in_liquid() const {
    Vectors_3 result = returns_of_vertices();
    for (std::size_t v = 0; v < result.size(); ++v)
      for (std::size_t side = 0; side < m_sides.size(); ++side)
        if (is_inflow(m_inflow, v) ||
            (m_open.sides(v) >> side & 1 && result[v].dot(normal_of_side(side)) > 0))
          result[v].setZero();
    return result;
  }

  // Adds the changes of velocities at vertices that do not move with the liquid.
  void change_velocities_by_shifts() {
    if (projects())
      return;
    for (const auto& change :
         changes_by_shifts(m_mesh, positions_of_liquid(), shifts_in_liquid(), m_final_velocities)) {
      m_final_velocities[change.vertex] += change.velocity;
      m_unstopped_velocities[change.vertex] += change.velocity;
    }
  }

  // Returns the tolerance of a solution that only determines the geometry of the next solution. It
  // is proportional to the change of velocities, relative to the change by the loads without
  // pressures. So a fluid at rest stays at rest.
  double tolerance_of_geometry() const {
    static constexpr double part = 1e-4, finest = 1e-9, coarsest = 1e-4;
    const Vector loads = m_equations.forces(Vectors_3(m_before.size(), Eigen::Vector3d::Zero()));
    const std::vector<double> masses = m_equations.masses_of_unknowns();
    double changes = 0, all = 0; // sums of squares, weighted by masses
    for (std::size_t v = 0; v < m_before.size(); ++v) {
      changes += m_equations.masses()[v] * m_accelerations[v].squaredNorm();
      all += loads.segment<3>(3 * Eigen::Index(v)).squaredNorm() / masses[v];
    }
    const double result = part * std::sqrt(changes / all);
    return result < coarsest ? (std::max)(result, finest) : coarsest; // also if the result is NaN
  }

  // Checks the true residual. The check uses the system, but no result of the solver other than the
  // solution.
  // \throws Convergence_error if the residual is above its bound
  void check_residual() {
    System system = constrained_system();
    system.closed = m_closed;
    const Solution& last = m_last_solution;
    m_residual = relative_residual(system, last.f, last.s, last.v, last.p);
    if (!(m_residual <= largest_residual))
      throw Convergence_error("the solution of the equations of the flow is not accurate: cells "
                              "may be too flat, or the time step may be too long",
                              m_residual, largest_residual);
  }

  // Checks that a liquid without a free surface neither gains nor loses volume by sources and
  // inflows. Its equations have a solution nevertheless, because closed sets have an additional
  // pressure.
  // \throws Error if it does
  void require_room() const {
    static constexpr double largest = 1e-6; // gain in a step, relative to the volume
    if (m_closed.empty())
      return;
    const std::vector<double> gains = gains_without_open_sides();
    if (gains.empty())
      return;
    std::vector<std::size_t> set_of_pressure(std::size_t(m_pressures.size()), m_closed.size());
    for (std::size_t k = 0; k < m_closed.size(); ++k)
      for (Eigen::Index p : m_closed[k].pressures)
        set_of_pressure[std::size_t(p)] = k;
    std::vector<double> gain(m_closed.size() + 1, 0), whole = gain;
    for (std::size_t k = 0; k < gains.size(); ++k) {
      const auto& cell = m_mesh.cells[k];
      const std::size_t set = set_of_pressure[cell.pressures[0]];
      gain[set] += gains[k] * m_step.dt;
      whole[set] += volume(m_mesh.corners_at(cell.vertices, m_midpoint_positions));
    }
    for (std::size_t k = 0; k < m_closed.size(); ++k)
      if (std::abs(gain[k]) > largest * whole[k])
        throw Error(std::string("a liquid without a free surface ") +
                    (gain[k] > 0 ? "gains" : "loses") +
                    " volume by sources or inflows: add an open side or a gas");
  }

  // Computes the destinations and the velocities at the end of the step, with damping and contacts.
  // \throws Convergence_error if a velocity is not finite
  void end() {
    Vectors_3 velocities;
    for (std::size_t v = 0; v < m_before.size(); ++v)
      velocities.push_back(m_before[v] + (m_velocities[v] - m_before[v]) / m_step.theta);
    m_destinations = at_time(m_step.dt);
    const Roughness_damper<Mesh> damper(m_mesh, m_destinations);
    m_unstopped_velocities = damper.damped(velocities, m_equations.masses(), m_step.dt);
    m_final_velocities = m_unstopped_velocities;
    Vertex_constraints constraints(m_positions.size());
    m_contacts.constrain_at_end(m_destinations, m_end, constraints);
    constraints.close();
    if (bodies_move())
      m_final_velocities_of_bodies = m_bodies.after_impact(
          m_bodies.final_velocities(m_contacts.velocities_of_bodies(), m_step.dt),
          m_unstopped_velocities, m_equations.masses(), constraints);
    constraints.apply(m_final_velocities_of_bodies, m_final_velocities);
    const Inflow_velocities inflow = m_solids_move
                                         ? inflow_velocities(m_mesh, m_sides, m_destinations, m_end)
                                         : Inflow_velocities();
    const Open_sides open =
        m_solids_move ? Open_sides(m_mesh, m_sides, m_destinations, m_end) : Open_sides();
    stop_on_sides(m_mesh, m_sides, inflow, open, m_final_velocities);
    for (std::size_t v = 0; v < m_final_velocities.size(); ++v)
      m_final_accelerations.push_back((m_final_velocities[v] - m_before[v]) / m_step.dt);
    for (const auto& change :
         changes_by_slip(m_mesh, m_destinations, m_velocities, m_final_velocities, m_step.dt)) {
      m_final_velocities[change.vertex] += change.velocity;
      m_unstopped_velocities[change.vertex] += change.velocity;
    }
    change_velocities_by_shifts();
    stop_on_sides(m_mesh, m_sides, inflow, open, m_final_velocities);
    for (std::size_t v = 0; v < m_final_velocities.size(); ++v)
      if (!m_final_velocities[v].allFinite() || !m_velocities[v].allFinite())
        throw Convergence_error("the equations of the flow have no finite solution: the time step "
                                "may be too short or too long, or cells may be flat",
                                std::numeric_limits<double>::infinity(), largest_residual);
  }

  // Returns the positions of vertices after a time t of the step.
  Vectors_3 at_time(double t) const { return projects() ? m_positions : moved(t); }

  bool projects() const { return m_solids_move && m_end == m_begin; }

  // Returns the positions of vertices that move with the solved velocities for a time t.
  Vectors_3 moved(double t) const {
    Vectors_3 result = velocities_of_vertices();
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
      result[v] =
          is_inflow(m_inflow, v) ? m_positions[v] : Eigen::Vector3d(m_positions[v] + t * result[v]);
      for (int axis = 0; axis < 3; ++axis) // without rounding
        if (Boundary_class::fixes(m_open.sides(v), axis))
          result[v][axis] = m_positions[v][axis];
    }
    return result;
  }

  // Assembles the equations for the geometry that the present velocities predict.
  void assemble() {
    if (m_solids_move)
      m_inflow = inflow_velocities(m_mesh, m_sides, m_positions, (m_begin + m_end) / 2);
    m_contacts.predict(moved(m_step.dt), m_begin, m_end, m_step.dt, m_solids_move);
    m_midpoint_positions = at_time(m_step.dt / 2);
    const std::vector<double> volumes =
        volumes_of_gases(m_mesh, m_gases, m_positions, m_midpoint_positions);
    std::vector<double> pressures;
    for (std::size_t k = 0; k < m_gases.size(); ++k)
      pressures.push_back(m_gases[k].pressure(volumes[k]));
    m_equations.assemble(
        m_midpoint_positions, m_velocities, [&](std::size_t f) { return m_contacts.tension(f); },
        pressures);
    if (!m_open.empty())
      m_equations.add_pushes(forces_of_open_sides());
    m_gains =
        gains_of_cells(m_sources, m_mesh, m_midpoint_positions, (m_begin + m_end) / 2, m_step.dt);
    m_is_assembled = false;
  }

  // Solves the equations, and revises the contacts until they do not change.
  void solve_with_contacts(double accuracy) {
    static constexpr unsigned rounds = 30;
    m_is_settled = false;
    for (unsigned round = 0; round < rounds && !m_is_settled; ++round) {
      solve_with_constraints(accuracy);
      m_is_settled = !m_contacts.revise(flat(m_velocities), m_reactions, round);
      m_is_assembled = m_is_assembled && m_is_settled;
    }
    for (std::size_t v = 0; v < m_velocities.size(); ++v)
      m_accelerations[v] = (m_velocities[v] - m_before[v]) / (m_step.theta * m_step.dt);
  }

  // Solves the equations with the present contacts.
  void solve_with_constraints(double accuracy) {
    if (!m_is_assembled)
      assemble_constraints();
    const auto& system = m_equations.system();
    const Vector& known = m_constraints.prescribed();
    const Vector f = m_equations.forces(m_before),
                 s = m_equations.stabilization(m_accelerations) + m_equations.sources(m_gains);
    Solution& last = m_last_solution;
    last.f = m_bodies.forces(f - system.multiply_a(known));
    last.s = s - m_b * known + m_slip_flux.of_walls;
    Vector v = flat(m_velocities);
    m_equations.slips().to_unknowns(v);
    last.v = m_bodies.unknowns(v - known, m_contacts.velocities_of_bodies());
    m_iterations += m_solver.solve(last.f, last.s, last.v, m_pressures, accuracy);
    ++m_solutions;
    last.p = m_pressures;
    if (bodies_move())
      m_contacts.set_velocities_of_bodies(m_bodies.velocities_of_bodies(last.v));
    // The constant in the pressures of a closed set is arbitrary. With a least pressure of 0, it
    // causes no negative normal forces at walls.
    for (const auto& set : m_closed) {
      double least = std::numeric_limits<double>::infinity();
      for (Eigen::Index p : set.pressures)
        least = (std::min)(least, m_pressures(p));
      set.add(-least, m_pressures);
    }
    v = known + m_bodies.velocities(last.v);
    m_reactions = system.multiply_a(v) - system.b.transpose() * m_pressures - f;
    // Clears the reactions of relative velocities: the forces between two liquids cancel.
    for (const auto& slip : m_mesh.slips)
      m_reactions.segment<3>(3 * Eigen::Index(slip.second)).setZero();
    m_equations.slips().to_velocities(v);
    for (std::size_t i = 0; i < m_velocities.size(); ++i)
      m_velocities[i] = v.segment<3>(3 * Eigen::Index(i));
  }

  // Adds the constraints to the system. The factorization for the first geometry is also used for
  // the others.
  void assemble_constraints() {
    m_constraints = Vertex_constraints(m_positions.size());
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
      if (m_open.sides(v) != 0 && !is_inflow(m_inflow, v)) {
        constrain_at_open_side(v);
        continue;
      }
      const auto sticking = velocity_of_side(v);
      for (int axis = 0; axis < 3; ++axis)
        if (axis >= Mesh::dimension ||
            (Boundary_class::fixes(m_mesh.vertices[v]->boundary_class(), axis) &&
             !is_inflow(m_inflow, v)))
          m_constraints.add(v, {Eigen::Vector3d::Unit(axis), 0});
        else if (sticking) // the second occurrence has the relative velocity of liquids
          m_constraints.add(v, {Eigen::Vector3d::Unit(axis),
                                v < m_mesh.number_of_vertices() ? (*sticking)[axis] : 0});
    }
    m_contacts.constrain(m_constraints);
    constrain_slips();
    m_constraints.close();
    m_slip_flux = slip_flux(m_mesh, m_contacts, m_constraints.constrained(), m_midpoint_positions);
    m_b = m_equations.system().b;
    if (m_slip_flux.matrix.nonZeros() > 0)
      m_b += m_slip_flux.matrix;
    m_bodies = {moving_bodies(), m_step.theta * m_step.dt,
                Eigen::Vector3d(m_properties.gravity().data()), m_positions.size(), m_constraints};
    System system = constrained_system();
    system.closed = m_closed = closed_sets(system);
    if (m_is_factorized)
      m_solver.update(std::move(system));
    else
      m_solver.factorize(std::move(system), m_number_of_threads);
    m_is_factorized = m_is_assembled = true;
  }

  // Adds the constraints of a vertex on an open side. The second occurrence of a vertex has the
  // relative velocity of liquids.
  void constrain_at_open_side(std::size_t v) {
    const auto prescribed = coordinates_at_open_vertex(m_mesh, m_sides, m_open.sides(v), v);
    for (int axis = 0; axis < 3; ++axis)
      if (axis >= Mesh::dimension || prescribed[std::size_t(axis)])
        m_constraints.add(v, {Eigen::Vector3d::Unit(axis),
                              axis < Mesh::dimension && v < m_mesh.number_of_vertices()
                                  ? *prescribed[std::size_t(axis)]
                                  : 0});
  }

  // Returns the system with the constraints and the bodies, but without closed sets.
  System constrained_system() const {
    System result = m_equations.system();
    result.b = m_b;
    result.constrained = m_constraints.constrained();
    m_bodies.extend(result, m_slip_flux.of_bodies);
    return result;
  }

  bool bodies_move() const { return m_solids_move && m_contacts.number_of_bodies() > 0; }

  Body_inertia inertia_of_body(std::size_t k) const {
    return {*m_solids[m_contacts.solid_of_body(k)].body, Mesh::dimension};
  }

  // Returns the bodies that move in the step.
  std::vector<Body_equations::Body> moving_bodies() const {
    std::vector<Body_equations::Body> result;
    for (std::size_t k = 0; bodies_move() && k < m_contacts.number_of_bodies(); ++k)
      result.push_back({inertia_of_body(k), m_velocities_of_bodies[k],
                        m_contacts.place_of_body(k, m_begin),
                        m_contacts.place_of_body(k, (m_begin + m_end) / 2)});
    return result;
  }

  std::optional<Eigen::Vector3d> velocity_of_side(std::size_t v) const {
    return is_inflow(m_inflow, v) ? m_inflow[v] : no_slip_velocity(m_mesh, m_sides, v);
  }

  // Permits two liquids to slip only along their interface: perpendicular to the gradients of their
  // volumes. So the velocity of the vertex determines how their volumes change.
  void constrain_slips() {
    if (m_mesh.slips.empty())
      return;
    Vectors_3 areas(m_positions.size(), Eigen::Vector3d::Zero());
    for (const auto& facet : m_mesh.facets) {
      const Eigen::Vector3d area =
          area_vector(m_mesh.corners_at(facet.vertices, m_midpoint_positions));
      for (auto corner : facet.vertices)
        areas[corner] += m_mesh.is_first_behind(facet) ? area : Eigen::Vector3d(-area);
    }
    for (const auto& slip : m_mesh.slips) {
      const Eigen::Vector3d normal = areas[slip.first].normalized();
      if (normal.allFinite() && !normal.isZero())
        m_constraints.add(slip.second, {normal, 0});
      else
        for (int axis = 0; axis < 3; ++axis)
          m_constraints.add(slip.second, {Eigen::Vector3d::Unit(axis), 0});
    }
  }

  static Vector flat(const Vectors_3& vectors) {
    Vector result(3 * Eigen::Index(vectors.size()));
    for (std::size_t i = 0; i < vectors.size(); ++i)
      result.segment<3>(3 * Eigen::Index(i)) = vectors[i];
    return result;
  }

  // The right side of a system, and the solution of the solver.
  struct Solution
  {
    Vector f, s, v, p;
  };

  const Mesh& m_mesh;
  const Fluid_properties& m_properties;
  Solver& m_solver;
  unsigned m_number_of_threads;
  For_each_index m_for_each;
  typename Equations::Step m_step;
  double m_begin, m_end; // times
  bool m_solids_move;
  Vectors_3 m_positions, m_before, m_accelerations, m_velocities, m_unstopped_velocities,
      m_final_velocities, m_final_accelerations;
  const Side_behaviors& m_sides;
  std::vector<Gas_component> m_gases;
  Fluid_sources m_sources;
  Inflow_velocities m_inflow; // in the middle of the step; empty if solids do not move
  Open_sides m_open;          // the same
  Vectors_3 m_destinations;
  Vectors_3 m_midpoint_positions; // positions at which the equations were assembled
  std::vector<double> m_gains;    // volume per unit of time, by cell
  Vector m_pressures, m_reactions;
  Equations m_equations;
  Contacts m_contacts;
  const typename Contacts::Solids& m_solids;
  std::vector<Body_velocity> m_velocities_of_bodies, m_final_velocities_of_bodies;
  double m_edge; // the mean edge of the initial interface
  Vertex_constraints m_constraints{0};
  Body_equations m_bodies;
  std::vector<System::Closed_set> m_closed;
  Slip_flux m_slip_flux;
  System::Matrix m_b; // with the correction for slip
  bool m_is_factorized = false, m_is_assembled = false, m_is_settled = false;
  unsigned m_iterations = 0, m_solutions = 0;
  Solution m_last_solution;
  double m_residual = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_STEPS_FLUID_STEP_H
