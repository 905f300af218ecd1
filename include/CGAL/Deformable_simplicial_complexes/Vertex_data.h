// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What a vertex of a deformable simplicial complex carries in any dimension, besides its point: a time
stamp that orders vertices by creation, and what the complex caches about it. The setters are for
the complex; calling them from outside breaks what it caches.
*/
class Vertex_data
{
public:
  using Has_timestamp = Tag_true; ///< makes the container of the vertices number them

  /// The number in the order of creation; `std::size_t(-1)` for a vertex outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// Whether a facet between two labels is incident.
  bool is_interface() const { return m_interface_degree > 0; }
  /// The number of facets between two labels that are incident.
  std::uint32_t interface_degree() const { return m_interface_degree; }
  /// Sets `interface_degree()`.
  void set_interface_degree(std::uint32_t degree) { m_interface_degree = degree; }

  /// The sides of the domain that hold the vertex, see `Boundary_class`; 0 in the inside.
  std::uint8_t boundary_class() const { return m_boundary_class; }
  /// Sets `boundary_class()`.
  void set_boundary_class(std::uint8_t boundary_class) { m_boundary_class = boundary_class; }

  /// How long edges of the interface at the vertex were, in the mean, when it was built or last
  /// made finer or coarser there: motion does not change it. 0 for a vertex that was not on it
  /// then.
  float spacing() const { return m_spacing; }
  /// Sets `spacing()`.
  void set_spacing(float spacing) { m_spacing = spacing; }

  /// An index into arrays beside the complex, below its `vertex_id_bound()`. Vertices that are
  /// created get ids of those that were removed.
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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_VERTEX_DATA_H
