// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ADVECT_INTERFACE_3_H
#define CGAL_ADVECT_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/Integration_scheme.h>
#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/deform_interface_3.h>

#include <type_traits>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// Velocities of all vertices of a snapshot at given positions, from a field of velocities
// (position, time) or from a function of the whole interface.
template <class Complex, class Velocity>
std::vector<typename Complex::Approximate_vector_3>
velocities_at(const Interface_snapshot_3<Complex>& interface_,
              const std::vector<typename Complex::Approximate_point_3>& positions, double t,
              const Velocity& velocity) {
  std::vector<typename Complex::Approximate_vector_3> result;
  if constexpr (std::is_invocable_v<const Velocity&, typename Complex::Approximate_point_3,
                                    double>) {
    for (const auto& p : positions)
      result.push_back(velocity(p, t));
  } else {
    velocity(interface_, positions, t, result);
    if (result.size() != positions.size())
      throw Invalid_destination_error(
          "a velocity must be given for each vertex of the interface, no more and no fewer", {});
  }
  std::vector<std::size_t> refused;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (!has_finite_coordinates(result[i]))
      refused.push_back(i);
  if (!refused.empty())
    throw Invalid_destination_error(
        "a velocity is not finite; check the velocities and the time step", refused);
  return result;
}

// Where the vertices of a snapshot are at t + dt.
template <class Complex, class Velocity>
std::vector<typename Complex::Approximate_point_3>
integrate(const Interface_snapshot_3<Complex>& interface_,
          const std::vector<typename Complex::Approximate_point_3>& start, const Velocity& velocity,
          double t, double dt, Integration_scheme scheme) {
  using Point = typename Complex::Approximate_point_3;
  if constexpr (std::is_invocable_v<const Velocity&, Point, double, double>) {
    std::vector<Point> result;
    for (const Point& p : start)
      result.push_back(velocity(p, t, dt));
    return result;
  } else {
    using Vectors = std::vector<typename Complex::Approximate_vector_3>;
    const auto advance = [&](const Vectors& v, double step) {
      std::vector<Point> result;
      for (std::size_t i = 0; i < start.size(); ++i)
        result.push_back(start[i] + step * v[i]);
      return result;
    };
    const auto at = [&](const std::vector<Point>& positions, double time) {
      return velocities_at(interface_, positions, time, velocity);
    };
    Vectors k1 = at(start, t);
    if (scheme == Integration_scheme::euler)
      return advance(k1, dt);
    const Vectors k2 = at(advance(k1, dt / 2), t + dt / 2);
    if (scheme == Integration_scheme::rk2)
      return advance(k2, dt);
    const Vectors k3 = at(advance(k2, dt / 2), t + dt / 2);
    const Vectors k4 = at(advance(k3, dt), t + dt);
    for (std::size_t i = 0; i < k1.size(); ++i)
      k1[i] = (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6;
    return advance(k1, dt);
  }
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Moves the interface with a velocity for one step of time: integrates the path of each vertex, then
calls `deform_interface()`. The path within the step is not followed, only its end.

\param dsc the complex
\param velocity one of
  - a velocity field, called as `velocity(p, t)` with a position and a time: returns a vector;
  - a flow map (model of `InterfaceFlowMap_3`), called as `velocity(p, t, dt)`: returns the position
    at t + dt of what is at p at t; the scheme does not matter then;
  - a function of the whole interface (model of `InterfaceVelocity_3`), called once for each
    evaluation as `velocity(interface, positions, t, velocities)`, which fills `velocities`.
  .
  Positions and vectors are of `Complex::Approximate_point_3` and `Approximate_vector_3`, in the
  coordinates of the complex.
\param t time at the beginning of the step.
\param dt its length; negative to go back.
\param np named parameters: those of `deform_interface()` and

\cgalNamedParamsBegin
  \cgalParamNBegin{scheme}
    \cgalParamDescription{how destinations follow from velocities}
    \cgalParamType{`Deformable_simplicial_complexes::Integration_scheme`}
    \cgalParamDefault{`Integration_scheme::rk2`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report of `deform_interface()`.
\throws Deformable_simplicial_complexes::Invalid_destination_error if a velocity is not finite; the
        complex is then unchanged.
*/
template <
    class Complex, class Velocity,
    class NamedParameters = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Deformation_report<Complex> advect_interface(Complex& dsc, const Velocity& velocity, double t,
                                             double dt,
                                             const NamedParameters& np = NamedParameters()) {
  using Deformable_simplicial_complexes::Integration_scheme;
  const Integration_scheme scheme = parameters::choose_parameter(
      parameters::get_parameter(np, Deformable_simplicial_complexes::internal_np::scheme),
      Integration_scheme::rk2);
  const Interface_snapshot_3<Complex> interface_(dsc);
  const auto destinations = Deformable_simplicial_complexes::internal::integrate(
      interface_, interface_.positions(dsc), velocity, t, dt, scheme);
  Deformable_simplicial_complexes::internal::number_vertices(interface_.vertices);
  return deform_interface(
      dsc,
      [&](typename Complex::Vertex_handle v) {
        return dsc.geom_traits().construct_exact_point_3_object()(destinations[v->scratch_index()]);
      },
      np);
}

} // namespace CGAL

#endif // CGAL_ADVECT_INTERFACE_3_H
