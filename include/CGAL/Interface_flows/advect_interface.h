// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H
#define CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Where the vertices of an interface go in a step, by the named parameters of advect_interface().
template <class Complex, class Interface, class Velocity, class NamedParameters>
std::vector<typename Complex::Approximate_point>
destinations_of_step(const Complex& dsc, const Interface& interface_, const Velocity& velocity,
                     double t, double dt, const NamedParameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Integration_scheme scheme =
      choose_parameter(get_parameter(np, internal_np::scheme), Integration_scheme::rk2);
  const double tolerance = choose_parameter(get_parameter(np, internal_np::integration_tolerance),
                                            defaults::integration_tolerance);
  if (!(tolerance > 0))
    throw Error("the tolerance of the integration is out of range: use more than 0");
  if (scheme == Integration_scheme::adaptive && !(dsc.mean_interface_edge() > 0) &&
      !interface_.vertices.empty())
    throw Error(
        "there is no unit for the tolerance of the integration: the complex was built without an "
        "interface; use another scheme");
  return find_destinations(interface_, interface_.positions(dsc), velocity, t, dt, scheme,
                           tolerance * dsc.mean_interface_edge());
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Moves the interface with a velocity for one step of time: integrates the path of each vertex, then
calls `deform_interface()`. The path within the step is not followed, only its end. Where the
velocity is known in all of space, as a field or an invertible flow map, free vertices around the
interface go with it, too, unless the parameter `flow` is given.

\param dsc the complex
\param velocity one of
  - a velocity field (model of `VelocityField`), called as `velocity(p, t)` with a position and a
    time: returns a vector;
  - a flow map (model of `InterfaceFlowMap`), called as `velocity(p, t, dt)`: returns the position
    at t + dt of what is at p at t; the scheme does not matter then;
  - a function of the whole interface (model of `InterfaceVelocity`), called once for each
    evaluation as `velocity(interface, positions, t, velocities)`, which fills `velocities`;
  - a motion of the whole interface (model of `InterfaceStep`), called once for the step as
    `velocity(interface, positions, t, dt, destinations)`, which fills `destinations`; the scheme
    does not matter then.
  .
  Positions and vectors are of `Complex::Approximate_point` and `Approximate_vector`, in the
  coordinates of the complex.
\param t time at the beginning of the step.
\param dt its length; negative to go back.
\param np named parameters: those of `deform_interface()` and

\cgalNamedParamsBegin
  \cgalParamNBegin{scheme}
    \cgalParamDescription{how destinations follow from velocities}
    \cgalParamType{`Integration_scheme`}
    \cgalParamDefault{`Integration_scheme::rk2`}
  \cgalParamNEnd
  \cgalParamNBegin{integration_tolerance}
    \cgalParamDescription{how far the error of a destination is estimated to be at the most with
                          `Integration_scheme::adaptive`, for each of the steps that it takes within
                          `dt`, in units of `dsc.mean_interface_edge()`, positive}
    \cgalParamType{`double`}
    \cgalParamDefault{1e-4}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report of `deform_interface()`.
\throws Invalid_destination_error if a velocity is not finite; the
        complex is then unchanged.
\throws Error if the tolerance is not positive or cannot be kept;
        the complex is then unchanged.
*/
template <class Complex, class Velocity,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> advect_interface(Complex& dsc, const Velocity& velocity, double t,
                                             double dt,
                                             const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  const internal::Interface_seen_by<Complex, Velocity> interface_(dsc);
  const auto destinations = internal::destinations_of_step(dsc, interface_, velocity, t, dt, np);
  constexpr bool has_flow =
      !CGAL::parameters::is_default_parameter<NamedParameters, tags::flow_t>::value;
  if constexpr (internal::is_flow_of_space<Complex, Velocity> && !has_flow) {
    auto flow = [&](const typename Complex::Approximate_point& p) {
      return internal::follow_flow<Complex>(dsc.domain(), p, velocity, t, dt);
    };
    const Named_parameters<decltype(flow), tags::flow_t, NamedParameters> with_flow(flow, np);
    return deform_interface_to(dsc, interface_, destinations, with_flow);
  } else {
    return deform_interface_to(dsc, interface_, destinations, np);
  }
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_ADVECT_INTERFACE_H
