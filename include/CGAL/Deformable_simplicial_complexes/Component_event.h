// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
What became of connected components of a label between two looks at them. Components that merge
while they split give two events with the same parts.
*/
struct Component_event
{
  /// What happened.
  enum class Kind {
    merged,   ///< several components became one
    split,    ///< a component fell into several
    vanished, ///< no cell is left of a component
    appeared  ///< a component comes from none
  };

  /// A component that took part.
  struct Part
  {
    std::uint32_t component; ///< the `component()` of its cells, at the look before or now
    double volume; ///< just before the change, or after it, in the coordinates of the complex
  };

  Kind kind;                ///< what happened
  int label;                ///< whose components these are
  std::vector<Part> before; ///< by number; empty if a component appeared
  std::vector<Part> after;  ///< by number; empty if a component vanished
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_COMPONENT_EVENT_H
