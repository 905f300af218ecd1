// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H

#include <CGAL/Triangulation_vertex_base_3.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Vertex of a deformable simplicial complex: a point, a time stamp that orders vertices by creation,
and what the complex caches about the vertex. The setters are for the complex; calling them from
outside breaks what it caches.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Vb a vertex base class of 3D triangulations with points

\cgalModels `DeformableSimplicialComplexVertexBase_3`
*/
template <class Traits, class Vb = Triangulation_vertex_base_3<Traits>>
class Deformable_simplicial_complex_vertex_base_3 : public Vb
{
public:
  using Cell_handle =
      typename Vb::Cell_handle;     ///< handle of a cell of the triangulation data structure
  using Point = typename Vb::Point; ///< `DeformableSimplicialComplexTraits_3::Point_3`
  using Has_timestamp = Tag_true;   ///< makes the container of the vertices number them

  /// The vertex of another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<Tds2>::Other;              ///< `Vb` for `Tds2`
    using Other = Deformable_simplicial_complex_vertex_base_3<Traits, Vb2>; ///< the same for `Tds2`
  };

  using Vb::Vb;

  /// The number in the order of creation; `std::size_t(-1)` for a vertex outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// Whether a facet between two labels is incident.
  bool is_interface() const { return m_is_interface; }
  /// Sets `is_interface()`.
  void set_interface(bool is_interface) { m_is_interface = is_interface; }

  /// The sides of the domain that hold the vertex, see `Boundary_class`; 0 in the inside.
  std::uint8_t boundary_class() const { return m_boundary_class; }
  /// Sets `boundary_class()`.
  void set_boundary_class(std::uint8_t boundary_class) { m_boundary_class = boundary_class; }

  /// Where the vertex is to go in the current deformation; meaningful while `has_destination()`.
  const Point& destination() const { return m_destination; }
  /// Whether the vertex is on its way to somewhere.
  bool has_destination() const { return m_has_destination; }
  /// Sets `destination()`; `has_destination()` is true afterwards.
  void set_destination(const Point& destination) {
    m_destination = destination;
    m_has_destination = true;
  }
  /// `has_destination()` is false afterwards.
  void clear_destination() { m_has_destination = false; }

  /// A place in whatever list an algorithm numbers vertices by; the list must confirm it.
  std::uint32_t scratch_index() const { return m_scratch_index; }
  /// Sets `scratch_index()`.
  void set_scratch_index(std::uint32_t index) { m_scratch_index = index; }

private:
  Point m_destination;
  std::size_t m_time_stamp = std::size_t(-1);
  std::uint32_t m_scratch_index = 0;
  std::uint8_t m_boundary_class = 0;
  bool m_is_interface = false;
  bool m_has_destination = false;
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
