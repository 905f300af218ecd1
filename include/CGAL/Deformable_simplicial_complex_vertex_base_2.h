// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_vertex_base_2.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Vertex of a deformable simplicial complex in the plane.

\tparam Traits a model of `DeformableSimplicialComplexTraits_2`
\tparam Vb a vertex base class of 2D triangulations with points
*/
template <class Traits, class Vb = Triangulation_vertex_base_2<Traits>>
class Deformable_simplicial_complex_vertex_base_2
    : public Vb,
      public Deformable_simplicial_complexes::Vertex_data
{
public:
  using Cell_handle = typename Vb::Face_handle; ///< handle of a triangle
  using Point = typename Vb::Point;             ///< `Traits::Point_2`

  /// Rebinds the vertex to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<Tds2>::Other; ///< `Vb` for `Tds2`
    /// this class for `Tds2`
    using Other = Deformable_simplicial_complex_vertex_base_2<Traits, Vb2>;
  };

  using Vb::Vb;

  Cell_handle cell() const { return this->face(); }   ///< one of the incident triangles
  void set_cell(Cell_handle c) { this->set_face(c); } ///< sets `cell()`
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_2_H
