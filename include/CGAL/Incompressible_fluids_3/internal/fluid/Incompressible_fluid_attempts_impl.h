// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_ATTEMPTS_IMPL_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_ATTEMPTS_IMPL_H

// Member functions of Incompressible_fluid that attempt a time step, check it and undo it, and that
// change the field that liquids carry. The class includes this file.
#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

namespace CGAL::Deformable_simplicial_complexes {

// Sets the field at vertices of the boundary to the values that are given there at the present
// time. The field is given by first occurrence of vertices. Returns which values are given.
// \throws Error if a given value is not finite
template <class Complex, class Solver>
template <class Selects>
std::vector<char>
Incompressible_fluid<Complex, Solver>::give_field(const Mesh& mesh, const Vectors& positions,
                                                  const Selects& selects,
                                                  std::vector<double>& field) const {
  const std::size_t n = mesh.number_of_vertices();
  std::vector<char> is_boundary(n, false), is_given(n, false);
  for (std::size_t v = 0; v < n; ++v)
    is_boundary[v] = mesh.vertices[v]->boundary_class() != 0;
  for (const auto& facet : mesh.facets)
    for (auto v : facet.vertices)
      is_boundary[mesh.first(v)] = is_boundary[mesh.first(v)] || facet.is_free;
  for (std::size_t v = 0; v < n && m_fixed_field; ++v)
    if (const auto value =
            is_boundary[v] && selects(v) ? m_fixed_field(positions[v], m_time) : std::nullopt) {
      if (!std::isfinite(*value))
        throw Error("a given value of the field is not finite: give finite values");
      field[v] = *value;
      is_given[v] = true;
    }
  return is_given;
}

// Carries the field to the destinations of vertices. Where liquid enters, it has the given values.
// Other vertices get given values after the motion, because facets keep their tensions in the
// motion.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::carry_field(const Flow& flow, const Step& step) {
  std::vector<double> field = step.carried(flow.field);
  give_field(
      flow.mesh, step.destinations(), [&step](std::size_t v) { return step.is_passage(v); }, field);
  m_motion.set_field(flow.mesh, field);
}

// Lets the field diffuse for a time dt, after it takes the given values on the boundary. Updates
// the surface tensions of the flow, and the report.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::diffuse_field(Flow& flow, double dt, Report& report) {
  Mesh& mesh = flow.mesh;
  std::vector<double> field(flow.field.begin(),
                            flow.field.begin() + std::ptrdiff_t(mesh.number_of_vertices()));
  const std::vector<char> is_given = give_field(
      mesh, flow.positions, [](std::size_t) { return true; }, field);
  internal::Field_diffusion<Complex>(mesh, flow.positions, dt).diffuse(field, is_given);
  m_motion.set_field(mesh, field);
  for (std::size_t v = 0; v < flow.field.size(); ++v)
    flow.field[v] = field[mesh.first(typename Mesh::Index(v))];
  internal::set_tensions(mesh, m_properties, flow.field);
  const double before = report.after.surface_energy;
  report.after = flow.balance(*this, flow.positions, flow.velocities, m_time);
  report.work_of_tensions += report.after.surface_energy - before;
}

// Performs a time step, see `advance()`. The state before the step is restored after any exception.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::advance(double dt, const Options& options) -> Report {
  options.check();
  require_step(dt);
  if (!(m_time + dt > m_time))
    throw Error("the time step is too short to change the time: use a longer one");
  if (internal::have_openings(m_sides)) {
    const Flow flow(*this, m_properties);
    internal::require_vertices_in_openings(flow.mesh, m_sides, flow.positions, m_time);
  }
  const Snapshot start(m_complex, *this);
  try {
    const auto begin = Clock::now();
    Report report = advance_in_parts(options, dt, start);
    ++m_steps;
    m_damped_steps -= m_damped_steps > 0;
    if (!report.deformation.events.empty())
      m_damped_steps = steps_after_change;
    report.seconds_of_mesh = seconds_since(begin) - report.seconds_of_solver;
    return report;
  } catch (...) {
    start.restore(m_complex, *this);
    throw;
  }
}

// Attempts a step in as few parts as possible. Failed attempts are undone.
// \throws Fluid_step_error if no attempt is left
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::advance_in_parts(const Options& chosen, double dt,
                                                             const Snapshot& start) -> Report {
  const double begin = m_time;
  const Snapshot* last = &start;
  std::optional<Snapshot> middle; // the state after the last part
  Report done;
  Vectors forces(m_solids.size(), Eigen::Vector3d::Zero()), torques = forces;
  for (internal::Step_plan plan; !plan.is_done();) {
    Report report = done;
    const auto failure = attempt(plan, begin, dt, chosen, report);
    done.seconds_of_solver = report.seconds_of_solver;
    if (failure) {
      last->restore(m_complex, *this);
      done.repetitions.push_back(*failure);
      if (!plan.fail(failure->cause))
        throw Fluid_step_error(internal::message_of(*failure, m_steps + 1), m_steps + 1, *failure);
      continue;
    }
    for (std::size_t k = 0; k < forces.size(); ++k) {
      forces[k] += plan.length() * internal::eigen_vector(report.forces_on_solids[k]);
      torques[k] += plan.length() * internal::eigen_vector(report.torques_on_solids[k]);
    }
    if (!plan.is_first())
      report.before = done.before;
    report.repetitions = std::move(done.repetitions);
    done = std::move(report);
    plan.succeed();
    done.parts = plan.parts();
    if (!plan.is_done())
      last = &middle.emplace(m_complex, *this);
  }
  for (std::size_t k = 0; k < forces.size(); ++k) {
    done.forces_on_solids[k] = internal::from_eigen<typename Report::Vector>(forces[k]);
    done.torques_on_solids[k] = internal::from_eigen<typename Report::Vector>(torques[k]);
  }
  done.dt = dt;
  return done;
}

// Attempts the next part of a step. Returns the reason of the failure, or nothing if the attempt
// succeeds.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::attempt(const internal::Step_plan& plan, double begin,
                                                    double dt, Options chosen, Report& report)
    -> std::optional<Fluid_repetition> {
  using Treatment = internal::Mesh_treatment;
  const double from = m_time, length = plan.length() * dt;
  if (m_damped_steps > 0)
    chosen.implicitness = (std::max)(chosen.implicitness, implicitness_after_change);
  if (plan.mesh() == Treatment::preserved)
    chosen.deformation.preserve_mesh();
  // The flow begins after the first adaptation, so the energy check does not include this
  // adaptation.
  const bool is_new = m_steps == 0;
  const auto is_due = [&] {
    switch (plan.mesh()) {
    case Treatment::chosen:
      return plan.is_first() && m_steps % chosen.adaptation_interval == 0;
    case Treatment::preserved:
      return plan.is_first() && is_new;
    default:
      return true;
    }
  };
  Energy_judge judge;
  try {
    if (chosen.adaptation_interval > 0 && is_due()) {
      if (!is_new && m_knows_accelerations)
        judge.budget = Flow(*this, m_properties).budget(*this);
      adapt(chosen, plan.mesh(), report);
    }
    if (!m_knows_accelerations)
      make_admissible(length, chosen.deformation.number_of_threads, report);
    step(length, begin + plan.end() * dt, chosen, std::numeric_limits<double>::infinity(), report,
         &judge);
    if (!judge.failure && report.volume_error > largest_volume_error)
      return Fluid_repetition{Fluid_failure::volume, from, length, report.volume_error,
                              fastest_vertex()};
    if (!judge.failure)
      return std::nullopt;
    return Fluid_repetition{*judge.failure, from, length, judge.rise,
                            judge.place ? *judge.place : fastest_vertex()};
  } catch (const Convergence_error& error) {
    return Fluid_repetition{Fluid_failure::equations, from, length, error.residual(),
                            flattest_cell()};
  }
}

// Returns the position of the vertex of greatest velocity.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::fastest_vertex() const -> Fluid_repetition::Point {
  Fluid_repetition::Point result = ORIGIN;
  double greatest = -1;
  for (Vertex_handle v : m_complex.vertices())
    if (const double square = m_motion.velocity(v).squaredNorm(); square > greatest) {
      greatest = square;
      result = internal::from_eigen<Fluid_repetition::Point>(
          internal::eigen_vector(m_complex.position(v)));
    }
  return result;
}

// Returns the barycenter of the liquid cell of lowest quality.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::flattest_cell() const -> Fluid_repetition::Point {
  Fluid_repetition::Point result = ORIGIN;
  double lowest = std::numeric_limits<double>::infinity();
  for (typename Complex::Cell_handle c : m_complex.cells())
    if (m_properties.liquid(c->subdomain_index()) && c->quality() < lowest) {
      lowest = c->quality();
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int i = 0; i < Complex::corners; ++i)
        sum += internal::eigen_vector(m_complex.corner(c, i)) / Complex::corners;
      result = internal::from_eigen<Fluid_repetition::Point>(sum);
    }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_ATTEMPTS_IMPL_H
