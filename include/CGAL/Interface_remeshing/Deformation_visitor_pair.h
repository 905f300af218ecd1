// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_DEFORMATION_VISITOR_PAIR_H
#define CGAL_INTERFACE_REMESHING_DEFORMATION_VISITOR_PAIR_H

#include <CGAL/license/Interface_remeshing.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Pair of visitors that acts as one visitor. Each change is reported to the first visitor, then to the
second. Changes that have happened are reported to the second visitor even if the first one throws,
so that both visitors stay consistent with the mesh. If the first visitor throws before a change,
the second one is not called. Pairs can be nested.

\tparam First, Second models of `DeformationVisitor`

\cgalModels `DeformationVisitor`
*/
template <class First, class Second> class Deformation_visitor_pair
{
public:
  /// Constructs the pair with references to both visitors, which must outlive the pair and its
  /// copies.
  Deformation_visitor_pair(First& first, Second& second) : m_first(first), m_second(second) {}

  /// Calls both visitors.
  template <class Cavity> void before_replacement(const Cavity& cavity) {
    m_first.before_replacement(cavity);
    m_second.before_replacement(cavity);
  }

  /// Calls both visitors.
  template <class Cavity> void after_replacement(const Cavity& cavity) {
    tell([&](auto& visitor) { visitor.after_replacement(cavity); });
  }

  /// Calls both visitors.
  template <class Vertex_handle, class Star, class Point_3>
  void before_smoothing(Vertex_handle v, const Star& star, const Point_3& target) {
    m_first.before_smoothing(v, star, target);
    m_second.before_smoothing(v, star, target);
  }

  /// Calls both visitors.
  template <class Vertex_handle, class Star>
  void after_smoothing(Vertex_handle v, const Star& star) {
    tell([&](auto& visitor) { visitor.after_smoothing(v, star); });
  }

  /// Calls both visitors.
  template <class Vertex_handle>
  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) {
    tell([&](auto& visitor) { visitor.after_split(v, a, b); });
  }

  /// Calls both visitors.
  template <class Vertex_handle> void after_insertion(Vertex_handle v) {
    tell([&](auto& visitor) { visitor.after_insertion(v); });
  }

  /// Calls both visitors.
  template <class Vertex_handle> void before_collapse(Vertex_handle removed, Vertex_handle kept) {
    m_first.before_collapse(removed, kept);
    m_second.before_collapse(removed, kept);
  }

  /// Calls both visitors.
  template <class Cells> void after_flip(const Cells& cells) {
    tell([&](auto& visitor) { visitor.after_flip(cells); });
  }

  /// Calls both visitors.
  template <class Cell_handle> void after_relabel(Cell_handle cell, int before) {
    tell([&](auto& visitor) { visitor.after_relabel(cell, before); });
  }

  /// Calls both visitors.
  template <class Event> void after_topology_event(const Event& event) {
    tell([&](auto& visitor) { visitor.after_topology_event(event); });
  }

  /// Calls both visitors. Returns whether both returned true.
  bool go_further(unsigned pass) {
    const bool first = m_first.go_further(pass);
    return m_second.go_further(pass) && first;
  }

private:
  template <class Tell> void tell(const Tell& tell) {
    try {
      tell(m_first);
    } catch (...) {
      tell(m_second);
      throw;
    }
    tell(m_second);
  }

  First& m_first;
  Second& m_second;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_DEFORMATION_VISITOR_PAIR_H
