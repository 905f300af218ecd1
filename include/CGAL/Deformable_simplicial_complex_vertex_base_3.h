// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Simplex_data.h>

#include <CGAL/Triangulation_vertex_base_3.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Vertex of a deformable simplicial complex in space. Its data about surface patches can be set when
`Labeled_complex::release()` was called.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Vb a vertex base class of 3D triangulations with points. Data that it adds are copied with a
        complex, and a vertex keeps them while it exists; `Deformation_visitor` tells when vertices
        are created, merged and removed.

\cgalModels{SimplicialMeshVertexBase_3}
*/
template <class Traits, class Vb = Triangulation_vertex_base_3<Traits>>
class Deformable_simplicial_complex_vertex_base_3
    : public Vb,
      public Deformable_simplicial_complexes::Vertex_data
{
public:
  using Cell_handle =
      typename Vb::Cell_handle;     ///< handle of a cell of the triangulation data structure
  using Point = typename Vb::Point; ///< `DeformableSimplicialComplexTraits_3::Point_3`

  /// Rebinds the vertex to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<Tds2>::Other; ///< `Vb` for `Tds2`
    /// this class for `Tds2`
    using Other = Deformable_simplicial_complex_vertex_base_3<Traits, Vb2>;
  };

  using Subdomain_index = int;     ///< a label
  using Surface_patch_index = int; ///< number of a surface patch
  using Curve_index = int;         ///< number of a curve
  using Corner_index = int;        ///< number of a corner
  using Index = int;               ///< one of these
  using FT = typename Traits::FT;  ///< `double`

  using Vb::Vb;

  /// Returns the dimension of the part of the model that contains the vertex: 3 in the interior of
  /// a label, 2 on the interface; outside a complex, what was set.
  int in_dimension() const {
    return !this->m_is_in_complex ? this->m_dimension : this->is_interface() ? 2 : 3;
  }
  /// Returns the index of the part of the model that contains the vertex.
  Index index() const { return this->m_is_in_complex ? 0 : this->m_index; }
  /// Sets `in_dimension()`. \pre the vertex belongs to no complex
  void set_dimension(int dimension) {
    CGAL_precondition(!this->m_is_in_complex);
    this->m_dimension = std::int8_t(dimension);
  }
  /// Sets `index()`. \pre the vertex belongs to no complex
  void set_index(Index index) {
    CGAL_precondition(!this->m_is_in_complex);
    this->m_index = index;
  }

  /// \name Cache of Mesh_complex_3_in_triangulation_3
  /// @{

  /// Returns whether the cached numbers are right.
  bool is_c2t3_cache_valid() const { return this->m_are_facets_known; }
  /// Forgets the cached numbers.
  void invalidate_c2t3_cache() { this->m_are_facets_known = false; }
  /// Caches the numbers of facets on patches at the vertex, and of their connected groups.
  /// \pre the vertex belongs to no complex
  void set_c2t3_cache(std::size_t facets, std::size_t components) {
    CGAL_precondition(!this->m_is_in_complex);
    this->m_interface_degree = std::uint32_t(facets);
    this->m_id = std::uint32_t(components);
    this->m_are_facets_known = true;
  }
  /// Returns the cached number of facets.
  std::size_t cached_number_of_incident_facets() const { return this->m_interface_degree; }
  /// Returns the cached number of connected groups of facets.
  std::size_t cached_number_of_components() const { return this->m_id; }

  /// @}
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_VERTEX_BASE_3_H
