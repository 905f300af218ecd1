// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_RENUMBER_VERTICES_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_RENUMBER_VERTICES_H

#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_RENUMBER_VERTICES_H
