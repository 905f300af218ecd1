// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_FAILED_COLLAPSES_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_FAILED_COLLAPSES_H

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Memory of edge collapses that were impossible. A collapse stays impossible as long as the stars
// of both ends of the edge stay the same. It is tried once instead of once from each cell around
// the edge, and again in each round.
template <class Complex> class Failed_collapses
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // Records that `removed` cannot be collapsed into `kept`.
  void add(Vertex_handle removed, Vertex_handle kept) { m_failures[key(removed, kept)] = m_now; }

  // Returns whether the collapse was impossible, and both stars are the same since.
  bool contains(Vertex_handle removed, Vertex_handle kept) const {
    const auto found = m_failures.find(key(removed, kept));
    return found != m_failures.end() && change_of(removed) <= found->second &&
           change_of(kept) <= found->second;
  }

  // Records that the stars of all vertices of new cells have changed.
  void update(const std::vector<Cell_handle>& created) {
    ++m_now;
    for (Cell_handle c : created)
      for (int i = 0; i < Complex::corners; ++i) {
        const std::size_t v = c->vertex(i)->id();
        if (v >= m_changes.size())
          m_changes.resize(v + 1, 0);
        m_changes[v] = m_now;
      }
  }

private:
  static std::uint64_t key(Vertex_handle removed, Vertex_handle kept) {
    return std::uint64_t(removed->id()) << 32 | kept->id();
  }

  std::uint32_t change_of(Vertex_handle v) const {
    return v->id() < m_changes.size() ? m_changes[v->id()] : 0;
  }

  std::unordered_map<std::uint64_t, std::uint32_t> m_failures; // times of failures
  std::vector<std::uint32_t> m_changes; // times of the last changes of stars, by id of the vertex
  std::uint32_t m_now = 0;              // number of changes of the mesh
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_REMESHING_FAILED_COLLAPSES_H
