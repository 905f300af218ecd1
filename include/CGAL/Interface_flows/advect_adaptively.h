// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H
#define CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Interface_flows/Integration_scheme.h>
#include <CGAL/Interface_flows/advect_interface.h>
#include <CGAL/Interface_flows/internal/paths/interface_paths.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>
#include <CGAL/Interface_remeshing/Adaptive_advection.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Interface_remeshing/Interface_adaptation.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {
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

Options of `advect_adaptively()`. The named parameters of that function have the same names. Default
values depend on whether the velocity contracts the interface, see `defaults::Adaptive_advection`.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Adaptive_advection_options
{
  /// Options of the advection.
  Advection_options<Complex> advection;
  /// Largest distance of an edge of an adapted interface from the smooth surface, in mean edges of
  /// the initial interface, at least 0. With 0, the interface is not adapted.
  double interface_tolerance;
  /// Number of steps from one adaptation to the next, at least 1.
  unsigned adaptation_interval;
  /// Edges are sharp if the normals of their facets differ by more, in degrees, in [0, 180].
  double feature_angle;

  /// Constructs options with default values.
  /// \param contracts whether the velocity contracts the interface
  explicit Adaptive_advection_options(bool contracts = false) {
    if (contracts)
      set<defaults::Adaptive_advection<Complex::dimension, true>>();
    else
      set<defaults::Adaptive_advection<Complex::dimension, false>>();
  }

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    advection.check();
    require_angle(feature_angle, 180, "feature angle");
    if (!(interface_tolerance >= 0))
      throw Error("the tolerance of the interface is out of range: use 0 or more");
    if (adaptation_interval == 0)
      throw Error("the interval between adaptations is out of range: use 1 or more");
  }

private:
  template <class Defaults> void set() {
    advection.scheme = Integration_scheme::rk4;
    advection.deformation.quality_threshold = Defaults::quality_threshold;
    advection.deformation.minimum_angle = Defaults::minimum_angle;
    advection.deformation.minimum_facet_angle = Defaults::minimum_facet_angle;
    interface_tolerance = Defaults::interface_tolerance;
    adaptation_interval = Defaults::adaptation_interval;
    feature_angle = Defaults::feature_angle;
  }
};

namespace internal {

// Adapts the interface and moves it for one time step, see `advect()`.
template <class Complex>
Deformation_report<Complex> adapt_and_advect(Complex& dsc, const Step_velocity<Complex>& velocity,
                                             double t, double dt,
                                             const Adaptive_advection_options<Complex>& options) {
  const bool contracts = velocity.contracts();
  options.check();
  require_interface_edge(dsc);
  const Deformation_options<Complex>& deformation = options.advection.deformation;
  Improvement_report changes;
  const auto earlier = volumes_before(dsc); // the adaptation
  if (std::fmod(std::round(t / dt), options.adaptation_interval) == 0 &&
      !dsc.interface_vertices().empty()) {
    const Adaptation_options adaptation = {options.interface_tolerance, options.feature_angle,
                                           !contracts, contracts && !deformation.topology_control,
                                           velocity.energy_or(deformation.interface_energy)};
    const auto is_stretching = [&](const auto& interface_) {
      return is_stretched(
          interface_, interface_.positions(dsc),
          destinations_of_step(dsc, interface_, velocity, t, dt, options.advection));
    };
    Volume_restoration_options<Complex> restoration;
    restoration.deformation = deformation;
    restoration.deformation.flow = nullptr;
    restoration.deformation.forbid_topology_changes();
    const auto volumes = volumes_but_one(dsc);
    changes = keep_interface_fit(dsc, adaptation, is_stretching, deformation.visitor);
    if ((contracts && Complex::dimension == 2) || velocity.preserves_volumes())
      for (const auto& restored : restore_volumes(dsc, volumes, restoration).deformations)
        changes += restored;
    Detail_options<Complex> detail;
    detail.collapse_length = defaults::Adaptive_advection<Complex::dimension>::collapse_length;
    detail.visitor = deformation.visitor;
    changes += control_detail(dsc, detail);
  }
  Deformation_report<Complex> report = advect(dsc, velocity, t, dt, options.advection);
  begin_with(earlier, report);
  report += changes;
  return report;
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
- If the flow preserves volumes, or contracts the interface in the plane, `restore_volumes()`
  restores the volumes from before the adaptation.
- Edges between two parts of the interface are split, and short edges away from it are collapsed:
  `control_detail()` with a `collapse_length` of 2.

The defaults of some parameters differ from those of `advect_interface()`. Cells may become flatter,
and facets of the interface may become longer, because the flow may bring the interface back. A flow
that contracts the interface does not bring it back. Its defaults of `quality_threshold`,
`minimum_angle` and `minimum_facet_angle` are those of `advect_interface()`.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param velocity as for `advect_interface()`. If the interface is worn, the step is integrated once
       more. The velocity contracts the interface if its type has a member
       `static constexpr bool contracts_interface` that is `true`. It preserves volumes if its
       member function `preserves_volumes()` returns `true`.
\param t the time at the beginning of the step
\param dt the length of the step. It must be the same in each step; otherwise use an
       `adaptation_interval` of 1.
\param np an `Adaptive_advection_options`, constructed with whether the velocity contracts the
       interface. Or named parameters: those of `advect_interface()`, and those with the names of
       the other members of `Adaptive_advection_options`, with the default values of
       `defaults::Adaptive_advection`. The default of `scheme` is `Integration_scheme::rk4`.

\return the report of `advect_interface()`. Its numbers of operations include the adaptation.
\throws Error if a parameter is out of its range, or if there is an interface and
        `dsc.mean_interface_edge()` is 0. The complex is then unchanged.
\throws Invalid_destination_error, Error as `advect_interface()`. The interface has then not moved,
        but it may have been adapted.

The time is that of `advect_interface()`. A step that adapts takes additional time: n log n in the
size of the interface, and one pass over the cells.
*/
template <class ConcurrencyTag = Sequential_tag, class Complex, class Velocity,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> advect_adaptively(Complex& dsc, const Velocity& velocity, double t,
                                              double dt,
                                              const NamedParameters& np = NamedParameters()) {
  if constexpr (internal::require_velocity<Complex, Velocity>())
    return internal::call_with_parameters<ConcurrencyTag>(
        dsc, np, Adaptive_advection_options<Complex>(internal::contracts_interface<Velocity>),
        [&](const auto& options) {
          return internal::adapt_and_advect(
              dsc, internal::Step_velocity_of<Complex, Velocity>(velocity), t, dt, options);
        });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_ADVECT_ADAPTIVELY_H
