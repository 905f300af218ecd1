// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H

#include <array>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
In the plane, two phases lost the wall between them, and the two at its ends became neighbors: what
is called a T1 event in foams.
\tparam Complex an instance of `Deformable_simplicial_complex_2`
*/
template <class Complex> struct Neighbor_exchange
{
  std::array<typename Complex::Label, 2> parted; ///< had a wall between them
  std::array<typename Complex::Label, 2> joined; ///< have one now, if they differ
  typename Complex::Approximate_point where;     ///< the middle of the wall
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_NEIGHBOR_EXCHANGE_H
