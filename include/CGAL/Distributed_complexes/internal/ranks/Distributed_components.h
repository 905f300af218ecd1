// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_COMPONENTS_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_COMPONENTS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/bookkeeping/Label_totals.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The connected components of the labels of a distributed complex. Each rank finds the components of
the cells that it holds. Cells that several ranks hold connect components of different ranks. All
ranks then unite the components in the same way, which needs memory for the components of all ranks.
*/
template <class Complex> class Distributed_components
{
public:
  static constexpr int d = Complex::dimension;
  using Mesh = Distributed_mesh<Complex>;
  using Index = typename Mesh::Index;

  explicit Distributed_components(Mesh& mesh)
      : m_mesh(mesh), m_totals(mesh.domain_measure), m_sets(mesh.piece.cell_bound()) {}

  // Numbers the components. A component keeps its number. A merged component gets the least number
  // of its parts that is still free. If a component is split, the part with the least hash of a
  // cell keeps the number. Cells with the number 0 are new. Replaces the components of the mesh.
  // Returns the changes.
  std::vector<Component_event> update() {
    unite_neighbors();
    describe_own_components();
    connect_ranks();
    unite_ranks();
    return name_components(m_mesh.components);
  }

private:
  // A component of the own cells of a rank.
  struct Share
  {
    std::uint64_t least; // hash of a cell: the least one of the component
    std::int64_t volume;
    std::int32_t label;
    std::uint32_t number; // on its rank
  };
  struct Origin // a component before the change that has cells in a share
  {
    std::uint32_t number, component;
  };
  struct Link // two components of two ranks that share a cell
  {
    std::int32_t rank, other_rank;
    std::uint32_t number, other_number;
  };
  struct Shared_cell
  {
    typename Piece<d>::Cell_ids ids;
    std::uint32_t number;
  };

  // Unites the cells that the rank holds with their neighbors of the same label.
  void unite_neighbors() {
    const auto& piece = m_mesh.piece;
    for (Index c : piece.cells()) {
      const auto& vertices = piece.cell(c).vertices;
      for (int i = 0; i <= d; ++i) {
        const Index corner = vertices[(i + 1) % (d + 1)];
        for (Index n : piece.star(corner))
          if (n < c && piece.cell(n).data.label == piece.cell(c).data.label &&
              piece.has_facet(n, vertices, i))
            m_sets.join(n, c);
      }
    }
  }

  void describe_own_components() {
    const auto& piece = m_mesh.piece;
    m_number_of.assign(piece.cell_bound(), 0);
    std::set<std::pair<std::uint32_t, std::uint32_t>> origins;
    for (Index c : piece.cells()) {
      const auto root = m_sets.find(c);
      if (root == c) { // the least cell of a set comes first
        m_number_of[c] = std::uint32_t(m_shares.size());
        m_shares.push_back(
            {std::uint64_t(-1), 0, piece.cell(c).data.label, std::uint32_t(m_shares.size())});
      }
      m_number_of[c] = m_number_of[root];
      if (piece.owner(c) != m_mesh.rank())
        continue;
      Share& share = m_shares[m_number_of[c]];
      share.least = (std::min)(share.least, hash_of(piece.ids(c)));
      share.volume += m_totals.units(m_mesh.measure(c));
      if (piece.cell(c).data.component != 0)
        origins.emplace(share.number, std::uint32_t(piece.cell(c).data.component));
    }
    for (const auto& [number, component] : origins)
      m_origins.push_back({number, component});
  }

  // Finds the links between own components and components of other ranks.
  void connect_ranks() {
    const auto& piece = m_mesh.piece;
    std::map<int, std::vector<Shared_cell>> lists;
    for (Index c : piece.cells())
      if (piece.owner(c) != m_mesh.rank())
        lists[piece.owner(c)].push_back({piece.ids(c), m_number_of[c]});
    std::set<std::array<std::uint32_t, 3>> links; // rank, number there, number here
    exchange_lists(*m_mesh.communicator, lists,
                   [&](int rank, const std::vector<Shared_cell>& cells) {
                     for (const Shared_cell& cell : cells)
                       links.insert({std::uint32_t(rank), cell.number,
                                     m_number_of[piece.find_cell(cell.ids)]});
                   });
    for (const auto& [rank, there, here] : links)
      m_links.push_back({m_mesh.rank(), std::int32_t(rank), here, there});
  }

  // Gathers the components of all ranks, and unites them.
  void unite_ranks() {
    Message_writer writer;
    writer.write(m_shares);
    writer.write(m_origins);
    writer.write(m_links);
    const auto all = m_mesh.communicator->all_gather(writer.take());
    std::vector<std::size_t> first(1, 0); // number of the first component of each rank
    std::vector<Share> shares;
    std::vector<Origin> origins;
    std::vector<Link> links;
    for (const auto& bytes : all) {
      Message_reader reader(bytes);
      const auto some_shares = reader.template read_list<Share>();
      shares.insert(shares.end(), some_shares.begin(), some_shares.end());
      for (Origin origin : reader.template read_list<Origin>()) {
        origin.number += std::uint32_t(first.back());
        origins.push_back(origin);
      }
      const auto some_links = reader.template read_list<Link>();
      links.insert(links.end(), some_links.begin(), some_links.end());
      first.push_back(shares.size());
    }
    Disjoint_sets sets(shares.size());
    for (const Link& link : links)
      sets.join(first[link.rank] + link.number, first[link.other_rank] + link.other_number);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      Whole& whole = m_wholes[sets.find(i)];
      whole.label = shares[i].label;
      whole.least = (std::min)(whole.least, shares[i].least);
      whole.volume += shares[i].volume;
    }
    for (const Origin& origin : origins)
      m_wholes[sets.find(origin.number)].origins.insert(origin.component);
    for (std::size_t i = 0; i < m_shares.size(); ++i)
      m_whole_of_share.push_back(sets.find(first[m_mesh.rank()] + i));
  }

  // Gives the components their numbers, and finds the events.
  std::vector<Component_event> name_components(Known_components& known) {
    // Events and numbers follow the least cells, which do not depend on the ranks.
    std::vector<Whole*> order;
    for (auto& [set, whole] : m_wholes)
      order.push_back(&whole);
    std::sort(order.begin(), order.end(),
              [](const Whole* a, const Whole* b) { return a->least < b->least; });
    std::map<std::uint32_t, std::vector<Whole*>> successors;
    std::uint32_t next = known.empty() ? 1 : known.rbegin()->first + 1;
    for (Whole* whole : order) {
      for (std::uint32_t origin : whole->origins)
        successors[origin].push_back(whole);
      for (std::uint32_t origin : whole->origins)
        if (whole->number == 0 && successors[origin].size() == 1)
          whole->number = origin;
      if (whole->number == 0)
        whole->number = next++;
    }
    std::vector<Component_event> events;
    const auto before = [&](std::uint32_t number) -> Component_event::Component {
      const auto it = known.find(number);
      return {number, it == known.end() ? 0 : m_totals.volume_of(it->second.volume)};
    };
    const auto after = [&](const Whole& whole) -> Component_event::Component {
      return {whole.number, m_totals.volume_of(whole.volume)};
    };
    using Kind = Component_event::Kind;
    for (const Whole* whole : order) {
      if (whole->origins.size() > 1) {
        events.push_back({Kind::merged, whole->label, {}, {after(*whole)}});
        for (std::uint32_t origin : whole->origins)
          events.back().before.push_back(before(origin));
      } else if (whole->origins.empty() && !known.empty()) {
        events.push_back({Kind::appeared, whole->label, {}, {after(*whole)}});
      }
    }
    for (const auto& [number, component] : known) {
      const auto it = successors.find(number);
      if (it == successors.end()) {
        events.push_back({Kind::vanished, component.label, {before(number)}, {}});
      } else if (it->second.size() > 1) {
        events.push_back({Kind::split, component.label, {before(number)}, {}});
        for (const Whole* whole : it->second)
          events.back().after.push_back(after(*whole));
      }
    }
    known.clear();
    for (const Whole* whole : order)
      known[whole->number] = {whole->label, whole->volume};
    for (Index c : m_mesh.piece.cells())
      m_mesh.piece.cell(c).data.component = m_wholes[m_whole_of_share[m_number_of[c]]].number;
    return events;
  }

  // A component of the complex.
  struct Whole
  {
    int label = 0;
    std::uint64_t least = std::uint64_t(-1);
    std::int64_t volume = 0;
    std::set<std::uint32_t> origins; // components before
    std::uint32_t number = 0;
  };

  Mesh& m_mesh;
  Label_totals m_totals;                  // defines the unit of volumes
  Disjoint_sets m_sets;                   // of held cells
  std::vector<std::uint32_t> m_number_of; // component of each held cell, on this rank
  std::vector<Share> m_shares;
  std::vector<Origin> m_origins;
  std::vector<Link> m_links;
  std::map<std::size_t, Whole> m_wholes; // by their sets
  std::vector<std::size_t> m_whole_of_share;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_COMPONENTS_H
