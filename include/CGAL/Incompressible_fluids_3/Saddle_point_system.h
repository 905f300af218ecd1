// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

A linear system of `Incompressible_fluid_3`. The unknowns are n velocities v of vertices and bodies,
with three numbers each, and m pressures p:

    P (a v - b^T p)     = P f,    v = P v,
      -b v - c p - d p  = -s.

The system is symmetric, `a` is positive definite, and `c` is positive semidefinite. P is an
orthogonal projection of velocities onto the subspace that walls leave free. The term d p belongs to
the closed sets: for each pressure of a closed set, it is the mean of the pressures of the set,
times the weight of the set. It is zero for all other pressures.
*/
struct Saddle_point_system
{
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>; ///< a sparse matrix, by rows
  using Vector = Eigen::VectorXd;                              ///< a dense vector

  /// A constrained velocity.
  struct Constrained_velocity
  {
    Eigen::Index vertex; ///< the vertex
    /// The orthogonal projection onto the free velocities of the vertex.
    Eigen::Matrix3d projection;
  };

  /// A closed set: the pressures of liquids without a free surface. A constant pressure in such a
  /// set exerts no force on vertices, up to the rounding of curved walls. Without the mean of the
  /// pressures, the system would be singular or almost singular.
  struct Closed_set
  {
    std::vector<Eigen::Index> pressures; ///< increasing; no pressure is in two sets
    double weight = 0;                   ///< the weight of the mean, greater than 0

    /// Returns the mean of the pressures of the set. The pressures begin at `begin` in the vector.
    template <class Scalar>
    double mean(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& vector,
                Eigen::Index begin = 0) const {
      double sum = 0;
      for (Eigen::Index p : pressures)
        sum += vector(begin + p);
      return sum / double(pressures.size());
    }
    /// Adds a value to each pressure of the set. The pressures begin at `begin` in the vector.
    template <class Scalar>
    void add(double value, Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& vector,
             Eigen::Index begin = 0) const {
      for (Eigen::Index p : pressures)
        vector(begin + p) += Scalar(value);
    }
  };

  /// n x n, the part of `a` that is the same for each coordinate: mass over time, surface tension,
  /// and half of the viscosity; positive definite.
  Matrix nodal;
  /// 3 n x 3 n, the rest of `a`; it has no rows if there is no rest.
  Matrix coupling;
  /// m x 3 n, the gradients of volumes; each row has all three entries of a vertex or none.
  Matrix b;
  /// m x m; it has an entry for each two pressures of a common cell.
  Matrix c;
  /// n, an approximation of the diagonal of `a` without viscosity, with lumped masses.
  Vector inertia;
  /// m, for each pressure the viscosity divided by a quarter of the volume of the cells around.
  Vector viscosity;
  /// Constrained velocities, by increasing vertex, each vertex once.
  std::vector<Constrained_velocity> constrained;
  /// Closed sets; there are none if all liquids have free surfaces.
  std::vector<Closed_set> closed;
  /// The number of velocities of rigid bodies. They are the last velocities. Each of them has an
  /// entry in `b` for all pressures around the body, so a preconditioner may omit them.
  Eigen::Index velocities_of_bodies = 0;

  /// Replaces v by P v. Takes linear time in the number of constrained velocities.
  template <class Scalar> void project(Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& v) const {
    for (const Constrained_velocity& h : constrained)
      v.template segment<3>(3 * h.vertex) =
          (h.projection.cast<Scalar>() * v.template segment<3>(3 * h.vertex)).eval();
  }

  /// Returns a v. Takes linear time.
  Vector multiply_a(const Vector& v) const {
    Vector result(v.size());
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    Eigen::Map<Rows>(result.data(), v.size() / 3, 3) =
        nodal * Eigen::Map<const Rows>(v.data(), v.size() / 3, 3);
    if (coupling.rows() > 0)
      result += coupling * v;
    return result;
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H
