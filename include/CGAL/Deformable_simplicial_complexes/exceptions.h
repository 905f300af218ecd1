// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Mesh_support/Error.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

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

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_EXCEPTIONS_H
