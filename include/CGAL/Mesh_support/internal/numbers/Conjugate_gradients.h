// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
#define CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H

#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Iterator_range.h>

#include <Eigen/Core>

#include <array>
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
Solves a symmetric, positive semidefinite system for d right-hand sides by the preconditioned
conjugate gradient method, from the solution 0. All sides are solved in the same iterations.
`System` has the rows, on several threads or processes:

- `for_each_row(f)` calls f(i) for each row i that is computed here, on any threads.
- `sum(f)` does so, too, and returns the sum of the vectors f(i) over all rows of all processes.
- `product(x, y)` returns what a row contributes to the scalar products of the d sides.
- `preconditioned(i, x)` applies the preconditioner to row i of a vector.
- `apply(directions, products)` multiplies the matrix with the search directions, and returns the
  scalar products of both. `is_stuck()` with these scalar products ends the iterations.

Iterates while `goes_on(energy, residuals)`. The energies are the scalar products of the residuals
and the preconditioned residuals.
*/
template <class System, class Vector, class Goes_on>
std::vector<Vector> conjugate_gradients(const System& system, std::vector<Vector> residuals,
                                        const Goes_on& goes_on) {
  const auto ratio = [](const Vector& a, const Vector& b) -> Vector { // 0 for a solved side
    return (b.array() > 0).select(a.cwiseQuotient(b), 0);
  };
  const std::size_t n = residuals.size();
  // The directions of entries that are no rows, such as fixed vertices, stay 0.
  std::vector<Vector> solution(n, Vector::Zero()), directions(solution), products(n);
  Vector energy = system.sum([&](std::size_t i) -> Vector {
    directions[i] = system.preconditioned(i, residuals[i]);
    return system.product(directions[i], residuals[i]);
  });
  while (goes_on(energy, residuals)) {
    const Vector curvature = system.apply(directions, products);
    if (system.is_stuck(curvature))
      break;
    const Vector step = ratio(energy, curvature);
    const Vector next = system.sum([&](std::size_t i) -> Vector {
      solution[i] += step.cwiseProduct(directions[i]);
      residuals[i] -= step.cwiseProduct(products[i]);
      return system.product(system.preconditioned(i, residuals[i]), residuals[i]);
    });
    const Vector beta = ratio(next, energy);
    system.for_each_row([&](std::size_t i) {
      directions[i] = system.preconditioned(i, residuals[i]) + beta.cwiseProduct(directions[i]);
    });
    energy = next;
  }
  return solution;
}

// Iterates until each component of the weighted residual norm is at most `part` times its initial
// value, or the maximum number of iterations is reached.
template <class System, class Vector>
std::vector<Vector> reduce_residuals(const System& system, std::vector<Vector> residuals,
                                     double part, int maximum_number_of_iterations) {
  Vector bound;
  int iterations = 0;
  return conjugate_gradients(system, std::move(residuals),
                             [&](const Vector& energy, const std::vector<Vector>&) {
                               if (iterations == 0)
                                 bound = part * part * energy;
                               return iterations++ < maximum_number_of_iterations &&
                                      (energy.array() > bound.array()).any();
                             });
}

// Rows of a system whose sides differ in their right-hand sides and constraints. The preconditioner
// is the diagonal.
template <int d> class Diagonal_preconditioner
{
public:
  using Vector = Eigen::Matrix<double, d, 1>; // the values of a row, one for each right-hand side

  static Vector product(const Vector& x, const Vector& y) { return x.cwiseProduct(y); }
  static bool is_stuck(const Vector&) { return false; }
  Vector preconditioned(std::size_t i, const Vector& x) const {
    return m_inverses[i].cwiseProduct(x);
  }

protected:
  explicit Diagonal_preconditioner(std::size_t size) : m_inverses(size) {}

  template <class IsConstrained>
  void set_diagonal(std::size_t i, double diagonal, const IsConstrained& is_constrained) {
    for (int side = 0; side < d; ++side)
      m_inverses[i][side] = diagonal > 0 && !is_constrained(side) ? 1 / diagonal : 0;
  }

private:
  std::vector<Vector> m_inverses; // 0 where the solution stays 0
};

/*
Conjugate gradients on several threads. The method is deterministic for any number of threads:
scalar products are summed within blocks of rows, and then over the blocks in their order.
*/
template <int d> class Conjugate_gradients : public Diagonal_preconditioner<d>
{
public:
  using Vector = Eigen::Matrix<double, d, 1>;

  struct Entry // an off-diagonal entry
  {
    std::uint32_t column;
    double value;
  };

  Conjugate_gradients(const Row_blocks<Entry>& matrix, const std::vector<double>& diagonal,
                      const For_each_index& for_each_index)
      : Diagonal_preconditioner<d>(diagonal.size()), m_matrix(matrix), m_diagonal(diagonal),
        m_for_each_index(for_each_index) {}

  // Reduces the residuals. Unknowns stay 0 where `is_constrained(row, side)`, and where the
  // diagonal is not positive.
  template <class IsConstrained>
  std::vector<Vector> solve(std::vector<Vector> residuals, const IsConstrained& is_constrained,
                            double part, int maximum_number_of_iterations) {
    for_each_row([&](std::size_t i) {
      this->set_diagonal(i, m_diagonal[i], [&](int side) { return is_constrained(i, side); });
    });
    return reduce_residuals(*this, std::move(residuals), part, maximum_number_of_iterations);
  }

  Vector apply(const std::vector<Vector>& directions, std::vector<Vector>& products) const {
    Progress_scope::check();
    return sum([&](std::size_t i) {
      Vector product = m_diagonal[i] * directions[i];
      for (const Entry& e : m_matrix.row(i))
        product += e.value * directions[e.column];
      products[i] = product;
      return this->product(product, directions[i]);
    });
  }

  template <class Function> void for_each_row(const Function& f) const {
    m_matrix.for_each_row(m_for_each_index, f);
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

private:
  const Row_blocks<Entry>& m_matrix;
  const std::vector<double>& m_diagonal;
  const For_each_index& m_for_each_index;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_CONJUGATE_GRADIENTS_H
