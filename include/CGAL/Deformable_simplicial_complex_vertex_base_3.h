// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_vertex_base_3.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Vertex of a deformable simplicial complex in space.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Vb a vertex base class of 3D triangulations with points

\cgalModels `DeformableSimplicialComplexVertexBase_3`
*/
template <class Traits, class Vb = Triangulation_vertex_base_3<Traits>>
class Deformable_simplicial_complex_vertex_base_3
    : public Vb,
      public Deformable_simplicial_complexes::Vertex_data
{
public:
  using Cell_handle =
      typename Vb::Cell_handle;     ///< handle of a cell of the triangulation data structure
  using Point = typename Vb::Point; ///< `DeformableSimplicialComplexTraits_3::Point_3`

  /// Rebinds the vertex to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<Tds2>::Other; ///< `Vb` for `Tds2`
    /// this class for `Tds2`
    using Other = Deformable_simplicial_complex_vertex_base_3<Traits, Vb2>;
  };

  using Vb::Vb;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
