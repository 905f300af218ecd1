// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PLACEMENT_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PLACEMENT_H

#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Cells to be sent to the owners of their vertices.
template <int d> class Placement
{
public:
  using Vertex = Piece_vertex<d>;
  using Cell = Sent_cell<d>;

  // Adds cells and their vertices, whose owners are the new ones.
  void add(const std::vector<Vertex>& vertices, const std::vector<Cell>& cells) {
    std::unordered_map<Global_id, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
      numbers.emplace(vertices[i].id, i);
    std::map<int, std::pair<std::vector<std::uint32_t>, std::vector<Cell>>> pieces;
    for (const Cell& c : cells) {
      std::vector<int> ranks;
      for (Global_id id : c.vertices) {
        const auto it = numbers.find(id);
        if (it == numbers.end())
          throw Error("a cell has a vertex that is missing: the data is damaged");
        ranks.push_back(vertices[it->second].owner);
      }
      std::sort(ranks.begin(), ranks.end());
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
      for (int rank : ranks) {
        for (Global_id id : c.vertices)
          pieces[rank].first.push_back(numbers.at(id));
        pieces[rank].second.push_back(c);
      }
    }
    for (auto& [rank, piece] : pieces) {
      std::sort(piece.first.begin(), piece.first.end());
      piece.first.erase(std::unique(piece.first.begin(), piece.first.end()), piece.first.end());
      std::vector<Vertex> list;
      for (std::uint32_t i : piece.first)
        list.push_back(vertices[i]);
      m_writers[rank].write(list);
      m_writers[rank].write(piece.second);
    }
  }

  // Sends the cells, and adds those that arrive to a piece. Collective.
  void send(Communicator& communicator, Piece<d>& piece) {
    exchange_messages(communicator, m_writers, [&](int, Message_reader& reader) {
      for (const Vertex& v : reader.read_list<Vertex>())
        piece.put(v);
      for (const Cell& c : reader.read_list<Cell>())
        piece.put(c);
    });
  }

private:
  std::map<int, Message_writer> m_writers;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PLACEMENT_H
