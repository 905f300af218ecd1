// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_cell_base_3.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Cell of a deformable simplicial complex in space.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Cb a cell base class of 3D triangulations

\cgalModels `DeformableSimplicialComplexCellBase_3`
*/
template <class Traits, class Cb = Triangulation_cell_base_3<Traits>>
class Deformable_simplicial_complex_cell_base_3
    : public Cb,
      public Deformable_simplicial_complexes::Cell_failures,
      public Deformable_simplicial_complexes::Cell_data
{
public:
  /// Rebinds the cell to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Cb2 = typename Cb::template Rebind_TDS<Tds2>::Other;            ///< `Cb` for `Tds2`
    using Other = Deformable_simplicial_complex_cell_base_3<Traits, Cb2>; ///< this class for `Tds2`
  };

  using Cb::Cb;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_CELL_BASE_3_H
