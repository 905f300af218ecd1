// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_PAIR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_PAIR_H

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Two visitors in the place of one: the first is told of each change, then the second. Of what has
happened the second is told even if the first throws, so that neither loses track of the mesh; what
the first refuses before it happens, the second does not hear of. Pairs can be nested.

\tparam First, Second models of `DeformationVisitor`

\cgalModels `DeformationVisitor`
*/
template <class First, class Second> class Deformation_visitor_pair
{
public:
  /// Refers to both visitors, which must outlive the pair and its copies.
  Deformation_visitor_pair(First& first, Second& second) : m_first(first), m_second(second) {}

  /// Tells both.
  template <class Cavity> void before_replacement(const Cavity& cavity) {
    m_first.before_replacement(cavity);
    m_second.before_replacement(cavity);
  }

  /// Tells both.
  template <class Cavity> void after_replacement(const Cavity& cavity) {
    tell([&](auto& visitor) { visitor.after_replacement(cavity); });
  }

  /// Tells both.
  template <class Vertex_handle, class Star, class Point_3>
  void before_smoothing(Vertex_handle v, const Star& star, const Point_3& target) {
    m_first.before_smoothing(v, star, target);
    m_second.before_smoothing(v, star, target);
  }

  /// Tells both.
  template <class Vertex_handle, class Star>
  void after_smoothing(Vertex_handle v, const Star& star) {
    tell([&](auto& visitor) { visitor.after_smoothing(v, star); });
  }

  /// Tells both.
  template <class Vertex_handle>
  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) {
    tell([&](auto& visitor) { visitor.after_split(v, a, b); });
  }

  /// Tells both.
  template <class Vertex_handle> void after_insertion(Vertex_handle v) {
    tell([&](auto& visitor) { visitor.after_insertion(v); });
  }

  /// Tells both.
  template <class Vertex_handle> void before_collapse(Vertex_handle removed, Vertex_handle kept) {
    m_first.before_collapse(removed, kept);
    m_second.before_collapse(removed, kept);
  }

  /// Tells both.
  template <class Cells> void after_flip(const Cells& cells) {
    tell([&](auto& visitor) { visitor.after_flip(cells); });
  }

  /// Tells both.
  template <class Cell_handle> void after_relabel(Cell_handle cell, int before) {
    tell([&](auto& visitor) { visitor.after_relabel(cell, before); });
  }

  /// Tells both.
  template <class Event> void after_topology_event(const Event& event) {
    tell([&](auto& visitor) { visitor.after_topology_event(event); });
  }

  /// Asks both, and goes further if both say so.
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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_PAIR_H
