// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_CONTROL_DISTRIBUTED_DETAIL_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_CONTROL_DISTRIBUTED_DETAIL_H

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/patches/remesh_in_patches.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Interface_remeshing/Detail_options.h>
#include <CGAL/Interface_remeshing/internal/remeshing/Detail_controller.h>

#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
    Any_visitor<Part> no_visitor;
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_CONTROL_DISTRIBUTED_DETAIL_H
