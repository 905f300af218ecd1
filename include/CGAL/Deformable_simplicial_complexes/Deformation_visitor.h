// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Does nothing when the mesh changes: the default visitor and a base for others, which hide the
functions they are interested in. Pass a visitor by `std::ref` to see its state afterwards. No
function may change the complex.

\cgalModels `DeformationVisitor`
*/
struct Deformation_visitor
{
  /// The planned tetrahedra of `cavity` are about to replace its cells, which are still there.
  template <class Cavity> void before_replacement(const Cavity& /*cavity*/) {}

  /// They have replaced them, and are `cavity.created()`.
  template <class Cavity> void after_replacement(const Cavity& /*cavity*/) {}

  /// `v`, the center of `star`, is about to move to `target` for the sake of the mesh.
  template <class Vertex_handle, class Star, class Point_3>
  void before_smoothing(Vertex_handle /*v*/, const Star& /*star*/, const Point_3& /*target*/) {}

  /// `v` has moved there.
  template <class Vertex_handle, class Star>
  void after_smoothing(Vertex_handle /*v*/, const Star& /*star*/) {}

  /// `v` was created on the edge between `a` and `b`.
  template <class Vertex_handle>
  void after_split(Vertex_handle /*v*/, Vertex_handle /*a*/, Vertex_handle /*b*/) {}

  /// `v` was created among the cells that are its star now, maybe with vertices around it.
  template <class Vertex_handle> void after_insertion(Vertex_handle /*v*/) {}

  /// `removed` is about to disappear into `kept`; both are still there.
  template <class Vertex_handle>
  void before_collapse(Vertex_handle /*removed*/, Vertex_handle /*kept*/) {}

  /// `cells` have replaced others: an edge, facets, or an edge of the interface was removed, or the
  /// surroundings of a cell were improved as a whole.
  template <class Cells> void after_flip(const Cells& /*cells*/) {}

  /// `cell` had the label `before`.
  template <class Cell_handle> void after_relabel(Cell_handle /*cell*/, int /*before*/) {}

  /// Components merged, split, vanished or appeared in a pass that has ended.
  template <class Event> void after_topology_event(const Event& /*event*/) {}

  /// Asked before each pass of a deformation, the first one being 1; false ends it as incomplete.
  bool go_further(unsigned /*pass*/) { return true; }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
