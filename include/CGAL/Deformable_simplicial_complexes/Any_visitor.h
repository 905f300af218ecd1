// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_ANY_VISITOR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_ANY_VISITOR_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Component_event.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef
A change of connected components of a label in a pass of a deformation, and its place.
\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Topology_event : public Component_event
{
  typename Complex::Point where; ///< place of one of the cells that changed their label
  unsigned pass;                 ///< pass of the deformation; the first one is 1
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Base class of visitors, with a virtual function for each function of `DeformationVisitor`. Functions
that change the mesh take an `Any_visitor`, so they are compiled only once for each type of complex.
The functions of this class do nothing. `DeformationVisitor` documents when they are called. They
must not change the complex, and their exceptions pass through.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Any_visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle; ///< a vertex
  using Cell_handle = typename Complex::Cell_handle;     ///< a cell
  using Star = std::vector<Cell_handle>;                 ///< the cells around a vertex
  using Event = Topology_event<Complex>;                 ///< a change of components

  /// Called before the planned cells of the cavity replace the removed cells.
  virtual void before_replacement(const Cavity<Complex>&) {}
  /// Called after the planned cells of the cavity have replaced the removed cells.
  virtual void after_replacement(const Cavity<Complex>&) {}
  /// Called before smoothing moves a vertex with this star to this target.
  virtual void before_smoothing(Vertex_handle, const Star&, const typename Complex::Point&) {}
  /// Called after smoothing has moved a vertex with this star.
  virtual void after_smoothing(Vertex_handle, const Star&) {}
  /// Called after a new vertex has split the edge between two other vertices.
  virtual void after_split(Vertex_handle, Vertex_handle, Vertex_handle) {}
  /// Called after a vertex has been inserted.
  virtual void after_insertion(Vertex_handle) {}
  /// Called before the first vertex is collapsed into the second one.
  virtual void before_collapse(Vertex_handle, Vertex_handle) {}
  /// Called after a flip has created these cells.
  virtual void after_flip(const std::vector<Cell_handle>&) {}
  /// Called after the label of a cell has changed from this label.
  virtual void after_relabel(Cell_handle, typename Complex::Label) {}
  /// Called after components have merged, split, vanished or appeared.
  virtual void after_topology_event(const Event&) {}
  /// Called before each pass of a deformation. If it returns false, the deformation ends.
  virtual bool go_further(unsigned /*pass*/) { return true; }

  /// Constructs a visitor that does nothing. Visitors cannot be copied.
  Any_visitor() = default;
  virtual ~Any_visitor() = default;
  Any_visitor(const Any_visitor&) = delete;
  Any_visitor& operator=(const Any_visitor&) = delete;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Adaptor that passes the calls of `Any_visitor` to a visitor of the user.

\tparam Complex a deformable simplicial complex
\tparam Visitor model of `DeformationVisitor`
*/
template <class Complex, class Visitor> class Visitor_adaptor final : public Any_visitor<Complex>
{
public:
  using typename Any_visitor<Complex>::Vertex_handle;
  using typename Any_visitor<Complex>::Cell_handle;
  using typename Any_visitor<Complex>::Star;
  using typename Any_visitor<Complex>::Event;

  /// Refers to a visitor. \pre The visitor outlives the object.
  explicit Visitor_adaptor(Visitor& visitor) : m_visitor(visitor) {}

  void before_replacement(const Cavity<Complex>& cavity) override {
    m_visitor.before_replacement(cavity);
  }
  void after_replacement(const Cavity<Complex>& cavity) override {
    m_visitor.after_replacement(cavity);
  }
  void before_smoothing(Vertex_handle v, const Star& star,
                        const typename Complex::Point& target) override {
    m_visitor.before_smoothing(v, star, target);
  }
  void after_smoothing(Vertex_handle v, const Star& star) override {
    m_visitor.after_smoothing(v, star);
  }
  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) override {
    m_visitor.after_split(v, a, b);
  }
  void after_insertion(Vertex_handle v) override { m_visitor.after_insertion(v); }
  void before_collapse(Vertex_handle removed, Vertex_handle kept) override {
    m_visitor.before_collapse(removed, kept);
  }
  void after_flip(const std::vector<Cell_handle>& cells) override { m_visitor.after_flip(cells); }
  void after_relabel(Cell_handle cell, typename Complex::Label before) override {
    m_visitor.after_relabel(cell, before);
  }
  void after_topology_event(const Event& event) override { m_visitor.after_topology_event(event); }
  bool go_further(unsigned pass) override { return bool(m_visitor.go_further(pass)); }

private:
  Visitor& m_visitor;
};

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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_ANY_VISITOR_H
