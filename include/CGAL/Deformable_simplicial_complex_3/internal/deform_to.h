// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_DEFORM_TO_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_DEFORM_TO_H

#include <CGAL/Deformable_simplicial_complex_3/Interface_snapshot_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/require_finite.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/deform_interface_3.h>

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Deforms the interface so that the vertices of a snapshot go to destinations in its order. Throws
// before anything is changed if one is not finite, since exact numbers could not express it.
// \pre the complex has not changed since the snapshot
template <class Complex, class NamedParameters>
Deformation_report<Complex>
deform_to(Complex& dsc, const Interface_snapshot_3<Complex>& interface_,
          const std::vector<typename Complex::Approximate_point_3>& destinations,
          const NamedParameters& np) {
  require_finite(destinations, "a destination");
  number_vertices(interface_.vertices);
  return deform_interface(
      dsc,
      [&](typename Complex::Vertex_handle v) {
        return dsc.geom_traits().construct_exact_point_3_object()(destinations[v->scratch_index()]);
      },
      np);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_DEFORM_TO_H
