// Copyright (c) 2026 The deformable simplicial complex authors
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

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// For each phase, the affine motion that the interface around its free vertices follows best: none
// for a phase that is held by something else, as the boundary of the domain.
template <int d> class Affine_phases
{
public:
  using Vector = Eigen::Matrix<double, d, 1>;

  // The number of a phase, and that of a vertex around it that is not free.
  using Around = std::pair<std::uint32_t, std::uint32_t>;

  // Free vertices, and then those around them: where they are, how those that are not free move,
  // and which hold their phases: free ones that cannot go everywhere, others that are not on the
  // interface.
  struct Vertices
  {
    std::vector<Vector> positions, known;
    std::vector<char> are_held;
  };

  // A vertex around a phase may come more than once, and counts for more.
  Affine_phases(std::size_t number_of_phases, const std::vector<std::uint32_t>& phase_of_free,
                const std::vector<Around>& around, const Vertices& vertices)
      : m_vertices(vertices), m_number_of_free(phase_of_free.size()), m_phases(number_of_phases) {
    for (std::size_t i = 0; i < phase_of_free.size(); ++i)
      if (vertices.are_held[i])
        m_phases[phase_of_free[i]].is_held = true;
    for (const auto& [i, v] : around) {
      m_phases[i].is_held = m_phases[i].is_held || vertices.are_held[v];
      m_phases[i].longest = (std::max)(m_phases[i].longest, known(v).squaredNorm());
    }
    find_motions(around);
  }

  // The motion of a phase at a vertex.
  Vector motion(std::uint32_t phase, std::uint32_t v) const { return motion(m_phases[phase], v); }

  // How a vertex that is not free deviates from it.
  Vector deviation(std::uint32_t phase, std::uint32_t v) const {
    return deviation(m_phases[phase], v);
  }

  // Whether one next to the free vertices of the phase does.
  bool deviates(std::uint32_t phase) const { return m_phases[phase].deviates; }

private:
  using Matrix = Eigen::Matrix<double, d, d>;

  struct Phase
  {
    double longest = 0; // way around it, squared
    bool is_held = false, deviates = false;
    double weight = 0;
    Vector center = Vector::Zero(), mean = Vector::Zero();
    Matrix linear = Matrix::Zero();

    bool has_motion() const { return !is_held && longest > 0; }
  };

  const Vector& position(std::uint32_t v) const { return m_vertices.positions[v]; }
  const Vector& known(std::uint32_t v) const { return m_vertices.known[v - m_number_of_free]; }

  // By least squares.
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

  // Of a symmetric matrix on its range: what lies in a plane tells nothing of other directions.
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
    static constexpr double negligible = 1e-6; // of the longest way
    const Vector result = known(v) - motion(phase, v);
    if (result.squaredNorm() > negligible * negligible * phase.longest)
      return result;
    return Vector::Zero();
  }

  const Vertices& m_vertices;
  std::size_t m_number_of_free;
  std::vector<Phase> m_phases;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_AFFINE_PHASES_H
