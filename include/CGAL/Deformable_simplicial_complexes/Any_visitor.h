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
#include <CGAL/Deformable_simplicial_complexes/Topology_event.h>

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// What is told of each change of the mesh, whatever its type: so the templates that change it are
// compiled once, and not for each visitor again.
template <class Complex> class Any_visitor
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Star = std::vector<Cell_handle>;
  using Event = Topology_event<Complex>;

  virtual void before_replacement(const Cavity<Complex>&) {}
  virtual void after_replacement(const Cavity<Complex>&) {}
  virtual void before_smoothing(Vertex_handle, const Star&, const typename Complex::Point&) {}
  virtual void after_smoothing(Vertex_handle, const Star&) {}
  virtual void after_split(Vertex_handle, Vertex_handle, Vertex_handle) {}
  virtual void after_insertion(Vertex_handle) {}
  virtual void before_collapse(Vertex_handle, Vertex_handle) {}
  virtual void after_flip(const std::vector<Cell_handle>&) {}
  virtual void after_relabel(Cell_handle, typename Complex::Label) {}
  virtual void after_topology_event(const Event&) {}

  Any_visitor() = default;
  virtual ~Any_visitor() = default;
  Any_visitor(const Any_visitor&) = delete;
  Any_visitor& operator=(const Any_visitor&) = delete;
};

// Tells a visitor of the user.
template <class Complex, class Visitor> class Visitor_adaptor final : public Any_visitor<Complex>
{
public:
  using typename Any_visitor<Complex>::Vertex_handle;
  using typename Any_visitor<Complex>::Cell_handle;
  using typename Any_visitor<Complex>::Star;
  using typename Any_visitor<Complex>::Event;

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

private:
  Visitor& m_visitor;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_ANY_VISITOR_H
