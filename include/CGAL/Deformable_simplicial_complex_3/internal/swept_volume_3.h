// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H

#include <CGAL/Deformable_simplicial_complex_3/Cavity_3.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A bound on the volume between the interface and what the collapse of one of its vertices makes of
// it: that of the tetrahedra of the kept vertex over the facets of the vanishing one.
template <class Complex>
double volume_swept_by_collapse(const Complex& complex, const Cavity_3<Complex>& collapse) {
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

// The volume between the interface and what the flip of its edge vw makes of it: that of the
// tetrahedron of the edge and the two other corners of its facets.
template <class Complex>
double volume_swept_by_flip(const Complex& complex, const Cavity_3<Complex>& flip,
                            typename Complex::Vertex_handle v, typename Complex::Vertex_handle w) {
  boost::container::small_vector<typename Complex::Vertex_handle, 4> corners; // each twice
  for (const auto c : flip.removed())
    for (int i = 0; i < 4; ++i)
      if (c->vertex(i) != v && c->vertex(i) != w && complex.is_interface(std::make_pair(c, i)))
        corners.push_back(c->vertex(6 - i - c->index(v) - c->index(w)));
  const auto p = complex.position(v), a = complex.position(corners.front());
  double largest = 0; // the first corner with itself makes none
  for (const auto corner : corners)
    largest = (std::max)(largest, std::abs(cross_product(complex.position(w) - p, a - p) *
                                           (complex.position(corner) - p)) /
                                      6);
  return largest;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_SWEPT_VOLUME_3_H
