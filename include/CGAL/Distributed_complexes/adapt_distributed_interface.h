// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_ADAPT_DISTRIBUTED_INTERFACE_H
#define CGAL_DISTRIBUTED_COMPLEXES_ADAPT_DISTRIBUTED_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/patches/Distributed_adaptation.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Interface_remeshing/Detail_options.h>
#include <CGAL/Interface_remeshing/Interface_adaptation.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Detail_controller.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Splits and collapses edges off the interface on several ranks, as `control_detail()` does.
// Lengths are in mean edges of the interface. Returns the numbers of operations of all ranks.
template <class Complex>
Improvement_report
control_distributed_detail(Distributed_mesh<Complex>& mesh,
                           const Detail_options<typename Part_of<Complex>::Type>& options) {
  using Index = typename Piece<Complex::dimension>::Index;
  using Part = typename Part_of<Complex>::Type;
  const auto is_longer = [&](Index v, Index w, double length) {
    length *= mesh.mean_interface_edge;
    return (mesh.position(w) - mesh.position(v)).squared_length() > length * length;
  };
  const auto mark_cells = [&] {
    const std::vector<std::uint8_t> is_interface = mesh.interface_flags();
    const auto is_tied = [&](Index v) {
      return is_interface[v] || mesh.piece.vertex(v).boundary_class != Boundary_class::inside;
    };
    const auto is_too_long = [&](Index v, Index w) { // if the edge is off the interface
      return ((is_interface[v] && is_tied(w)) || (is_interface[w] && is_tied(v))) &&
             is_longer(v, w, options.split_length);
    };
    const auto has_long_edge = mesh.vertices_with_edge([&](Index v, Index w) {
      return is_too_long(v, w) && !mesh.piece.has_several_labels(v, w);
    });
    mesh.activate_cells_with_edge([&](Index v, Index w) {
      return is_tied(v) || is_tied(w) ? has_long_edge[v] && has_long_edge[w] && is_too_long(v, w)
                                      : !is_longer(v, w, options.collapse_length);
    });
  };
  const auto treat = [&](Treated_patch<Complex>& patch) {
    const Treated_cells<Complex> cells(patch);
    Deformation_visitor<Part> no_visitor;
    Detail_controller<Part> controller(patch.part, no_visitor, options);
    controller.run();
    patch.counts += controller.report();
    cells.for_each([&](auto c) {
      if (controller.has_edge_to_change(c))
        set_exhausted(c, to_control_detail);
    });
  };
  return remesh_in_patches<Complex>(mesh, to_control_detail, mark_cells, treat);
}

// Returns whether cells have different labels. Equal on all ranks.
template <class Complex> bool has_interface(const Distributed_complex<Complex>& dsc) {
  const auto& components = dsc.mesh().components;
  return std::any_of(components.begin(), components.end(), [&](const auto& entry) {
    return entry.second.label != components.begin()->second.label;
  });
}

// \throws Error on all ranks if there is an interface and no unit of length
template <class Complex> void require_interface_edge_of(const Distributed_complex<Complex>& dsc) {
  if (!(dsc.mean_interface_edge() > 0) && has_interface(dsc))
    throw Error("the complex was built without an interface and has no unit of length: distribute "
                "a complex with an interface");
}

} // namespace internal

/*!
\ingroup PkgDistributedComplexesRef

Adapts the edges of the interface to its curvature, as `keep_interface_fit()` does on one rank.
Edges are changed in patches, see `deform_interface_to()`. The result is bitwise identical for any
number of ranks.

\param dsc the complex
\param options the options
\param destinations function object that takes the `Distributed_complex::Interface` of this rank
       and returns the destinations of its vertices in the next time step; called on all ranks or on
       none, and only if the interface is worn and `options.only_if_worn` is set. Destinations of
       vertices of other ranks have no effect. If it makes collective calls, it must throw on all
       ranks or on none.
\return the numbers of operations of all ranks
\throws Error on all ranks if an option is out of its range, if there is an interface and
        `dsc.mean_interface_edge()` is 0, or if `destinations` throws or returns a wrong number of
        points on a rank; the complex is then unchanged
\throws Interrupted_error on all ranks if a rank is interrupted. The complex is then valid.

Collective.
*/
template <class Complex, class Destinations>
Improvement_report keep_interface_fit(Distributed_complex<Complex>& dsc,
                                      const Adaptation_options& options,
                                      const Destinations& destinations) {
  if (!(options.tolerance > 0) || !internal::has_interface(dsc))
    return {};
  dsc.communicator().call_together(
      [&] { require_angle(options.feature_angle, 180, "feature angle"); });
  internal::require_interface_edge_of(dsc);
  const auto interface_ = dsc.interface_here();
  internal::Distributed_adaptation<Complex> adaptation(dsc, interface_, options);
  if (options.only_if_worn) {
    if (!adaptation.is_worn())
      return {};
    std::vector<typename Complex::Point> targets;
    dsc.communicator().call_together([&] {
      targets = destinations(interface_);
      if (targets.size() != interface_.indices.size())
        throw Error(
            "the number of destinations differs from the number of interface vertices: give "
            "one destination for each vertex");
    });
    dsc.share(interface_, targets);
    if (dsc.communicator().reduced(
            Communicator::Operation::maximum,
            is_stretched(interface_.snapshot, interface_.positions, targets)) == 0)
      return {};
  }
  return adaptation.apply();
}

/*!
\ingroup PkgDistributedComplexesRef

Splits long edges and collapses short edges off the interface, as `control_detail()` does on one
rank. Edges are changed in patches, see `deform_interface_to()`. Cells whose edges could not be
changed are not tried again before their shape changes, even with other options. The result is
bitwise identical for any number of ranks.

\param dsc the complex
\param options the options; lengths are in mean edges of the initial interface. `sizing_field`,
       `where` and `visitor` must not be set, and `change_interface` must be `false`.
\return the numbers of operations of all ranks
\throws Error on all ranks if an option is out of its range or not available, or if there is an
        interface and `dsc.mean_interface_edge()` is 0; the complex is then unchanged
\throws Interrupted_error on all ranks if a rank is interrupted. The complex is then valid.

Collective.
*/
template <class Complex>
Improvement_report
control_detail(Distributed_complex<Complex>& dsc,
               const Detail_options<typename Distributed_complex<Complex>::Part>& options) {
  dsc.communicator().call_together([&] {
    options.check();
    if (options.sizing_field || options.where || options.visitor || options.change_interface)
      throw Error(
          "an option of the control of detail is not available on several ranks: do not use "
          "sizing_field, where, visitor and change_interface");
  });
  internal::require_interface_edge_of(dsc);
  if (!(dsc.mean_interface_edge() > 0))
    return {};
  return internal::control_distributed_detail(dsc.mesh(), options);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_ADAPT_DISTRIBUTED_INTERFACE_H
