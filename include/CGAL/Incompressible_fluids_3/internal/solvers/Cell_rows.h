// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CELL_ROWS_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CELL_ROWS_H

#include <CGAL/Mesh_support/For_each_index.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The rows of a sparse matrix that is assembled cell by cell, with the cells around each row. Each
// row is the sum of the contributions of its cells, in a fixed order. So the result does not depend
// on threads, and the pattern is sorted only once.
template <int corners> class Cell_rows
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Index = std::uint32_t;
  using Corners = std::array<Index, corners>; // of a cell: its rows or its columns

  // Finds the cells around each row. Takes linear time.
  Cell_rows(const std::vector<Corners>& rows_of_cells, std::size_t rows) : m_begin(rows + 1, 0) {
    for (const Corners& of_cell : rows_of_cells)
      for (Index row : of_cell)
        ++m_begin[row + 1];
    for (std::size_t row = 0; row < rows; ++row)
      m_begin[row + 1] += m_begin[row];
    m_corners.resize(m_begin.back());
    std::vector<std::size_t> end(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t k = 0; k < rows_of_cells.size(); ++k)
      for (unsigned i = 0; i < corners; ++i)
        m_corners[end[rows_of_cells[k][i]]++] = {Index(k), i};
  }

  std::size_t size() const { return m_begin.size() - 1; }

  // Returns a matrix of blocks of zeros, with a block for each row and column that share a cell.
  // Takes linear time.
  template <int block_rows, int block_columns>
  Matrix zeros(const std::vector<Corners>& columns_of_cells, std::size_t columns) const {
    using Entry = Matrix::StorageIndex;
    std::vector<Entry> entries, ends; // of the blocks of each row
    std::vector<std::size_t> row_of_last_entry(columns, size());
    for (std::size_t row = 0; row < size(); ++row) {
      const auto first = std::ptrdiff_t(entries.size());
      for (std::size_t k = m_begin[row]; k < m_begin[row + 1]; ++k)
        for (Index column : columns_of_cells[m_corners[k].cell])
          if (row_of_last_entry[column] != row) {
            row_of_last_entry[column] = row;
            entries.push_back(Entry(column));
          }
      std::sort(entries.begin() + first, entries.end());
      ends.push_back(Entry(entries.size()));
    }
    Matrix result(block_rows * Eigen::Index(size()), block_columns * Eigen::Index(columns));
    result.resizeNonZeros(Eigen::Index(entries.size()) * block_rows * block_columns);
    Entry next = 0;
    for (std::size_t row = 0; row < size(); ++row)
      for (std::size_t i = 0; i < block_rows; ++i) {
        for (Entry k = row == 0 ? 0 : ends[row - 1]; k < ends[row]; ++k)
          for (int j = 0; j < block_columns; ++j)
            result.innerIndexPtr()[next++] = block_columns * entries[std::size_t(k)] + j;
        result.outerIndexPtr()[block_rows * row + i + 1] = next;
      }
    result.coeffs().setZero();
    return result;
  }

  // Sets the entries of a matrix made by `zeros()`. Each block is the sum of `block_of(cell, i, j)`
  // over the common cells of its row and column, where the row belongs to corner i of the cell, and
  // the column to corner j. Takes linear time.
  template <int block_rows, int block_columns, class BlockOf>
  void sum(const For_each_index& for_each, const std::vector<Corners>& columns_of_cells,
           const BlockOf& block_of, Matrix& matrix) const {
    static constexpr std::size_t parts = 16; // each part has a vector of the size of all columns
    for_each(
        parts,
        [&](std::size_t part) {
          std::vector<int> entry_of(std::size_t(matrix.cols()) / block_columns);
          std::array<double*, block_rows> values;
          const std::size_t end = size() * (part + 1) / parts;
          for (std::size_t row = size() * part / parts; row < end; ++row) {
            const int first = matrix.outerIndexPtr()[block_rows * row],
                      n = matrix.outerIndexPtr()[block_rows * row + 1] - first;
            for (std::size_t i = 0; i < block_rows; ++i)
              values[i] = matrix.valuePtr() + matrix.outerIndexPtr()[block_rows * row + i];
            std::fill(values[0], values[0] + block_rows * n, 0.);
            for (int k = 0; k < n; k += block_columns)
              entry_of[std::size_t(matrix.innerIndexPtr()[first + k]) / block_columns] = k;
            for (std::size_t k = m_begin[row]; k < m_begin[row + 1]; ++k) {
              const auto [cell, corner] = m_corners[k];
              for (std::size_t j = 0; j < corners; ++j) {
                const Eigen::Matrix<double, block_rows, block_columns> block =
                    block_of(cell, corner, j);
                const int entry = entry_of[columns_of_cells[cell][j]];
                for (int a = 0; a < block_rows; ++a)
                  for (int b = 0; b < block_columns; ++b)
                    values[std::size_t(a)][entry + b] += block(a, b);
              }
            }
          }
        },
        2);
  }

private:
  struct Corner
  {
    Index cell, corner;
  };

  std::vector<std::size_t> m_begin; // by row
  std::vector<Corner> m_corners;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_SOLVERS_CELL_ROWS_H
