// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H
#define CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H

#include <CGAL/license/Interface_flows.h>

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

// Returns the volumes of all labels except the smallest label. The smallest label takes the
// remaining volume.
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

Moves the interface with a velocity for one time step, as `advect_interface()` does, and adapts the
interface and the mesh. The function is meant for long runs of flows that stretch and fold the
interface. The interface gets facets as small as its curvature requires, and the mesh gets enough
cells for thin sheets and threads.

The number of a step is `t / dt`, rounded. If this number is a multiple of `adaptation_interval`,
the mesh is adapted at the beginning of the step:
- The interface is adapted if it is worn and the step stretches it. It is worn if more than a few
  edges are too long for their curvature, or too short. Long edges are then split, and the new
  vertices are placed on the smooth surface that the neighboring facets suggest. Short edges are
  collapsed. See `improve_interface()` and `Curvature_sizing_field`. A rigid motion therefore keeps
  all facets, and a flow that stretches the interface only a little keeps them, too.
- For a flow that contracts the interface, such as `Mean_curvature_flow`, these edges are always
  split and collapsed. In the plane, vertices where more than three phases meet are split as well,
  see `propose_junction_split()`, unless the parameter `topology_control` is given.
- If the flow preserves volumes, `restore_volumes()` restores the volumes from before the
  adaptation.
- Edges between two parts of the interface are split, and short edges away from it are collapsed:
  `control_detail()` with a `collapse_length` of 2.

The defaults of some parameters differ from those of `advect_interface()`. Cells may become flatter,
and facets of the interface may become longer, because the flow may bring the interface back. A flow
that contracts the interface does not bring it back. It has the defaults of `advect_interface()` for
the last three parameters below.

\param dsc the complex
\param velocity as for `advect_interface()`. If the interface is worn, the step is integrated once
       more. The velocity contracts the interface if its type has a member
       `static constexpr bool contracts_interface` that is `true`. It preserves volumes if its
       member function `preserves_volumes()` returns `true`.
\param t the time at the beginning of the step
\param dt the length of the step. It must be the same in each step; otherwise use an
       `adaptation_interval` of 1.
\param np named parameters: those of `advect_interface()` and

\cgalNamedParamsBegin
  \cgalParamNBegin{interface_tolerance}
    \cgalParamDescription{the largest distance of an edge of an adapted interface from the smooth
                          surface, in units of `dsc.mean_interface_edge()`, not negative; with 0,
                          the interface is not adapted}
    \cgalParamType{`double`}
    \cgalParamDefault{0.04 in space, 0.005 in the plane}
  \cgalParamNEnd
  \cgalParamNBegin{adaptation_interval}
    \cgalParamDescription{the number of steps from one adaptation to the next, positive}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{4; 1 if the velocity contracts the interface}
  \cgalParamNEnd
  \cgalParamNBegin{feature_angle}
    \cgalParamDescription{edges with a larger angle between the normals of their facets are sharp
                          and stay when the interface is adapted, in degrees, in [0, 180]}
    \cgalParamType{`double`}
    \cgalParamDefault{85: the edges of a cube are sharp, the rims of thin sheets are not. 180 for a
                      velocity that contracts the interface in the plane, where corners become round
                      at once}
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

\return the report of `advect_interface()`. Its numbers of operations include the adaptation.
\throws Error if one of the first three parameters is out of its range, or if there is an interface
        and `dsc.mean_interface_edge()` is 0. The complex is then unchanged.
\throws Invalid_destination_error, Error as `advect_interface()`. The interface has then not moved,
        but it may have been adapted.

The time is that of `advect_interface()`. A step that adapts takes additional time: n log n in the
size of the interface, and one pass over the cells.
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
  const unsigned interval = count_parameter(np, tags::adaptation_interval, "adaptation_interval",
                                            Defaults::adaptation_interval);
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
