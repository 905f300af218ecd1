// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_support, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_ROW_BLOCKS_H
#define CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_ROW_BLOCKS_H

#include <CGAL/Mesh_support/For_each_index.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_SUPPORT_INTERNAL_NUMBERS_ROW_BLOCKS_H
