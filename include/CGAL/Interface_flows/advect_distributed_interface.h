// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_DISTRIBUTED_INTERFACE_H
#define CGAL_INTERFACE_FLOWS_ADVECT_DISTRIBUTED_INTERFACE_H

#include <CGAL/license/Interface_flows.h>

#include <CGAL/Deformable_simplicial_complexes/Distributed_complex.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/deform_distributed_interface.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/internal/curvature/Distributed_curvature_system.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

namespace internal {

// An interface velocity on several ranks: each rank computes the velocities of its own vertices,
// and gets those of the others. An exception of the velocity on one rank is thrown on all ranks.
template <class Complex, class Velocity> class Shared_velocity
{
public:
  using Distributed = Distributed_complex<Complex>;

  Shared_velocity(const Distributed& dsc, const typename Distributed::Interface& interface_,
                  const Velocity& velocity)
      : m_mesh(dsc.mesh()), m_interface(interface_), m_velocity(velocity) {}

  void operator()(const Interface_snapshot<Complex>& snapshot,
                  const std::vector<typename Complex::Approximate_point>& positions, double t,
                  std::vector<typename Complex::Approximate_vector>& velocities) const {
    static constexpr int d = Complex::dimension;
    m_mesh.communicator->call_together([&] {
      m_velocity(snapshot, positions, t, velocities);
      if (velocities.size() != positions.size())
        throw Error("the number of velocities differs from the number of interface vertices: give "
                    "one velocity for each vertex");
      for (std::size_t i = 0; i < velocities.size(); ++i)
        if (m_mesh.is_own(m_interface.indices[i]) && !has_finite_coordinates(velocities[i]))
          throw Error("a velocity is not finite: correct the velocity");
    });
    std::vector<std::array<double, d>> values(m_mesh.piece.vertex_bound());
    for (std::size_t i = 0; i < velocities.size(); ++i)
      values[m_interface.indices[i]] = coordinates_of<d>(velocities[i]);
    m_mesh.ghosts.update(values);
    for (std::size_t i = 0; i < velocities.size(); ++i)
      velocities[i] = vector_of<Complex>(values[m_interface.indices[i]]);
  }

private:
  const Distributed_mesh<Complex>& m_mesh;
  const typename Distributed::Interface& m_interface;
  const Velocity& m_velocity;
};

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Moves the interface with a velocity for one time step, as `advect_interface()` does on one rank.

\param dsc the complex
\param velocity a velocity field, a flow map, or an interface velocity or step that computes the
       value of a vertex from the facets around it only, such as `Normal_offset`
\param t the time at the beginning of the step
\param dt the length of the step
\param options the options
\param scheme the method that integrates velocities; `Integration_scheme::adaptive` chooses the same
       substeps for all vertices, which would depend on the rank, and is not available
\return the report, equal on all ranks
\throws Error on all ranks if the velocity throws on a rank, returns a wrong number of values, or
        `scheme` is `adaptive`; the complex is then unchanged
\throws Error, Interrupted_error as `deform_interface_to()`

Collective.
*/
template <class Complex, class Velocity>
Distributed_report<Complex>
advect_interface(Distributed_complex<Complex>& dsc, const Velocity& velocity, double t, double dt,
                 const Distributed_options<Distributed_complex<Complex>>& options =
                     Distributed_options<Distributed_complex<Complex>>(),
                 Integration_scheme scheme = Integration_scheme::rk2) {
  using Points = std::vector<typename Complex::Approximate_point>;
  if (scheme == Integration_scheme::adaptive)
    throw Error("the adaptive scheme is not available on several ranks: use rk2 or rk4");
  const auto interface_ = dsc.interface_here();
  const auto destinations_with = [&](const auto& v) {
    return internal::find_destinations(interface_.snapshot, interface_.positions, v, t, dt, scheme,
                                       0.);
  };
  Points destinations;
  dsc.communicator().call_together([&] {
    if constexpr (internal::is_velocity_field<Complex, Velocity> ||
                  internal::is_flow_map<Complex, Velocity> ||
                  internal::is_interface_step<Complex, Velocity>)
      destinations = destinations_with(velocity);
    else // throws on all ranks or on none
      destinations = destinations_with(
          internal::Shared_velocity<Complex, Velocity>(dsc, interface_, velocity));
  });
  std::function<Points(const Points&)> flow;
  if constexpr (internal::is_flow_of_space<Complex, Velocity>)
    flow = [&](const Points& points) {
      return internal::follow_flow<Complex>(typename Complex::Domain(), points, velocity, t, dt);
    };
  return deform_interface_to(dsc, interface_, destinations, options, flow);
}

/*!
\ingroup PkgInterfaceFlowsRef

Moves the interface by mean curvature for one time step, as `advect_interface()` does on one rank.
The conjugate gradient method solves the systems on all ranks together. The result is bitwise
identical for any number of ranks.

\param dsc the complex
\param flow the flow; it must not preserve volumes
\param dt the length of the step, not negative
\param options the options. `interface_energy` is replaced by the energy of the flow.
\return the report, equal on all ranks
\throws Error on all ranks if the flow preserves volumes, `dt` is negative, or a system cannot be
        solved, see `Mean_curvature_flow`; the complex is then unchanged
\throws Error, Interrupted_error as `deform_interface_to()`

Collective.
*/
template <class Complex>
Distributed_report<Complex>
advect_interface(Distributed_complex<Complex>& dsc, const Mean_curvature_flow& flow, double /*t*/,
                 double dt,
                 Distributed_options<Distributed_complex<Complex>> options =
                     Distributed_options<Distributed_complex<Complex>>()) {
  if (flow.preserves_volumes())
    throw Error("mean curvature flow on several ranks does not preserve volumes: use one rank");
  if (!(dt >= 0))
    throw Error("mean curvature flow cannot go back in time: use a time step of 0 or more");
  const auto interface_ = dsc.interface_here();
  options.interface_energy = flow.energy();
  return deform_interface_to(
      dsc, interface_, internal::mean_curvature_destinations(dsc, interface_, flow.energy(), dt),
      options);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_ADVECT_DISTRIBUTED_INTERFACE_H
