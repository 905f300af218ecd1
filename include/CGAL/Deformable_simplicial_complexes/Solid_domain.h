// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SOLID_DOMAIN_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SOLID_DOMAIN_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Ball_domain.h>
#include <CGAL/Deformable_simplicial_complexes/State.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Domain of a complex that has any shape: any number of components, handles and cavities. It may touch
itself in vertices and along edges. The complex then has a copy of such a vertex for each set of
cells that are connected through facets at the vertex. If the domain is a box, vertices on the
boundary move only within their sides. Otherwise, they do not move. `assign_solid_3()` makes
complexes in such domains, and `improve_mesh()` improves them.

\cgalModels{SimplicialDomain}
*/
class Solid_domain : public Ball_domain
{
public:
  /// Tells that the domain can have any shape.
  static constexpr bool is_ball = false;

  /// Returns the domain, for any state.
  template <int d> static Solid_domain of(const State<d>& /*state*/) { return Solid_domain(); }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SOLID_DOMAIN_H
