// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

A linear system of `Incompressible_fluid_3` for the velocities v of n vertices, three numbers each,
and m pressures p,

    P (a v - b^T p)     = P f,    v = P v,
      -b v - c p - d p  = -s,

symmetric, `a` positive definite and `c` positive semidefinite; and what tells about its nature. P
are the projections of velocities that walls hold onto what is left to them, and d p is the mean of
the pressures of a closed set times its weight, at each of those.
*/
struct Saddle_point_system
{
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>; ///< by rows
  using Vector = Eigen::VectorXd;                              ///< dense

  /// A velocity that is not free.
  struct Held_velocity
  {
    Eigen::Index vertex;        ///< whose it is
    Eigen::Matrix3d projection; ///< an orthogonal one
  };

  /// The pressures of liquids without a surface that could move. Where they are all the same, they
  /// push nothing, but for the rounding of round walls: without their mean in the equations, these
  /// were singular, or nearly so.
  struct Closed_set
  {
    std::vector<Eigen::Index> pressures; ///< increasing, each in one set at the most
    double weight = 0;                   ///< of their mean, more than 0

    /// The mean of those in a vector that begin there.
    double mean(const Vector& vector, Eigen::Index begin = 0) const {
      double sum = 0;
      for (Eigen::Index p : pressures)
        sum += vector(begin + p);
      return sum / double(pressures.size());
    }
    /// Adds a value to each of those in a vector that begin there.
    void add(double value, Vector& vector, Eigen::Index begin = 0) const {
      for (Eigen::Index p : pressures)
        vector(begin + p) += value;
    }
  };

  Matrix nodal; ///< n x n, the part of `a` that treats coordinates alike: masses over time, surface
                ///< tension, and half of viscosity; positive definite
  Matrix coupling; ///< 3 n x 3 n, the rest of `a`; no rows where there is no viscosity
  Matrix b;       ///< m x 3 n, the gradients of volumes; has all three entries of a vertex, or none
  Matrix c;       ///< m x m; has an entry where two pressures share a cell
  Vector inertia; ///< n, about the diagonal of `a` without the part of viscosity: of masses, sums
                  ///< of rows
  Vector viscosity; ///< for each pressure the viscosity over a quarter of the volume around
  std::vector<Held_velocity> held; ///< by increasing numbers of vertices, each once
  std::vector<Closed_set> closed;  ///< none where surfaces are free

  /// P v. Linear in the number of those that are held.
  void project(Vector& v) const {
    for (const Held_velocity& h : held)
      v.segment<3>(3 * h.vertex) = (h.projection * v.segment<3>(3 * h.vertex)).eval();
  }

  /// a v. Linear.
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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SADDLE_POINT_SYSTEM_H
