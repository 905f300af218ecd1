// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_REFINE_DISTRIBUTED_COMPLEX_3_H
#define CGAL_DISTRIBUTED_COMPLEXES_REFINE_DISTRIBUTED_COMPLEX_3_H

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Replaces the ids of all vertices by 0, 1, 2, ... in the same order. The ids are divided among the
// ranks by their values, and each rank counts those that it gets. `bound` is larger than all ids.
template <class Complex> void renumber_vertices(Distributed_mesh<Complex>& mesh, Global_id bound) {
  using Index = typename Distributed_mesh<Complex>::Index;
  static constexpr int d = Complex::dimension;
  Communicator& communicator = *mesh.communicator;
  const int size = communicator.size();
  const Global_id range = bound / unsigned(size) + 1;
  std::map<int, std::vector<Global_id>> ids;
  std::map<int, std::vector<Index>> vertices;
  for (Index v : mesh.own_vertices()) {
    const int rank = int(mesh.piece.vertex(v).id / range);
    ids[rank].push_back(mesh.piece.vertex(v).id);
    vertices[rank].push_back(v);
  }
  std::vector<Global_id> sorted;
  std::map<int, std::vector<Global_id>> answers;
  exchange_lists(communicator, ids, [&](int rank, const std::vector<Global_id>& list) {
    sorted.insert(sorted.end(), list.begin(), list.end());
    answers[rank] = list;
  });
  std::sort(sorted.begin(), sorted.end());
  Global_id first = 0, all = 0;
  int rank = 0;
  for (std::uint64_t number : gather_items<std::uint64_t>(communicator, {sorted.size()})) {
    first += rank++ < mesh.rank() ? number : 0;
    all += number;
  }
  for (auto& [other, list] : answers)
    for (Global_id& id : list)
      id = first + Global_id(std::lower_bound(sorted.begin(), sorted.end(), id) - sorted.begin());
  std::vector<Global_id> numbers(mesh.piece.vertex_bound(), 0);
  exchange_lists(communicator, answers, [&](int other, const std::vector<Global_id>& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
      numbers[vertices.at(other)[i]] = list[i];
  });
  mesh.ghosts.update(numbers);
  Piece<d> renumbered;
  for (Index v : mesh.piece.vertices()) {
    Piece_vertex<d> vertex = mesh.piece.vertex(v);
    vertex.id = numbers[v];
    renumbered.put(vertex);
  }
  for (Index c : mesh.piece.cells()) {
    Sent_cell<d> cell = mesh.piece.sent(c);
    for (int i = 0; i <= d; ++i)
      cell.vertices[i] = numbers[mesh.piece.cell(c).vertices[i]];
    renumbered.put(cell); // the order of the vertices stays
  }
  mesh.piece = std::move(renumbered);
  mesh.next_id = all;
  mesh.find_ghosts();
}

// The refinement of the cells of a piece. The id of a new vertex consists of the ids of the ends of
// its edge, so it does not depend on the ranks.
template <class Complex> class Piece_refiner_3
{
public:
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;
  using Vertex = Piece_vertex<3>;

  // Ids of input vertices must be below.
  static constexpr Global_id bound = Global_id(1) << 31;

  explicit Piece_refiner_3(Mesh& mesh) : m_mesh(mesh) {}

  void run() {
    for (Index c : m_mesh.piece.cells())
      refine(c);
    m_mesh.piece = std::move(m_refined);
    m_mesh.mean_interface_edge /= 2;
    m_mesh.minimum_interface_edge /= 2;
    m_mesh.find_ghosts();
    renumber_vertices(m_mesh, (m_mesh.next_id + 2) << 31);
  }

private:
  void refine(Index c) {
    const auto& cell = m_mesh.piece.cell(c);
    std::array<Vertex, 4> corners;
    for (int i = 0; i < 4; ++i) {
      corners[i] = m_mesh.piece.vertex(cell.vertices[i]);
      corners[i].spacing /= 2;
    }
    std::array<std::array<Vertex, 4>, 4> middles;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        middles[i][j] = middles[j][i] = middle(corners[i], corners[j]);
    const auto m = [&](int i, int j) -> const Vertex& { return middles[i][j]; };
    for (int i = 0; i < 4; ++i) {
      std::array<Vertex, 4> child;
      for (int j = 0; j < 4; ++j)
        child[j] = i == j ? corners[i] : m(i, j);
      put(child, cell.data);
    }
    // The octahedron is divided along its shortest diagonal. (i, j) and (k, l) are opposite edges
    // of the cell, and (i, j, k, l) is even.
    static constexpr int pairs[3][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}};
    const auto length = [&](const int* p) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) {
        const double x = m(p[0], p[1]).point[k] - m(p[2], p[3]).point[k];
        sum += x * x;
      }
      return std::make_pair(sum, (std::min)(m(p[0], p[1]).id, m(p[2], p[3]).id));
    };
    const int* best = pairs[0];
    for (const int* p : {pairs[1], pairs[2]})
      if (length(p) < length(best))
        best = p;
    const int i = best[0], j = best[1], k = best[2], l = best[3];
    // The other vertices of the octahedron around the diagonal.
    const std::array<const Vertex*, 4> ring = {&m(i, k), &m(j, k), &m(j, l), &m(i, l)};
    for (int r = 0; r < 4; ++r)
      put({m(k, l), m(i, j), *ring[r], *ring[(r + 1) % 4]}, cell.data);
  }

  static Vertex middle(const Vertex& a, const Vertex& b) {
    const Vertex& first = a.id < b.id ? a : b;
    const Vertex& second = a.id < b.id ? b : a;
    Vertex result = {};
    result.id = (first.id + 1) << 31 | second.id; // larger than the ids of the input
    for (int k = 0; k < 3; ++k)
      result.point[k] = (first.point[k] + second.point[k]) / 2;
    result.spacing = a.spacing > 0 && b.spacing > 0 ? (first.spacing + second.spacing) / 2 : 0;
    result.owner = first.owner;
    result.boundary_class = a.boundary_class & b.boundary_class;
    return result;
  }

  // Adds a cell if this rank owns one of its vertices.
  void put(const std::array<Vertex, 4>& vertices, const Piece_cell_data& parent) {
    if (std::none_of(vertices.begin(), vertices.end(),
                     [&](const Vertex& v) { return v.owner == m_mesh.rank(); }))
      return;
    Sent_cell<3> cell = {};
    std::array<typename Complex::Point, 4> p;
    for (int i = 0; i < 4; ++i) {
      m_refined.put(vertices[i]);
      cell.vertices[i] = vertices[i].id;
      p[i] = point_at<Complex>(vertices[i].point);
    }
    cell.vertices = canonical_cell(cell.vertices);
    cell.data = parent;
    cell.data.noted_quality = float(m_mesh.quality_measure(p[0], p[1], p[2], p[3]));
    cell.data.failures = 0;
    m_refined.put(cell);
  }

  Mesh& m_mesh;
  Piece<3> m_refined;
};

} // namespace internal

/*!
\ingroup PkgDistributedComplexesRef

Divides each tetrahedron of a distributed complex into eight. Each edge is split at its midpoint,
and the interface keeps its shape. No rank holds the whole complex, so a coarse complex that one
rank can build is refined to a size that no rank could hold. `mean_interface_edge()` is halved.
Linear in the number of cells of a rank, with memory for the old and the new piece. Collective.

\param dsc the complex; its domain must be a box
\throws Error on all ranks if the domain is not a box, there are 2^31 or more vertices, or a
        coordinate of a midpoint is rounded so that a cell is
not positively oriented; the complex is then unchanged
*/
template <class Complex> void refine_3(Distributed_complex<Complex>& dsc) {
  auto& mesh = dsc.mesh();
  std::string error;
  if (mesh.next_id >= internal::Piece_refiner_3<Complex>::bound)
    internal::renumber_vertices(mesh, mesh.next_id);
  if (mesh.next_id >= internal::Piece_refiner_3<Complex>::bound)
    error = "the complex has too many vertices to be refined";
  for (std::uint32_t v : mesh.own_vertices())
    if ((mesh.piece.vertex(v).boundary_class & Boundary_class::fixed) != 0)
      error = "only complexes in a box can be refined";
  dsc.communicator().agree_on_error(error);
  const auto before = dsc.state();
  internal::Piece_refiner_3<Complex>(mesh).run();
  bool is_valid = true;
  for (std::uint32_t c : mesh.own_cells())
    is_valid = is_valid && mesh.is_positive(c, [&](auto v) { return mesh.position(v); });
  try {
    dsc.communicator().agree_on_error(
        is_valid ? "" : "a cell is too flat to be refined: use a better mesh");
  } catch (const Error&) {
    dsc.restore(before);
    throw;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_REFINE_DISTRIBUTED_COMPLEX_3_H
