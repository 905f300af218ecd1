// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_VERTICES_ON_JUNCTIONS_H
#define CGAL_INTERFACE_REMESHING_VERTICES_ON_JUNCTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Returns for each vertex of a snapshot whether it lies on a junction: whether its facets separate
different pairs of labels. A vertex in which two components with the same two labels touch is not on
a junction. Linear in the size of the interface.

\tparam Complex a deformable simplicial complex
\param interface_ the snapshot
\return 1 or 0 for each vertex, in the order of the snapshot
*/
template <class Complex>
std::vector<char> vertices_on_junctions(const Interface_snapshot<Complex>& interface_) {
  std::vector<char> result(interface_.vertices.size(), false);
  using Facet = typename Interface_vertices<Complex>::Facet;
  std::vector<const Facet*> first(result.size(), nullptr);
  for (const Facet& facet : interface_.facets())
    for (std::size_t v : facet.vertices) {
      if (first[v] == nullptr)
        first[v] = &facet;
      result[v] =
          result[v] || facet.behind != first[v]->behind || facet.in_front != first[v]->in_front;
    }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_VERTICES_ON_JUNCTIONS_H
