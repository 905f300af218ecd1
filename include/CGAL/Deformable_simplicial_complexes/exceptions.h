// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is the base class of everything this package throws because of its input. `what()` is one line that
says what is wrong and what can be done about it. The offending simplices are carried as indices
that always refer to what the user passed in.
*/
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when an input surface does not bound a solid, so that inside and outside are undefined.
*/
class Invalid_surface_error : public Error
{
public:
  /// what is wrong with the surface
  enum class Reason {
    empty,             ///< there are no facets
    not_finite,        ///< a coordinate is not a finite number
    bad_index,         ///< a facet refers to a vertex that does not exist
    degenerate_facet,  ///< a facet has no area
    open,              ///< an edge bounds a single facet
    non_manifold_edge, ///< an edge bounds an odd number of facets, but not one
    self_intersection, ///< two facets of one surface meet outside their common vertices and edges
    crossing_surfaces, ///< two surfaces cross, or meet outside their common vertices and edges
    too_fine,          ///< vertices cannot be told apart beside the size of all surfaces
    outside_enclosing_box, ///< a vertex is not strictly inside the enclosing box
    contradicting_sides ///< two patches tell different labels for the same region: the first facet
                        ///< of `facets()` is of `surface()`, the second of `other_surface()`
  };

  /// constructs the error; the arguments are returned by the functions below.
  Invalid_surface_error(Reason reason, const std::string& message, std::size_t surface,
                        std::vector<std::size_t> facets, std::vector<std::size_t> vertices,
                        std::size_t other_surface)
      : Error(message), m_reason(reason), m_surface(surface), m_other_surface(other_surface),
        m_facets(std::move(facets)), m_vertices(std::move(vertices)) {}

  /// constructs an error that concerns a single surface.
  Invalid_surface_error(Reason reason, const std::string& message, std::size_t surface,
                        std::vector<std::size_t> facets = {},
                        std::vector<std::size_t> vertices = {})
      : Invalid_surface_error(reason, message, surface, std::move(facets), std::move(vertices),
                              surface) {}

  /// returns what is wrong.
  Reason reason() const { return m_reason; }

  /// returns the index of the offending input surface.
  std::size_t surface() const { return m_surface; }

  /// returns the index of the second surface if two surfaces cross, `surface()` otherwise.
  std::size_t other_surface() const { return m_other_surface; }

  /// returns the indices of the offending facets, increasing. Facets that intersect come in pairs
  /// instead: `facets()[2*i]` of `surface()` and `facets()[2*i+1]` of `other_surface()`.
  const std::vector<std::size_t>& facets() const { return m_facets; }

  /// returns the indices of the offending vertices of `surface()`, increasing. Edges come in pairs
  /// instead: `vertices()[2*i]` and `vertices()[2*i+1]` are the ends of an offending edge.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  Reason m_reason;
  std::size_t m_surface, m_other_surface;
  std::vector<std::size_t> m_facets, m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when space around valid surfaces could not be filled with tetrahedra.
*/
class Tetrahedralization_error : public Error
{
public:
  /// constructs the error; `code` is returned by `code()`.
  explicit Tetrahedralization_error(const std::string& message, int code = 0)
      : Error(message), m_code(code) {}

  /// returns the code that TetGen threw, or zero if it crashed, was stopped, or made a bad result.
  int code() const { return m_code; }

private:
  int m_code;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when given tetrahedra do not form a ball-shaped mesh without flat or inverted cells.
*/
class Invalid_cells_error : public Error
{
public:
  /// constructs the error; the arguments are returned by the functions below.
  explicit Invalid_cells_error(const std::string& message, std::vector<std::size_t> tetrahedra = {},
                               std::vector<std::size_t> vertices = {})
      : Error(message), m_tetrahedra(std::move(tetrahedra)), m_vertices(std::move(vertices)) {}

  /// returns the indices of the offending tetrahedra, increasing.
  const std::vector<std::size_t>& tetrahedra() const { return m_tetrahedra; }

  /// returns the indices of the offending vertices.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_tetrahedra, m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when points bound no solid, so that none can be reconstructed from them.
*/
class Invalid_points_error : public Error
{
public:
  /// what is wrong with the points
  enum class Reason {
    not_finite,   ///< coordinates are not finite numbers
    out_of_range, ///< the extent of the points is not between 1e-30 and 1e30
    too_few,      ///< fewer than four points differ
    flat,         ///< all points lie in a plane
    open,         ///< what the points enclose is nothing, or too thin beside their distances
    sheet         ///< the points sample an open sheet, and not a solid with holes
  };

  /// constructs the error; the arguments are returned by the functions below.
  Invalid_points_error(Reason reason, const std::string& message,
                       std::vector<std::size_t> points = {})
      : Error(message), m_reason(reason), m_points(std::move(points)) {}

  /// returns what is wrong.
  Reason reason() const { return m_reason; }

  /// returns the indices of the offending points among those that were given, increasing; none if
  /// no point is worse than the others.
  const std::vector<std::size_t>& points() const { return m_points; }

private:
  Reason m_reason;
  std::vector<std::size_t> m_points;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when interface vertices are sent to places that no position can be computed for, such as
points with coordinates that are not finite. Nothing has been moved then.
*/
class Invalid_destination_error : public Error
{
public:
  /// constructs the error; `vertices` is returned by `vertices()`.
  Invalid_destination_error(const std::string& message, std::vector<std::size_t> vertices)
      : Error(message), m_vertices(std::move(vertices)) {}

  /// returns the indices of the offending vertices in the order of `interface_vertices()`.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

private:
  std::vector<std::size_t> m_vertices;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when a proposal is committed that was made before the last change of the complex: what was
found out then need not hold any more. Nothing has changed then; propose again.
*/
class Stale_proposal_error : public Error
{
public:
  /// constructs the error.
  Stale_proposal_error()
      : Error("the complex has changed since this change of it was proposed; propose it again") {}
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is thrown when a file cannot be opened, read, written or understood.
*/
class File_error : public Error
{
public:
  /// constructs the error; `path` is returned by `path()`.
  File_error(const std::string& message, std::string path)
      : Error(message), m_path(std::move(path)) {}

  /// returns the path of the file as the user gave it.
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
