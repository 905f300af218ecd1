// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Deformable_simplicial_complexes/internal/patches/Patch.h>
#include <CGAL/Deformable_simplicial_complexes/internal/patches/Patch_rounds.h>
#include <CGAL/Deformable_simplicial_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Deformable_simplicial_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/internal/ranks/Piece.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Treats a patch, then records the attempt in its active cells and in new cells. Edges that end on
// the cut were not treated, so cells there have no record.
template <class Complex>
void treat_and_record(Treated_patch<Complex>& patch, const Patch_treatment<Complex>& treat,
                      Attempt attempt) {
  std::size_t last = 0; // time stamp before the treatment
  for (auto c : patch.part.finite_cells())
    last = (std::max)(last, c->time_stamp());
  for (auto c : patch.core)
    set_exhausted(c, attempt);
  treat(patch);
  for (auto c : patch.part.finite_cells()) {
    bool is_at_cut = false;
    for (int i = 0; i < Complex::corners; ++i)
      is_at_cut = is_at_cut || Boundary_class::is_cut(c->vertex(i)->boundary_class());
    if (c->time_stamp() > last && !is_at_cut)
      set_exhausted(c, attempt);
  }
}

// Changes the edges of cells in patches, without a motion. Calls mark_cells(), which sets
// `is_active` of the cells with an edge to be changed, and treats these cells in patches. A patch
// cannot change an edge that ends on its cut, so this is repeated. Cells with a record of the
// attempt are not treated. Returns the numbers of operations of all ranks.
template <class Complex, class Mark>
Patch_counts remesh_in_patches(Distributed_mesh<Complex>& mesh, Attempt attempt,
                               const Mark& mark_cells, const Patch_treatment<Complex>& treat) {
  static constexpr int most = 4; // repetitions; few edges remain after the second one
  mesh.are_components_known = false;
  for (typename Piece<Complex::dimension>::Index v = 0; v < mesh.piece.vertex_bound(); ++v)
    mesh.piece.vertex(v).end_motion();
  Patch_counts result;
  for (int i = 0; i < most; ++i) {
    mark_cells();
    for (typename Piece<Complex::dimension>::Index c = 0; c < mesh.piece.cell_bound(); ++c)
      if ((mesh.piece.cell(c).data.failures & attempt) != 0)
        mesh.piece.cell(c).data.is_active = false;
    std::vector<Topology_place<Complex::dimension>> places; // none, because no label changes
    const Patch_counts counts =
        Patch_rounds<Complex>(
            mesh, [&](Treated_patch<Complex>& patch) { treat_and_record(patch, treat, attempt); },
            0, places)
            .run();
    if (counts.patches == 0)
      break;
    result += counts;
    result.rounds += counts.rounds;
  }
  // The volumes have changed.
  Distributed_components<Complex>(mesh, Label_totals(mesh.domain_measure)).update(mesh.components);
  mesh.are_components_known = true;
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H
