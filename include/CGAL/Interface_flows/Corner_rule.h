// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_CORNER_RULE_H
#define CGAL_INTERFACE_FLOWS_CORNER_RULE_H

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgInterfaceFlowsRef
/// The front of a `Normal_offset` at corners from which it moves away.
enum class Corner_rule {
  miter, ///< the faces move, and corners stay sharp
  round  ///< corners become arcs, edges become cylinders, and vertices become spheres
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_FLOWS_CORNER_RULE_H
