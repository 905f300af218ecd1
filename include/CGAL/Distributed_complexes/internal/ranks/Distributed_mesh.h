// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_MESH_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_MESH_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/apply_to_corners.h>
#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/internal/ranks/Exact_sums.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

#include <CGAL/enum.h>

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
    for (Index v : piece.vertices()) {
      if (piece.vertex(v).owner == me)
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
  // index of a vertex: a trivially copyable one, or a point or a vector. Calls `changed(v)` for
  // each ghost whose value changed.
  template <class Value, class Changed>
  void update(std::vector<Value>& values, const Changed& changed) const {
    static constexpr bool is_plain = std::is_trivially_copyable<Value>::value;
    using Plain = std::conditional_t<is_plain, Value, std::array<double, d>>;
    const auto plain = [](const Value& value) -> Plain {
      if constexpr (is_plain)
        return value;
      else
        return coordinates_of<d>(value);
    };
    std::map<int, std::vector<Plain>> lists;
    for (const auto& [rank, vertices] : m_shared)
      for (Index v : vertices)
        lists[rank].push_back(plain(values[v]));
    exchange_lists(*m_communicator, lists, [&](int rank, const std::vector<Plain>& list) {
      const std::vector<Index>& ghosts = m_ghosts.at(rank);
      for (std::size_t i = 0; i < list.size(); ++i) {
        const Plain before = plain(values[ghosts[i]]);
        if (std::memcmp(&before, &list[i], sizeof(Plain)) == 0) // -0. differs from 0.
          continue;
        if constexpr (is_plain)
          values[ghosts[i]] = list[i];
        else
          values[ghosts[i]] = point_of<Value>(list[i]);
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

// A connected component of a label, known to all ranks.
struct Known_component
{
  int label;
  std::int64_t volume; // in the units of `Label_totals`
};
using Known_components = std::map<std::uint32_t, Known_component>; // by number

// Returns the box around the boxes of all ranks. The box of a rank may be empty.
template <int d> Extent<d> extent_of_ranks(Communicator& communicator, const Extent<d>& own) {
  std::vector<std::array<double, d>> corners;
  if (own.lower(0) <= own.upper(0)) {
    corners.resize(2);
    for (int axis = 0; axis < d; ++axis) {
      corners[0][axis] = own.lower(axis);
      corners[1][axis] = own.upper(axis);
    }
  }
  return extent_of<d>(gather_items(communicator, corners));
}

// What operations on a distributed complex change: the piece of this rank, and what all ranks know.
template <int d> struct Distributed_state
{
  Piece<d> piece;
  Known_components components;
  bool are_components_known = true; // false during a change, and after an exception in it
  double mean_interface_edge = 0, minimum_interface_edge = 0;
  Global_id next_id = 0; // of new vertices
};

// The state of a distributed complex, the communicator, and what stays: the geometry traits, and
// the size of the complex.
template <class Complex> struct Distributed_mesh : Distributed_state<Complex::dimension>
{
  static constexpr int d = Complex::dimension;
  static constexpr int corners = d + 1;
  using Index = typename Piece<d>::Index;
  using Position = typename Complex::Point;
  using Space = typename Complex::Space;
  using Distributed_state<d>::piece;
  using Distributed_state<d>::components;

  explicit Distributed_mesh(Communicator& communicator)
      : communicator(&communicator), ghosts(piece, communicator) {}

  int rank() const { return communicator->rank(); }
  bool is_own(Index v) const { return piece.has_vertex(v) && piece.vertex(v).owner == rank(); }
  bool is_own_cell(Index c) const { return piece.has_cell(c) && piece.owner(c) == rank(); }
  // The indices of the vertices and of the cells that this rank owns.
  auto own_vertices() const {
    return indices_where(piece.vertex_bound(), [this](Index v) { return is_own(v); });
  }
  auto own_cells() const {
    return indices_where(piece.cell_bound(), [this](Index c) { return is_own_cell(c); });
  }

  void clear() {
    piece = Piece<d>();
    components.clear();
    find_ghosts();
  }

  // Returns the work at a vertex: of a motion, and of recent improvements.
  std::int64_t weight(Index v) const {
    static constexpr double improvement = 10; // cost of an improvement; a motion costs 1
    return 1 + std::llrint(improvement * piece.vertex(v).work);
  }

  // Must be called after vertices and cells of the piece changed.
  void find_ghosts() { ghosts = Ghosts<d>(piece, *communicator); }

  Position position(Index v) const { return point_at<Complex>(piece.vertex(v).point); }

  // In the functions of cells, `position(v)` returns positions of vertices.

  template <class Position_of> double quality(Index c, const Position_of& position) const {
    return apply_to_corners<corners>(
        quality_measure, [&](int i) -> Position { return position(piece.cell(c).vertices[i]); });
  }
  double quality(Index c) const {
    return quality(c, [this](Index v) { return position(v); });
  }

  // Returns whether a cell is positively oriented, decided exactly.
  template <class Position_of> bool is_positive(Index c, const Position_of& position) const {
    return apply_to_corners<corners>(Space::orientation(traits), [&](int i) {
             return position(piece.cell(c).vertices[i]);
           }) == POSITIVE;
  }

  double measure(Index c) const {
    return apply_to_corners<corners>(Space::measure,
                                     [&](int i) { return position(piece.cell(c).vertices[i]); });
  }

  // Returns for each index whether the vertex is on the interface.
  std::vector<std::uint8_t> interface_flags() const {
    std::vector<std::uint8_t> result(piece.vertex_bound(), 0);
    for (Index v : own_vertices())
      result[v] = piece.has_several_labels(v);
    ghosts.update(result);
    return result;
  }

  // Returns for each vertex whether condition(v, w) holds for one of its edges. The owner of a
  // vertex decides, because it knows all cells around the edges.
  template <class Condition>
  std::vector<std::uint8_t> vertices_with_edge(const Condition& condition) const {
    std::vector<std::uint8_t> result(piece.vertex_bound(), 0);
    for (Index v : own_vertices())
      for_each_neighbor(v, [&](Index w) { result[v] = result[v] || condition(v, w); });
    ghosts.update(result);
    return result;
  }

  // Sets `is_active` of each cell: whether `condition(v, w)` holds for an edge of the cell.
  template <class Condition> void activate_cells_with_edge(const Condition& condition) {
    for (Index c : piece.cells()) {
      auto& cell = piece.cell(c);
      cell.data.is_active = false;
      for (int i = 0; i < corners; ++i)
        for (int j = 0; j < i; ++j)
          cell.data.is_active =
              cell.data.is_active || condition(cell.vertices[i], cell.vertices[j]);
    }
  }

  // Returns the box around all vertices of all ranks.
  Extent<d> extent() const {
    Extent<d> own;
    for (Index v : own_vertices())
      own.add(piece.vertex(v).point);
    return extent_of_ranks(*communicator, own);
  }

  // Calls f(w) for each neighbor w of a vertex; several times for most of them.
  template <class Function> void for_each_neighbor(Index v, const Function& f) const {
    for (Index c : piece.star(v))
      for (Index w : piece.cell(c).vertices)
        if (w != v)
          f(w);
  }

  Communicator* communicator;
  Ghosts<d> ghosts;
  typename Complex::Geom_traits traits;
  typename Complex::Quality_measure quality_measure;
  typename Complex::Normalization normalization;
  double domain_measure = 1; // of the box around the complex when it was built; unit of volumes
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_DISTRIBUTED_MESH_H
