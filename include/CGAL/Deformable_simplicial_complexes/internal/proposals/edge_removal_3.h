// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_REMOVAL_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_REMOVAL_3_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/internal/operations/Polygon_triangulation_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/relabeling.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Ring of cells around an edge a -> b. The ring vertices k and k + 1 belong to the cell k.
template <class Complex> class Edge_ring_3
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cavity = Deformable_simplicial_complexes::Cavity<Complex>;
  using Index = typename Cavity::Index;

  // Collects the ring counterclockwise around a -> b, starting at a cell, and adds its vertices to
  // the cavity. Stops if the ring becomes too large.
  Edge_ring_3(Cell_handle cell, int i, int j, Cavity& cavity)
      : m_triangulation{cavity, cavity.add(cell->vertex(i)), cavity.add(cell->vertex(j))} {
    // (a, b, s, t) is positively oriented; the next cell is opposite to s.
    static constexpr int next[4][4] = {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}};
    const Vertex_handle a = cell->vertex(i), b = cell->vertex(j);
    Vertex_handle s = cell->vertex(next[i][j]);
    Cell_handle c = cell;
    do {
      const int s_index = c->index(s);
      m_cells.push_back(c);
      m_vertices.push_back(cavity.add(s));
      s = c->vertex(6 - s_index - c->index(a) - c->index(b));
      c = c->neighbor(s_index);
    } while (c != cell && !is_too_large());
  }

  // Returns whether the ring is too large to be triangulated. It is then incomplete.
  bool is_too_large() const {
    return size() > Polygon_triangulation_3<Complex>::maximum_number_of_vertices;
  }

  std::size_t size() const { return m_cells.size(); }
  Cell_handle cell(std::size_t k) const { return m_cells[k % size()]; }

  // Triangulates the polygon of the ring vertices first, ..., last (modulo the size), and plans the
  // tetrahedra over and under the triangles. The triangulation maximizes the worst quality of these
  // tetrahedra. Returns false if this quality is not above `bound`.
  bool triangulate(std::size_t first, std::size_t last, double bound) {
    const auto vertex = [&](std::size_t p) { return m_vertices[(first + p) % size()]; };
    return m_triangulation.create(last - first + 1, vertex, bound, cell(first));
  }

private:
  // Most rings have fewer than eight cells.
  template <class T> using Ring = boost::container::small_vector<T, 8>;
  Ring<Cell_handle> m_cells;
  Ring<Index> m_vertices;
  Polygon_triangulation_3<Complex> m_triangulation;
};

} // namespace internal

template <class Complex>
bool propose_edge_removal(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                          Cavity<Complex>& cavity) {
  cavity.begin(Proposal_kind::flip);
  internal::Edge_ring_3<Complex> ring(cell, i, j, cavity);
  if (ring.is_too_large())
    return false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (complex.is_infinite(ring.cell(k)) ||
        ring.cell(k)->subdomain_index() != cell->subdomain_index())
      return false;
    cavity.remove(ring.cell(k));
  }
  return ring.triangulate(0, ring.size() - 1, cavity.quality_before()) && cavity.is_positive();
}

template <class Complex>
bool propose_interface_edge_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                 int j, Cavity<Complex>& cavity, double minimum_quality = 1) {
  cavity.begin(Proposal_kind::flip);
  internal::Edge_ring_3<Complex> ring(cell, i, j, cavity);
  if (ring.is_too_large())
    return false;
  const std::size_t n = ring.size();
  boost::container::small_vector<std::size_t, 8> sheets; // ring vertices where the label changes
  for (std::size_t k = 0; k < n; ++k) {
    if (complex.is_infinite(ring.cell(k)))
      return false;
    cavity.remove(ring.cell(k));
    if (ring.cell(k)->subdomain_index() != ring.cell(k + n - 1)->subdomain_index())
      sheets.push_back(k);
  }
  if (sheets.size() != 2)
    return false;
  // If one side consists of a single cell, the cell is relabeled to the other side.
  for (std::size_t k : sheets)
    if (ring.cell(k)->subdomain_index() != ring.cell(k + 1)->subdomain_index() &&
        !relabeling_keeps_topology(complex, ring.cell(k), ring.cell(k + 1)->subdomain_index()))
      return false;
  const double bound = (std::min)(cavity.quality_before(), minimum_quality);
  return ring.triangulate(sheets[0], sheets[1], bound) &&
         ring.triangulate(sheets[1], sheets[0] + n, bound) && cavity.is_admissible();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_PROPOSALS_EDGE_REMOVAL_3_H
