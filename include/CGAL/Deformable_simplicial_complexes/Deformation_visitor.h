// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Visitor that does nothing when the mesh changes. It is the default visitor, and a base class of
other visitors, which hide the functions that they need. Pass a visitor by `std::ref` to read its
state afterwards. No function may change the complex.

\cgalModels `DeformationVisitor`
*/
struct Deformation_visitor
{
  /// Called before the planned cells of `cavity` replace its removed cells, which still exist.
  template <class Cavity> void before_replacement(const Cavity& /*cavity*/) {}

  /// Called after the planned cells replaced the removed ones; the new cells are
  /// `cavity.created()`.
  template <class Cavity> void after_replacement(const Cavity& /*cavity*/) {}

  /// Called before mesh optimization moves `v`, the center of `star`, to `target`.
  template <class Vertex_handle, class Star, class Point_3>
  void before_smoothing(Vertex_handle /*v*/, const Star& /*star*/, const Point_3& /*target*/) {}

  /// Called after mesh optimization moved `v`, the center of `star`.
  template <class Vertex_handle, class Star>
  void after_smoothing(Vertex_handle /*v*/, const Star& /*star*/) {}

  /// Called after `v` was created on the edge between `a` and `b`.
  template <class Vertex_handle>
  void after_split(Vertex_handle /*v*/, Vertex_handle /*a*/, Vertex_handle /*b*/) {}

  /// Called after `v` was created. The cells around it are new, and some of their other vertices
  /// may be new, too.
  template <class Vertex_handle> void after_insertion(Vertex_handle /*v*/) {}

  /// Called before `removed` collapses into `kept`; both still exist.
  template <class Vertex_handle>
  void before_collapse(Vertex_handle /*removed*/, Vertex_handle /*kept*/) {}

  /// Called after `cells` replaced others: an edge, facets, or an edge of the interface was
  /// removed, or the cells around a cell were replaced as a whole.
  template <class Cells> void after_flip(const Cells& /*cells*/) {}

  /// Called after the label of `cell` changed from `before`.
  template <class Cell_handle> void after_relabel(Cell_handle /*cell*/, int /*before*/) {}

  /// Called at the end of a pass in which components merged, split, vanished or appeared.
  template <class Event> void after_topology_event(const Event& /*event*/) {}

  /// Called before each pass of a deformation; the first pass is 1. If it returns false, the
  /// deformation ends and is incomplete.
  bool go_further(unsigned /*pass*/) { return true; }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
