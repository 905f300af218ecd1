// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
A change of connected components of a label between two calls. If components merge and split at the
same time, two events with the same components are reported.
*/
struct Component_event
{
  /// Kind of the change.
  enum class Kind {
    merged,   ///< several components became one
    split,    ///< one component was divided into several
    vanished, ///< no cell of a component is left
    appeared  ///< a component has no predecessor
  };

  /// Returns the name of a kind, which is the name of its enumerator.
  static const char* name_of(Kind kind) {
    switch (kind) {
    case Kind::merged:
      return "merged";
    case Kind::split:
      return "split";
    case Kind::vanished:
      return "vanished";
    case Kind::appeared:
      break;
    }
    return "appeared";
  }

  /// Component that took part in the change.
  struct Component
  {
    std::uint32_t component; ///< `component()` of its cells, at the previous or at the present call
    /// volume just before or just after the change, in the coordinates of the complex
    double volume;
  };

  Kind kind;                     ///< kind of the change
  int label;                     ///< label of the components
  std::vector<Component> before; ///< components before, by number; empty if a component appeared
  std::vector<Component> after;  ///< components after, by number; empty if a component vanished
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H
