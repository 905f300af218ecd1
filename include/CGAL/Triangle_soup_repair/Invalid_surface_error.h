// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INVALID_SURFACE_ERROR_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INVALID_SURFACE_ERROR_H

#include <CGAL/Mesh_support/Error.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgTriangleSoupRepairRef

Exception thrown if an input surface (in 2D, a curve) does not bound a solid, so that inside and
outside are undefined.
*/
class Invalid_surface_error : public Error
{
public:
  /// Kind of the error.
  enum class Reason {
    empty,             ///< there is no facet
    not_finite,        ///< a coordinate is not a finite number
    bad_index,         ///< a facet refers to a vertex that does not exist
    degenerate_facet,  ///< a facet has no area (in 2D, no length)
    open,              ///< the surface has boundary edges: an edge has a single facet
    non_manifold_edge, ///< an edge has an odd number of facets, at least three
    self_intersection, ///< two facets of one surface meet outside their common vertices and edges
    crossing_surfaces, ///< facets of two surfaces meet outside their common vertices and edges
    too_fine,          ///< vertices nearly coincide in relation to the extent of all surfaces
    outside_enclosing_box, ///< a vertex is not strictly inside the enclosing box
    /// two patches give different labels for the same region: the first facet of `facets()` is in
    /// `surface()`, the second in `other_surface()`
    contradicting_sides
  };

  /// Constructs the error; the arguments are returned by the functions below.
  Invalid_surface_error(Reason reason, const std::string& message, std::size_t surface,
                        std::vector<std::size_t> facets, std::vector<std::size_t> vertices,
                        std::size_t other_surface)
      : Error(message), m_reason(reason), m_surface(surface), m_other_surface(other_surface),
        m_facets(std::move(facets)), m_vertices(std::move(vertices)) {}

  /// Constructs an error that concerns a single surface.
  Invalid_surface_error(Reason reason, const std::string& message, std::size_t surface,
                        std::vector<std::size_t> facets = {},
                        std::vector<std::size_t> vertices = {})
      : Invalid_surface_error(reason, message, surface, std::move(facets), std::move(vertices),
                              surface) {}

  /// Returns the kind of the error.
  Reason reason() const { return m_reason; }

  /// Returns the index of the offending input surface.
  std::size_t surface() const { return m_surface; }

  /// Returns the index of the second surface if the error concerns two surfaces, otherwise
  /// `surface()`.
  std::size_t other_surface() const { return m_other_surface; }

  /// Returns the indices of the offending facets, increasing. Facets that intersect come in pairs
  /// instead: `facets()[2*i]` of `surface()` and `facets()[2*i+1]` of `other_surface()`.
  const std::vector<std::size_t>& facets() const { return m_facets; }

  /// Returns the indices of the offending vertices of `surface()`, increasing. Edges come in pairs
  /// instead: `vertices()[2*i]` and `vertices()[2*i+1]` are the ends of an offending edge.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  Reason m_reason;
  std::size_t m_surface, m_other_surface;
  std::vector<std::size_t> m_facets, m_vertices;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INVALID_SURFACE_ERROR_H
