// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_INTERFACE_H
#define CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_INTERFACE_H

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/deform_distributed_interface.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/internal/curvature/Interface_forces.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Conjugate_gradients.h>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

// The system of `Curvature_system` on several ranks: each rank has the rows of its own vertices.
// The conjugate gradient method with the diagonal as preconditioner solves it. Scalar products do
// not depend on the ranks, so the solution has the same bits for any number of ranks.
template <class Complex> class Distributed_curvature_system
{
public:
  static constexpr int d = Complex::dimension;
  using Distributed = Distributed_complex<Complex>;
  using Interface = typename Distributed::Interface;
  using Forces = Interface_forces<Complex>;
  using Vector = typename Forces::Vector;
  using Vectors = std::vector<Vector>; // one for each vertex of the interface here

  // \throws Error on all ranks if all facets of a vertex have area zero
  Distributed_curvature_system(const Distributed& dsc, const Interface& interface_,
                               const Forces& forces, double dt)
      : m_dsc(dsc), m_interface(interface_), m_forces(forces), m_dt(dt),
        m_diagonal(interface_.indices.size()) {
    bool is_flat = false;
    for (std::size_t v = 0; v < m_diagonal.size(); ++v) {
      m_diagonal[v] = forces.mass(v).diagonal();
      if (!dsc.mesh().is_own(interface_.indices[v]))
        continue;
      m_own.push_back(v);
      const auto* const constraint = forces.constraint(v);
      is_flat =
          is_flat || (!(forces.share(v) > 0) && !(constraint != nullptr && constraint->isZero(0)));
    }
    dsc.communicator().agree_on_error(
        is_flat ? "the step of mean curvature flow cannot be computed: all facets of a vertex have "
                  "area zero; use a shorter time step"
                : "");
    for (const auto& pull : forces.pulls())
      for (std::size_t v : {pull.from, pull.to})
        m_diagonal[v] += Vector::Constant(dt * pull.weight);
  }

  // Returns the solution for a right-hand side, also for ghosts.
  // \throws Error on all ranks if the method does not converge
  Vectors solve(Vectors right) const {
    static constexpr double tolerance = 1e-13, sufficient = 1e-9; // of the relative residual
    for (std::size_t v = 0; v < right.size(); ++v)
      right[v] = constrained(v, right[v]);
    const std::size_t most = 2 * d *
                             std::size_t(m_dsc.communicator().reduced(Communicator::Operation::sum,
                                                                      std::int64_t(m_own.size())));
    double size = 0, rest = 0; // squared norms of the right-hand side and of the residual
    std::size_t iterations = 0;
    Vectors solution = conjugate_gradients(
        *this, std::move(right), [&](const Vector& /* energy */, const Vectors& residuals) {
          rest = sum([&](std::size_t v) { return product(residuals[v], residuals[v]); })[0];
          if (iterations == 0)
            size = rest;
          return iterations++ < most && rest > tolerance * tolerance * size;
        });
    if (!(rest <= sufficient * sufficient * size)) // equal on all ranks
      throw Error(
          "the step of mean curvature flow cannot be computed: the linear system is too ill "
          "conditioned; use a shorter time step");
    m_dsc.share(m_interface, solution);
    return solution;
  }

  // The rows of own vertices for `conjugate_gradients()`.

  // The sides are the axes, which are coupled: all have the scalar product of the vectors.
  static Vector product(const Vector& x, const Vector& y) { return Vector::Constant(x.dot(y)); }
  static bool is_stuck(const Vector& curvature) { return !(curvature[0] > 0); }

  Vector preconditioned(std::size_t v, const Vector& x) const {
    return constrained(v, x.cwiseQuotient(m_diagonal[v]));
  }

  Vector apply(Vectors& directions, Vectors& products) const {
    m_dsc.communicator().check_progress();
    m_dsc.share(m_interface, directions);
    for (std::size_t v = 0; v < directions.size(); ++v)
      products[v] = m_forces.mass(v) * directions[v];
    for (const auto& pull : m_forces.pulls()) {
      const Vector difference = m_dt * pull.weight * (directions[pull.from] - directions[pull.to]);
      products[pull.from] += difference;
      products[pull.to] -= difference;
    }
    for_each_row([&](std::size_t v) { products[v] = constrained(v, products[v]); });
    return sum([&](std::size_t v) { return product(directions[v], products[v]); });
  }

  template <class Function> void for_each_row(const Function& f) const {
    for (std::size_t v : m_own)
      f(v);
  }

  template <class Function> Vector sum(const Function& f) const {
    std::vector<std::array<double, 1>> terms;
    for_each_row([&](std::size_t v) { terms.push_back({f(v)[0]}); });
    return Vector::Constant(Exact_sums<1>(m_dsc.communicator())(terms)[0]);
  }

private:
  Vector constrained(std::size_t v, const Vector& x) const {
    const auto* const constraint = m_forces.constraint(v);
    return constraint != nullptr ? (*constraint * x).eval() : x;
  }

  const Distributed& m_dsc;
  const Interface& m_interface;
  const Forces& m_forces;
  double m_dt;
  std::vector<std::size_t> m_own; // vertices of this rank
  Vectors m_diagonal;
};

// Returns the destinations of the vertices of the interface here after a step of mean curvature
// flow, as `Mean_curvature_flow` computes them.
template <class Complex>
std::vector<typename Complex::Point>
mean_curvature_destinations(const Distributed_complex<Complex>& dsc,
                            const typename Distributed_complex<Complex>::Interface& interface_,
                            const Interface_energy& energy, double dt) {
  using System = Distributed_curvature_system<Complex>;
  using Points = std::vector<typename Complex::Point>;
  std::vector<Boundary_class::Bits> sides;
  for (auto v : interface_.indices)
    sides.push_back(dsc.mesh().piece.vertex(v).boundary_class);
  const auto implicit_step = [&](const Points& positions, double time) {
    const Interface_forces<Complex> forces(interface_.snapshot, positions, energy, sides);
    const System system(dsc, interface_, forces, time);
    typename System::Vectors right;
    for (std::size_t v = 0; v < positions.size(); ++v)
      right.push_back(time * forces.force(v));
    const auto motion = system.solve(right);
    Points result;
    for (std::size_t v = 0; v < positions.size(); ++v)
      result.push_back(positions[v] + Interface_forces<Complex>::vector(motion[v]));
    return result;
  };
  const Points whole = implicit_step(interface_.positions, dt);
  Points result = implicit_step(implicit_step(interface_.positions, dt / 2), dt / 2);
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = result[v] + (result[v] - whole[v]);
  return result;
}

// An interface velocity on several ranks: each rank computes the velocities of its own vertices,
// and gets those of the others. An exception of the velocity on one rank is thrown on all ranks.
template <class Complex, class Velocity> class Shared_velocity
{
public:
  using Distributed = Distributed_complex<Complex>;

  Shared_velocity(const Distributed& dsc, const typename Distributed::Interface& interface_,
                  const Velocity& velocity)
      : m_dsc(dsc), m_interface(interface_), m_velocity(velocity) {}

  void operator()(const Interface_snapshot<Complex>& snapshot,
                  const std::vector<typename Complex::Point>& positions, double t,
                  std::vector<typename Complex::Vector>& velocities) const {
    m_dsc.communicator().call_together([&] {
      m_velocity(snapshot, positions, t, velocities);
      if (velocities.size() != positions.size())
        throw Error("the number of velocities differs from the number of interface vertices: give "
                    "one velocity for each vertex");
      for (std::size_t i = 0; i < velocities.size(); ++i)
        if (m_dsc.mesh().is_own(m_interface.indices[i]) && !has_finite_coordinates(velocities[i]))
          throw Error("a velocity is not finite: correct the velocity");
    });
    m_dsc.share(m_interface, velocities);
  }

private:
  const Distributed& m_dsc;
  const typename Distributed::Interface& m_interface;
  const Velocity& m_velocity;
};

inline void require_distributed_scheme(Integration_scheme scheme) {
  if (scheme == Integration_scheme::adaptive)
    throw Error("the adaptive scheme is not available on several ranks: use rk2 or rk4");
}

template <class Velocity> void require_distributed_flow(const Velocity& velocity) {
  if (preserves_volumes(velocity))
    throw Error("flows on several ranks do not preserve volumes: use one rank");
}

// Returns the destinations of the vertices of the interface here in a time step.
// \throws Error on all ranks as `advect_interface()`
template <class Complex, class Velocity>
std::vector<typename Complex::Point>
distributed_destinations(const Distributed_complex<Complex>& dsc,
                         const typename Distributed_complex<Complex>::Interface& interface_,
                         const Velocity& velocity, double t, double dt, Integration_scheme scheme) {
  require_distributed_scheme(scheme);
  const auto destinations_with = [&](const auto& v) {
    return find_destinations(interface_.snapshot, interface_.positions, v, t, dt, scheme, 0.);
  };
  std::vector<typename Complex::Point> destinations;
  dsc.communicator().call_together([&] {
    if constexpr (is_velocity_field<Complex, Velocity> || is_flow_map<Complex, Velocity> ||
                  is_interface_step<Complex, Velocity>)
      destinations = destinations_with(velocity);
    else // throws on all ranks or on none
      destinations =
          destinations_with(Shared_velocity<Complex, Velocity>(dsc, interface_, velocity));
  });
  return destinations;
}

// Returns the destinations after a step of mean curvature flow.
// \throws Error on all ranks as `advect_interface()`
template <class Complex>
std::vector<typename Complex::Point>
distributed_destinations(const Distributed_complex<Complex>& dsc,
                         const typename Distributed_complex<Complex>::Interface& interface_,
                         const Mean_curvature_flow& flow, double /*t*/, double dt,
                         Integration_scheme /*scheme*/) {
  require_distributed_flow(flow);
  if (!(dt >= 0))
    throw Error("mean curvature flow cannot go back in time: use a time step of 0 or more");
  return mean_curvature_destinations(dsc, interface_, flow.energy(), dt);
}

} // namespace internal

/*!
\ingroup PkgDistributedComplexesRef

Moves the interface with a velocity for one time step, as `advect_interface()` does on one rank.

\param dsc the complex
\param velocity a velocity field, a flow map, or an interface velocity or step that computes the
       value of a vertex from the facets around it only, such as `Normal_offset`. Also a
       `Mean_curvature_flow` that does not preserve volumes: all ranks solve its systems together by
       the conjugate gradient method. If the velocity has a member function `energy()`, its result
       replaces `interface_energy`.
\param t the time at the beginning of the step
\param dt the length of the step; not negative for a `Mean_curvature_flow`
\param options the options
\param scheme the method that integrates velocities; `Integration_scheme::adaptive` chooses the same
       substeps for all vertices, which would depend on the rank, and is not available
\return the report, equal on all ranks
\throws Error on all ranks if the velocity throws on a rank, returns a wrong number of values, or
        `scheme` is `adaptive`; for a `Mean_curvature_flow` if it preserves volumes, `dt` is
        negative, or a system cannot be solved. The complex is then unchanged.
\throws Error, Interrupted_error as `deform_interface_to()`

Collective.
*/
template <class Complex, class Velocity>
Distributed_report<Complex>
advect_interface(Distributed_complex<Complex>& dsc, const Velocity& velocity, double t, double dt,
                 Distributed_options<Distributed_complex<Complex>> options =
                     Distributed_options<Distributed_complex<Complex>>(),
                 Integration_scheme scheme = Integration_scheme::rk2) {
  using Points = std::vector<typename Complex::Point>;
  const auto interface_ = dsc.interface_here();
  const Points destinations =
      internal::distributed_destinations(dsc, interface_, velocity, t, dt, scheme);
  options.interface_energy = internal::energy_of(velocity, options.interface_energy);
  std::function<Points(const Points&)> flow;
  if constexpr (internal::is_flow_of_space<Complex, Velocity>)
    flow = [&](const Points& points) {
      return internal::follow_flow<Complex>(typename Complex::Domain(), points, velocity, t, dt);
    };
  return deform_interface_to(dsc, interface_, destinations, options, flow);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_INTERFACE_H
