// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CARRIED_VERTEX_VALUES_3_H
#define CGAL_CARRIED_VERTEX_VALUES_3_H

#include <CGAL/Deformable_simplicial_complexes/Carried_vertex_values.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
A visitor by which values on vertices follow changes of the mesh, in space.
*/
template <class Complex, class VertexValueMap>
class Carried_vertex_values_3
    : public Deformable_simplicial_complexes::Carried_vertex_values<Complex, VertexValueMap>
{
public:
  using Deformable_simplicial_complexes::Carried_vertex_values<
      Complex, VertexValueMap>::Carried_vertex_values;
};

/// \cond SKIP_IN_MANUAL
template <class Complex, class VertexValueMap>
Carried_vertex_values_3(const Complex&, const VertexValueMap&)
    -> Carried_vertex_values_3<Complex, VertexValueMap>;
/// \endcond

} // namespace CGAL

#endif // CGAL_CARRIED_VERTEX_VALUES_3_H
