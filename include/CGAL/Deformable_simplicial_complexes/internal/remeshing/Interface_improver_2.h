// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_2_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/interface_curve_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Interface_remesher.h>
#include <CGAL/Deformable_simplicial_complexes/junction_split_2.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The interface improvement in the plane. The vertices of a curve can be connected in one way only,
// so nothing is reconnected.
template <class Complex> class Interface_improver_2 : public Interface_remesher<Complex>
{
public:
  using Interface_remesher<Complex>::Interface_remesher;

  void reconnect() {}

  // Splits each junction of more than three phases into several junctions of three.
  void split_junctions() {
    for (auto v : this->m_complex.interface_vertices()) {
      Progress_scope::check();
      while (propose_junction_split(this->m_complex, v, this->m_cavity,
                                    this->m_options.interface_energy)) {
        this->commit();
        const auto other = this->m_cavity.vertices().back().handle;
        for (auto junction : {v, other})
          junction->set_spacing(float(this->m_complex.interface_edge_length(junction)));
      }
    }
  }
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_REMESHING_INTERFACE_IMPROVER_2_H
