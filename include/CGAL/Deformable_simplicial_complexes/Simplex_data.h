// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {
struct Simplex_access;
}

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

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SIMPLEX_DATA_H
