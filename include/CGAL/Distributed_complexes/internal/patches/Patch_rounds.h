// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_ROUNDS_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_ROUNDS_H

#include <CGAL/Distributed_complexes/internal/patches/Patch.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
Improves the active cells of a distributed complex in rounds. In a round, each cube of space that
contains active cells proposes a patch: these cells and two rings of cells around them. Among
patches that overlap, the one with the largest key wins. Each winner is gathered on one rank,
improved there, and put back on all ranks that hold its cells. The keys and the patches depend on
the complex only. So the result does not depend on the number of ranks or on the partition.
*/
template <class Complex> class Patch_rounds
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;

  // `treat` treats a patch. `places` receives the places of changes of topology on this rank in the
  // pass `pass`.
  Patch_rounds(Mesh& mesh, Patch_treatment<Complex> treat, std::uint32_t pass,
               std::vector<Topology_place<d>>& places)
      : m_mesh(mesh), m_treat(std::move(treat)), m_pass(pass), m_places(places) {}

  // Runs until no cell is active. Returns the numbers of operations of all ranks.
  // Throws Error on all ranks if a patch of one of them throws.
  Distributed_counts run() {
    while (propose()) {
      ++m_counts.rounds;
      find_winners();
      std::map<Patch_key, Patch<Complex>> patches = gather();
      m_mesh.communicator->call_together([&] {
        for (auto& [key, patch] : patches)
          m_counts += patch.run(m_mesh, m_treat, m_pass, m_places);
      });
      number_vertices(patches);
      commit(patches);
    }
    return totals();
  }

private:
  using Operation = Communicator::Operation;
  using Cell_ids = typename Piece<d>::Cell_ids;

  static constexpr int rings = 1;             // around the vertices of active cells
  static constexpr int reach = 2 * rings + 1; // smallest distance without overlap, minus 1

  struct Active_cell
  {
    Index cell;
    Patch_key key;
  };

  // Finds the active cells. Patches deactivate cells and activate none, so after the first round
  // only the cells of the last round can be active.
  void find_active_cells() {
    std::vector<Index> cells;
    if (m_counts.rounds == 0) {
      for (Index c = 0; c < m_mesh.piece.cell_bound(); ++c)
        cells.push_back(c);
    } else {
      for (const Active_cell& active : m_active)
        cells.push_back(active.cell);
    }
    m_active.clear();
    for (Index c : cells) {
      if (!m_mesh.piece.has_cell(c) || !m_mesh.piece.cell(c).data.is_active)
        continue;
      std::array<typename Complex::Point, d + 1> p;
      for (int i = 0; i <= d; ++i)
        p[i] = m_mesh.position(m_mesh.piece.cell(c).vertices[i]);
      m_active.push_back({c, patch_key<Complex>(p, m_mesh.mean_interface_edge)});
    }
  }

  // Finds the active cells, and for each vertex the largest key of the patches whose active cells
  // are within `rings` and within `reach`. Returns whether there is an active cell on any rank.
  bool propose() {
    find_active_cells();
    if (m_mesh.communicator->reduced(Operation::maximum, !m_active.empty()) == 0)
      return false;
    const Index n = m_mesh.piece.vertex_bound();
    m_near.assign(n, 0);
    m_far.assign(n, 0);
    m_raised.assign(n, 0);
    m_is_touched.assign(n, 0);
    m_touched.clear();
    std::vector<Index> changed;
    for (const Active_cell& active : m_active)
      for (Index v : m_mesh.piece.cell(active.cell).vertices)
        if (m_far[v] < active.key) {
          m_far[v] = active.key;
          changed.push_back(v);
        }
    // A ghost can have active cells that only other ranks hold.
    m_mesh.ghosts.update(m_far, [&](Index v) { changed.push_back(v); });
    touch(changed);
    for (int step = 1; step <= reach; ++step) {
      spread(changed);
      touch(changed);
      if (step == rings)
        for (Index v : m_touched)
          m_near[v] = m_far[v];
    }
    return true;
  }

  // Appends vertices to the vertices with a key, each once.
  void touch(const std::vector<Index>& vertices) {
    for (Index v : vertices)
      if (!m_is_touched[v]) {
        m_is_touched[v] = 1;
        m_touched.push_back(v);
      }
  }

  // Raises the key of each vertex to the largest key of its neighbors. `changed` are the vertices
  // with keys that the last call raised; they are replaced.
  void spread(std::vector<Index>& changed) {
    std::vector<Index> raised;
    for (Index v : changed)
      m_mesh.for_each_neighbor(v, [&](Index w) {
        if (m_far[w] < m_far[v] && m_raised[w] < m_far[v]) {
          if (m_raised[w] == 0)
            raised.push_back(w);
          m_raised[w] = m_far[v];
        }
      });
    for (Index v : raised) {
      m_far[v] = m_raised[v];
      m_raised[v] = 0;
    }
    changed.swap(raised);
    m_mesh.ghosts.update(m_far, [&](Index v) { changed.push_back(v); });
  }

  // A rank that holds a part of a patch, as sent to the rank that decides about the patch.
  struct Share
  {
    Patch_key key;
    std::uint64_t loses;        // whether a vertex is within the reach of a larger key
    std::uint64_t active_cells; // number of active cells that the rank owns
  };
  struct Verdict
  {
    Patch_key key;
    std::int64_t rank; // that improves the patch; -1 if it loses
  };

  // Determines the winners, and the ranks that improve them. About each patch, one rank decides:
  // the rank that the key determines.
  void find_winners() {
    std::map<Patch_key, Share> shares;
    const auto share = [&](Patch_key key) -> Share& {
      return shares.emplace(key, Share{key, 0, 0}).first->second;
    };
    for (const Active_cell& active : m_active) {
      Share& s = share(active.key);
      s.active_cells += m_mesh.is_own_cell(active.cell);
      for (Index v : m_mesh.piece.cell(active.cell).vertices)
        if (m_mesh.is_own(v) && m_far[v] != active.key)
          s.loses = 1;
    }
    for (Index v : m_touched)
      if (m_near[v] != 0)
        share(m_near[v]);
    const int size = m_mesh.communicator->size();
    std::map<int, std::vector<Share>> questions;
    for (const auto& [key, s] : shares)
      questions[int(key % unsigned(size))].push_back(s);
    struct Decision
    {
      bool loses = false;
      std::uint64_t most = 0; // active cells
      int rank = -1;
    };
    std::unordered_map<Patch_key, Decision> decisions;
    std::map<int, std::vector<Patch_key>> asked;
    exchange_lists(*m_mesh.communicator, questions, [&](int rank, const std::vector<Share>& list) {
      for (const Share& s : list) {
        Decision& decision = decisions[s.key];
        decision.loses = decision.loses || s.loses != 0;
        if (s.active_cells > decision.most) {
          decision.most = s.active_cells;
          decision.rank = rank;
        }
        asked[rank].push_back(s.key);
      }
    });
    std::map<int, std::vector<Verdict>> answers;
    for (const auto& [rank, keys] : asked)
      for (Patch_key key : keys)
        answers[rank].push_back({key, decisions[key].loses ? -1 : decisions[key].rank});
    m_winners.clear();
    exchange_lists(*m_mesh.communicator, answers, [&](int, const std::vector<Verdict>& verdicts) {
      for (const Verdict& v : verdicts)
        if (v.rank >= 0)
          m_winners[v.key] = int(v.rank);
    });
  }

  // Returns the key of the winner that a vertex is inside; 0 if there is none.
  Patch_key winner_of(Index v) const {
    return m_near[v] != 0 && m_winners.count(m_near[v]) != 0 ? m_near[v] : 0;
  }

  // Sends the cells of the winners to the ranks that improve them.
  std::map<Patch_key, Patch<Complex>> gather() {
    using Patch_vertex = typename Patch<Complex>::Patch_vertex;
    std::map<Patch_key, std::vector<Index>> cells;
    for (Index v : m_touched)
      if (const Patch_key key = winner_of(v))
        for (Index c : m_mesh.piece.star(v))
          if (m_mesh.is_own_cell(c))
            cells[key].push_back(c);
    std::map<int, Message_writer> writers;
    std::vector<Index> vertices;
    for (auto& [key, list] : cells) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      vertices.clear();
      std::vector<Sent_cell<d>> sent_cells;
      for (Index c : list) {
        sent_cells.push_back(m_mesh.piece.sent(c));
        vertices.insert(vertices.end(), m_mesh.piece.cell(c).vertices.begin(),
                        m_mesh.piece.cell(c).vertices.end());
      }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      std::vector<Patch_vertex> sent_vertices;
      for (Index v : vertices)
        sent_vertices.push_back({m_mesh.piece.vertex(v), winner_of(v) == key});
      Message_writer& writer = writers[m_winners.at(key)];
      writer.write(key);
      writer.write(sent_vertices);
      writer.write(sent_cells);
    }
    std::map<Patch_key, Patch<Complex>> patches;
    exchange_messages(*m_mesh.communicator, writers, [&](int, Message_reader& reader) {
      const Patch_key key = reader.read<Patch_key>();
      const auto sent_vertices = reader.read_list<Patch_vertex>();
      const auto sent_cells = reader.read_list<Sent_cell<d>>();
      patches.emplace(key, Patch<Complex>(key)).first->second.add(sent_vertices, sent_cells);
    });
    return patches;
  }

  // Gives the new vertices of all ranks ids that increase with the keys of their patches.
  void number_vertices(std::map<Patch_key, Patch<Complex>>& patches) {
    struct Number
    {
      Patch_key key;
      std::uint64_t number; // of new vertices
    };
    std::vector<Number> numbers;
    for (const auto& [key, patch] : patches)
      if (patch.number_of_new() > 0)
        numbers.push_back({key, patch.number_of_new()});
    numbers = gather_items(*m_mesh.communicator, numbers);
    std::sort(numbers.begin(), numbers.end(),
              [](const Number& a, const Number& b) { return a.key < b.key; });
    for (const auto& [key, number] : numbers) {
      const auto patch = patches.find(key);
      if (patch != patches.end())
        patch->second.number(m_mesh.next_id);
      m_mesh.next_id += number;
    }
  }

  static bool are_equal(const Piece_vertex<d>& a, const Piece_vertex<d>& b) {
    return std::memcmp(&a, &b, sizeof(a)) == 0;
  }

  // Puts the patches back on all ranks that hold their cells.
  void commit(const std::map<Patch_key, Patch<Complex>>& patches) {
    std::map<int, Message_writer> writers;
    for (const auto& [key, patch] : patches) {
      std::set<int> ranks;
      for (const auto& v : patch.vertices_before())
        ranks.insert(v.data.owner);
      for (int rank : ranks)
        write_changes(patch, rank, writers[rank]);
    }
    exchange_messages(*m_mesh.communicator, writers, [&](int, Message_reader& reader) {
      const auto removed = reader.read_list<Cell_ids>();
      for (const Cell_ids& ids : removed)
        m_mesh.piece.remove(m_mesh.piece.find_cell(ids));
      for (const auto& v : reader.read_list<Piece_vertex<d>>())
        m_mesh.piece.put(v);
      for (const auto& c : reader.read_list<Sent_cell<d>>())
        m_mesh.piece.put(c);
      for (const Cell_ids& ids : removed)
        for (Global_id id : ids)
          m_mesh.piece.remove_if_unused(id);
    });
    m_mesh.find_ghosts();
  }

  // Writes the changes of a patch that concern a rank: of cells with a vertex that the rank owns.
  void write_changes(const Patch<Complex>& patch, int rank, Message_writer& writer) const {
    std::vector<Cell_ids> removed;
    std::vector<Sent_cell<d>> put;
    std::vector<Global_id> needed; // vertices
    const auto& old_cells = patch.cells_before();
    const auto& new_cells = patch.cells_after();
    std::size_t i = 0, k = 0;
    while (i < old_cells.size() || k < new_cells.size()) {
      const bool is_removed = k == new_cells.size() ||
                              (i < old_cells.size() && less_vertices(old_cells[i], new_cells[k]));
      if (is_removed) {
        const Cell_ids& ids = old_cells[i].vertices;
        if (std::any_of(ids.begin(), ids.end(),
                        [&](Global_id id) { return patch.before(id).owner == rank; }))
          removed.push_back(ids);
        ++i;
        continue;
      }
      const Sent_cell<d>& c = new_cells[k];
      const bool is_kept = i < old_cells.size() && old_cells[i].vertices == c.vertices;
      if (std::any_of(c.vertices.begin(), c.vertices.end(),
                      [&](Global_id id) { return patch.after(id).owner == rank; })) {
        if (!is_kept || !(old_cells[i].data == c.data)) {
          put.push_back(c);
          needed.insert(needed.end(), c.vertices.begin(), c.vertices.end());
        } else {
          for (Global_id id : c.vertices)
            if (!are_equal(patch.before(id), patch.after(id)))
              needed.push_back(id);
        }
      }
      i += is_kept;
      ++k;
    }
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    std::vector<Piece_vertex<d>> vertices;
    for (Global_id id : needed)
      vertices.push_back(patch.after(id));
    writer.write(removed);
    writer.write(vertices);
    writer.write(put);
  }

  // Returns the sums of the numbers of all ranks.
  Distributed_counts totals() const {
    Distributed_counts result;
    std::vector<std::int64_t> numbers;
    for (const auto member : Distributed_counts::sums())
      numbers.push_back(m_counts.*member);
    m_mesh.communicator->reduce(Operation::sum, numbers);
    auto next = numbers.begin();
    for (const auto member : Distributed_counts::sums())
      result.*member = *next++;
    result.rounds = m_counts.rounds;
    return result;
  }

  Mesh& m_mesh;
  Patch_treatment<Complex> m_treat;
  std::uint32_t m_pass;
  std::vector<Topology_place<d>>& m_places;
  std::vector<Active_cell> m_active;
  std::vector<Patch_key> m_near, m_far;   // by vertex; 0 if no patch is near
  std::vector<Patch_key> m_raised;        // keys that `spread()` is about to give; 0 outside it
  std::vector<Index> m_touched;           // vertices with a key
  std::vector<std::uint8_t> m_is_touched; // by vertex
  std::map<Patch_key, int> m_winners;     // known to this rank, and the ranks that improve them
  Distributed_counts m_counts;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_PATCHES_PATCH_ROUNDS_H
