// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAIN_RULE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAIN_RULE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What happens if a destination of the interface is outside the domain, a box. The sides of the box
are walls for an interface that touches them: its vertices stop there, whatever the rule is.
*/
enum class Domain_rule {
  refuse, ///< an `Invalid_destination_error` is thrown before anything changes
  grow, ///< the box is enlarged by `grow_domain()`, so handles are invalidated; a deformation whose
        ///< destinations are given cannot do this and refuses
  stop  ///< vertices stop at the sides
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DOMAIN_RULE_H
