// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_PART_DOMAIN_H
#define CGAL_DISTRIBUTED_COMPLEXES_PART_DOMAIN_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Domain of a complex that is a part of a larger complex: any set of its cells. The boundary of the
part may have several components and any genus, and may touch itself along edges. Vertices on the
cut, around which cells are missing, have the class `cut`. They do not move, their edges stay, and
their cells keep their labels. Operations inside the part thus leave the larger complex valid if the
part is put back.

\cgalModels{SimplicialDomain}
*/
class Part_domain : public Ball_domain
{
public:
  /// Boundary class of vertices on the cut.
  static constexpr Boundary_class::Bits cut = 128;
  /// Tells that the domain can have any shape.
  static constexpr bool is_ball = false;

  /// Returns whether a vertex is on the cut.
  template <class Vertex> static bool is_constrained(const Vertex& v) {
    return (v.boundary_class() & cut) != 0;
  }

  /// Returns the domain, for any state.
  template <int d> static Part_domain of(const State<d>& /*state*/) { return Part_domain(); }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_PART_DOMAIN_H
