// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FIXED_POINT_ACCELERATOR_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FIXED_POINT_ACCELERATOR_H

#include <Eigen/Dense>

#include <cstddef>
#include <deque>

namespace CGAL::Deformable_simplicial_complexes::internal {

// An accelerator for fixed-point iterations x = g(x). It combines the last values of g so that the
// difference g(x) - x is least (D. G. Anderson, "Iterative procedures for nonlinear integral
// equations", J. ACM 12, 1965).
class Fixed_point_accelerator
{
public:
  using Vector = Eigen::VectorXd;

  // Takes a point x and its value g. Returns the next point for an evaluation of g.
  Vector next(const Vector& x, const Vector& g) {
    static constexpr std::size_t memory = 20;
    m_values.push_back(g);
    m_changes.push_back(g - x);
    if (m_values.size() > memory + 1) {
      m_values.pop_front();
      m_changes.pop_front();
    }
    const std::size_t n = m_values.size() - 1;
    if (n == 0)
      return g;
    Eigen::MatrixXd value_differences(x.size(), n), change_differences(x.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = Eigen::Index(k);
      value_differences.col(column) = m_values[k + 1] - m_values[k];
      change_differences.col(column) = m_changes[k + 1] - m_changes[k];
    }
    return g - value_differences * change_differences.colPivHouseholderQr().solve(m_changes.back());
  }

  // Removes all values, after which the next point is g.
  void forget() {
    m_values.clear();
    m_changes.clear();
  }

private:
  std::deque<Vector> m_values, m_changes;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FIXED_POINT_ACCELERATOR_H
