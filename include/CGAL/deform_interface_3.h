// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORM_INTERFACE_3_H
#define CGAL_DEFORM_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/improvement/Mesh_care_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/require_finite.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Deforms the interface as `deform_interface()` does, with destinations in the order of a snapshot.

\param dsc the complex
\param interface_ its interface. \pre the complex has not changed since
\param destinations one for each vertex of the snapshot, in the coordinates of the complex
\param np the named parameters of `deform_interface()`
\return what that returns
\throws Deformable_simplicial_complexes::Invalid_destination_error if a destination is not finite;
       and whatever that throws
*/
template <class Complex, class NamedParameters =
                             Deformable_simplicial_complexes::parameters::Default_named_parameters>
Deformation_report<Complex>
deform_interface_to(Complex& dsc, const Interface_snapshot_3<Complex>& interface_,
                    const std::vector<typename Complex::Approximate_point_3>& destinations,
                    const NamedParameters& np = NamedParameters()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  internal::require_finite(destinations, "a destination"); // exact numbers could not express it
  internal::number_vertices(interface_.vertices);
  return deform_interface(
      dsc,
      [&](typename Complex::Vertex_handle v) {
        return dsc.exact(destinations[v->scratch_index()]);
      },
      np);
}

} // namespace CGAL

#endif // CGAL_DEFORM_INTERFACE_3_H
