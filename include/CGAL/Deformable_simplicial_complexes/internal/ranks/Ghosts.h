// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_RANKS_GHOSTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_RANKS_GHOSTS_H

#include <CGAL/Deformable_simplicial_complexes/Communicator.h>
#include <CGAL/Deformable_simplicial_complexes/internal/ranks/Piece.h>
#include <CGAL/Deformable_simplicial_complexes/internal/ranks/message_bytes.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The vertices that a rank holds and other ranks own, called ghosts, and the own vertices that
// other ranks hold.
template <int d> class Ghosts
{
public:
  using Index = typename Piece<d>::Index;

  // Finds the vertices of a piece.
  Ghosts(const Piece<d>& piece, Communicator& communicator) : m_communicator(&communicator) {
    const int me = communicator.rank();
    if (communicator.size() == 1)
      return;
    for (Index v = 0; v < piece.vertex_bound(); ++v) {
      if (!piece.has_vertex(v) || piece.vertex(v).owner == me)
        continue;
      m_ghosts[piece.vertex(v).owner].push_back(v);
      // The owner of v holds all vertices of the cells around v.
      auto& shared = m_shared[piece.vertex(v).owner];
      for (Index c : piece.star(v))
        for (Index w : piece.cell(c).vertices)
          if (piece.vertex(w).owner == me)
            shared.push_back(w);
    }
    const auto by_id = [&](Index v, Index w) { return piece.vertex(v).id < piece.vertex(w).id; };
    for (auto& [rank, vertices] : m_ghosts)
      std::sort(vertices.begin(), vertices.end(), by_id);
    for (auto& [rank, vertices] : m_shared) {
      std::sort(vertices.begin(), vertices.end(), by_id);
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }

  // Sends the values of own vertices to the ranks that hold them. `values` has an entry for each
  // index of a vertex. Calls `changed(v)` for each ghost whose value changed.
  template <class Value, class Changed>
  void update(std::vector<Value>& values, const Changed& changed) const {
    std::map<int, std::vector<Value>> lists;
    for (const auto& [rank, vertices] : m_shared)
      for (Index v : vertices)
        lists[rank].push_back(values[v]);
    exchange_lists(*m_communicator, lists, [&](int rank, const std::vector<Value>& list) {
      const std::vector<Index>& ghosts = m_ghosts.at(rank);
      for (std::size_t i = 0; i < list.size(); ++i)
        if (std::memcmp(&values[ghosts[i]], &list[i], sizeof(Value)) != 0) { // -0. differs from 0.
          values[ghosts[i]] = list[i];
          changed(ghosts[i]);
        }
    });
  }

  template <class Value> void update(std::vector<Value>& values) const {
    update(values, [](Index) {});
  }

  // The number of ghosts.
  std::size_t size() const {
    std::size_t result = 0;
    for (const auto& [rank, vertices] : m_ghosts)
      result += vertices.size();
    return result;
  }

private:
  Communicator* m_communicator;
  std::map<int, std::vector<Index>> m_ghosts, m_shared; // by rank; ordered by id
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_RANKS_GHOSTS_H
