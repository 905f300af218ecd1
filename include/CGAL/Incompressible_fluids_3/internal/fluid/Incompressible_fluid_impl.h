// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_IMPL_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_IMPL_H

// Member functions of Incompressible_fluid that perform a time step. The class includes this file.
#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

namespace CGAL::Deformable_simplicial_complexes {

// Moves the liquids to an equilibrium of forces, see `relax()`.
template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::relax(double dt, unsigned steps, Options chosen) {
  // Relative to the velocity of the first step, and to an edge in a step.
  static constexpr double rest = 1e-14;
  static constexpr double longest_displacement = .3; // in edges: forces change over an edge
  chosen.check();
  chosen.implicitness = 1;
  require_step(dt);
  if (Mesh::is_periodic && m_properties.gravity() != std::array<double, 3>())
    throw Error("relax() needs the potential of gravity, which does not exist on a torus: set "
                "gravity to 0, or call advance()");
  Report report;
  const auto stop = [this](void*) {
    m_motion.stop();
    m_knows_accelerations = false;
  };
  const std::unique_ptr<void, decltype(stop)> stops_in_the_end(this, stop);
  stop(this);
  if (chosen.adaptation_interval > 0)
    adapt(chosen, internal::Mesh_treatment::chosen, report);
  double first = 0, velocity = 0;
  internal::Fixed_point_accelerator accelerator;
  Eigen::VectorXd last; // the coordinates of the interface after the previous step
  const auto move_interface = [&](const Eigen::VectorXd& coordinates) {
    const Flow flow(*this, m_properties);
    this->move_interface(flow, flow.contacts(*this), coordinates, chosen, report);
  };
  for (unsigned k = 0; k < steps; ++k) {
    const std::vector<std::size_t> before = stamps_of_interface();
    const Eigen::VectorXd from = coordinates_of_interface(last);
    report = {};
    step(dt, m_time, chosen, longest_displacement, report, nullptr);
    stop(this);
    velocity = report.greatest_velocity;
    first = k == 0 ? velocity : first;
    if (velocity <= rest * (std::max)(first, mean_edge() / dt))
      break;
    if (before != stamps_of_interface()) {
      accelerator.forget();
      continue;
    }
    const Eigen::VectorXd to = last = coordinates_of_interface(from);
    const double energy = balance().energy();
    const Eigen::VectorXd next = accelerator.next(from, to);
    if (!((next - to).lpNorm<Eigen::Infinity>() <= mean_edge())) {
      accelerator.forget(); // the extrapolation is too far or not finite
      continue;
    }
    move_interface(next);
    if (before != stamps_of_interface()) {
      accelerator.forget();
      continue;
    }
    if (!(balance().energy() <= energy)) {
      accelerator.forget();
      move_interface(to);
    }
  }
  return velocity;
}

// Returns the time stamps of the vertices of the interface.
template <class Complex, class Solver>
std::vector<std::size_t> Incompressible_fluid<Complex, Solver>::stamps_of_interface() const {
  std::vector<std::size_t> result;
  for (Vertex_handle v : m_complex.interface_vertices())
    result.push_back(v->time_stamp());
  return result;
}

// Returns the coordinates of the vertices of the interface. On a torus, they are those of the
// images that are nearest to the points with the coordinates `near`, if this vector has the same
// size.
template <class Complex, class Solver>
Eigen::VectorXd Incompressible_fluid<Complex, Solver>::coordinates_of_interface(
    const Eigen::VectorXd& nearby) const {
  const auto vertices = m_complex.interface_vertices();
  Eigen::VectorXd result(3 * Eigen::Index(vertices.size()));
  const bool has_images = Mesh::is_periodic && nearby.size() == result.size();
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Eigen::Index row = 3 * Eigen::Index(v);
    const auto position = m_complex.position(vertices[v]);
    result.segment<3>(row) = internal::eigen_vector(
        has_images ? m_complex.position_near(point(nearby.segment<3>(row)), vertices[v])
                   : position);
  }
  return result;
}

// Performs a time step that ends at the time `end`. If this is the present time, solids do not
// move. Displacements are scaled down to `longest_displacement`, in edges. The judge can be null.
// If it finds a failure before the mesh is changed, the function returns at once.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::step(double dt, double end, const Options& chosen,
                                                 double longest_displacement, Report& report,
                                                 Energy_judge* judge) {
  const bool time_passes = end > m_time;
  const Flow flow(*this, m_properties);
  report.dt = dt;
  report.time = end;
  report.before = report.moved = flow.balance(*this, flow.positions, flow.velocities, m_time);
  report.after = report.before;
  report.forces_on_solids.assign(m_solids.size(), NULL_VECTOR);
  report.torques_on_solids = report.forces_on_solids;
  if (!flow.mesh.can_move()) { // only bodies can move
    for (internal::Any_solid_3& solid : m_solids)
      if (solid.body && time_passes)
        internal::move_freely(*solid.body, Eigen::Vector3d(m_properties.gravity().data()), dt,
                              dimension);
    m_time = end;
    return;
  }
  const auto begin_of_solver = Clock::now();
  Step step(m_complex, flow,
            {m_properties, m_solids, m_sides, m_gases.components_of(flow.mesh),
             time_passes ? m_sources : internal::Fluid_sources()},
            {m_time, end, {dt, chosen.implicitness}, time_passes}, m_solver,
            chosen.deformation.number_of_threads);
  if (time_passes)
    flow.require_holes(*this, step.contacts());
  if (judge && time_passes && jumps(flow, step.contacts(), end, *judge))
    return;
  step.solve(m_knows_accelerations);
  report.seconds_of_solver += seconds_since(begin_of_solver);
  add_source_volumes(flow, step, dt, report);
  m_time = end;
  set_motion_of_bodies(step.contacts(), step.final_velocities_of_bodies(), true);
  const Vectors after = step.final_velocities(),
                destinations =
                    shortened(step.destinations(), flow, longest_displacement, step.contacts());
  m_motion.set(flow.mesh, after, step.final_accelerations());
  m_motion.set_pressures(flow.mesh, step.pressures());
  if (time_passes && m_has_field)
    carry_field(flow, step);
  m_knows_accelerations = true;
  report.moved = flow.balance(*this, destinations, after, m_time);
  if (judge) {
    if (!judge->budget)
      judge->budget = flow.budget(*this);
    judge->budget->supply(step.work_of_walls() + step.work_of_bodies() +
                          step.work_of_sources(judge->budget->level()) +
                          step.work_of_open_sides(judge->budget->level()) + step.work_of_gravity());
    // The volumes of gases are not restored yet, so their energies are not exact.
    if (m_properties.gases().empty())
      judge->check(report, report.moved);
    if (judge->failure)
      return;
  }
  record_momenta(flow, [&](const internal::Masses& masses) { return step.final_momentum(masses); });
  auto events = std::move(report.deformation.events); // the events of the adaptation
  report.deformation = move(flow, step.contacts(), destinations, chosen);
  events.insert(events.end(), report.deformation.events.begin(), report.deformation.events.end());
  report.deformation.events = std::move(events);
  Flow last = restore_components(chosen, report);
  report.after = last.balance(*this, last.positions, last.velocities, m_time);
  m_motion.keep(last.mesh.vertices);
  report.depth_in_solids = last.depth_in_solids(*this);
  describe(step, flow, report);
  if (judge)
    judge->check(report, energies_with_gases_of(report));
  // After the check: while the liquids move, each facet keeps its surface tension.
  if (time_passes && m_has_field)
    diffuse_field(last, dt, report);
}

// Returns whether a wall jumps before the time `end`, and tells the judge.
template <class Complex, class Solver>
bool Incompressible_fluid<Complex, Solver>::jumps(const Flow& flow, const Contacts& contacts,
                                                  double end, Energy_judge& judge) const {
  static constexpr double longest = 1; // in edges
  const auto jump = contacts.greatest_jump(m_time, end);
  if (jump.length <= longest)
    return false;
  judge.failure = Fluid_failure::walls;
  judge.rise = jump.length;
  judge.place = internal::from_eigen<Fluid_repetition::Point>(flow.positions[jump.vertex]);
  return true;
}

// Sets the velocities of bodies. If `moves`, also sets their places at the end of a step.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::set_motion_of_bodies(
    const Contacts& contacts, const std::vector<internal::Body_velocity>& velocities, bool moves) {
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    Rigid_body_3& body = *m_solids[contacts.solid_of_body(k)].body;
    internal::set_motion(body, moves ? contacts.place_of_body(k, m_time) : internal::place_of(body),
                         velocities[k]);
  }
}

// Adds the volumes from sources and through sides to the volumes to be preserved.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::add_source_volumes(const Flow& flow, const Step& step,
                                                               double dt, Report& report) {
  Liquid_bookkeeping::Volumes volumes = m_liquids.volumes();
  const std::vector<double> gains = step.gains();
  for (std::size_t k = 0; k < gains.size(); ++k) {
    report.gained_volume += dt * gains[k];
    volumes.at(flow.mesh.cells[k].component) += dt * gains[k];
  }
  const std::array<double, 6> fluxes = step.flux_through_sides();
  for (std::size_t side = 0; side < fluxes.size(); ++side)
    report.volume_through_sides[side] += dt * fluxes[side];
  for (const auto& [component, volume] : volumes)
    if (!(volume > 0))
      throw Error("sources or outflows remove more than the volume of a component: use a shorter "
                  "time step, or end the outflow before the component is empty");
  m_liquids.set_volumes(volumes);
}

// Returns destinations outside of walls, after scaling all displacements so that none is longer
// than `longest_displacement`, in edges.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::shortened(Vectors destinations, const Flow& flow,
                                                      double longest_displacement,
                                                      const Contacts& contacts) const -> Vectors {
  double fraction = 1;
  for (std::size_t v = 0; v < destinations.size(); ++v)
    fraction = (std::min)(fraction, longest_displacement * edge_at(flow.mesh.vertices[v]) /
                                        (destinations[v] - flow.positions[v]).norm());
  for (std::size_t v = 0; v < destinations.size() && fraction < 1; ++v)
    destinations[v] = flow.positions[v] + fraction * (destinations[v] - flow.positions[v]);
  contacts.project_out_of_solids(destinations, m_time);
  return destinations;
}

// Adds the solution of a step to the report.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::describe(const Step& step, const Flow& flow,
                                                     Report& report) const {
  report.solutions += step.solutions();
  report.iterations += step.iterations();
  report.residual = (std::max)(report.residual, step.residual());
  report.flat_cells = (std::max)(report.flat_cells, step.number_of_flat_cells());
  report.contacts = step.contacts().number_of_constrained();
  report.contacts_settled = report.contacts_settled && step.is_settled();
  const auto loads = step.loads_on_solids();
  for (std::size_t k = 0; k < loads.size(); ++k) {
    report.forces_on_solids[k] = internal::from_eigen<typename Report::Vector>(loads[k].force);
    report.torques_on_solids[k] = internal::from_eigen<typename Report::Vector>(loads[k].torque);
  }
  const Vectors& after = step.final_velocities();
  for (std::size_t v = 0; v < after.size(); ++v) {
    report.greatest_velocity = (std::max)(report.greatest_velocity, after[v].norm());
    report.greatest_change_of_velocity =
        (std::max)(report.greatest_change_of_velocity, (after[v] - flow.velocities[v]).norm());
  }
}

// Returns the balance after a step. If gases merged or split, their energies before and after have
// no common origin. Then the energy of gases before changes of the mesh is used.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::energies_with_gases_of(const Report& report) const
    -> Balance {
  Balance result = report.after;
  const auto& events = report.deformation.events;
  if (std::any_of(events.begin(), events.end(),
                  [this](const auto& event) { return m_properties.gas(event.label); }))
    result.gas_energy = report.moved.gas_energy;
  return result;
}

// Replaces given velocities by the nearest ones that preserve volumes and enter no wall, in the
// norm of the kinetic energy. These are the velocities after a step in which only pressures act. A
// solid or a side that moves from the first instant sets the liquid in motion in this step.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::make_admissible(double dt, unsigned number_of_threads,
                                                            Report& report) {
  Properties inviscid;
  for (const auto& [label, liquid] : m_properties.liquids())
    inviscid.set_liquid(label, {liquid.density, 0});
  const Flow flow(*this, inviscid);
  const bool sides_rest =
      std::all_of(m_sides.begin(), m_sides.end(), [](const Side_behavior& side) {
        return !side.inflow &&
               side.velocity.value_or(std::array<double, 3>()) == std::array<double, 3>();
      });
  if (sides_rest && !flow.contacts(*this).touches_moving_wall(m_time) &&
      std::all_of(flow.velocities.begin(), flow.velocities.end(),
                  [](const Eigen::Vector3d& v) { return v.isZero(0); }))
    return;
  internal::Side_behaviors sides = m_sides; // open sides exert no pressure in the projection
  for (Side_behavior& side : sides)
    if (side.pressure)
      side.pressure = [given = side.pressure](const std::array<double, 3>& p, double t) {
        const auto pressure = given(p, t);
        return pressure ? std::optional<double>(0) : pressure;
      };
  Step step(m_complex, flow, {inviscid, m_solids, sides, m_gases.components_of(flow.mesh), {}},
            {m_time, m_time, {dt, 1}, true}, m_solver, number_of_threads);
  const auto begin = Clock::now();
  step.solve(false); // the stabilization needs the accelerations of an impulsive start
  report.seconds_of_solver += seconds_since(begin);
  report.solutions += step.solutions();
  report.iterations += step.iterations();
  const Vectors& velocities = step.solved_velocities();
  set_motion_of_bodies(step.contacts(), step.contacts().velocities_of_bodies(), false);
  m_motion.set(flow.mesh, velocities, Vectors(velocities.size(), Eigen::Vector3d::Zero()));
  record_momenta(flow,
                 [&](const internal::Masses& masses) { return step.pushed_momentum(masses); });
  Flow projected(*this, m_properties);
  restore_momenta(projected);
}

template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::largest_step(double fraction) const {
  const Boundary_class::Bits closed = internal::sides_without_openings(m_sides);
  double result = std::numeric_limits<double>::infinity();
  for (Vertex_handle v : m_complex.finite_vertices()) {
    const auto& motion = m_motion.at(v);
    double velocity = 0, acceleration = 0; // the largest sums of squares of a liquid
    for (std::size_t k = 0; k <= motion.deviations.size(); ++k) {
      internal::Fluid_motion::Numbers numbers = motion.common;
      if (k > 0)
        numbers += motion.deviations[k - 1].second;
      for (int axis = 0; axis < 3; ++axis)
        if (Boundary_class::fixes(Boundary_class::Bits(v->boundary_class() & closed), axis))
          numbers(axis) = numbers(3 + axis) = 0;
      velocity = (std::max)(velocity, numbers.template head<3>().squaredNorm());
      acceleration = (std::max)(acceleration, numbers.template segment<3>(3).squaredNorm());
    }
    const double length = fraction * edge_at(v);
    // Solves length = velocity t + acceleration t^2 / 2 for t.
    if (velocity > 0 || acceleration > 0)
      result = (std::min)(result, 2 * length /
                                      (std::sqrt(velocity) +
                                       std::sqrt(velocity + 2 * std::sqrt(acceleration) * length)));
  }
  return result;
}

template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::state() const -> State {
  State result;
  result.time = m_time;
  result.steps = m_steps;
  result.damped_steps = m_damped_steps;
  result.knows_accelerations = m_knows_accelerations;
  for (Vertex_handle v : m_complex.vertices()) {
    const auto& value = m_motion.at(v);
    for (const auto& [label, numbers] : value.deviations)
      result.deviations.emplace_back(result.motion.size(), label, array(numbers));
    result.motion.push_back(array(value.common));
    if (m_has_field)
      result.field.push_back(value.field);
  }
  result.volumes.assign(m_liquids.volumes().begin(), m_liquids.volumes().end());
  for (const auto& [component, gas] : m_gases.components())
    result.gases.emplace_back(component,
                              std::array<double, 2>{gas.reference_pressure, gas.reference_volume});
  for (const auto& solid : m_solids)
    if (solid.body)
      result.bodies.push_back(internal::motion_of(*solid.body));
  return result;
}

template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::restore(const State& state) {
  const auto vertices = m_complex.vertices();
  const Mesh mesh(updated_complex(), m_properties);
  const auto present = Liquid_bookkeeping::measure(mesh, mesh.positions(m_complex));
  bool fits = state.motion.size() == vertices.size() && state.volumes.size() == present.size() &&
              std::isfinite(state.time);
  const Liquid_bookkeeping::Volumes volumes(state.volumes.begin(), state.volumes.end());
  fits = fits && volumes.size() == present.size(); // no component occurs twice
  for (const auto& [component, volume] : volumes)
    fits = fits && present.count(component) > 0 && volume > 0 && std::isfinite(volume);
  auto gases = Gas_bookkeeping::measure(mesh, m_properties);
  const std::map<Liquid_bookkeeping::Number, std::array<double, 2>> references(state.gases.begin(),
                                                                               state.gases.end());
  fits = fits && state.gases.size() == gases.size() && references.size() == gases.size();
  for (const auto& [component, reference] : references) {
    const auto found = gases.find(component);
    if (found != gases.end() && reference[0] >= 0 && reference[1] > 0 &&
        std::isfinite(reference[0] * reference[1])) {
      found->second.reference_pressure = reference[0];
      found->second.reference_volume = reference[1];
    } else
      fits = false;
  }
  const auto is_finite = [](const auto& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  };
  for (const auto& numbers : state.motion)
    fits = fits && is_finite(numbers);
  fits = fits && (state.field.empty() || state.field.size() == vertices.size()) &&
         is_finite(state.field);
  for (const auto& [vertex, label, numbers] : state.deviations)
    fits = fits && vertex < vertices.size() && m_properties.liquid(label) && is_finite(numbers);
  fits = fits && state.bodies.size() == number_of_bodies() &&
         std::all_of(state.bodies.begin(), state.bodies.end(), [&](const auto& numbers) {
           return is_finite(numbers) && internal::has_rotation(numbers);
         });
  if (!fits)
    throw Error(
        "the state of the fluid does not match the complex or the bodies: first restore the "
        "complex with which the state was saved, and add the bodies");
  internal::Fluid_motion motion;
  using Motion = internal::Fluid_motion;
  std::vector<Motion::Value> values(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    values[v].common = Motion::Numbers(state.motion[v].data());
  for (const auto& [vertex, label, numbers] : state.deviations)
    values[vertex].deviation(label) = Motion::Numbers(numbers.data());
  for (std::size_t v = 0; v < state.field.size(); ++v)
    values[v].field = state.field[v];
  for (std::size_t v = 0; v < vertices.size(); ++v)
    motion.put(vertices[v], values[v]);
  m_motion = std::move(motion);
  m_liquids.set_volumes(volumes);
  m_gases.set_components(gases);
  m_complex.take_component_lineage();
  auto of_body = state.bodies.begin();
  for (auto& solid : m_solids)
    if (solid.body)
      internal::set_motion(*solid.body, *of_body++);
  m_time = state.time;
  m_steps = state.steps;
  m_damped_steps = state.damped_steps;
  m_knows_accelerations = state.knows_accelerations;
  m_has_field = !state.field.empty();
}

// Returns the options that named parameters give.
template <class Complex, class Solver>
template <class NamedParameters>
auto Incompressible_fluid<Complex, Solver>::options(const NamedParameters& np) const -> Options {
  Options result;
  internal::refuse_parameters<Options, internal_np::flow_t, internal_np::visitor_t>(np);
  read_parameters(m_complex, np, result);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_IMPL_H
