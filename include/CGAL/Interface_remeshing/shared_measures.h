// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_SHARED_MEASURES_H
#define CGAL_INTERFACE_REMESHING_SHARED_MEASURES_H

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the measure of the interface between each pair of neighboring labels: the area, in the plane
the length. The smaller label of a pair is first. n log n in the number of facets of the interface,
plus linear in the number of cells.
*/
template <class Complex>
std::map<std::pair<typename Complex::Label, typename Complex::Label>, double>
shared_measures(const Complex& complex) {
  std::map<std::pair<typename Complex::Label, typename Complex::Label>, double> result;
  for (const auto& facet : complex.interface_facets())
    result[std::minmax({facet.first->subdomain_index(),
                        facet.first->neighbor(facet.second)->subdomain_index()})] +=
        complex.measure(facet);
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the labels of the cells around a vertex, increasing. Linear in the star of the vertex.
\pre the vertex is finite
*/
template <class Complex>
std::vector<typename Complex::Label> labels_around(const Complex& complex,
                                                   typename Complex::Vertex_handle v) {
  std::vector<typename Complex::Cell_handle> star;
  complex.star(v, star);
  std::vector<typename Complex::Label> result;
  for (auto c : star)
    if (!complex.is_infinite(c))
      result.push_back(c->subdomain_index());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_SHARED_MEASURES_H
