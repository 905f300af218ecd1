// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TETGEN_TETRAHEDRALIZER_3_H
#define CGAL_TETGEN_TETRAHEDRALIZER_3_H

#include <CGAL/Complex_construction/Tetrahedralization_3.h>

#include <limits>

namespace CGAL {

/*!
\ingroup PkgComplexConstructionRef

Constrained tetrahedralizer that uses TetGen 1.5. It fills space around triangles with tetrahedra.
It adds points where tetrahedra would be badly shaped otherwise, but it adds no points on the
triangles.

The class is compiled: link with the target `Deformable_simplicial_complex::Tetgen`. TetGen is
distributed under the AGPL-3.0.

TetGen checks its algorithms with `assert()`. An assertion can fail for valid surfaces that are
large, almost touch themselves, or contain extremely thin triangles. TetGen therefore runs in a
child process, made by `fork()`. If the child crashes or does not end, TetGen is run again. An
exception is thrown if the next runs fail, too, or if memory is exhausted. All memory of the child
is returned to the system. On platforms without `fork()`, such as Windows, TetGen runs in the
calling process and may end it.

\cgalModels{ConstrainedTetrahedralizer_3}
*/
class Tetgen_tetrahedralizer_3
{
public:
  /*!
  Constructs the tetrahedralizer.

  The bounds cannot be kept where triangles are badly shaped or meet at small angles. For 5000
  triangles and more, added points replace the default bounds and weaker ones, which is faster: the
  points are sparser farther from the triangles.

  \param radius_edge_ratio upper bound of the circumradius of a tetrahedron divided by its shortest
         edge, at least 1.2; infinity for no bound
  \param minimum_dihedral_angle lower bound of dihedral angles in degrees, in [0, 18]
  \param maximum_volume upper bound of the volume of a tetrahedron, positive, in the coordinates of
         the input of `operator()`
  \param time_limit upper bound of the wall-clock time of a call in seconds, positive; infinity for
         no limit. After one third of the limit, another order of the points is tried. After two
         thirds, the bounds on shapes and volumes are dropped. The result of a call that takes so
         long thus depends on the speed of the machine.

  \throws Deformable_simplicial_complexes::Error if a bound is out of range, since TetGen might not
          end
  */
  explicit Tetgen_tetrahedralizer_3(double radius_edge_ratio = 2.5,
                                    double minimum_dihedral_angle = 10,
                                    double maximum_volume = std::numeric_limits<double>::infinity(),
                                    double time_limit = 1200);

  /// Returns the upper bound of the circumradius divided by the shortest edge; infinity if there is
  /// none.
  double radius_edge_ratio() const { return m_radius_edge_ratio; }
  /// Returns the lower bound of dihedral angles, in degrees.
  double minimum_dihedral_angle() const { return m_minimum_dihedral_angle; }
  /// Returns the upper bound of the volume of a tetrahedron; infinity if there is none.
  double maximum_volume() const { return m_maximum_volume; }
  /// Returns the limit of the wall-clock time of a call, in seconds; infinity if there is none.
  double time_limit() const { return m_time_limit; }

  /*!
  Fills the space inside a closed surface with tetrahedra. The surface may enclose other ones.

  If TetGen fails, the function tries in this order:
  - bounds on shapes, if added points replaced them;
  - a smaller tolerance, unless TetGen crashed or was too slow;
  - another order of the points;
  - no bounds, with both orders of the points, so that tetrahedra are of lower quality.

  If TetGen reports invalid input, only the first two are tried. If a call takes less than a
  third of the time limit, its result is deterministic.

  Several threads may call this function at the same time on platforms with `fork()`. The allocator
  must then work in the child process. The allocator of glibc does; the one of the address sanitizer
  of GCC 12 does not.

  \param points vertices of the triangles
  \param triangles indices into `points`
  \pre Points are finite and differ. Triangles meet only in common vertices and edges.
  \return see `ConstrainedTetrahedralizer_3`
  \throws Deformable_simplicial_complexes::Tetrahedralization_error if TetGen reports a failure,
          crashes, runs out of memory or time, loses a triangle or makes a degenerate tetrahedron
  */
  Deformable_simplicial_complexes::Tetrahedralization_3
  operator()(const std::vector<std::array<double, 3>>& points,
             const std::vector<std::array<std::size_t, 3>>& triangles) const;

private:
  double m_radius_edge_ratio, m_minimum_dihedral_angle, m_maximum_volume, m_time_limit;
};

} // namespace CGAL

#endif // CGAL_TETGEN_TETRAHEDRALIZER_3_H
