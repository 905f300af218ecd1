// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A bound on the volume between the interface and what the collapse of one of its vertices makes of
// it: that of the tetrahedra of the kept vertex over the facets of the vanishing one.
template <class Complex>
double swept_volume(const Complex& complex, const Cavity_3<Complex>& collapse) {
  const auto kept = complex.position(collapse.kept_vertex());
  double sum = 0;
  for (const auto c : collapse.removed())
    for (int i = 0; i < 4; ++i) {
      const std::pair<typename Complex::Cell_handle, int> facet(c, i);
      // Each facet has two cells here, but for those that the vanishing vertex is not in.
      if (c->vertex(i) == collapse.vanishing_vertex() || !complex.is_interface(facet))
        continue;
      const auto v = complex.facet_vertices(facet);
      sum += std::abs(cross_product(complex.position(v[0]) - kept, complex.position(v[1]) - kept) *
                      (complex.position(v[2]) - kept)) /
             12;
    }
  return sum;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H
