// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H
#define CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H

#include <CGAL/Deformable_simplicial_complexes/Edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_adaptation.h>
#include <CGAL/Deformable_simplicial_complexes/control_detail.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>
#include <CGAL/Deformable_simplicial_complexes/restore_volumes.h>
#include <CGAL/Deformable_simplicial_complexes/topology_control.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>

#include <cmath>
#include <map>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The volumes of all labels but the least one, which takes what is left.
template <class Complex>
std::map<typename Complex::Label, double> volumes_but_one(const Complex& dsc) {
  std::map<typename Complex::Label, double> result;
  for (const auto label : dsc.labels())
    result.emplace(label, dsc.measure(label));
  if (!result.empty())
    result.erase(result.begin());
  return result;
}

} // namespace internal

/*!
\ingroup PkgInterfaceFlowsRef

Moves the interface with a velocity for one step of time, as `advect_interface()` does, in long runs
of flows that stretch and fold it: thin sheets and threads find room, and the interface gets facets
as fine as its curvature asks for.

A step whose number, `t / dt` rounded, is a multiple of the interval begins with what adapts the
mesh:
- If the interface is *worn*, and the step stretches it, then long edges are split on the smooth
  surface that their neighbors suggest, and short ones are collapsed, see `improve_interface()` and
  `Curvature_sizing_field`. It is worn if more than a few edges are too long for their curvature, or
  too short. What moves rigidly, and what is stretched only a little, is not touched.
- A flow that contracts the interface, such as `Mean_curvature_flow`, splits and collapses these
  edges in each step. In the plane, vertices where more than three phases meet are split, too, see
  `propose_junction_split()`, unless there is a parameter `topology_control`.
- If the flow preserves volumes, `restore_volumes()` corrects what this changed.
- Edges between parts of the interface are split, and short ones away from it collapsed:
  `control_detail()` with a `collapse_length` of 2.

Cells may get flatter than with `advect_interface()`, and triangles of the interface as long as the
flow draws them, as it may bring them back: the defaults of some parameters differ. Flows that
contract the interface bring nothing back, and have the defaults of `advect_interface()`.

\param dsc the complex
\param velocity as for `advect_interface()`; asked once more where the interface is worn. It contracts
       the interface if its type has a `static constexpr bool contracts_interface` that is `true`.
\param t time at the beginning of the step.
\param dt its length, the same for each step; if it is not, use an `adaptation_interval` of 1.
\param np named parameters: those of `advect_interface()` and

\cgalNamedParamsBegin
  \cgalParamNBegin{interface_tolerance}
    \cgalParamDescription{how far edges of an adapted interface may lie from the smooth surface, in
                          units of `dsc.mean_interface_edge()`, not negative; with 0, the interface
                          is changed only where it must}
    \cgalParamType{`double`}
    \cgalParamDefault{0.04 in space, 0.005 in the plane}
  \cgalParamNEnd
  \cgalParamNBegin{adaptation_interval}
    \cgalParamDescription{number of steps from one that adapts to the next, positive}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{4; 1 if the velocity contracts the interface}
  \cgalParamNEnd
  \cgalParamNBegin{feature_angle}
    \cgalParamDescription{edges where the normals of the facets differ by more are sharp, in
                          degrees, in [0, 180]: they stay when the interface is adapted}
    \cgalParamType{`double`}
    \cgalParamDefault{85: below a cube, above the rims of thin sheets. 180 for curvature flow in the
                       plane, which rounds corners at once}
  \cgalParamNEnd
  \cgalParamNBegin{scheme}
    \cgalParamDefault{`Integration_scheme::rk4`}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDefault{0.1; 0.2 if the velocity contracts the interface}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_angle}
    \cgalParamDefault{0.1; 5 if the velocity contracts the interface}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_facet_angle}
    \cgalParamDefault{0; 5 if the velocity contracts the interface}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the report of `advect_interface()`; its numbers of operations count those that adapted, too.
\throws Error if a parameter of the first three is out of its range, or
        there is an interface, but no `dsc.mean_interface_edge()`; the complex is then unchanged.
        What `advect_interface()` throws leaves the interface as it was or adapted.

As `advect_interface()`; where a step adapts, n log n in the size of the interface more, and a pass
over the cells.
*/
template <class Complex, class Velocity,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> advect_adaptively(Complex& dsc, const Velocity& velocity, double t,
                                              double dt,
                                              const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  constexpr bool contracts = internal::contracts_interface<Velocity>;
  constexpr bool has_topology_control =
      !CGAL::parameters::is_default_parameter<NamedParameters, tags::topology_control_t>::value;
  using Defaults = defaults::Adaptive_advection<Complex::dimension, contracts>;
  const Adaptation_options options = {
      number_parameter(np, tags::interface_tolerance, Defaults::interface_tolerance),
      angle_parameter(np, tags::feature_angle, Defaults::feature_angle, 180, "angle of features"),
      !contracts, contracts && !has_topology_control};
  const unsigned interval = internal::count_parameter(
      np, tags::adaptation_interval, "adaptation_interval", Defaults::adaptation_interval);
  if (!(options.tolerance >= 0))
    throw Error("the tolerance of the interface is out of range: use 0 or more");
  if (interval == 0)
    throw Error("the interval between adaptations is out of range: use 1 or more");
  require_interface_edge(dsc);
  const auto motion =
      np.scheme(parameter_or(np, tags::scheme, Integration_scheme::rk4))
          .quality_threshold(
              number_parameter(np, tags::quality_threshold, Defaults::quality_threshold))
          .minimum_angle(number_parameter(np, tags::minimum_angle, Defaults::minimum_angle))
          .minimum_facet_angle(
              number_parameter(np, tags::minimum_facet_angle, Defaults::minimum_facet_angle));

  Improvement_report changes;
  if (std::fmod(std::round(t / dt), interval) == 0 && !dsc.interface_vertices().empty()) {
    const auto visitor = parameter_or(np, CGAL::internal_np::visitor, Deformation_visitor());
    const auto is_stretching = [&](const auto& interface_) {
      return is_stretched(interface_, interface_.positions(dsc),
                          internal::destinations_of_step(dsc, interface_, velocity, t, dt, motion));
    };
    const auto volumes = internal::volumes_but_one(dsc);
    changes = keep_interface_fit(dsc, options, is_stretching, visitor);
    if (internal::preserves_volumes(velocity))
      restore_volumes(dsc, volumes,
                      motion.topology_control(Forbid_topology_changes()).relabeling_threshold(0.));
    changes =
        changes + control_detail(
                      dsc, parameters::collapse_length(Defaults::collapse_length).visitor(visitor));
  }
  Deformation_report<Complex> report = advect_interface(dsc, velocity, t, dt, motion);
  report.split += changes.split;
  report.collapsed += changes.collapsed;
  report.flipped += changes.flipped;
  report.smoothed += changes.smoothed;
  report.inserted += changes.inserted;
  return report;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H
