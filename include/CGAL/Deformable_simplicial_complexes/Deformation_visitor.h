// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>

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

Base class of visitors: objects whose functions are called when the simplices of a complex change.
User data that is attached to simplices can follow these changes. A visitor can also end a
deformation. The functions of this class do nothing. Mark the functions of a derived class with
`override`, so that misspelled names and wrong arguments do not compile.

The following functions call visitors: `deform_interface()`, `advect_interface()`,
`advect_adaptively()`, `fit_interface()`, `restore_volumes()`, `improve_mesh()`,
`improve_interface()`, `control_detail()`, `refine_cells()` and `remove_degeneracies()`. Only the
first five functions relabel cells, change the topology, or work in passes. The motion of a
deformation calls no function, since vertices and cells carry their data along.

Each change of the mesh is a replacement of cells or the smoothing of a vertex. The functions for
these two changes receive the geometry before and after the change. The other functions receive the
purpose of the change. Data in the bases of simplices (`..._with_info`) have their default value in
new vertices and cells, which is indeterminate for numbers; `after_replacement()` is the place to
set them, from the values that `before_replacement()` reads.

One thread at a time calls the functions. The order of the calls does not depend on the number of
threads. No function may change the complex. If a function throws, the exception reaches the caller,
and the complex is valid. If a function throws before a change, the change does not happen. With
several visitors, another visitor can then receive a call before the change without the call after
the change.

Pass a visitor by `std::ref()`. A visitor that is passed by value is copied, and what it stores is
lost.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Deformation_visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle; ///< a vertex
  using Cell_handle = typename Complex::Cell_handle;     ///< a cell
  using Star = std::vector<Cell_handle>;                 ///< the cells around a vertex
  using Event = Topology_event<Complex>;                 ///< a change of components

  /// Called before the planned cells of the cavity replace its removed cells, which still exist.
  /// New vertices have null handles. This function is called for splits, collapses, insertions and
  /// flips, after `before_collapse()`.
  virtual void before_replacement(const Cavity<Complex>&) {}
  /// Called after the replacement. The cells `created()` of the cavity and the handles of new
  /// vertices exist. The removed cells, their parents, and the removed vertices must not be
  /// accessed. This function is called before `after_split()`, `after_insertion()` and
  /// `after_flip()`.
  virtual void after_replacement(const Cavity<Complex>&) {}
  /// Called before smoothing moves a vertex to a target. The star includes infinite cells. This
  /// function is not called when the vertex moves with a deformation.
  virtual void before_smoothing(Vertex_handle, const Star&, const typename Complex::Point&) {}
  /// Called after smoothing has moved a vertex with this star.
  virtual void after_smoothing(Vertex_handle, const Star&) {}
  /// Called after a new vertex, the first one, has split the edge between two other vertices.
  virtual void after_split(Vertex_handle, Vertex_handle, Vertex_handle) {}
  /// Called after the star of a new vertex has replaced other cells. In aggressive mesh
  /// optimization, vertices around it can also be new; the calls for these vertices follow each
  /// other.
  virtual void after_insertion(Vertex_handle) {}
  /// Called before the first vertex is collapsed into the second one, which keeps its position.
  /// Both still exist. In aggressive mesh optimization, the vertices need not share an edge; the
  /// second one is then the nearest vertex that remains.
  virtual void before_collapse(Vertex_handle, Vertex_handle) {}
  /// Called after these cells have replaced other cells by the removal of an edge, of facets, or of
  /// an edge of the interface. In aggressive mesh optimization, the cells fill a neighborhood in
  /// which vertices can have been collapsed, moved or created.
  virtual void after_flip(const std::vector<Cell_handle>&) {}
  /// Called after the label of a cell has changed from this label.
  virtual void after_relabel(Cell_handle, typename Complex::Label) {}
  /// Called once for each event in which components of a label merged, split, vanished or appeared,
  /// at the end of the pass and after the removal of small angles.
  virtual void after_topology_event(const Event&) {}
  /// Called before each pass of a deformation; the first one is 1. If it returns false, the
  /// deformation ends at once, and the report says that it was stopped.
  virtual bool go_further(unsigned /*pass*/) { return true; }

  virtual ~Deformation_visitor() = default;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Two visitors as one. The first one is called first. If the first visitor throws after a change, the
second one is still called, so that both visitors stay consistent with the mesh. If the first
visitor throws before a change, the second one is not called. Pairs can be nested.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Deformation_visitor_pair final : public Deformation_visitor<Complex>
{
  using Base = Deformation_visitor<Complex>;
  using typename Base::Cell_handle;
  using typename Base::Event;
  using typename Base::Star;
  using typename Base::Vertex_handle;

public:
  /// Constructs the pair with references to both visitors, which must outlive the pair.
  Deformation_visitor_pair(Base& first, Base& second) : m_first(first), m_second(second) {}

  /// \cond SKIP_IN_MANUAL
  void before_replacement(const Cavity<Complex>& cavity) override {
    m_first.before_replacement(cavity);
    m_second.before_replacement(cavity);
  }
  void after_replacement(const Cavity<Complex>& cavity) override {
    tell([&](Base& visitor) { visitor.after_replacement(cavity); });
  }
  void before_smoothing(Vertex_handle v, const Star& star,
                        const typename Complex::Point& target) override {
    m_first.before_smoothing(v, star, target);
    m_second.before_smoothing(v, star, target);
  }
  void after_smoothing(Vertex_handle v, const Star& star) override {
    tell([&](Base& visitor) { visitor.after_smoothing(v, star); });
  }
  void after_split(Vertex_handle v, Vertex_handle a, Vertex_handle b) override {
    tell([&](Base& visitor) { visitor.after_split(v, a, b); });
  }
  void after_insertion(Vertex_handle v) override {
    tell([&](Base& visitor) { visitor.after_insertion(v); });
  }
  void before_collapse(Vertex_handle removed, Vertex_handle kept) override {
    m_first.before_collapse(removed, kept);
    m_second.before_collapse(removed, kept);
  }
  void after_flip(const std::vector<Cell_handle>& cells) override {
    tell([&](Base& visitor) { visitor.after_flip(cells); });
  }
  void after_relabel(Cell_handle cell, typename Complex::Label before) override {
    tell([&](Base& visitor) { visitor.after_relabel(cell, before); });
  }
  void after_topology_event(const Event& event) override {
    tell([&](Base& visitor) { visitor.after_topology_event(event); });
  }
  bool go_further(unsigned pass) override {
    const bool first = m_first.go_further(pass);
    return m_second.go_further(pass) && first;
  }
  /// \endcond

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

  Base &m_first, &m_second;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_VISITOR_H
