// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_COMPONENT_CHANGE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_COMPONENT_CHANGE_H

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
How the connected components of a label changed between two looks at them.
*/
struct Component_change
{
  int label = 0;          ///< whose components these are
  std::size_t before = 0; ///< number of components then
  std::size_t after = 0;  ///< number of components now
  std::size_t merged = 0; ///< sum over the components of now: those they come from, minus one
  std::size_t split = 0;  ///< sum over the components of then: the parts they fell into, minus one
  std::size_t vanished = 0; ///< components of then of which no cell is left
  std::size_t appeared = 0; ///< components of now that come from none
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_COMPONENT_CHANGE_H
