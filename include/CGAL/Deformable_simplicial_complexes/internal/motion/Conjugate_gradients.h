// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_CONJUGATE_GRADIENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_CONJUGATE_GRADIENTS_H

#include <CGAL/Deformable_simplicial_complexes/For_each_index.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Row_blocks.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Conjugate gradients for systems that have one symmetric, positive semidefinite matrix and d right
sides, in one pass over it for all; with its diagonal as preconditioner. Scalar products are summed
up within blocks of rows, then over these in their order, so that the number of threads changes no
bit.
*/
template <int d> class Conjugate_gradients
{
public:
  using Vector = Eigen::Matrix<double, d, 1>; // of a row, for each right side

  struct Entry // beside the diagonal
  {
    std::uint32_t column;
    double value;
  };

  Conjugate_gradients(const Row_blocks<Entry>& matrix, const std::vector<double>& diagonal,
                      const For_each_index& for_each_index)
      : m_matrix(matrix), m_diagonal(diagonal), m_for_each_index(for_each_index) {}

  // Until the residuals, weighted by the inverse of the diagonal, are a part of what they were, or
  // after a number of iterations. Unknowns stay 0 where `is_held(row, side)`, and where the
  // diagonal is not positive.
  template <class IsHeld>
  std::vector<Vector> solve(std::vector<Vector> residuals, const IsHeld& is_held, double part,
                            int maximum_number_of_iterations) const {
    const std::size_t n = residuals.size();
    std::vector<Vector> inverses(n), solution(n, Vector::Zero()), directions(n), products(n);
    Vector energy = sum([&](std::size_t i) -> Vector {
      for (int side = 0; side < d; ++side)
        inverses[i][side] = m_diagonal[i] > 0 && !is_held(i, side) ? 1 / m_diagonal[i] : 0;
      directions[i] = inverses[i].cwiseProduct(residuals[i]);
      return directions[i].cwiseProduct(residuals[i]);
    });
    const Vector bound = part * part * energy;
    for (int k = 0; k < maximum_number_of_iterations && (energy.array() > bound.array()).any();
         ++k) {
      Progress_scope::check();
      const Vector step = ratio(energy, sum([&](std::size_t i) -> Vector {
                                  products[i] = product(i, directions);
                                  return products[i].cwiseProduct(directions[i]);
                                }));
      const Vector next = sum([&](std::size_t i) -> Vector {
        solution[i] += step.cwiseProduct(directions[i]);
        residuals[i] -= step.cwiseProduct(products[i]);
        return residuals[i].cwiseProduct(inverses[i]).cwiseProduct(residuals[i]);
      });
      const Vector turn = ratio(next, energy);
      m_matrix.for_each_row(m_for_each_index, [&](std::size_t i) {
        directions[i] = inverses[i].cwiseProduct(residuals[i]) + turn.cwiseProduct(directions[i]);
      });
      energy = next;
    }
    return solution;
  }

private:
  // Of a row with vectors.
  Vector product(std::size_t i, const std::vector<Vector>& vectors) const {
    Vector result = m_diagonal[i] * vectors[i];
    for (const Entry& e : m_matrix.row(i))
      result += e.value * vectors[e.column];
    return result;
  }

  // Of what a function of rows returns.
  template <class Function> Vector sum(const Function& f) const {
    std::vector<Vector> sums(m_matrix.number_of_blocks(), Vector::Zero());
    m_matrix.for_each_block(m_for_each_index, [&](std::size_t b) {
      Vector sum = Vector::Zero();
      m_matrix.for_each_row_of_block(b, [&](std::size_t i) { sum += f(i); });
      sums[b] = sum;
    });
    Vector result = Vector::Zero();
    for (const Vector& s : sums)
      result += s;
    return result;
  }

  // 0 where a side has been solved for.
  static Vector ratio(const Vector& a, const Vector& b) {
    Vector result = Vector::Zero();
    for (int side = 0; side < d; ++side)
      if (b[side] > 0)
        result[side] = a[side] / b[side];
    return result;
  }

  const Row_blocks<Entry>& m_matrix;
  const std::vector<double>& m_diagonal;
  const For_each_index& m_for_each_index;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_CONJUGATE_GRADIENTS_H
