// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Data of a vertex of a deformable simplicial complex, in any dimension, in addition to its point: a
time stamp that orders vertices by creation, and values cached by the complex. Only the package may
call the setters, since the complex caches these values.
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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Record of failed attempts to improve a cell. It is a class of its own since a single byte fits into
a gap of the memory layout of a cell.
*/
class Cell_failures
{
public:
  /// Returns the kinds of attempts that have failed since motion last changed the shape of the
  /// cell, as bits.
  std::uint8_t failures() const { return m_failures; }
  /// Sets `failures()`.
  void set_failures(std::uint8_t bits) { m_failures = bits; }

private:
  std::uint8_t m_failures = 0;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Data of a cell of a deformable simplicial complex, in any dimension: a label, the cached quality,
the connected component of the label, a time stamp that orders cells by creation, and an id. Only
the complex may call the setters, since they change values that it caches.
*/
class Cell_data
{
public:
  using Has_timestamp = Tag_true; ///< tells the container to number the cells

  /// Returns the number in the order of creation; `std::size_t(-1)` for a cell outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// Returns an index into arrays beside the complex, less than its `cell_id_bound()`. New cells
  /// get the ids of removed cells.
  std::uint32_t id() const { return m_id; }
  /// Sets `id()`.
  void set_id(std::uint32_t id) { m_id = id; }

  /// Returns the phase that fills the cell. It is 0 for infinite cells, where it has no meaning.
  int label() const { return m_label; }
  /// Sets `label()`.
  void set_label(int label) { m_label = label; }

  /// Returns the quality by the measure of the complex, at the last change of the cell.
  double quality() const { return m_quality; }
  /// Sets `quality()`.
  void set_quality(double quality) { m_quality = quality; }

  /// Returns the number of the connected component of the label.
  std::uint32_t component() const { return m_component; }
  /// Sets `component()`.
  void set_component(std::uint32_t component) { m_component = component; }

  /// Returns the quality at the last essential change of the cell's shape by motion or smoothing.
  float noted_quality() const { return m_noted_quality; }
  /// Sets `noted_quality()`.
  void set_noted_quality(float quality) { m_noted_quality = quality; }

private:
  int m_label = 0;
  std::uint32_t m_component = 0;
  float m_noted_quality = 1;
  std::uint32_t m_id = 0;
  double m_quality = 1;
  std::size_t m_time_stamp = std::size_t(-1);
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H
