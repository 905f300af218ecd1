// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TETGEN_TETRAHEDRALIZER_3_H
#define CGAL_TETGEN_TETRAHEDRALIZER_3_H

#include <CGAL/Deformable_simplicial_complexes/Tetrahedralization_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Fills space around triangles with tetrahedra by means of TetGen 1.5. It adds points where tetrahedra
would be bad otherwise, but none on the triangles.

The class is compiled: link with the target `Deformable_simplicial_complex::Tetgen`. TetGen is
distributed under the AGPL-3.0.

TetGen guards its algorithms with `assert()`, which surfaces may violate that are valid, but large,
almost touching or made of extremely thin triangles. So it runs in a child of this process, made by
`fork()`: if it crashes or walks around for ever, it is run again, and an exception is thrown if
that fails, too, or memory is exhausted. What it allocates is given back to the system. Where there
is no `fork()`, as on Windows, TetGen runs in this process and may end it.

\cgalModels `ConstrainedTetrahedralizer_3`
*/
class Tetgen_tetrahedralizer_3
{
public:
  /*!
  With the default values, there are between 5 and 6 tetrahedra per triangle of a fine surface of
  good triangles, and 99 % of them have dihedral angles of more than 11 degrees. Where triangles are
  bad or meet at small angles, the bounds cannot be kept.

  \param radius_edge_ratio upper bound of circumradius divided by shortest edge of a tetrahedron,
         1.2 or more; infinity for no bound
  \param minimum_dihedral_angle lower bound of dihedral angles in degrees, 0 to 18
  \param maximum_volume upper bound of the volume of a tetrahedron, more than 0, in the coordinates
         that `operator()` gets
  \param time_limit the seconds that a call may take, more than 0; infinity for no limit. After one
         third of it another order of points is tried, after two thirds there are no bounds any
         more; so what becomes of a surface that takes so long depends on the speed of the machine.
         1.6 million triangles take about five minutes.

  \throws Deformable_simplicial_complexes::Error if a bound is out of range, as TetGen might not end
  */
  explicit Tetgen_tetrahedralizer_3(double radius_edge_ratio = 2.5,
                                    double minimum_dihedral_angle = 10,
                                    double maximum_volume = std::numeric_limits<double>::infinity(),
                                    double time_limit = 1200);

  /// The upper bound of circumradius divided by shortest edge; infinity if there is none.
  double radius_edge_ratio() const { return m_radius_edge_ratio; }
  /// The lower bound of dihedral angles, in degrees.
  double minimum_dihedral_angle() const { return m_minimum_dihedral_angle; }
  /// The upper bound of the volume of a tetrahedron; infinity if there is none.
  double maximum_volume() const { return m_maximum_volume; }
  /// The seconds that a call may take; infinity if there is no limit.
  double time_limit() const { return m_time_limit; }

  /*!
  Fills the space inside a closed surface of `triangles`, which may enclose other ones. If TetGen
  fails, it tries a smaller tolerance, unless it crashed or was too slow; then, unless the input is
  said to be bad, the points in another order; and at last it does without the bounds, so that
  tetrahedra are worse. Within a third of the time limit, the result is the same each time.

  Several threads may call this at the same time where there is `fork()`, and an allocator that
  works in its child, as that of glibc does, and that of the address sanitizer of GCC 12 does not.

  \pre Points are finite and differ. Triangles meet only in common vertices and edges.
  \return see `ConstrainedTetrahedralizer_3`
  \throws Deformable_simplicial_complexes::Tetrahedralization_error if TetGen gives up, crashes,
          runs out of memory or time, loses a triangle or makes a flat tetrahedron
  */
  Deformable_simplicial_complexes::Tetrahedralization_3
  operator()(const std::vector<std::array<double, 3>>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles) const;

private:
  double m_radius_edge_ratio, m_minimum_dihedral_angle, m_maximum_volume, m_time_limit;
};

} // namespace CGAL

#endif // CGAL_TETGEN_TETRAHEDRALIZER_3_H
