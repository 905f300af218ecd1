// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H
#define CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/internal/curvature/Interface_forces.h>
#include <CGAL/Interface_remeshing/Volume_changer.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceFlowsRef

The explicit form of mean curvature flow (section 4.1.2 of the paper). In the plane, the flow is
called curve shortening flow. The velocity of a vertex is the negative gradient of an
`Interface_energy`, by the cotangent formula, divided by the mixed Voronoi area of the vertex and
multiplied by the mobility. In the plane, this area is half of the length of the edges at the
vertex. By default, the energy is the measure of the interface, and the mobility is 1. Then the
speed is the sum of the principal curvatures, and three labels that meet along a line form angles of
120 degrees.

The explicit form is stable for short time steps only: about half of the area of the smallest
triangle, in the plane half of the square of the shortest edge, divided by the greatest product of a
tension and a mobility. `Mean_curvature_flow` has no such limit.

\cgalModels{InterfaceVelocity}
*/
class Mean_curvature_velocity
{
public:
  /// The flow decreases the energy of the interface: `advect_adaptively()` adapts it in each step.
  static constexpr bool contracts_interface = true;

  /// Constructs the velocity for an energy.
  explicit Mean_curvature_velocity(const Interface_energy& energy = {}) : m_energy(energy) {}

  /// Returns the energy that the flow decreases.
  const Interface_energy& energy() const { return m_energy; }

  /// Computes the velocities of all vertices at the given positions, see `InterfaceVelocity`.
  /// Vertices on sides of the domain stay on them. The time is linear in the size of the interface.
  /// \throws Error if a function of the energy returns a value out of its range
  template <class Complex>
  void operator()(const Interface_snapshot<Complex>& interface_,
                  const std::vector<typename Complex::Point>& positions, double /*t*/,
                  std::vector<typename Complex::Vector>& velocities) const;

private:
  Interface_energy m_energy;
};

template <class Complex>
void Mean_curvature_velocity::operator()(const Interface_snapshot<Complex>& interface_,
                                         const std::vector<typename Complex::Point>& positions,
                                         double /*t*/,
                                         std::vector<typename Complex::Vector>& velocities) const {
  using Forces = internal::Interface_forces<Complex>;
  const Forces forces(interface_, positions, m_energy);
  velocities.assign(positions.size(), NULL_VECTOR);
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (forces.share(v) > 0) {
      auto mass = forces.mass(v);
      auto force = forces.force(v);
      if (const auto* constraint = forces.constraint(v)) {
        mass = (*constraint * mass * *constraint).eval();
        mass += mass.Identity() - *constraint;
        force = (*constraint * force).eval();
      }
      velocities[v] = Forces::vector(mass.ldlt().solve(force).eval());
    }
}

/*!
\ingroup PkgInterfaceFlowsRef

The semi-implicit form of mean curvature flow, in the plane called curve shortening flow
(M. Desbrun, M. Meyer, P. Schröder, A. H. Barr, *Implicit fairing of irregular meshes using
diffusion and curvature flow*, SIGGRAPH 1999). The forces are those of `Mean_curvature_velocity`:
those of tensions at the positions at the end of the step, with the weights of its beginning, and
those of energy densities at the beginning. One step and two steps of half the length are computed,
and both results are extrapolated. The method is of second order in time. Without energy densities,
it is stable for any time step.

The difference of both results estimates the error. If a vertex differs by more than .005 mean edges
in the plane, the time step is divided. So corners, where the curvature is not bounded, become round
at the right speed. Parts are not shorter than about a thousandth of the time step. A step within
which a component vanishes is not divided.

\cgalModels{InterfaceStep}
*/
class Mean_curvature_flow
{
public:
  /// The flow decreases the energy of the interface: `advect_adaptively()` adapts it in each step.
  static constexpr bool contracts_interface = true;

  /// Constructs the flow for the energy whose tensions and mobilities are all 1.
  /// \param preserves_volumes see the other constructor
  explicit Mean_curvature_flow(bool preserves_volumes = false)
      : m_preserves_volumes(preserves_volumes) {}

  /// Constructs the flow for an energy.
  /// \param energy the energy; copied
  /// \param preserves_volumes whether each label keeps its volume, in the plane its area. Each
  ///        label then has a pressure, so a cluster of soap bubbles in equilibrium stays at rest.
  ///        Volumes are preserved up to rounding for labels that do not touch the boundary of the
  ///        domain. The time step must be shorter than the time in which a label would vanish
  ///        without its pressure.
  /// \param divides_steps whether steps are divided by their error. Flows in which components vanish
  ///        all the time, and whose steps are short, need no division.
  explicit Mean_curvature_flow(const Interface_energy& energy, bool preserves_volumes = false,
                               bool divides_steps = true)
      : m_energy(energy), m_preserves_volumes(preserves_volumes), m_divides_steps(divides_steps) {}

  /// Returns the energy that the flow decreases.
  const Interface_energy& energy() const { return m_energy; }

  /// Returns whether each label keeps its volume. `advect_adaptively()` then restores the volumes
  /// after each adaptation.
  bool preserves_volumes() const { return m_preserves_volumes; }

  /// Computes the destinations of all vertices, see `InterfaceStep`. The flow solves three linear
  /// systems by the conjugate gradient method in each part of the time step. Its iterations are
  /// linear in the size n of the interface, and their number grows with the square root of the time
  /// step divided by the area of a facet. The preservation of volumes solves as many additional
  /// systems as there are labels. It takes memory for each pair of a vertex and a label on the same
  /// connected component of the interface.
  /// \return the largest difference of a vertex between one implicit step and two of half the
  ///         length, summed over the parts of the step. The extrapolated result is more exact.
  /// \throws Error if dt is negative, if all facets of a vertex have area 0, if a function of the
  ///         energy returns a value out of its range, or if a system cannot be solved
  template <class Complex>
  double operator()(const Interface_snapshot<Complex>& interface_,
                    const std::vector<typename Complex::Point>& positions, double /*t*/, double dt,
                    std::vector<typename Complex::Point>& destinations) const;

private:
  // Largest difference of one step and two steps of half the length, in mean edges. Longer steps
  // are divided, in the plane.
  static constexpr double error_bound = .005;
  // Shortest part of a step. At a corner, the curvature has no bound.
  static constexpr double shortest_step = 1. / 1024;
  static constexpr double rounding = 1e-9; // of the rest of a step

  // Returns the destinations of a step in parts of an error up to the tolerance.
  // \param whole the positions after half of the step, by one implicit step
  // \param total the sum of the errors of the parts
  template <class Complex>
  std::vector<typename Complex::Point>
  divided_step(const Interface_snapshot<Complex>& interface_,
               std::vector<typename Complex::Point> positions, double dt,
               std::vector<typename Complex::Point> whole, double tolerance, double& total) const {
    double step = dt / 2, sum = 0;
    for (double rest = dt;;) {
      for (;;) {
        Progress_scope::check();
        const auto half = implicit_step(interface_, positions, step / 2);
        const auto halves = implicit_step(interface_, half, step / 2);
        const double error = largest_distance<Complex>(whole, halves);
        if (error <= tolerance || step / 2 < shortest_step * dt) {
          positions = extrapolated<Complex>(whole, halves);
          sum += error;
          rest = step < (1 - rounding) * rest ? rest - step : 0;
          step *= error < tolerance / 4 ? 2 : 1;
          break;
        }
        whole = half;
        step /= 2;
      }
      if (!(rest > 0)) {
        total = sum;
        return positions;
      }
      step = (std::min)(step, rest);
      whole = implicit_step(interface_, positions, step);
    }
  }

  // Returns the result of second order, from one step and from two steps of half the length.
  template <class Complex>
  static std::vector<typename Complex::Point>
  extrapolated(const std::vector<typename Complex::Point>& whole,
               std::vector<typename Complex::Point> halves) {
    for (std::size_t i = 0; i < halves.size(); ++i)
      halves[i] = halves[i] + (halves[i] - whole[i]);
    return halves;
  }

  template <class Complex>
  static double mean_edge(const Interface_snapshot<Complex>& interface_,
                          const std::vector<typename Complex::Point>& positions) {
    double sum = 0;
    std::size_t number = 0;
    for (const auto& facet : interface_.facets())
      for (const auto& [i, j] : Complex::Space::facet_edges) {
        const auto& p = positions[facet.vertices[i]];
        sum += Complex::Space::length(
            interface_.domain.nearest_image(p, positions[facet.vertices[j]]) - p);
        ++number;
      }
    return sum / double(number);
  }

  template <class Complex>
  static double largest_distance(const std::vector<typename Complex::Point>& a,
                                 const std::vector<typename Complex::Point>& b) {
    double result = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      result = (std::max)(result, (a[i] - b[i]).squared_length());
    return std::sqrt(result);
  }

  // Corrects the destinations so that the volumes of all labels are those at the positions, within
  // the constraints of vertices.
  template <class Complex>
  void restore_volumes(const Interface_snapshot<Complex>& interface_,
                       const std::vector<typename Complex::Point>& positions,
                       std::vector<typename Complex::Point>& destinations) const {
    using Forces = internal::Interface_forces<Complex>;
    const Volume_changer<Complex> changer(interface_);
    const auto amounts = changer.changes(destinations, positions);
    const Forces forces(interface_, positions, m_energy);
    if (!forces.has_obstacles()) {
      changer.change_by(amounts, destinations);
      return;
    }
    auto directions = changer.gradients(amounts, destinations);
    for (const auto& [v, constraint] : forces.constraints())
      for (auto& [label, direction] : directions[v])
        direction = Forces::vector((constraint * Forces::vector(direction)).eval());
    changer.change_by(amounts, directions, destinations);
  }

  // Returns the positions after one backward Euler step with the weights of its beginning. Vertices
  // on sides of the domain stay on these sides.
  template <class Complex>
  std::vector<typename Complex::Point>
  implicit_step(const Interface_snapshot<Complex>& interface_,
                const std::vector<typename Complex::Point>& positions, double dt) const {
    using System = internal::Curvature_system<Complex>;
    static constexpr int d = Complex::dimension;
    const internal::Interface_forces<Complex> forces(interface_, positions, m_energy);
    const System system(interface_, forces, dt);
    Eigen::VectorXd right(d * Eigen::Index(positions.size()));
    for (std::size_t v = 0; v < positions.size(); ++v)
      right.segment<d>(System::row(v, 0)) = dt * forces.force(v);
    const auto displacement = [](const Eigen::VectorXd& x, std::size_t v) {
      return System::Forces::vector(x.segment<d>(System::row(v, 0)).eval());
    };
    const Eigen::VectorXd motion = system.solve(right);
    std::vector<typename Complex::Point> result;
    for (std::size_t v = 0; v < positions.size(); ++v)
      result.push_back(positions[v] + displacement(motion, v));
    if (!m_preserves_volumes)
      return result;

    // The responses of vertices to a unit pressure in each label. A response is zero on components
    // of the interface that do not touch the label.
    const Volume_changer<Complex> changer(interface_);
    const auto labels = changer.changes(positions, positions);
    const auto pressures = changer.gradients(labels, positions);
    typename Volume_changer<Complex>::Directions responses(positions.size());
    for (Eigen::Index label = 0; label < Eigen::Index(labels.size()); ++label) {
      right.setZero();
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (const auto found = pressures[v].find(label); found != pressures[v].end())
          for (int axis = 0; axis < d; ++axis)
            right(System::row(v, axis)) = found->second[axis];
      const Eigen::VectorXd response = system.solve(right);
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (const auto part = displacement(response, v); part != NULL_VECTOR)
          responses[v].emplace(label, part);
    }
    changer.change_by(changer.changes(result, positions), responses, result);
    return result;
  }

  Interface_energy m_energy;
  bool m_preserves_volumes = false;
  bool m_divides_steps = true;
};

template <class Complex>
double Mean_curvature_flow::operator()(const Interface_snapshot<Complex>& interface_,
                                       const std::vector<typename Complex::Point>& positions,
                                       double /*t*/, double dt,
                                       std::vector<typename Complex::Point>& destinations) const {
  if (!(dt >= 0))
    throw Error("mean curvature flow cannot go back in time: use a time step of 0 or more");
  destinations.clear();
  if (positions.empty())
    return 0;
  const auto whole = implicit_step(interface_, positions, dt);
  const auto half = implicit_step(interface_, positions, dt / 2);
  const auto halves = implicit_step(interface_, half, dt / 2);
  destinations = extrapolated<Complex>(whole, halves);
  double error = largest_distance<Complex>(whole, halves);
  if (Complex::dimension == 2 && m_divides_steps) {
    const double tolerance = error_bound * mean_edge(interface_, positions);
    if (error > tolerance)
      try {
        destinations = divided_step(interface_, positions, dt, half, tolerance, error);
      } catch (const Error&) {
        // A component vanishes within the step, which only the whole step passes over.
      }
  }
  if (m_preserves_volumes)
    restore_volumes(interface_, positions, destinations);
  return error;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_MEAN_CURVATURE_FLOW_H
