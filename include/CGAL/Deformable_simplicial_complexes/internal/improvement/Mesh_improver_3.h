// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_3_H

#include <CGAL/Deformable_simplicial_complexes/degeneracy_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_3.h>

#include <utility>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The improver for 3D, which also removes degenerate interface facets.
template <class Complex> class Mesh_improver_3 : public Mesh_improver<Complex>
{
  using Base = Mesh_improver<Complex>;

public:
  using Base::Base;
  using typename Base::Cell_handle;
  using typename Base::Cells;
  using typename Base::Vertex_handle;

  // Removes an interface facet that has an angle below a bound, if this improves the surrounding
  // cells. `cosine` is the cosine of the bound. Returns whether the facet was removed.
  bool remove_degenerate_facet(Cell_handle c, int i, double cosine, Cells& touched) {
    const double quality = Base::better * c->quality();
    Cavity<Complex>& cavity = this->m_cavity;
    if (!this->m_complex.is_interface(std::make_pair(c, i)) ||
        !propose_degenerate_facet_removal(this->m_complex, c, i, cosine, quality, cavity))
      return false;
    const Vertex_handle vanishing = cavity.vanishing_vertex(), kept = cavity.kept_vertex();
    if (vanishing != Vertex_handle() && this->covers_interface() &&
        (!propose_edge_collapse(this->m_complex, c, c->index(kept), c->index(vanishing), quality,
                                cavity) ||
         this->covers_interface()))
      return false;
    if (!this->m_tolerance.allows(cavity, this->m_tolerance_factor))
      return false;
    this->m_tolerance.record();
    return this->commit(touched);
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_MESH_IMPROVER_3_H
