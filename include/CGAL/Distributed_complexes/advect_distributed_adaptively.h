// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_ADAPTIVELY_H
#define CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_ADAPTIVELY_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/Distributed_report.h>
#include <CGAL/Distributed_complexes/adapt_distributed_interface.h>
#include <CGAL/Distributed_complexes/advect_distributed_interface.h>
#include <CGAL/Interface_flows/advect_adaptively.h>
#include <CGAL/Interface_flows/internal/paths/velocity_properties.h>
#include <CGAL/Interface_remeshing/Adaptive_advection.h>
#include <CGAL/Interface_remeshing/Detail_options.h>
#include <CGAL/Interface_remeshing/Interface_adaptation.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Moves the interface with a velocity for one time step and adapts the interface and the mesh, as
`advect_adaptively()` does on one rank. The result is bitwise identical for any number of ranks.

\param dsc the complex
\param velocity as for `advect_interface()` of a distributed complex
\param t the time at the beginning of the step
\param dt the length of the step. It must be the same in each step; otherwise use an
       `adaptation_interval` of 1.
\param options the options; `advection.integration_tolerance` has no effect. `topology_control` and
       `visitor` see the patches of the motion, see `Distributed_options`.
\return the report of `advect_interface()`, equal on all ranks. Its numbers of operations include
        the adaptation.
\throws Error on all ranks if an option is out of its range, the scheme is adaptive, the flow
        preserves volumes, or there is an interface and `dsc.mean_interface_edge()` is 0; the
        complex is then unchanged
\throws Error, Interrupted_error as `advect_interface()`. The interface may have been adapted, and
        a part of its vertices may have moved.

Collective.
*/
template <class Complex, class Velocity>
Distributed_report<Complex> advect_adaptively(
    Distributed_complex<Complex>& dsc, const Velocity& velocity, double t, double dt,
    const Adaptive_advection_options<typename Distributed_complex<Complex>::Part>& options =
        Adaptive_advection_options<typename Distributed_complex<Complex>::Part>(
            internal::contracts_interface<Velocity>)) {
  constexpr bool contracts = internal::contracts_interface<Velocity>;
  using Part = typename Distributed_complex<Complex>::Part;
  const Deformation_options<Part>& deformation = options.advection.deformation;
  dsc.communicator().call_together([&] {
    options.check();
    internal::require_distributed_scheme(options.advection.scheme);
    internal::require_distributed_flow(velocity);
  });
  internal::require_interface_edge_of(dsc);
  if (std::fmod(std::round(t / dt), options.adaptation_interval) != 0 ||
      !internal::has_interface(dsc))
    return advect_interface(dsc, velocity, t, dt, deformation, options.advection.scheme);
  const Adaptation_options adaptation = {
      options.interface_tolerance, options.feature_angle, !contracts,
      contracts && !deformation.topology_control,
      internal::energy_of(velocity, deformation.interface_energy)};
  Improvement_report changes = keep_interface_fit(dsc, adaptation, [&](const auto& interface_) {
    return internal::distributed_destinations(dsc, interface_, velocity, t, dt,
                                              options.advection.scheme);
  });
  Detail_options<Part> detail;
  detail.collapse_length = defaults::Adaptive_advection<Complex::dimension>::collapse_length;
  changes += control_detail(dsc, detail);
  Distributed_report<Complex> report =
      advect_interface(dsc, velocity, t, dt, deformation, options.advection.scheme);
  report += changes;
  return report;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_ADVECT_DISTRIBUTED_ADAPTIVELY_H
