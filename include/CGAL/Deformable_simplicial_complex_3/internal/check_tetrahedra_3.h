// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHECK_TETRAHEDRA_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHECK_TETRAHEDRA_3_H

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/Triangle_soup_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/assemble_triangulation.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/has_finite_coordinates.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Makes tetrahedra positive by swapping two vertices of the negative ones. Throws
// Invalid_tetrahedra_error if coordinates are not finite, indices do not exist, or tetrahedra are
// flat.
template <class Traits>
void orient_tetrahedra(const std::vector<typename Traits::Point_3>& points,
                       std::vector<std::array<std::size_t, 4>>& tetrahedra, const Traits& traits) {
  std::vector<std::size_t> offenders;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!has_finite_coordinates(coordinates(points[i])))
      offenders.push_back(i);
  if (!offenders.empty())
    throw Invalid_tetrahedra_error("coordinates are no finite numbers: correct or remove these "
                                   "points",
                                   {}, std::move(offenders));

  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    if (*std::max_element(tetrahedra[t].begin(), tetrahedra[t].end()) >= points.size())
      offenders.push_back(t);
  if (!offenders.empty())
    throw Invalid_tetrahedra_error("tetrahedra have vertices that do not exist: correct these "
                                   "indices",
                                   std::move(offenders));

  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    std::array<std::size_t, 4>& v = tetrahedra[t];
    switch (traits.orientation_3_object()(points[v[0]], points[v[1]], points[v[2]], points[v[3]])) {
    case COPLANAR:
      offenders.push_back(t);
      break;
    case NEGATIVE:
      std::swap(v[2], v[3]);
      break;
    case POSITIVE:
      break;
    }
  }
  if (!offenders.empty())
    throw Invalid_tetrahedra_error("tetrahedra are flat: remesh where they are",
                                   std::move(offenders));
}

// Throws Invalid_tetrahedra_error if the boundary, given by the infinite ones among the cells and
// supposed that it is a connected 2-manifold, is no sphere.
inline void check_boundary(const std::vector<Cell_vertices>& cells) {
  std::vector<std::size_t> vertices;
  std::size_t number_of_facets = 0;
  for (const Cell_vertices& c : cells)
    if (std::find(c.begin(), c.end(), 0) != c.end()) {
      ++number_of_facets;
      vertices.insert(vertices.end(), c.begin(), c.end());
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  // Three edges for two facets: V - E + F = V - F / 2. The infinite vertex counts here, too.
  if (2 * (vertices.size() - 1) != number_of_facets + 4)
    throw Invalid_tetrahedra_error("the boundary of the tetrahedra is no sphere: give a mesh whose "
                                   "domain is a ball");
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CHECK_TETRAHEDRA_3_H
