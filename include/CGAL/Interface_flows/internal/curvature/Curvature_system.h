// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_flows, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_flows/internal/curvature/Interface_forces.h>
#include <CGAL/Mesh_support/Error.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The symmetric positive definite system (M + dt K) u = f of a step of an interface, with the
// masses M and the tensions K. There is a row for each vertex and each axis. Vertices with a
// constraint move in its directions only. The conjugate gradient method solves the system: a
// factorization would fill up where junctions couple the axes.
template <class Complex> class Curvature_system
{
public:
  static constexpr int d = Complex::dimension;
  using Forces = Interface_forces<Complex>;
  using Vector = Eigen::VectorXd;

  // \throws Error if all facets of a vertex have area zero
  Curvature_system(const Interface_snapshot<Complex>& interface_, const Forces& forces, double dt)
      : m_forces(forces) {
    for (const auto& pull : forces.pulls()) {
      const double x = dt * pull.weight;
      add_scalar(pull.from, pull.from, x);
      add_scalar(pull.to, pull.to, x);
      add_scalar(pull.from, pull.to, -x);
      add_scalar(pull.to, pull.from, -x);
    }
    for (std::size_t v = 0; v < interface_.vertices.size(); ++v) {
      const Block* constraint = forces.constraint(v);
      if (!(forces.share(v) > 0) && !(constraint != nullptr && constraint->isZero(0)))
        throw Error("the step of mean curvature flow cannot be computed: all facets of a vertex "
                    "have area zero; improve the interface, or use a shorter time step");
      if (constraint != nullptr)
        add_block(v, v,
                  *constraint * forces.mass(v) * *constraint + Block::Identity() - *constraint);
      else if (forces.is_junction(v))
        add_block(v, v, forces.mass(v));
      else
        add_scalar(v, v, forces.share(v));
    }
    const auto size = d * Eigen::Index(interface_.vertices.size());
    m_matrix.resize(size, size);
    m_matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    m_entries = {};
    static constexpr double tolerance = 1e-13; // of the relative residual
    m_solver.setTolerance(tolerance);
    m_solver.compute(m_matrix);
  }

  static Eigen::Index row(std::size_t v, int axis) { return d * Eigen::Index(v) + axis; }

  // Returns the solution for a right-hand side. Its components that a constraint excludes are
  // ignored.
  // \throws Error if the method does not converge
  Vector solve(Vector right) const {
    // Rounding can prevent the tolerance if the time step is long. A solution with this residual
    // is accurate enough.
    static constexpr double sufficient = 1e-9;
    for (const auto& [v, constraint] : m_forces.constraints())
      right.template segment<d>(row(v, 0)) =
          (constraint * right.template segment<d>(row(v, 0))).eval();
    const Vector result = m_solver.solve(right);
    if (!(m_solver.error() <= sufficient) || !result.allFinite())
      throw Error(
          "the step of mean curvature flow cannot be computed: the linear system is too ill "
          "conditioned; improve the interface, or use a shorter time step");
    return result;
  }

private:
  using Block = typename Forces::Matrix;
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  // Adds x times the identity to the block of two vertices, within their constraints.
  void add_scalar(std::size_t v, std::size_t w, double x) {
    const Block *of_v = m_forces.constraint(v), *of_w = m_forces.constraint(w);
    if (of_v != nullptr && of_w != nullptr)
      add_block(v, w, x * *of_v * *of_w);
    else if (of_v != nullptr || of_w != nullptr)
      add_block(v, w, x * (of_v != nullptr ? *of_v : *of_w));
    else
      for (int axis = 0; axis < d; ++axis)
        m_entries.emplace_back(row(v, axis), row(w, axis), x);
  }
  void add_block(std::size_t v, std::size_t w, const Block& block) {
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j)
        if (block(i, j) != 0)
          m_entries.emplace_back(row(v, i), row(w, j), block(i, j));
  }

  const Forces& m_forces;
  std::vector<Eigen::Triplet<double>> m_entries;
  Matrix m_matrix;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> m_solver;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_CURVATURE_CURVATURE_SYSTEM_H
