// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CELL_DATA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CELL_DATA_H

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What was tried with a cell in vain: a part of what a cell carries in any dimension, by itself as a
byte fits in where the rest of a cell does not.
*/
class Cell_failures
{
public:
  /// What was tried in vain since motion last changed the shape of the cell, as bits.
  std::uint8_t failures() const { return m_failures; }
  /// Sets `failures()`.
  void set_failures(std::uint8_t bits) { m_failures = bits; }

private:
  std::uint8_t m_failures = 0;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What a cell of a deformable simplicial complex carries in any dimension: a label, the quality cached
by the complex, the connected component of its label that it belongs to, a time stamp that orders
cells by creation, and an id. The setters are for the complex; calling them from outside breaks what
it caches.
*/
class Cell_data
{
public:
  using Has_timestamp = Tag_true; ///< makes the container of the cells number them

  /// The number in the order of creation; `std::size_t(-1)` for a cell outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// An index into arrays beside the complex, below its `cell_id_bound()`. Cells that are created
  /// get ids of those that were removed.
  std::uint32_t id() const { return m_id; }
  /// Sets `id()`.
  void set_id(std::uint32_t id) { m_id = id; }

  /// The phase that fills the cell; 0 for infinite cells, where it means nothing.
  int label() const { return m_label; }
  /// Sets `label()`.
  void set_label(int label) { m_label = label; }

  /// Quality by the measure of the complex, as of the last change of the cell.
  double quality() const { return m_quality; }
  /// Sets `quality()`.
  void set_quality(double quality) { m_quality = quality; }

  /// Identifies the connected component of the label.
  std::uint32_t component() const { return m_component; }
  /// Sets `component()`.
  void set_component(std::uint32_t component) { m_component = component; }

  /// Quality when the shape of the cell last changed essentially, by motion or by smoothing.
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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_CELL_DATA_H
