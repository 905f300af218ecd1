// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H
#define CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H

#include <CGAL/Mesh_support/Error.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Exception thrown if the space around valid surfaces could not be filled with tetrahedra.
*/
class Tetrahedralization_error : public Error
{
public:
  /// Constructs the error; `code` is returned by `code()`.
  explicit Tetrahedralization_error(const std::string& message, int code = 0)
      : Error(message), m_code(code) {}

  /// Returns the code that TetGen threw; 0 if TetGen crashed, was stopped, or made an invalid
  /// result, and for other tetrahedralizers.
  int code() const { return m_code; }

private:
  int m_code;
};

/*!
\ingroup PkgComplexConstructionRef

The result of a `ConstrainedTetrahedralizer_3`: the input points, in their order, followed by added
points, and positively oriented tetrahedra of these points. If input triangles were divided, also
the facets in all input triangles.
*/
struct Tetrahedralization_3
{
  std::vector<std::array<double, 3>> points;          ///< input points, followed by added points
  std::vector<std::array<std::size_t, 4>> tetrahedra; ///< indices into `points`
  /// The facets that form the input triangles, with the orientation of these triangles; indices
  /// into `points`. Empty if each input triangle is a facet.
  std::vector<std::array<std::size_t, 3>> facets;
  std::vector<std::size_t> triangles_of_facets; ///< the input triangle of each item of `facets`
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_TETRAHEDRALIZATION_3_H
