// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_INCOMPRESSIBLE_FLUID_IMPL_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_INCOMPRESSIBLE_FLUID_IMPL_H

// Included by the class.
#include <CGAL/Incompressible_fluid_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {

template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::advance_with(Options chosen, double dt) -> Report {
  require_step(dt);
  if (!(m_time + dt > m_time))
    throw Error("the step of time is too short to change the time");
  if (m_damped_steps > 0)
    chosen.implicitness = (std::max)(chosen.implicitness, implicitness_after_change);
  Report report;
  const auto begin = Clock::now();
  if (chosen.adaptation_interval > 0 && m_steps % chosen.adaptation_interval == 0)
    adapt(chosen, report);
  if (!m_knows_accelerations)
    make_admissible(dt, chosen.number_of_threads, report);
  step(dt, m_time + dt, chosen, std::numeric_limits<double>::infinity(), report);
  ++m_steps;
  m_damped_steps -= m_damped_steps > 0;
  if (!report.deformation.events.empty())
    m_damped_steps = steps_after_change;
  report.seconds_of_mesh = seconds_since(begin) - report.seconds_of_solver;
  return report;
}

template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::relax_with(Options chosen, double dt,
                                                         unsigned steps) {
  static constexpr double rest = 1e-14;     // of the first step
  static constexpr double longest_way = .3; // edges in a step, as forces change on it
  chosen.implicitness = 1;
  require_step(dt);
  Report report;
  const auto stop = [this](void*) {
    m_motion = internal::Fluid_motion_3();
    m_knows_accelerations = false;
  };
  const std::unique_ptr<void, decltype(stop)> stops_in_the_end(this, stop);
  stop(this);
  if (chosen.adaptation_interval > 0)
    adapt(chosen, report);
  double first = 0, velocity = 0;
  internal::Fixed_point_accelerator accelerator;
  for (unsigned k = 0; k < steps; ++k) {
    const std::vector<std::size_t> before = stamps_of_interface();
    const Eigen::VectorXd from = coordinates_of_interface();
    report = {};
    step(dt, m_time, chosen, longest_way, report);
    stop(this);
    velocity = report.greatest_velocity;
    first = k == 0 ? velocity : first;
    if (velocity <= rest * first)
      break;
    if (before != stamps_of_interface()) {
      accelerator.forget();
      continue;
    }
    const Eigen::VectorXd to = coordinates_of_interface();
    const double energy = balance().energy();
    move_interface(Flow(*this, m_properties), accelerator.next(from, to), chosen, report);
    if (before != stamps_of_interface()) {
      accelerator.forget();
      continue;
    }
    if (!(balance().energy() <= energy)) {
      accelerator.forget();
      move_interface(Flow(*this, m_properties), to, chosen, report);
    }
  }
  return velocity;
}

template <class Complex, class Solver>
std::vector<std::size_t> Incompressible_fluid<Complex, Solver>::stamps_of_interface() const {
  std::vector<std::size_t> result;
  for (Vertex_handle v : m_complex.interface_vertices())
    result.push_back(v->time_stamp());
  return result;
}

template <class Complex, class Solver>
Eigen::VectorXd Incompressible_fluid<Complex, Solver>::coordinates_of_interface() const {
  const auto vertices = m_complex.interface_vertices();
  Eigen::VectorXd result(3 * Eigen::Index(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v)
    result.segment<3>(3 * Eigen::Index(v)) =
        internal::eigen_vector(m_complex.position(vertices[v]));
  return result;
}

// Solids stand still if time does. Ways are cut down to the longest one, in edges.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::step(double dt, double end, const Options& chosen,
                                                 double longest_way, Report& report) {
  const Flow flow(*this, m_properties);
  report.dt = dt;
  report.time = end;
  report.before = report.moved = flow.balance(*this, flow.positions, flow.velocities, m_time);
  report.after = report.before;
  report.forces_on_solids.assign(m_solids.size(), Vector(0, 0, 0));
  if (flow.mesh.facets.empty()) { // nothing is left that could move
    m_time = end;
    return;
  }
  const auto begin_of_solver = Clock::now();
  Step step(flow.mesh, m_properties, m_solids, m_complex, m_solver, {dt, chosen.implicitness},
            m_time, end, flow.positions, flow.velocities, flow.accelerations,
            m_gas_ledger.bodies_of(flow.mesh), end > m_time ? m_source : typename Step::Source(),
            chosen.number_of_threads);
  step.solve(m_knows_accelerations);
  report.seconds_of_solver += seconds_since(begin_of_solver);
  Ledger::Volumes owned = m_ledger.volumes();
  for (std::size_t k = 0; k < step.gains().size(); ++k) {
    report.gained_volume += dt * step.gains()[k];
    owned.at(flow.mesh.cells[k].component) += dt * step.gains()[k];
  }
  m_ledger.set_volumes(owned);

  m_time = end;
  const Vectors after = step.final_velocities();
  store(flow, after, dt);
  Vectors destinations = step.destinations();
  double part = 1;
  for (std::size_t v = 0; v < destinations.size(); ++v)
    part = (std::min)(part, longest_way * edge_at(flow.mesh.vertices[v]) /
                                (destinations[v] - flow.positions[v]).norm());
  for (std::size_t v = 0; v < destinations.size() && part < 1; ++v)
    destinations[v] = flow.positions[v] + part * (destinations[v] - flow.positions[v]);
  step.contacts().put_out(destinations, m_time);
  report.moved = flow.balance(*this, destinations, after, m_time);
  note_momenta(flow, [&](const internal::Masses_3& masses) { return step.final_momentum(masses); });
  auto events = std::move(report.deformation.events); // of the adaptation
  report.deformation = move(flow, step.contacts(), destinations, chosen);
  events.insert(events.end(), report.deformation.events.begin(), report.deformation.events.end());
  report.deformation.events = std::move(events);
  const Flow last = settle(chosen, report);

  report.solutions += step.solutions();
  report.iterations += step.iterations();
  report.contacts = step.contacts().number_of_held();
  report.contacts_settled = step.is_settled();
  const Vectors forces = step.contacts().forces(step.forces_on_vertices());
  std::transform(forces.begin(), forces.end(), report.forces_on_solids.begin(), vector);
  for (std::size_t v = 0; v < after.size(); ++v) {
    report.greatest_velocity = (std::max)(report.greatest_velocity, after[v].norm());
    report.greatest_change_of_velocity =
        (std::max)(report.greatest_change_of_velocity, (after[v] - flow.velocities[v]).norm());
  }
  report.after = last.balance(*this, last.positions, last.velocities, m_time);
  m_motion.keep(last.mesh.vertices);
  report.depth_in_solids = last.depth_in_solids(*this);
}

// Gives parts what they own, after changes of the mesh. Returns what is then.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::settle(const Options& chosen, Report& report) -> Flow {
  Flow result(*this, m_properties);
  report.lost_volume += follow_parts(result);
  restore_volumes(result, chosen, report);
  report.greatest_correction = (std::max)(report.greatest_correction, restore_momenta(result));
  return result;
}

// Given velocities may change volumes and enter walls: the nearest ones that do not, as masses
// weigh them, are those of a step in which nothing but pressure acts.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::make_admissible(double dt, unsigned number_of_threads,
                                                            Report& report) {
  Properties inviscid;
  for (const auto& [label, liquid] : m_properties.liquids())
    inviscid.set_liquid(label, {liquid.density, 0});
  const Flow flow(*this, inviscid);
  if (std::all_of(flow.velocities.begin(), flow.velocities.end(),
                  [](const Eigen::Vector3d& v) { return v.isZero(0); }))
    return;
  Step step(flow.mesh, inviscid, m_solids, m_complex, m_solver, {dt, 1}, m_time, m_time + dt,
            flow.positions, flow.velocities, flow.accelerations, m_gas_ledger.bodies_of(flow.mesh),
            {}, number_of_threads);
  const auto begin = Clock::now();
  step.solve(true);
  report.seconds_of_solver += seconds_since(begin);
  report.solutions += step.solutions();
  report.iterations += step.iterations();
  const Vectors& velocities = step.solved_velocities();
  for (std::size_t v = 0; v < velocities.size(); ++v)
    m_motion.set(flow.mesh.vertices[v], velocities[v], Eigen::Vector3d::Zero());
  note_momenta(flow,
               [&](const internal::Masses_3& masses) { return step.pushed_momentum(masses); });
  Flow projected(*this, m_properties);
  restore_momenta(projected);
}

template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::largest_step(double part) const {
  double result = std::numeric_limits<double>::infinity();
  for (Vertex_handle v : m_complex.finite_vertices()) {
    const auto motion = m_motion.at(v->time_stamp());
    double velocity = 0, acceleration = 0; // squares
    for (int axis = 0; axis < 3; ++axis)
      if (!Boundary_class::fixes(v->boundary_class(), axis)) {
        velocity += square(motion(axis));
        acceleration += square(motion(3 + axis));
      }
    const double length = part * edge_at(v);
    // length = velocity t + acceleration t^2 / 2
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
    const auto value = m_motion.at(v->time_stamp());
    result.motion.emplace_back();
    std::copy(value.data(), value.data() + 6, result.motion.back().begin());
  }
  result.volumes.assign(m_ledger.volumes().begin(), m_ledger.volumes().end());
  for (const auto& [part, body] : m_gas_ledger.bodies())
    result.gases.emplace_back(
        part, std::array<double, 2>{body.reference_pressure, body.reference_volume});
  return result;
}

template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::restore(const State& state) {
  const auto vertices = m_complex.vertices();
  const Flow flow(*this, m_properties);
  const auto present = flow.volumes();
  bool fits = state.motion.size() == vertices.size() && state.volumes.size() == present.size() &&
              std::isfinite(state.time);
  const Ledger::Volumes volumes(state.volumes.begin(), state.volumes.end());
  fits = fits && volumes.size() == present.size(); // none of them twice
  for (const auto& [part, volume] : volumes)
    fits = fits && present.count(part) > 0 && volume > 0 && std::isfinite(volume);
  auto gases = Gas_ledger::measure(flow.mesh, m_properties);
  const std::map<Ledger::Part, std::array<double, 2>> references(state.gases.begin(),
                                                                 state.gases.end());
  fits = fits && state.gases.size() == gases.size() && references.size() == gases.size();
  for (const auto& [part, reference] : references) {
    const auto found = gases.find(part);
    if (found != gases.end() && reference[0] >= 0 && reference[1] > 0 &&
        std::isfinite(reference[0] * reference[1])) {
      found->second.reference_pressure = reference[0];
      found->second.reference_volume = reference[1];
    } else
      fits = false;
  }
  for (const auto& value : state.motion)
    fits =
        fits && std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
  if (!fits)
    throw Error("the state of the fluid does not fit the complex: restore the complex that it was "
                "taken with first");
  internal::Fluid_motion_3 motion;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    motion.put(vertices[v]->time_stamp(), internal::Fluid_motion_3::Value(state.motion[v].data()));
  m_motion = std::move(motion);
  m_ledger.set_volumes(volumes);
  m_gas_ledger.set_bodies(gases);
  m_complex.take_component_lineage();
  m_time = state.time;
  m_steps = state.steps;
  m_damped_steps = state.damped_steps;
  m_knows_accelerations = state.knows_accelerations;
}

template <class Complex, class Solver>
template <class NamedParameters>
auto Incompressible_fluid<Complex, Solver>::options(const NamedParameters& np) const -> Options {
  namespace tags = internal_np;
  using Defaults = internal::defaults::Adaptive_advection<3>;
  const Options result = {
      internal::deformation_options(m_complex, np),
      internal::number_parameter(np, tags::implicitness, internal::defaults::implicitness),
      internal::number_parameter(np, tags::interface_tolerance, Defaults::interface_tolerance),
      internal::count_parameter(np, tags::adaptation_interval, "adaptation_interval",
                                Defaults::adaptation_interval),
      internal::count_parameter(np, tags::number_of_threads, "number_of_threads",
                                internal::defaults::number_of_threads)};
  if (!(result.implicitness >= .5 && result.implicitness <= 1))
    throw Error("the implicitness is out of range: use 0.5 to 1");
  if (!(result.interface_tolerance >= 0))
    throw Error("the tolerance of the interface is out of range: use 0 or more");
  return result;
}

// The interface where it is worn, and inside of liquids edges about as long as those of the
// interface: in the beginning, and later where the flow has stretched them a lot.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::adapt(const Options& chosen, Report& report) {
  // In mean edges of the interface. What is split later is collapsed to no less than it was.
  static constexpr double longest_of_new = 1.7, longest = 2.5, shortest = .3;
  static constexpr double quality = .3; // of tetrahedra, as of new meshes
  using Defaults = internal::defaults::Adaptive_advection<3>;
  if (m_complex.interface_vertices().empty())
    return;
  internal::require_interface_edge(m_complex);
  const Flow flow(*this, m_properties);
  note_momenta(flow, [&](const internal::Masses_3& masses) {
    return internal::momentum(flow.mesh, masses, flow.positions, flow.velocities);
  });
  Improvement_report& result = report.adaptation;
  change_followed([&](const auto& visitor) {
    result = internal::keep_interface_fit(
        m_complex, {chosen.interface_tolerance, Defaults::feature_angle},
        [](const auto&) { return true; }, visitor);
    const double edge = m_complex.mean_interface_edge();
    const auto is_liquid = [this](typename Complex::Cell_handle c) {
      return m_properties.liquid(c->label()) != nullptr;
    };
    const bool is_new = m_steps == 0;
    result = result + control_detail(
                          m_complex,
                          parameters::size_field([edge](const Approximate_point&) { return edge; })
                              .where(is_liquid)
                              .split_length(is_new ? longest_of_new : longest)
                              .collapse_length(is_new ? 0. : shortest)
                              .visitor(visitor));
    if (is_new)
      result =
          result + improve_mesh(m_complex, parameters::quality_threshold(quality).visitor(visitor));
  });
  settle(chosen, report);
}

template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::store(const Flow& flow, const Vectors& velocities,
                                                  double dt) {
  for (std::size_t v = 0; v < flow.mesh.vertices.size(); ++v)
    m_motion.set(flow.mesh.vertices[v], velocities[v], (velocities[v] - flow.velocities[v]) / dt);
  m_knows_accelerations = true;
}

template <class Complex, class Solver>
Deformation_report<Complex>
Incompressible_fluid<Complex, Solver>::move(const Flow& flow, const Contacts& contacts,
                                            const Vectors& destinations, const Options& chosen) {
  const Mesh& mesh = flow.mesh;
  const Part_interface parts(m_complex, m_properties, flow.volumes());
  const internal::Vertex_numbers number(m_complex, mesh.vertices);
  const auto from = parts.snapshot().positions(m_complex);
  auto to = from;
  std::vector<char> is_held(to.size(), false);
  for (std::size_t k = 0; k < to.size(); ++k)
    if (const std::size_t i = number(parts.snapshot().vertices[k]); i < mesh.vertices.size()) {
      to[k] = point(destinations[i]);
      is_held[k] = contacts.is_held(i);
    }
  parts.restore(
      m_ledger.volumes(), from, [&](std::size_t v) { return is_held[v] != 0; }, to);

  std::unordered_map<std::size_t, Approximate_point> inside; // by time stamp
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!mesh.is_on_interface[i])
      inside.emplace(mesh.vertices[i]->time_stamp(), point(destinations[i]));
  const auto inner_flow = [&inside](Vertex_handle v) {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto found = inside.find(v->time_stamp());
    return found != inside.end() ? found->second : Approximate_point(unknown, unknown, unknown);
  };
  return change_followed([&](const auto& visitor) {
    return deform_interface_to(m_complex, parts.snapshot(), to,
                               chosen.parameters().flow(inner_flow).visitor(visitor));
  });
}

// Changes the mesh by a function of a visitor, which carries velocities. If that throws, parts are
// still those of the ledger.
template <class Complex, class Solver>
template <class Change>
auto Incompressible_fluid<Complex, Solver>::change_followed(const Change& change) {
  Carrier carried = carrier();
  try {
    return change(std::ref(carried));
  } catch (...) {
    follow_parts(Flow(*this, m_properties));
    throw;
  }
}

// Where changes of the mesh have altered them.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::restore_volumes(Flow& flow, const Options& chosen,
                                                            Report& report) {
  static constexpr double rounding = 1e-14;
  static constexpr int rounds = 3;
  for (int k = 0; k <= rounds; ++k) {
    report.volume_error = m_ledger.error(flow.volumes());
    if (k == 0)
      report.volume_correction = (std::max)(report.volume_correction, report.volume_error);
    if (k == rounds || (report.volume_error <= rounding && !(flow.depth_in_solids(*this) > 0)))
      break;
    flow = move_interface(flow, coordinates_of_interface(), chosen, report);
  }
}

// To about given coordinates: out of solids, and so that parts have their volumes. The mesh stays
// as it is if it can. Returns what is then.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::move_interface(const Flow& flow,
                                                           const Eigen::VectorXd& coordinates,
                                                           const Options& chosen, Report& report)
    -> Flow {
  const Mesh& mesh = flow.mesh;
  Vectors positions = flow.positions;
  const Contacts contacts(mesh, m_solids, m_complex, positions, m_time);
  std::unordered_map<std::size_t, std::size_t> number; // in the mesh, by time stamp
  for (std::size_t v = 0; v < positions.size(); ++v)
    number.emplace(mesh.vertices[v]->time_stamp(), v);
  const Part_interface parts(m_complex, m_properties, flow.volumes());
  const auto& vertices = parts.snapshot().vertices;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    if (const auto found = number.find(vertices[k]->time_stamp()); found != number.end())
      positions[found->second] = coordinates.segment<3>(3 * Eigen::Index(k));
  contacts.put_out(positions, m_time);

  std::vector<Approximate_point> to;
  std::vector<char> is_held(vertices.size(), false);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto found = number.find(vertices[k]->time_stamp());
    to.push_back(found != number.end() ? point(positions[found->second])
                                       : m_complex.position(vertices[k]));
    is_held[k] = found != number.end() && contacts.touches(found->second);
  }
  parts.restore(
      m_ledger.volumes(), parts.snapshot().positions(m_complex),
      [&](std::size_t v) { return is_held[v] != 0; }, to);
  const auto deformation = change_followed([&](const auto& visitor) {
    return deform_interface_to(m_complex, parts.snapshot(), to,
                               chosen.parameters()
                                   .quality_threshold(0.)
                                   .relabeling_threshold(0.)
                                   .minimum_angle(0.)
                                   .minimum_facet_angle(0.)
                                   .visitor(visitor));
  });
  auto& events = report.deformation.events;
  events.insert(events.end(), deformation.events.begin(), deformation.events.end());
  Flow result(*this, m_properties);
  report.lost_volume += follow_parts(result);
  return result;
}

// Those of parts that touch, together.
template <class Complex, class Solver>
template <class MomentumOf>
void Incompressible_fluid<Complex, Solver>::note_momenta(const Flow& flow,
                                                         const MomentumOf& momentum_of) {
  std::size_t size = 0;
  for (const auto& cell : flow.mesh.cells)
    size = (std::max)(size, std::size_t(cell.component) + 1);
  internal::Number_groups touching(size + flow.mesh.vertices.size());
  for (const auto& cell : flow.mesh.cells)
    for (auto v : cell.vertices)
      touching.join(size + v, cell.component);
  std::vector<std::size_t> set_of_part;
  for (std::size_t part = 0; part < size; ++part)
    set_of_part.push_back(touching.of(part));
  std::vector<internal::Momentum_3> momenta;
  for (const auto& masses : internal::masses_of_sets(
           flow.mesh, flow.positions, size, [&](std::uint32_t part) { return set_of_part[part]; }))
    momenta.push_back(momentum_of(masses));
  m_ledger.set_momenta(std::move(momenta), set_of_part);
}

// Returns the volume of parts that are gone.
template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::follow_parts(const Flow& now) {
  const auto lineage = m_complex.take_component_lineage();
  m_gas_ledger.follow(lineage, Gas_ledger::measure(now.mesh, m_properties));
  return m_ledger.follow(lineage, now.volumes());
}

// Gives parts the momenta that they own by a rigid motion. Returns the greatest change of a
// velocity.
template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::restore_momenta(Flow& flow) {
  // Of parts that touch by now, together, as their vertices are the same.
  internal::Number_groups sets(m_ledger.momenta().size());
  std::vector<std::size_t> set_of_vertex(flow.positions.size(), sets.size());
  for (const auto& cell : flow.mesh.cells)
    for (auto v : cell.vertices) {
      const std::size_t set = m_ledger.set_of(cell.component);
      if (set_of_vertex[v] < sets.size())
        sets.join(set, set_of_vertex[v]);
      set_of_vertex[v] = set;
    }
  std::vector<internal::Momentum_3> wanted(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    wanted[sets.of(k)].linear += m_ledger.momenta()[k].linear;
    wanted[sets.of(k)].angular += m_ledger.momenta()[k].angular;
  }
  const auto bodies =
      internal::masses_of_sets(flow.mesh, flow.positions, wanted.size(),
                               [&](std::uint32_t part) { return sets.of(m_ledger.set_of(part)); });
  double result = 0;
  Vectors velocities = flow.velocities;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    internal::Momentum_3 missing =
        internal::momentum(flow.mesh, bodies[k], flow.positions, flow.velocities);
    missing.linear = wanted[k].linear - missing.linear;
    missing.angular = wanted[k].angular - missing.angular;
    const auto correction = internal::rigid_velocity(flow.mesh, bodies[k], flow.positions, missing);
    for (const auto& [v, mass] : bodies[k].of_vertices)
      velocities[v] = flow.velocities[v] + correction.at(flow.positions[v]);
  }
  flow.mesh.keep_on_sides(velocities);
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    result = (std::max)(result, (velocities[v] - flow.velocities[v]).norm());
    m_motion.set(flow.mesh.vertices[v], velocities[v], flow.accelerations[v]);
  }
  flow.velocities.swap(velocities);
  return result;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_INCOMPRESSIBLE_FLUID_IMPL_H
