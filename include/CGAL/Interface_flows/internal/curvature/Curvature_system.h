// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H

#include <CGAL/Deformable_simplicial_complexes/Boundary_class.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/coordinates.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Interface_flows/internal/curvature/Interface_forces.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The symmetric positive definite system (M + dt K) u = f of a step of an interface, with the
// masses M and the tensions K. There is a row for each vertex and each axis. Pinned vertices and
// sides of the domain fix rows. The conjugate gradient method solves the system: a factorization
// would fill up where junctions couple the axes.
template <class Complex> class Curvature_system
{
public:
  static constexpr int d = Complex::dimension;
  using Forces = Interface_forces<Complex>;
  using Vector = Eigen::VectorXd;

  // \throws Error if all facets of a vertex have area zero
  Curvature_system(const Interface_snapshot<Complex>& interface_, const Forces& forces, double dt)
      : m_is_fixed(d * interface_.vertices.size(), false) {
    for (std::size_t v = 0; v < interface_.vertices.size(); ++v)
      for (int axis = 0; axis < d; ++axis)
        m_is_fixed[std::size_t(row(v, axis))] =
            forces.is_pinned(v) ||
            Boundary_class::fixes(interface_.vertices[v]->boundary_class(), axis);
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Eigen::Index i, Eigen::Index j, double x) {
      if (!m_is_fixed[std::size_t(i)] && !m_is_fixed[std::size_t(j)])
        entries.emplace_back(i, j, x);
    };
    for (const auto& pull : forces.pulls())
      for (int axis = 0; axis < d; ++axis) {
        const Eigen::Index a = row(pull.from, axis), b = row(pull.to, axis);
        const double x = dt * pull.weight;
        add(a, a, x);
        add(b, b, x);
        add(a, b, -x);
        add(b, a, -x);
      }
    for (std::size_t v = 0; v < interface_.vertices.size(); ++v) {
      if (!(forces.share(v) > 0) && !forces.is_pinned(v))
        throw Error("the step of mean curvature flow cannot be computed: all facets of a vertex "
                    "have area zero; improve the interface, or use a shorter time step");
      for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j)
          if (i == j || forces.is_junction(v))
            add(row(v, i), row(v, j), forces.mass(v)(i, j));
    }
    for (std::size_t i = 0; i < m_is_fixed.size(); ++i)
      if (m_is_fixed[i])
        entries.emplace_back(Eigen::Index(i), Eigen::Index(i), 1);
    const auto size = Eigen::Index(m_is_fixed.size());
    m_matrix.resize(size, size);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    static constexpr double tolerance = 1e-13; // of the relative residual
    m_solver.setTolerance(tolerance);
    m_solver.compute(m_matrix);
  }

  static Eigen::Index row(std::size_t v, int axis) { return d * Eigen::Index(v) + axis; }

  // Returns the solution for a right-hand side. Fixed components are 0.
  // \throws Error if the method does not converge
  Vector solve(Vector right) const {
    // Rounding can prevent the tolerance if the time step is long. A solution with this residual
    // is accurate enough.
    static constexpr double sufficient = 1e-9;
    for (Eigen::Index i = 0; i < right.size(); ++i)
      if (m_is_fixed[std::size_t(i)])
        right(i) = 0;
    const Vector result = m_solver.solve(right);
    if (!(m_solver.error() <= sufficient) || !result.allFinite())
      throw Error(
          "the step of mean curvature flow cannot be computed: the linear system is too ill "
          "conditioned; improve the interface, or use a shorter time step");
    return result;
  }

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  std::vector<char> m_is_fixed; // by row
  Matrix m_matrix;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> m_solver;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H
