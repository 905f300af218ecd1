// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_INTERFACE_H
#define CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_INTERFACE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/deform_distributed_interface.h>
#include <CGAL/Distributed_complexes/internal/curvature/Distributed_curvature_system.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/Mean_curvature_flow.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

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
                  const std::vector<typename Complex::Approximate_point>& positions, double t,
                  std::vector<typename Complex::Approximate_vector>& velocities) const {
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
std::vector<typename Complex::Approximate_point>
distributed_destinations(const Distributed_complex<Complex>& dsc,
                         const typename Distributed_complex<Complex>::Interface& interface_,
                         const Velocity& velocity, double t, double dt, Integration_scheme scheme) {
  require_distributed_scheme(scheme);
  const auto destinations_with = [&](const auto& v) {
    return find_destinations(interface_.snapshot, interface_.positions, v, t, dt, scheme, 0.);
  };
  std::vector<typename Complex::Approximate_point> destinations;
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
std::vector<typename Complex::Approximate_point>
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
  using Points = std::vector<typename Complex::Approximate_point>;
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
