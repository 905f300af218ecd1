// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_BASES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_BASES_H

#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>
#include <CGAL/Triangulation_vertex_base_3.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {
struct Simplex_access;
} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Data of a vertex of a deformable simplicial complex, in any dimension, in addition to its point: a
time stamp that orders vertices by creation, and values that the complex computes.

Outside a complex, the memory of these values contains what `SimplicialMeshVertexBase_3` of CGAL
requires, see `Labeled_complex::release()`.
*/
class Vertex_data
{
public:
  using Has_timestamp = Tag_true; ///< tells the container to number the vertices

  /// Returns the number in the order of creation; `std::size_t(-1)` for a vertex outside a
  /// container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`. Containers call it.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// \name In a Complex
  /// @{

  /// Returns whether an incident facet is on the interface.
  bool is_interface() const { return interface_degree() > 0; }
  /// Returns the number of incident facets on the interface.
  std::uint32_t interface_degree() const { return m_interface_degree; }
  /// Returns the sides of the domain that the vertex lies on, see `Boundary_class`; 0 in the
  /// interior.
  std::uint8_t boundary_class() const { return m_boundary_class; }
  /// Returns the mean length of the interface edges at the vertex when the interface was built, or
  /// when it was last refined or coarsened there. Motion does not change it. It is 0 if the vertex
  /// was not on the interface then.
  float spacing() const { return m_spacing; }
  /// Returns an index into arrays beside the complex, less than its `vertex_id_bound()`. New
  /// vertices get the ids of removed vertices.
  std::uint32_t id() const { return m_id; }

  /// @}

  /// \cond SKIP_IN_MANUAL
protected:
  friend struct internal::Simplex_access;

  std::size_t m_time_stamp = std::size_t(-1);
  std::uint32_t m_id = 0;               // outside a complex: connected groups of incident facets
  std::uint32_t m_interface_degree = 0; // outside a complex: facets of surface patches
  union {
    float m_spacing;
    int m_index = 0; // outside a complex: of the subdomain or the surface patch
  };
  std::uint8_t m_boundary_class = 0;
  bool m_is_in_complex = false;
  std::int8_t m_dimension = -1;    // outside a complex: of the part that contains the vertex
  bool m_are_facets_known = false; // outside a complex
  /// \endcond
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Record of failed attempts to improve a cell. It is a class of its own since a few bytes fit into a
gap of the memory layout of a cell.
*/
class Cell_failures
{
public:
  /// Returns the kinds of attempts that have failed since motion last changed the shape of the
  /// cell, as bits.
  std::uint8_t failures() const { return m_failures; }

  /// \cond SKIP_IN_MANUAL
protected:
  friend struct internal::Simplex_access;

  std::uint8_t m_failures = 0;
  bool m_is_in_complex = false;
  /// \endcond
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Data of a cell of a deformable simplicial complex, in any dimension: the label, a time stamp that
orders cells by creation, and values that the complex computes.

Outside a complex, the memory of these values contains the surface patches of the facets, see
`Labeled_complex::release()`.
*/
class Cell_data
{
public:
  using Has_timestamp = Tag_true; ///< tells the container to number the cells
  using Subdomain_index = int;    ///< a label

  /// Returns the number in the order of creation; `std::size_t(-1)` for a cell outside a container.
  std::size_t time_stamp() const { return m_time_stamp; }
  /// Sets `time_stamp()`. Containers call it.
  void set_time_stamp(std::size_t stamp) { m_time_stamp = stamp; }

  /// Returns the label: the phase that fills the cell. It is 0 for infinite cells, where it has no
  /// meaning.
  Subdomain_index subdomain_index() const { return m_subdomain_index; }
  /// Sets `subdomain_index()`. Use `Labeled_complex::relabel()` for a cell of a complex.
  void set_subdomain_index(Subdomain_index index) { m_subdomain_index = index; }

  /// \name In a Complex
  /// @{

  /// Returns an index into arrays beside the complex, less than its `cell_id_bound()`. New cells
  /// get the ids of removed cells.
  std::uint32_t id() const { return m_id; }
  /// Returns the quality by the measure of the complex, at the last change of the cell.
  double quality() const { return m_cache.quality; }
  /// Returns the number of the connected component of the label.
  std::uint32_t component() const { return m_cache.component; }
  /// Returns the quality at the last essential change of the cell's shape by motion or smoothing.
  float noted_quality() const { return m_cache.noted_quality; }

  /// @}

  /// \cond SKIP_IN_MANUAL
protected:
  friend struct internal::Simplex_access;

  struct Cache
  {
    double quality;
    std::uint32_t component;
    float noted_quality;
  };
  union {
    Cache m_cache;
    std::array<int, 4> m_patches = {0, 0, 0, 0}; // outside a complex
  };
  Subdomain_index m_subdomain_index = 0;
  std::uint32_t m_id = 0;
  std::size_t m_time_stamp = std::size_t(-1);
  /// \endcond
};

namespace internal {

// Sets the values that the complex computes. Only the package may use it.
struct Simplex_access
{
  // Begin the use of a simplex in a complex.
  static void join(Vertex_data& v) {
    v.m_is_in_complex = true;
    v.m_interface_degree = 0;
    v.m_spacing = 0;
    v.m_boundary_class = 0;
  }
  static void join(Cell_data& c, Cell_failures& failures) {
    c.m_cache = {1, 0, 1};
    failures.m_is_in_complex = true;
    failures.m_failures = 0;
  }
  // End the use of a simplex in a complex.
  static void leave(Vertex_data& v) {
    v.m_is_in_complex = v.m_are_facets_known = false;
    v.m_dimension = -1;
    v.m_index = 0;
  }
  static void leave(Cell_data& c, Cell_failures& failures, const std::array<int, 4>& patches) {
    failures.m_is_in_complex = false;
    c.m_patches = patches;
  }
  // Tells a vertex outside a complex the label of a cell, and the patch of one of its facets at the
  // vertex, 0 for none. A vertex on several patches is on a curve, which has no number.
  static void add_facet(Vertex_data& v, int label, int patch) {
    const bool is_on_other = v.m_dimension == 1 || (v.m_dimension == 2 && v.m_index != patch);
    if (patch != 0) {
      v.m_dimension = is_on_other ? 1 : 2;
      v.m_index = is_on_other ? 0 : patch;
    } else if (v.m_dimension == -1 || v.m_dimension == 3) {
      v.m_dimension = 3;
      v.m_index = label;
    }
  }
  template <class Handle> static void set_id(Handle simplex, std::uint32_t id) {
    simplex->m_id = id;
  }
  template <class Handle> static void set_interface_degree(Handle v, std::uint32_t degree) {
    v->m_interface_degree = degree;
  }
  template <class Handle> static void set_boundary_class(Handle v, std::uint8_t boundary_class) {
    v->m_boundary_class = boundary_class;
  }
  template <class Handle> static void set_spacing(Handle v, float spacing) {
    v->m_spacing = spacing;
  }
  template <class Handle> static void set_failures(Handle c, std::uint8_t bits) {
    c->m_failures = bits;
  }
  template <class Handle> static void set_quality(Handle c, double quality) {
    c->m_cache.quality = quality;
  }
  template <class Handle> static void set_component(Handle c, std::uint32_t component) {
    c->m_cache.component = component;
  }
  template <class Handle> static void set_noted_quality(Handle c, float quality) {
    c->m_cache.noted_quality = quality;
  }
};

} // namespace internal
} // namespace CGAL::Deformable_simplicial_complexes

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Vertex of a deformable simplicial complex in the plane.

\tparam Traits a model of `DeformableSimplicialComplexTraits_2`
\tparam Vb a vertex base class of 2D triangulations with points
*/
template <class Traits, class Vb = Triangulation_vertex_base_2<Traits>>
class Deformable_simplicial_complex_vertex_base_2
    : public Vb,
      public Deformable_simplicial_complexes::Vertex_data
{
public:
  using Cell_handle = typename Vb::Face_handle; ///< handle of a triangle
  using Point = typename Vb::Point;             ///< `Traits::Point_2`

  /// Rebinds the vertex to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<Tds2>::Other; ///< `Vb` for `Tds2`
    /// this class for `Tds2`
    using Other = Deformable_simplicial_complex_vertex_base_2<Traits, Vb2>;
  };

  using Vb::Vb;

  Cell_handle cell() const { return this->face(); }   ///< one of the incident triangles
  void set_cell(Cell_handle c) { this->set_face(c); } ///< sets `cell()`
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Triangle of a deformable simplicial complex in the plane. The triangles are the cells of the
complex.

\tparam Traits a model of `DeformableSimplicialComplexTraits_2`
\tparam Fb a face base class of 2D triangulations
*/
template <class Traits, class Fb = Triangulation_face_base_2<Traits>>
class Deformable_simplicial_complex_face_base_2
    : public Fb,
      public Deformable_simplicial_complexes::Cell_failures,
      public Deformable_simplicial_complexes::Cell_data
{
public:
  /// Rebinds the triangle to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Fb2 = typename Fb::template Rebind_TDS<Tds2>::Other;            ///< `Fb` for `Tds2`
    using Other = Deformable_simplicial_complex_face_base_2<Traits, Fb2>; ///< this class for `Tds2`
  };

  using Fb::Fb;
};

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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Cell of a deformable simplicial complex in space. Labels are subdomain indices, and facets of the
interface are facets on surface patches.

In a complex, the patches follow from the labels and cannot be set. `Labeled_complex::release()`
numbers the patches; from then on, they can be set.

\tparam Traits model of `DeformableSimplicialComplexTraits_3`
\tparam Cb a cell base class of 3D triangulations. Data that it adds are copied with a complex, and
        a cell keeps them while it exists; `Deformation_visitor` tells when cells are replaced.

\cgalModels{SimplicialMeshCellBase_3}
*/
template <class Traits, class Cb = Triangulation_cell_base_3<Traits>>
class Deformable_simplicial_complex_cell_base_3
    : public Cb,
      public Deformable_simplicial_complexes::Cell_failures,
      public Deformable_simplicial_complexes::Cell_data
{
public:
  /// Rebinds the cell to another triangulation data structure.
  template <class Tds2> struct Rebind_TDS
  {
    using Cb2 = typename Cb::template Rebind_TDS<Tds2>::Other;            ///< `Cb` for `Tds2`
    using Other = Deformable_simplicial_complex_cell_base_3<Traits, Cb2>; ///< this class for `Tds2`
  };

  using Surface_patch_index = int; ///< number of a surface patch; 0 for none

  using Cb::Cb;

  /// Returns the patch that contains the facet `i`. In a complex, it is 1 for each facet between
  /// cells of different labels.
  Surface_patch_index surface_patch_index(int i) const {
    return !this->m_is_in_complex ? this->m_patches[i]
                                  : this->subdomain_index() != this->neighbor(i)->subdomain_index();
  }
  /// Returns whether a patch contains the facet `i`.
  bool is_facet_on_surface(int i) const { return surface_patch_index(i) != 0; }
  /// Sets `surface_patch_index()`. \pre the cell belongs to no complex
  void set_surface_patch_index(int i, Surface_patch_index index) {
    CGAL_precondition(!this->m_is_in_complex);
    this->m_patches[i] = index;
  }

  /// \name Cache of Remeshing
  /// `tetrahedral_isotropic_remeshing()` can store an angle in a cell. This cell stores none.
  /// @{
  bool is_cache_valid() const { return false; }       ///< false
  double sliver_value() const { return 0; }           ///< never called
  void set_sliver_value(double /*squared_cosine*/) {} ///< nothing
  void reset_cache_validity() const {}                ///< nothing
  /// @}
};

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_BASES_H
