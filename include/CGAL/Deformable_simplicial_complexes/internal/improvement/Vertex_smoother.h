// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_VERTEX_SMOOTHER_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_VERTEX_SMOOTHER_H

#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Vertex_numbers.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_smoothing.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/star_union.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Parallel smoother of the vertices of cells. The vertices are divided into colors: two vertices of
// the same color have no cell in common, so their motions are independent of each other. The result
// does not depend on the number of threads.
template <class Complex> class Vertex_smoother
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  // `moves_interface` states whether interface vertices move within their plane or line.
  Vertex_smoother(const Complex& complex, const For_each_index& for_each_index,
                  bool moves_interface)
      : m_complex(complex), m_for_each_index(for_each_index), m_moves_interface(moves_interface) {}

  // Calls `move(v, star, target)` for each vertex of the cells that has a better position, at most
  // once. A vertex is skipped if `is_bad(c)` holds for no cell `c` around it when its turn comes.
  // `is_bad` can be called by several threads. `move` changes only the vertex and the cells around
  // it.
  template <class IsBad, class Move>
  void run(const std::vector<Cell_handle>& cells, const IsBad& is_bad, const Move& move) {
    static constexpr std::size_t worthwhile = 16; // vertices
    color(cells);
    for (const std::vector<Vertex_handle>& vertices : m_vertices_of_color)
      for (std::size_t first = 0; first < vertices.size(); first += block_size) {
        Progress_scope::check();
        const std::size_t number = (std::min)(block_size, vertices.size() - first);
        m_for_each_index(
            number, [&](std::size_t k) { propose(vertices[first + k], is_bad, m_motions[k]); },
            worthwhile);
        for (std::size_t k = 0; k < number; ++k)
          if (m_motions[k].is_better)
            move(vertices[first + k], m_motions[k].star, m_motions[k].target);
      }
  }

private:
  // Vertices whose motions are stored at a time. A user can interrupt the work between two blocks.
  static constexpr std::size_t block_size = 1024;

  struct Motion
  {
    std::vector<Cell_handle> star;
    typename Complex::Point target;
    bool is_better;
  };

  template <class IsBad> void propose(Vertex_handle v, const IsBad& is_bad, Motion& motion) const {
    m_complex.star(v, motion.star);
    motion.is_better =
        std::any_of(motion.star.begin(), motion.star.end(),
                    [&](Cell_handle c) { return !m_complex.is_infinite(c) && is_bad(c); }) &&
        (propose_smart_laplacian(m_complex, v, motion.star, motion.target) ||
         Mesh_operations<Complex>::propose_optimal_position(m_complex, v, motion.star,
                                                            motion.target));
  }

  // Gives each vertex of the cells the first color that no vertex with a common cell has.
  void color(const std::vector<Cell_handle>& cells) {
    static constexpr std::uint32_t none = Vertex_numbers::none;
    for (auto& vertices : m_vertices_of_color)
      vertices.clear();
    Vertex_numbers colors(m_complex);
    std::vector<char> is_used; // by color
    for (Vertex_handle v : vertices_of(m_complex, cells)) {
      Progress_scope::check();
      if (v->is_interface() && !m_moves_interface)
        continue;
      is_used.assign(m_vertices_of_color.size(), false);
      m_complex.star(v, m_star);
      for (Cell_handle c : m_star)
        for (int i = 0; i < Complex::corners; ++i)
          if (const std::uint32_t color = colors(c->vertex(i)); color != none)
            is_used[color] = true;
      const std::size_t color = std::find(is_used.begin(), is_used.end(), false) - is_used.begin();
      if (color == m_vertices_of_color.size())
        m_vertices_of_color.emplace_back();
      m_vertices_of_color[color].push_back(v);
      colors.set(v, std::uint32_t(color));
    }
  }

  const Complex& m_complex;
  const For_each_index& m_for_each_index;
  bool m_moves_interface;
  std::vector<std::vector<Vertex_handle>> m_vertices_of_color;
  std::vector<Motion> m_motions = std::vector<Motion>(block_size);
  std::vector<Cell_handle> m_star;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMPROVEMENT_VERTEX_SMOOTHER_H
