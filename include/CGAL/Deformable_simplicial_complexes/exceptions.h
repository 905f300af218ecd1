// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Base class of all exceptions that this package throws because of its input. `what()` is one line
that states the error and its remedy. Offending simplices are given as indices into the input of the
user.
*/
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

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

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if the space around valid surfaces could not be filled with tetrahedra.
*/
class Tetrahedralization_error : public Error
{
public:
  /// Constructs the error; `code` is returned by `code()`.
  explicit Tetrahedralization_error(const std::string& message, int code = 0)
      : Error(message), m_code(code) {}

  /// Returns the code that TetGen threw; 0 if TetGen crashed, was stopped, or made an invalid
  /// result.
  int code() const { return m_code; }

private:
  int m_code;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if given cells do not form a valid mesh of the domain: a ball or a torus without
flat or inverted cells.
*/
class Invalid_cells_error : public Error
{
public:
  /// Constructs the error; the arguments are returned by the functions below.
  explicit Invalid_cells_error(const std::string& message, std::vector<std::size_t> tetrahedra = {},
                               std::vector<std::size_t> vertices = {})
      : Error(message), m_tetrahedra(std::move(tetrahedra)), m_vertices(std::move(vertices)) {}

  /// Returns the indices of the offending cells, increasing: tetrahedra in 3D, triangles in 2D.
  const std::vector<std::size_t>& tetrahedra() const { return m_tetrahedra; }

  /// Returns the indices of the offending vertices.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_tetrahedra, m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if points do not bound a solid, so that no solid can be reconstructed from them.
*/
class Invalid_points_error : public Error
{
public:
  /// Kind of the error.
  enum class Reason {
    not_finite,   ///< coordinates are not finite numbers
    out_of_range, ///< the extent of the points is not between 1e-30 and 1e30
    too_few,      ///< fewer than four points are different
    flat,         ///< all points lie in a plane
    /// the points enclose nothing, or a volume that is too thin in relation to their distances
    open,
    sheet ///< the points sample an open sheet, not a solid with holes
  };

  /// Constructs the error; the arguments are returned by the functions below.
  Invalid_points_error(Reason reason, const std::string& message,
                       std::vector<std::size_t> points = {})
      : Error(message), m_reason(reason), m_points(std::move(points)) {}

  /// Returns the kind of the error.
  Reason reason() const { return m_reason; }

  /// Returns the indices of the offending input points, increasing; empty if the error concerns all
  /// points equally.
  const std::vector<std::size_t>& points() const { return m_points; }

private:
  Reason m_reason;
  std::vector<std::size_t> m_points;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if destinations of interface vertices are invalid, such as points with coordinates
that are not finite. No vertex has been moved then.
*/
class Invalid_destination_error : public Error
{
public:
  /// Constructs the error; `vertices` is returned by `vertices()`.
  Invalid_destination_error(const std::string& message, std::vector<std::size_t> vertices)
      : Error(message), m_vertices(std::move(vertices)) {}

  /// Returns the indices of the offending vertices, in the order of `interface_vertices()`.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if a proposal is committed after the complex has changed, so that the proposal may
be invalid. The complex is unchanged; make a new proposal.
*/
class Stale_proposal_error : public Error
{
public:
  /// Constructs the error.
  Stale_proposal_error()
      : Error("the complex has changed since the proposal was made: make a new proposal") {}
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Exception thrown if a file cannot be opened, read, written or understood.
*/
class File_error : public Error
{
public:
  /// Constructs the error; `path` is returned by `path()`.
  File_error(const std::string& message, std::string path)
      : Error(message), m_path(std::move(path)) {}

  /// Returns the path of the file as given by the user.
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
