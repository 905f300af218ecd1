// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TETGEN_TETRAHEDRALIZER_3_H
#define CGAL_TETGEN_TETRAHEDRALIZER_3_H

#include <CGAL/Deformable_simplicial_complex_3/Tetrahedralization_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Fills space around triangles with tetrahedra by means of the program TetGen, which adds points where
tetrahedra would be bad otherwise, but none on the triangles.

The class is compiled: link with the target `Deformable_simplicial_complex::Tetgen`. TetGen is
distributed under the AGPL-3.0.

\cgalModels `ConstrainedTetrahedralizer_3`
*/
class Tetgen_tetrahedralizer_3
{
public:
  /*!
  \param radius_edge_ratio upper bound of the circumradius of a tetrahedron divided by its shortest
  edge, greater than 1. Below 1.2 points get very many, at infinity none are added for this bound.
  \param minimum_dihedral_angle lower bound of dihedral angles in degrees, 0 to 18
  \param maximum_volume upper bound of the volume of a tetrahedron, greater than 0, in the
  coordinates that are passed to `operator()`

  Near small angles between triangles, and where triangles are bad, the bounds cannot be kept.
  With the default values, there are about 6 tetrahedra per triangle of a surface of good triangles.

  \throws Deformable_simplicial_complexes::Error if a parameter is out of range
  */
  explicit Tetgen_tetrahedralizer_3(
      double radius_edge_ratio = 2, double minimum_dihedral_angle = 10,
      double maximum_volume = std::numeric_limits<double>::infinity());

  double radius_edge_ratio() const { return m_radius_edge_ratio; }
  double minimum_dihedral_angle() const { return m_minimum_dihedral_angle; }
  double maximum_volume() const { return m_maximum_volume; }

  /*!
  Fills the space inside a closed surface of `triangles`, which may enclose other ones.

  Calls from several threads take turns, as TetGen has global state.

  \pre Points are finite and differ. Triangles meet only in common vertices and edges.
  \return see `ConstrainedTetrahedralizer_3`
  \throws Deformable_simplicial_complexes::Tetrahedralization_error if TetGen fails, or its result
  lacks a triangle or has a flat tetrahedron
  */
  Tetrahedralization_3 operator()(const std::vector<std::array<double, 3>>& points,
                                  const std::vector<std::array<std::size_t, 3>>& triangles) const;

private:
  double m_radius_edge_ratio, m_minimum_dihedral_angle, m_maximum_volume;
};

} // namespace CGAL

#endif // CGAL_TETGEN_TETRAHEDRALIZER_3_H
