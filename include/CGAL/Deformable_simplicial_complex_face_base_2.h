// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_FACE_BASE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_FACE_BASE_2_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_face_base_2.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Triangle of a deformable simplicial complex in the plane. The triangles are the cells of the
complex.

\tparam Traits a model of `DeformableSimplicialComplexTraits_2`
\tparam Fb a face base class of 2D triangulations
*/
template <class Traits, class Fb = Triangulation_face_base_2<Traits>>
class Deformable_simplicial_complex_face_base_2
    : public Fb,
      public Deformable_simplicial_complexes::Cell_failures,
      public Deformable_simplicial_complexes::Cell_data
{
public:
  /// Rebinds the triangle to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Fb2 = typename Fb::template Rebind_TDS<Tds2>::Other;            ///< `Fb` for `Tds2`
    using Other = Deformable_simplicial_complex_face_base_2<Traits, Fb2>; ///< this class for `Tds2`
  };

  using Fb::Fb;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_FACE_BASE_2_H
