// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
#define CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H

#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Iterator_range.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Rows of entries, stored in blocks. Each block is filled by one thread.
template <class Entry> class Row_blocks
{
public:
  static constexpr std::size_t block_size = 256; // rows; enough work for a thread

  // `fill(i, entries)` appends the entries of row i. The function object is copied for each block,
  // so that it can keep temporary data.
  template <class Fill>
  Row_blocks(std::size_t size, Fill fill, const For_each_index& for_each_index)
      : m_size(size), m_blocks((size + block_size - 1) / block_size) {
    for_each_block(for_each_index, [&](std::size_t b) {
      Fill fill_of_block = fill;
      Block& block = m_blocks[b];
      for_each_row_of_block(b, [&](std::size_t i) {
        fill_of_block(i, block.entries);
        block.ends[i % block_size] = block.entries.size();
      });
    });
  }

  std::size_t number_of_blocks() const { return m_blocks.size(); }

  // Calls f(b) for all blocks, on any threads.
  template <class Function>
  void for_each_block(const For_each_index& for_each_index, const Function& f) const {
    static constexpr std::size_t worthwhile = 4; // blocks from which threads are used
    for_each_index(m_blocks.size(), f, worthwhile);
  }

  // Calls f(i) for the rows of a block, in order.
  template <class Function> void for_each_row_of_block(std::size_t b, const Function& f) const {
    const std::size_t end = (std::min)(m_size, (b + 1) * block_size);
    for (std::size_t i = b * block_size; i < end; ++i)
      f(i);
  }

  template <class Function>
  void for_each_row(const For_each_index& for_each_index, const Function& f) const {
    for_each_block(for_each_index, [&](std::size_t b) { for_each_row_of_block(b, f); });
  }

  Iterator_range<const Entry*> row(std::size_t i) const {
    const Block& block = m_blocks[i / block_size];
    const std::size_t k = i % block_size;
    return make_range(block.entries.data() + (k == 0 ? 0 : block.ends[k - 1]),
                      block.entries.data() + block.ends[k]);
  }

private:
  struct Block
  {
    std::array<std::size_t, block_size> ends; // end of each row
    std::vector<Entry> entries;
  };

  std::size_t m_size;
  std::vector<Block> m_blocks;
};

/*
A preconditioned conjugate gradient solver for systems with one symmetric, positive semidefinite
matrix and d right-hand sides, all solved in the same iterations. The preconditioner is the
diagonal. The method is deterministic for any number of threads: scalar products are summed within
blocks of rows, and then over the blocks in their order.
*/
template <int d> class Conjugate_gradients
{
public:
  using Vector = Eigen::Matrix<double, d, 1>; // the values of a row, one for each right-hand side

  struct Entry // an off-diagonal entry
  {
    std::uint32_t column;
    double value;
  };

  Conjugate_gradients(const Row_blocks<Entry>& matrix, const std::vector<double>& diagonal,
                      const For_each_index& for_each_index)
      : m_matrix(matrix), m_diagonal(diagonal), m_for_each_index(for_each_index) {}

  // Iterates until the residual norm, weighted by the inverse of the diagonal, is at most `part`
  // times its initial value, or the maximum number of iterations is reached. Unknowns stay 0 where
  // `is_constrained(row, side)`, and where the diagonal is not positive.
  template <class IsConstrained>
  std::vector<Vector> solve(std::vector<Vector> residuals, const IsConstrained& is_constrained,
                            double part, int maximum_number_of_iterations) const {
    const std::size_t n = residuals.size();
    std::vector<Vector> inverses(n), solution(n, Vector::Zero()), directions(n), products(n);
    Vector energy = sum([&](std::size_t i) -> Vector {
      for (int side = 0; side < d; ++side)
        inverses[i][side] = m_diagonal[i] > 0 && !is_constrained(i, side) ? 1 / m_diagonal[i] : 0;
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
      const Vector beta = ratio(next, energy);
      m_matrix.for_each_row(m_for_each_index, [&](std::size_t i) {
        directions[i] = inverses[i].cwiseProduct(residuals[i]) + beta.cwiseProduct(directions[i]);
      });
      energy = next;
    }
    return solution;
  }

private:
  // Returns the product of a row with the vectors.
  Vector product(std::size_t i, const std::vector<Vector>& vectors) const {
    Vector result = m_diagonal[i] * vectors[i];
    for (const Entry& e : m_matrix.row(i))
      result += e.value * vectors[e.column];
    return result;
  }

  // Returns the sum of f over all rows, in a deterministic order.
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

  // Returns the quotients of the components; 0 for a right-hand side that is already solved.
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
