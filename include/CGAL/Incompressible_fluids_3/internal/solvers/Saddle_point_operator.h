// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H

#include <CGAL/Incompressible_fluids_3/Saddle_point_system.h>
#include <CGAL/Incompressible_fluids_3/internal/solvers/blocks_of_vectors.h>
#include <CGAL/Mesh_support/For_each_index.h>

#include <array>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A sparse matrix of dense blocks, by rows of blocks. The blocks of a row have increasing columns.
// A block has one index, so that products read less memory than those of `Eigen::SparseMatrix`.
template <class Scalar, int block_rows, int block_columns> class Block_matrix
{
public:
  using Index = Eigen::Index;
  using Block = Eigen::Matrix<Scalar, block_rows, block_columns,
                              block_columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
  using Part = Eigen::Matrix<Scalar, block_rows, 1>; // of a vector: the rows of a block

  Block_matrix() = default;

  // Converts a sparse matrix. A block has an entry in at least one row.
  explicit Block_matrix(const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix) {
    using Entry = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    const Index n = matrix.rows() / block_rows;
    reserve(n, std::size_t(matrix.nonZeros()) / (block_rows * block_columns));
    for (Index i = 0; i < n; ++i) {
      std::array<Entry, block_rows> entries = entries_of(matrix, i);
      for (;;) {
        static constexpr Index none = (std::numeric_limits<Index>::max)();
        Index column = none; // the next one
        for (const Entry& k : entries)
          if (k)
            column = (std::min)(column, k.col() / block_columns);
        if (column == none)
          break;
        Block block = Block::Zero();
        for (int row = 0; row < block_rows; ++row)
          for (Entry& k = entries[std::size_t(row)]; k && k.col() / block_columns == column; ++k)
            block(row, int(k.col() % block_columns)) = Scalar(k.value());
        append(column, block);
      }
      m_begin.push_back(m_columns.size());
    }
  }

  // Converts another scalar, after multiplication by a factor.
  template <class Other>
  Block_matrix(const Block_matrix<Other, block_rows, block_columns>& other, double factor)
      : m_begin(other.begin()), m_columns(other.columns()), m_values(other.values().size()) {
    std::transform(other.values().begin(), other.values().end(), m_values.begin(),
                   [factor](Other value) { return Scalar(factor * value); });
  }

  // Returns the transpose of a matrix with `columns` columns of blocks. Takes linear time.
  Block_matrix<Scalar, block_columns, block_rows> transpose(Index columns) const {
    std::vector<std::size_t> begin(std::size_t(columns) + 1, 0);
    for (int column : m_columns)
      ++begin[std::size_t(column) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i)
      begin[i] += begin[i - 1];
    std::vector<int> rows(m_columns.size());
    std::vector<Scalar> values(m_values.size());
    std::vector<std::size_t> next = begin;
    for (Index i = 0; i < this->rows(); ++i)
      for_each_in_row(i, [&](Index column, const auto& block) {
        const std::size_t k = next[std::size_t(column)]++;
        rows[k] = int(i);
        using Transposed = typename Block_matrix<Scalar, block_columns, block_rows>::Block;
        Eigen::Map<Transposed>(values.data() + k * size) = block.transpose();
      });
    return {std::move(begin), std::move(rows), std::move(values)};
  }

  // Constructs a matrix from its arrays.
  Block_matrix(std::vector<std::size_t> begin, std::vector<int> columns, std::vector<Scalar> values)
      : m_begin(std::move(begin)), m_columns(std::move(columns)), m_values(std::move(values)) {}

  // Returns the number of rows of blocks.
  Index rows() const { return m_begin.empty() ? 0 : Index(m_begin.size()) - 1; }

  // Calls `f(column, block)` for each block of a row.
  template <class Function> void for_each_in_row(Index row, const Function& f) const {
    for (std::size_t k = m_begin[std::size_t(row)]; k < m_begin[std::size_t(row) + 1]; ++k)
      f(Index(m_columns[k]), Eigen::Map<const Block>(m_values.data() + k * size));
  }

  // Returns the product of a row and of the entries of x that begin at `from`.
  template <class Vector> Part product(Index row, const Vector& x, Index from) const {
    Part result = Part::Zero();
    for_each_in_row(row, [&](Index column, const auto& block) {
      result += block * x.template segment<block_columns>(from + block_columns * column);
    });
    return result;
  }

  const std::vector<std::size_t>& begin() const { return m_begin; }
  const std::vector<int>& columns() const { return m_columns; }
  const std::vector<Scalar>& values() const { return m_values; }

private:
  static constexpr std::size_t size = std::size_t(block_rows) * block_columns; // of a block

  template <class Matrix> static auto entries_of(const Matrix& matrix, Index row) {
    using Entry = typename Matrix::InnerIterator;
    if constexpr (block_rows == 1)
      return std::array<Entry, 1>{Entry(matrix, row)};
    else
      return std::array<Entry, 3>{Entry(matrix, 3 * row), Entry(matrix, 3 * row + 1),
                                  Entry(matrix, 3 * row + 2)};
  }
  static_assert(block_rows == 1 || block_rows == 3, "other sizes are not needed");

  void reserve(Index rows, std::size_t blocks) {
    m_begin.reserve(std::size_t(rows) + 1);
    m_columns.reserve(blocks);
    m_values.reserve(blocks * size);
    m_begin.push_back(0);
  }
  void append(Index column, const Block& block) {
    m_columns.push_back(int(column));
    m_values.insert(m_values.end(), block.data(), block.data() + size);
  }

  std::vector<std::size_t> m_begin; // by row
  std::vector<int> m_columns;
  std::vector<Scalar> m_values;
};

// The units of velocities and pressures in which the entries of a system are near 1, and the factor
// of all equations. They are powers of two. So the digits of a solution are the same for all units
// of the user that differ by powers of two.
struct System_units
{
  double velocity = 1, pressure = 1, factor = 1;

  // Constructs the units for given largest diagonal entries of velocities and of pressures.
  static System_units of(double largest_of_velocities, double largest_of_pressures) {
    const auto exponent = [](double x) { return std::ilogb(unit_of(x)); };
    // Other units of the user change both exponents by even or both by odd numbers.
    const int odd = exponent(largest_of_velocities) & 1;
    const auto unit = [odd](int e) { return std::ldexp(1., -((e + odd) >> 1)); };
    return {unit(exponent(largest_of_velocities)), unit(exponent(largest_of_pressures)),
            odd ? 2. : 1.};
  }

  // The factors of the parts of the matrix.
  double of_nodal() const { return factor * velocity * velocity; }
  double of_b() const { return factor * velocity * pressure; }
  double of_c() const { return factor * pressure * pressure; }
};

// The matrix of a `Saddle_point_system`, without the projection and the closed sets.
template <class Scalar> class Saddle_point_operator
{
public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Index = Eigen::Index;

  Saddle_point_operator() = default;

  explicit Saddle_point_operator(const For_each_index& for_each,
                                 const Saddle_point_system& system) {
    for_each(
        4,
        [&](std::size_t k) {
          if (k == 0) {
            m_b = Block_matrix<Scalar, 1, 3>(system.b);
            m_bt = m_b.transpose(system.nodal.rows());
          } else if (k == 1)
            m_nodal = Block_matrix<Scalar, 1, 1>(system.nodal);
          else if (k == 2)
            m_coupling = Block_matrix<Scalar, 3, 3>(system.coupling);
          else
            m_c = Block_matrix<Scalar, 1, 1>(system.c);
        },
        2);
  }

  // Converts another scalar and other units.
  template <class Other>
  Saddle_point_operator(const For_each_index& for_each, const Saddle_point_operator<Other>& other,
                        const System_units& units) {
    for_each(
        5,
        [&](std::size_t k) {
          if (k == 0)
            m_b = {other.b(), units.of_b()};
          else if (k == 1)
            m_bt = {other.bt(), units.of_b()};
          else if (k == 2)
            m_nodal = {other.nodal(), units.of_nodal()};
          else if (k == 3)
            m_coupling = {other.coupling(), units.of_nodal()};
          else
            m_c = {other.c(), units.of_c()};
        },
        2);
  }

  // Computes the product y of the matrix and a vector x.
  void multiply(const For_each_index& for_each, const Vector& x, Vector& y) const {
    const Index n = m_nodal.rows(), m = m_c.rows();
    for_each_block(for_each, n + m, [&](Index begin, Index size) {
      for (Index i = begin; i < begin + size; ++i)
        if (i < n) {
          Eigen::Matrix<Scalar, 3, 1> sum = -m_bt.product(i, x, 3 * n);
          m_nodal.for_each_in_row(i, [&](Index j, const auto& value) {
            sum += value(0) * x.template segment<3>(3 * j);
          });
          if (m_coupling.rows() > 0)
            sum += m_coupling.product(i, x, 0);
          y.template segment<3>(3 * i) = sum;
        } else
          y(2 * n + i) = -m_b.product(i - n, x, 0)(0) - m_c.product(i - n, x, 3 * n)(0);
    });
  }

  const Block_matrix<Scalar, 1, 1>& nodal() const { return m_nodal; }
  const Block_matrix<Scalar, 3, 3>& coupling() const { return m_coupling; }
  const Block_matrix<Scalar, 1, 3>& b() const { return m_b; }
  const Block_matrix<Scalar, 3, 1>& bt() const { return m_bt; }
  const Block_matrix<Scalar, 1, 1>& c() const { return m_c; }

private:
  Block_matrix<Scalar, 1, 1> m_nodal;
  Block_matrix<Scalar, 3, 3> m_coupling;
  Block_matrix<Scalar, 1, 3> m_b;
  Block_matrix<Scalar, 3, 1> m_bt; // the transpose of b
  Block_matrix<Scalar, 1, 1> m_c;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_SADDLE_POINT_OPERATOR_H
