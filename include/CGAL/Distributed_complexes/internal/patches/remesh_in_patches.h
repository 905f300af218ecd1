// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Failure_memory.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/patches/Patch_rounds.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_components.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The cells of a patch that a treatment changes or tries to change: its active cells, and new cells
// away from the cut. Edges that end on the cut are not treated.
template <class Complex> class Treated_cells
{
public:
  using Cell_handle = typename Treated_patch<Complex>::Part::Cell_handle;

  // Must be constructed before the treatment.
  explicit Treated_cells(const Treated_patch<Complex>& patch) : m_patch(patch) {
    for (Cell_handle c : patch.part.finite_cells())
      m_last = (std::max)(m_last, c->time_stamp());
    for (Cell_handle c : patch.core)
      m_core.push(c);
  }

  // Calls f(c) for each cell that is there after the treatment.
  template <class Function> void for_each(const Function& f) const {
    for (const auto& item : m_core)
      if (m_patch.part.is_alive(item.cell, item.time_stamp))
        f(item.cell);
    for (Cell_handle c : m_patch.part.finite_cells())
      if (c->time_stamp() > m_last && !m_patch.part.is_constrained(c))
        f(c);
  }

private:
  const Treated_patch<Complex>& m_patch;
  Work_list<Cell_handle> m_core;
  std::size_t m_last = 0; // time stamp before the treatment
};

// Attempts that cells remember besides those of one complex.
inline constexpr Attempt to_control_detail = Attempt(4);
inline constexpr Attempt to_adapt_interface = Attempt(8);

// Changes the edges of cells in patches, without a motion. Calls mark_cells(), which sets
// `is_active` of the cells with an edge to be changed, and treats these cells in patches, apart
// from cells for which the attempt has failed. A patch cannot change an edge that ends on its cut,
// so this is repeated. Returns the numbers of operations of all ranks.
template <class Complex, class Mark>
Improvement_report remesh_in_patches(Distributed_mesh<Complex>& mesh, Attempt attempt,
                                     const Mark& mark_cells,
                                     const Patch_treatment<Complex>& treat) {
  static constexpr int most = 4; // repetitions; each leaves only edges on the cuts of its patches
  // If a motion ended with an exception, the next motion reports its events.
  const bool are_known = mesh.are_components_known;
  mesh.are_components_known = false;
  for (typename Piece<Complex::dimension>::Index v = 0; v < mesh.piece.vertex_bound(); ++v)
    mesh.piece.vertex(v).end_motion();
  Distributed_counts result;
  for (int i = 0; i < most; ++i) {
    mark_cells();
    for (typename Piece<Complex::dimension>::Index c = 0; c < mesh.piece.cell_bound(); ++c)
      if ((mesh.piece.cell(c).data.failures & attempt) != 0)
        mesh.piece.cell(c).data.is_active = false;
    std::vector<Topology_place<Complex::dimension>> places; // none, because no label changes
    const Distributed_counts counts = Patch_rounds<Complex>(mesh, treat, 0, places).run();
    if (counts.patches == 0)
      break;
    result += counts;
  }
  if (are_known && result.patches > 0) // measures the new volumes
    Distributed_components<Complex>(mesh).update();
  mesh.are_components_known = are_known;
  return {std::size_t(result.split), std::size_t(result.collapsed), std::size_t(result.flipped),
          std::size_t(result.smoothed), std::size_t(result.inserted)};
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_REMESH_IN_PATCHES_H
