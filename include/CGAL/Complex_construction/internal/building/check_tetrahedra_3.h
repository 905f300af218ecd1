// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CHECK_TETRAHEDRA_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CHECK_TETRAHEDRA_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Orients tetrahedra positively by swapping two vertices of the negative ones. Throws
// `Invalid_cells_error` if coordinates are not finite, if indices do not exist, or if tetrahedra
// are degenerate.
template <class Traits>
void orient_tetrahedra(const std::vector<typename Traits::Point_3>& points,
                       std::vector<std::array<std::size_t, 4>>& tetrahedra, const Traits& traits) {
  std::vector<std::size_t> offenders;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!has_finite_coordinates(coordinates(points[i])))
      offenders.push_back(i);
  if (!offenders.empty())
    throw Invalid_cells_error("coordinates are not finite: correct or remove these points", {},
                              std::move(offenders));

  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    if (*std::max_element(tetrahedra[t].begin(), tetrahedra[t].end()) >= points.size())
      offenders.push_back(t);
  if (!offenders.empty())
    throw Invalid_cells_error("tetrahedra have vertices that do not exist: correct these "
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
    throw Invalid_cells_error("tetrahedra are flat: remesh near these tetrahedra",
                              std::move(offenders));
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_BUILDING_CHECK_TETRAHEDRA_3_H
