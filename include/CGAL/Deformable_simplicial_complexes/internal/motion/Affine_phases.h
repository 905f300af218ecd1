// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_AFFINE_PHASES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_AFFINE_PHASES_H

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// For each phase, the affine motion that fits the motion of the surrounding interface best. A phase
// with other constraints, such as the boundary of the domain, has no affine motion.
template <int d> class Affine_phases
{
public:
  using Vector = Eigen::Matrix<double, d, 1>;

  // The number of a phase, and the number of a vertex at the phase that is not free.
  using Around = std::pair<std::uint32_t, std::uint32_t>;

  // The free vertices, followed by the vertices around them. `positions` and `are_constrained` have
  // an entry for each vertex, `known` has the displacement of each vertex that is not free.
  // `are_constrained` marks vertices that constrain their phase: free vertices that cannot move in
  // all directions, and other vertices that are not on the interface.
  struct Vertices
  {
    std::vector<Vector> positions, known;
    std::vector<char> are_constrained;
  };

  // A vertex may occur several times at a phase; its weight is the number of occurrences.
  Affine_phases(std::size_t number_of_phases, const std::vector<std::uint32_t>& phase_of_free,
                const std::vector<Around>& around, const Vertices& vertices)
      : m_vertices(vertices), m_number_of_free(phase_of_free.size()), m_phases(number_of_phases) {
    for (std::size_t i = 0; i < phase_of_free.size(); ++i)
      if (vertices.are_constrained[i])
        m_phases[phase_of_free[i]].is_constrained = true;
    for (const auto& [i, v] : around) {
      m_phases[i].is_constrained = m_phases[i].is_constrained || vertices.are_constrained[v];
      m_phases[i].longest = (std::max)(m_phases[i].longest, known(v).squaredNorm());
    }
    find_motions(around);
  }

  // Returns the displacement of a vertex by the affine motion of a phase.
  Vector motion(std::uint32_t phase, std::uint32_t v) const { return motion(m_phases[phase], v); }

  // Returns the difference between the displacement of a vertex that is not free and the affine
  // motion of the phase.
  Vector deviation(std::uint32_t phase, std::uint32_t v) const {
    return deviation(m_phases[phase], v);
  }

  // Returns whether a vertex next to the free vertices of the phase deviates from the affine
  // motion.
  bool deviates(std::uint32_t phase) const { return m_phases[phase].deviates; }

private:
  using Matrix = Eigen::Matrix<double, d, d>;

  struct Phase
  {
    double longest = 0; // squared length of the longest displacement at the phase
    bool is_constrained = false, deviates = false;
    double weight = 0;
    Vector center = Vector::Zero(), mean = Vector::Zero();
    Matrix linear = Matrix::Zero();

    bool has_motion() const { return !is_constrained && longest > 0; }
  };

  const Vector& position(std::uint32_t v) const { return m_vertices.positions[v]; }
  const Vector& known(std::uint32_t v) const { return m_vertices.known[v - m_number_of_free]; }

  // Fits the affine motions by least squares.
  void find_motions(const std::vector<Around>& around) {
    for (const auto& [i, v] : around) {
      m_phases[i].weight += 1;
      m_phases[i].center += position(v);
      m_phases[i].mean += known(v);
    }
    for (Phase& phase : m_phases)
      if (phase.has_motion()) {
        phase.center /= phase.weight;
        phase.mean /= phase.weight;
      }
    std::vector<Matrix> extents(m_phases.size(), Matrix::Zero());
    for (const auto& [i, v] : around) {
      const Vector p = position(v) - m_phases[i].center;
      extents[i] += p * p.transpose();
      m_phases[i].linear += (known(v) - m_phases[i].mean) * p.transpose();
    }
    for (std::size_t i = 0; i < m_phases.size(); ++i)
      if (m_phases[i].has_motion())
        m_phases[i].linear *= inverse(extents[i]);
      else
        m_phases[i].deviates = m_phases[i].longest > 0;
    for (const auto& [i, v] : around)
      m_phases[i].deviates = m_phases[i].deviates || !deviation(m_phases[i], v).isZero(0);
  }

  // Returns the pseudoinverse of a symmetric matrix. Positions that lie in a plane determine no
  // motion in the normal direction.
  static Matrix inverse(const Matrix& matrix) {
    static constexpr double negligible = 1e-14;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    Vector inverses = Vector::Zero();
    for (int i = 0; i < d; ++i)
      if (solver.eigenvalues()[i] > negligible * solver.eigenvalues()[d - 1])
        inverses[i] = 1 / solver.eigenvalues()[i];
    return solver.eigenvectors() * inverses.asDiagonal() * solver.eigenvectors().transpose();
  }

  Vector motion(const Phase& phase, std::uint32_t v) const {
    if (!phase.has_motion())
      return Vector::Zero();
    return phase.mean + phase.linear * (position(v) - phase.center);
  }

  Vector deviation(const Phase& phase, std::uint32_t v) const {
    static constexpr double negligible = 1e-6; // relative to the longest displacement
    const Vector result = known(v) - motion(phase, v);
    if (result.squaredNorm() > negligible * negligible * phase.longest)
      return result;
    return Vector::Zero();
  }

  const Vertices& m_vertices;
  std::size_t m_number_of_free;
  std::vector<Phase> m_phases;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_AFFINE_PHASES_H
