// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CARRIED_CELL_AVERAGES_3_H
#define CGAL_CARRIED_CELL_AVERAGES_3_H

#include <CGAL/Deformable_simplicial_complexes/Carried_cell_averages.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
A visitor by which averages over cells follow changes of the mesh, in space.
*/
template <class Complex, class CellValueMap>
class Carried_cell_averages_3
    : public Deformable_simplicial_complexes::Carried_cell_averages<Complex, CellValueMap>
{
public:
  using Deformable_simplicial_complexes::Carried_cell_averages<Complex,
                                                               CellValueMap>::Carried_cell_averages;
};

/// \cond SKIP_IN_MANUAL
template <class Complex, class CellValueMap>
Carried_cell_averages_3(const Complex&, const CellValueMap&)
    -> Carried_cell_averages_3<Complex, CellValueMap>;
/// \endcond

} // namespace CGAL

#endif // CGAL_CARRIED_CELL_AVERAGES_3_H
