// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_RELATIVE_RESIDUAL_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_RELATIVE_RESIDUAL_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/fluid_errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The largest relative residual that is accepted, for any solver. The tolerance of solvers is
// smaller, but in their own norm. The two norms can differ by the condition of the preconditioner.
constexpr double largest_residual = 1e-8;

// Throws the error of a factorization that fails.
[[noreturn]] inline void throw_singular_equations() {
  throw Convergence_error("the equations of the flow are singular: cells may be flat",
                          std::numeric_limits<double>::infinity(), largest_residual);
}

// The norm of residuals of a saddle point system. The weight of an equation of velocities is the
// inverse of the diagonal entry of the matrix. The weight of an equation of pressures is the
// inverse of the diagonal entry of the Schur complement, which is computed with the diagonal of the
// matrix. With these weights, all equations have the same unit.
class Residual_norm
{
public:
  using System = Saddle_point_system;
  using Vector = System::Vector;

  explicit Residual_norm(const System& system)
      : m_velocities(system.nodal.diagonal().cwiseInverse()), m_pressures(system.c.diagonal()) {
    std::vector<const Eigen::Matrix3d*> projections(std::size_t(system.nodal.rows()), nullptr);
    for (const auto& h : system.constrained)
      projections[std::size_t(h.vertex)] = &h.projection;
    for (Eigen::Index p = 0; p < system.b.rows(); ++p)
      for (System::Matrix::InnerIterator i(system.b, p); i;) {
        const Eigen::Index v = i.col() / 3;
        Eigen::Vector3d gradient;
        for (int axis = 0; axis < 3; ++axis, ++i)
          gradient(axis) = i.value();
        if (projections[std::size_t(v)] != nullptr)
          gradient = (*projections[std::size_t(v)] * gradient).eval();
        m_pressures(p) += m_velocities(v) * gradient.squaredNorm();
      }
    for (double& weight : m_pressures)
      weight = weight > 0 ? 1 / weight : 0;
  }

  double operator()(const Vector& of_velocities, const Vector& of_pressures) const {
    double square = m_pressures.dot(of_pressures.cwiseAbs2());
    for (Eigen::Index v = 0; v < m_velocities.size(); ++v)
      square += m_velocities(v) * of_velocities.segment<3>(3 * v).squaredNorm();
    return std::sqrt(square);
  }

  // Return the weights of the equations of velocities, one for each vertex, and of pressures.
  const Vector& weights_of_velocities() const { return m_velocities; }
  const Vector& weights_of_pressures() const { return m_pressures; }

private:
  Vector m_velocities, m_pressures; // the weights of equations
};

// Returns the norm of the true residual of velocities v and pressures p, divided by the norm of the
// largest term. The residual is computed from the definition of the system alone, independently of
// the solver. Returns infinity if numbers are not finite. Takes linear time.
inline double relative_residual(const Saddle_point_system& system,
                                const Saddle_point_system::Vector& f,
                                const Saddle_point_system::Vector& s,
                                const Saddle_point_system::Vector& v,
                                const Saddle_point_system::Vector& p) {
  using Vector = Saddle_point_system::Vector;
  const auto free = [&system](Vector vector) {
    system.project(vector);
    return vector;
  };
  const Residual_norm norm(system);
  const Vector given = free(f), motion = free(system.multiply_a(v)),
               push = free(system.b.transpose() * p);
  const Vector change = system.b * v;
  Vector leveling = system.c * p;
  for (const auto& set : system.closed)
    set.add(set.weight * set.mean(p), leveling);
  const Vector no_velocities = Vector::Zero(f.size()), no_pressures = Vector::Zero(s.size());
  const double size = (std::max)({norm(given, s), norm(motion, change), norm(push, no_pressures),
                                  norm(no_velocities, leveling)});
  const double residual = norm(motion - push - given, change + leveling - s);
  if (!std::isfinite(residual) || !std::isfinite(size))
    return std::numeric_limits<double>::infinity();
  return residual > 0 ? residual / size : 0;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_RELATIVE_RESIDUAL_H
