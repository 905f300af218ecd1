// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What limits of lengths are measured by, so that they follow the mesh from place to place and as
// it is refined.

// The mean length of the edges at a vertex: those of the interface if it is on it, else all.
// Linear in the star.
template <class Complex>
double local_edge_length(const Complex& complex, typename Complex::Vertex_handle v) {
  std::vector<typename Complex::Cell_handle> star;
  complex.star(v, star);
  double sum = 0;
  std::size_t number = 0;
  for (auto c : star) {
    if (complex.is_infinite(c))
      continue;
    const int apex = c->index(v);
    const auto add = [&](int i) {
      sum += Complex::Space::length(complex.displacement(c, apex, i));
      ++number;
    };
    if (!v->is_interface()) {
      for (int i = 0; i < Complex::corners; ++i)
        if (i != apex)
          add(i);
      continue;
    }
    for (int facet = 0; facet < Complex::corners; ++facet)
      if (facet != apex && complex.is_interface(typename Complex::Facet(c, facet)))
        for (int i = 0; i < Complex::corners; ++i)
          if (i != apex && i != facet)
            add(i);
  }
  return number > 0 ? sum / double(number) : 0;
}

// The mean of these lengths at the vertices of a cell that are on the interface, or at all if none
// is.
template <class Complex>
double local_edge_length(const Complex& complex, typename Complex::Cell_handle c) {
  const auto mean = [&](bool of_interface) {
    double sum = 0;
    int number = 0;
    for (int i = 0; i < Complex::corners; ++i)
      if (c->vertex(i)->is_interface() == of_interface) {
        sum += local_edge_length(complex, c->vertex(i));
        ++number;
      }
    return number > 0 ? sum / number : 0;
  };
  const double of_interface = mean(true);
  return of_interface > 0 ? of_interface : mean(false);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_LOCAL_EDGE_LENGTH_H
