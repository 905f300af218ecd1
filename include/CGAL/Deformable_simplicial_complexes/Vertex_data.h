// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Data of a vertex of a deformable simplicial complex, in any dimension, in addition to its point: a
time stamp that orders vertices by creation, and values cached by the complex. Only the complex may
call the setters, since they change values that it caches.
*/
class Vertex_data
{
public:
  using Has_timestamp = Tag_true; ///< tells the container to number the vertices

  /// Returns the number in the order of creation; `std::size_t(-1)` for a vertex outside a
  /// container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// Returns whether an incident facet is on the interface.
  bool is_interface() const { return m_interface_degree > 0; }
  /// Returns the number of incident facets on the interface.
  std::uint32_t interface_degree() const { return m_interface_degree; }
  /// Sets `interface_degree()`.
  void set_interface_degree(std::uint32_t degree) { m_interface_degree = degree; }

  /// Returns the sides of the domain that the vertex lies on, see `Boundary_class`; 0 in the
  /// interior.
  std::uint8_t boundary_class() const { return m_boundary_class; }
  /// Sets `boundary_class()`.
  void set_boundary_class(std::uint8_t boundary_class) { m_boundary_class = boundary_class; }

  /// Returns the mean length of the interface edges at the vertex when the interface was built, or
  /// when it was last refined or coarsened there. Motion does not change it. It is 0 if the vertex
  /// was not on the interface then.
  float spacing() const { return m_spacing; }
  /// Sets `spacing()`.
  void set_spacing(float spacing) { m_spacing = spacing; }

  /// Returns an index into arrays beside the complex, less than its `vertex_id_bound()`. New
  /// vertices get the ids of removed vertices.
  std::uint32_t id() const { return m_id; }
  /// Sets `id()`.
  void set_id(std::uint32_t id) { m_id = id; }

private:
  std::size_t m_time_stamp = std::size_t(-1);
  std::uint32_t m_id = 0;
  std::uint32_t m_interface_degree = 0;
  float m_spacing = 0;
  std::uint8_t m_boundary_class = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H
