// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PIECE_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PIECE_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/assemble_triangulation.h>
#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>

#include <tuple>
#include <unordered_map>

namespace CGAL::Deformable_simplicial_complexes::internal {

using Global_id = std::uint64_t;

// Returns the indices below a bound for which a condition holds, in increasing order.
template <class Condition> auto indices_where(std::uint32_t bound, const Condition& condition) {
  const boost::counting_iterator<std::uint32_t> begin(0), end(bound);
  return make_range(boost::make_filter_iterator(condition, begin, end),
                    boost::make_filter_iterator(condition, end, end));
}

// Mixes the bits of a number (the finalizer of SplitMix64).
inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// The data of a vertex, as stored and sent.
template <int d> struct Piece_vertex
{
  Global_id id;
  std::array<double, d> point;
  std::array<double, d> before;      // position before the motion, if `has_motion`
  std::array<double, d> destination; // if `has_motion`
  double target_length;              // of interface edges, while the interface is adapted
  float spacing;
  float work;         // recent improvements of the cells around the vertex
  std::int32_t owner; // rank
  std::uint8_t boundary_class;
  std::uint8_t has_motion; // whether the motion under way gave the vertex a destination
  std::uint8_t is_open;    // whether the destination can still be reached
  std::uint8_t padding;    // so that equal vertices have equal bytes

  // Returns references to the members, for checkpoints.
  template <class Vertex> static auto members(Vertex& v) {
    return std::tie(v.id, v.point, v.before, v.destination, v.target_length, v.spacing, v.work,
                    v.owner, v.boundary_class, v.has_motion, v.is_open);
  }

  void end_motion() {
    has_motion = is_open = 0;
    before = destination = {};
  }
};

// Everything that belongs to a cell except its vertices.
struct Piece_cell_data
{
  Global_id component;
  std::int32_t label;
  float noted_quality;
  std::uint8_t failures;
  std::uint8_t is_active; // whether the pass under way still has to improve the cell
  std::uint8_t padding[6];

  // Returns references to the members, for checkpoints.
  template <class Data> static auto members(Data& data) {
    return std::tie(data.component, data.label, data.noted_quality, data.failures, data.is_active);
  }
};

inline bool operator==(const Piece_cell_data& a, const Piece_cell_data& b) {
  return Piece_cell_data::members(a) == Piece_cell_data::members(b);
}

// A cell as it is sent. The vertices are increasing, except that the last two are exchanged if the
// cell would otherwise be negatively oriented. The vertices are thus the same on all ranks.
template <int d> struct Sent_cell
{
  std::array<Global_id, d + 1> vertices;
  Piece_cell_data data;

  template <class Cell> static auto members(Cell& c) { return std::tie(c.vertices, c.data); }
};

template <int d> bool less_vertices(const Sent_cell<d>& a, const Sent_cell<d>& b) {
  return a.vertices < b.vertices;
}

// Sorts the vertices of a positively oriented cell as `Sent_cell` does.
template <std::size_t corners>
std::array<Global_id, corners> canonical_cell(std::array<Global_id, corners> vertices) {
  if (!sort_vertices(vertices))
    std::swap(vertices[corners - 2], vertices[corners - 1]);
  return vertices;
}

template <std::size_t corners> std::uint64_t hash_of(const std::array<Global_id, corners>& ids) {
  std::uint64_t result = 0;
  for (Global_id id : ids)
    result = mixed(result ^ id);
  return result;
}

/*
The piece of a complex that a rank holds: all cells around its own vertices. A cell is owned by the
rank of its first vertex. Vertices and cells have indices, which are used again after a removal.
*/
template <int d> class Piece
{
public:
  using Index = std::uint32_t;
  using Vertex = Piece_vertex<d>;
  using Cell_ids = std::array<Global_id, d + 1>;
  static constexpr int corners = d + 1;
  static constexpr Index none = Index(-1);

  struct Cell
  {
    std::array<Index, corners> vertices; // in the order of `Sent_cell`; none if it was removed
    Piece_cell_data data;
  };

  // Bounds of the indices.
  Index vertex_bound() const { return Index(m_vertices.size()); }
  Index cell_bound() const { return Index(m_cells.size()); }
  bool has_vertex(Index v) const { return !m_stars[v].empty(); }
  bool has_cell(Index c) const { return m_cells[c].vertices[0] != none; }
  // The indices of all vertices and of all cells.
  auto vertices() const {
    return indices_where(vertex_bound(), [this](Index v) { return has_vertex(v); });
  }
  auto cells() const {
    return indices_where(cell_bound(), [this](Index c) { return has_cell(c); });
  }

  Vertex& vertex(Index v) { return m_vertices[v]; }
  const Vertex& vertex(Index v) const { return m_vertices[v]; }
  Cell& cell(Index c) { return m_cells[c]; }
  const Cell& cell(Index c) const { return m_cells[c]; }
  int owner(Index c) const { return m_vertices[m_cells[c].vertices[0]].owner; }

  Cell_ids ids(Index c) const {
    Cell_ids result;
    for (int i = 0; i < corners; ++i)
      result[i] = m_vertices[m_cells[c].vertices[i]].id;
    return result;
  }
  Sent_cell<d> sent(Index c) const { return {ids(c), m_cells[c].data}; }

  // Returns the cells around a vertex, ordered by the ids of their vertices.
  const std::vector<Index>& star(Index v) const { return m_stars[v]; }

  Index find(Global_id id) const {
    const auto it = m_index.find(id);
    return it == m_index.end() ? none : it->second;
  }

  Index find_cell(const Cell_ids& ids) const {
    const Index v = find(ids[0]);
    if (v == none)
      return none;
    const auto it = position(v, ids);
    return it != m_stars[v].end() && this->ids(*it) == ids ? *it : none;
  }

  // Adds a vertex, or replaces the data of a vertex that is already there. A new vertex needs a
  // cell before it counts.
  Index put(const Vertex& vertex) {
    const auto [it, is_new] = m_index.emplace(vertex.id, none);
    if (is_new) {
      if (m_free_vertices.empty()) {
        it->second = Index(m_vertices.size());
        m_vertices.emplace_back();
        m_stars.emplace_back();
      } else {
        it->second = m_free_vertices.back();
        m_free_vertices.pop_back();
      }
    }
    m_vertices[it->second] = vertex;
    return it->second;
  }

  // Adds a cell, or replaces the data of a cell that is already there.
  // \pre The vertices were added.
  Index put(const Sent_cell<d>& cell) {
    if (const Index known = find_cell(cell.vertices); known != none) {
      m_cells[known].data = cell.data;
      return known;
    }
    Index c;
    if (m_free_cells.empty()) {
      c = Index(m_cells.size());
      if (c == none)
        throw Error("a rank holds 2^32 - 1 cells: use more ranks");
      m_cells.emplace_back();
    } else {
      c = m_free_cells.back();
      m_free_cells.pop_back();
    }
    for (int i = 0; i < corners; ++i)
      m_cells[c].vertices[i] = m_index.at(cell.vertices[i]);
    m_cells[c].data = cell.data;
    for (Index v : m_cells[c].vertices)
      m_stars[v].insert(position(v, cell.vertices), c);
    return c;
  }

  // Removes a cell. Vertices without cells stay until `remove_unused()` is called for them.
  void remove(Index c) {
    const Cell_ids ids = this->ids(c);
    for (Index v : m_cells[c].vertices)
      m_stars[v].erase(position(v, ids));
    m_cells[c].vertices.fill(none);
    m_free_cells.push_back(c);
  }

  // Removes a vertex if no cell has it.
  void remove_if_unused(Global_id id) {
    const auto it = m_index.find(id);
    if (it == m_index.end() || has_vertex(it->second))
      return;
    std::vector<Index>().swap(m_stars[it->second]);
    m_free_vertices.push_back(it->second);
    m_index.erase(it);
  }

  // Returns whether the cells around a vertex have several labels. For vertices of other ranks,
  // cells can be missing.
  bool has_several_labels(Index v) const {
    const std::vector<Index>& cells = m_stars[v];
    return std::any_of(cells.begin(), cells.end(), [&](Index c) {
      return m_cells[c].data.label != m_cells[cells.front()].data.label;
    });
  }

  // Returns whether the cells around an edge have several labels.
  // \pre This rank owns an end of the edge.
  bool has_several_labels(Index v, Index w) const {
    Index first = none;
    for (Index c : m_stars[v]) {
      const auto& vertices = m_cells[c].vertices;
      if (std::find(vertices.begin(), vertices.end(), w) == vertices.end())
        continue;
      if (first == none)
        first = c;
      if (m_cells[c].data.label != m_cells[first].data.label)
        return true;
    }
    return false;
  }

  // Returns whether a cell has all of the vertices of another cell except the vertex `opposite`.
  bool has_facet(Index c, const std::array<Index, corners>& vertices, int opposite) const {
    const auto& own = m_cells[c].vertices;
    for (int i = 0; i < corners; ++i)
      if (i != opposite && std::find(own.begin(), own.end(), vertices[i]) == own.end())
        return false;
    return true;
  }

  // Returns the bytes that the piece occupies, about.
  std::size_t memory() const {
    std::size_t result = m_vertices.capacity() * (sizeof(Vertex) + sizeof(std::vector<Index>)) +
                         m_cells.capacity() * sizeof(Cell) +
                         m_index.size() * (sizeof(std::pair<Global_id, Index>) + 3 * sizeof(void*));
    for (const auto& star : m_stars)
      result += star.capacity() * sizeof(Index);
    return result;
  }

private:
  // Returns the place of a cell in the ordered star of a vertex.
  typename std::vector<Index>::iterator position(Index v, const Cell_ids& ids) {
    return std::lower_bound(m_stars[v].begin(), m_stars[v].end(), ids,
                            [&](Index c, const Cell_ids& key) { return this->ids(c) < key; });
  }
  typename std::vector<Index>::const_iterator position(Index v, const Cell_ids& ids) const {
    return const_cast<Piece*>(this)->position(v, ids);
  }

  std::vector<Vertex> m_vertices;
  std::vector<std::vector<Index>> m_stars; // empty for indices that are not used
  std::vector<Cell> m_cells;
  std::unordered_map<Global_id, Index> m_index;
  std::vector<Index> m_free_vertices, m_free_cells;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_PIECE_H
