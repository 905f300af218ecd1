// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CHORDAL_AXIS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CHORDAL_AXIS_2_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The neighbors of the nodes of a graph.
class Neighborhoods
{
public:
  explicit Neighborhoods(std::size_t size = 0) : m_neighbors(size) {}

  std::size_t size() const { return m_neighbors.size(); }
  const std::set<std::size_t>& operator[](std::size_t node) const { return m_neighbors[node]; }

  void add_node() { m_neighbors.emplace_back(); }

  void join(std::size_t a, std::size_t b) {
    if (a == b)
      return;
    m_neighbors[a].insert(b);
    m_neighbors[b].insert(a);
  }

  void part(std::size_t a, std::size_t b) {
    m_neighbors[a].erase(b);
    m_neighbors[b].erase(a);
  }

  // Leaves the node without neighbors.
  void remove(std::size_t node) {
    for (std::size_t neighbor : m_neighbors[node])
      m_neighbors[neighbor].erase(node);
    m_neighbors[node].clear();
  }

  // The neighbors of the node become those of another one.
  void merge(std::size_t node, std::size_t into) {
    const std::set<std::size_t> neighbors = m_neighbors[node];
    remove(node);
    for (std::size_t neighbor : neighbors)
      join(neighbor, into);
  }

  // From an end or a junction to the next one, by way of one of its neighbors.
  std::vector<std::size_t> chain(std::size_t from, std::size_t next) const {
    std::vector<std::size_t> result = {from, next};
    while (m_neighbors[result.back()].size() == 2 && result.back() != from) {
      const auto& both = m_neighbors[result.back()];
      const std::size_t last = result[result.size() - 2];
      result.push_back(*both.begin() == last ? *both.rbegin() : *both.begin());
    }
    return result;
  }

  // Takes away chains from an end to a junction that are short, until there are none.
  template <class Distance> void prune(const Distance& distance, double shortest) {
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (std::size_t end = 0; end < size(); ++end) {
        if (m_neighbors[end].size() != 1)
          continue;
        const auto spur = chain(end, *m_neighbors[end].begin());
        if (length_of(spur, distance) >= shortest || m_neighbors[spur.back()].size() < 3)
          continue;
        for (std::size_t i = 0; i + 1 < spur.size(); ++i)
          remove(spur[i]);
        has_changed = true;
      }
    }
  }

private:
  template <class Distance>
  static double length_of(const std::vector<std::size_t>& chain, const Distance& distance) {
    double length = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
      length += distance(chain[i - 1], chain[i]);
    return length;
  }

  std::vector<std::set<std::size_t>> m_neighbors;
};

/*
The axis of what a front has left, phase 0: a graph. Its nodes are rungs, edges inside between two
vertices of the front, and junctions, where three or more of these bound the same cells. (L. Prasad,
Morphological analysis of shapes, CNLS Newsletter 139, 1997.)
*/
template <class Front> class Chordal_axis_2
{
public:
  using Complex = typename Front::Complex;
  using Vertex_handle = typename Front::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;
  using Point = typename Front::Point_2;
  using Vector = typename Complex::Approximate_vector_2;

  struct Node
  {
    std::vector<Vertex_handle> front; // the vertices around: two for a rung
    Point position;
    bool is_rung() const { return front.size() == 2; }
  };

  explicit Chordal_axis_2(const Front& front) : m_complex(front.complex()) { connect(); }

  const std::vector<Node>& nodes() const { return m_nodes; }
  const Neighborhoods& neighborhoods() const { return m_neighborhoods; }

  // Of the axis at a rung: from one of its neighbors to the other, or across the rung.
  Vector direction(std::size_t i) const {
    const auto& neighbors = m_neighborhoods[i];
    if (neighbors.size() == 2) {
      const Point p = m_nodes[*neighbors.begin()].position;
      const Point q = m_complex.domain().near(p, m_nodes[*neighbors.rbegin()].position);
      if (p != q)
        return q - p;
    }
    const Vector rung = m_complex.displacement(m_nodes[i].front[0], m_nodes[i].front[1]);
    return Vector(-rung.y(), rung.x());
  }

private:
  bool is_left(Cell_handle c) const { return c->label() == 0; }

  std::array<Vertex_handle, 2> ends(Cell_handle c, int i) const {
    return {c->vertex((i + 1) % 3), c->vertex((i + 2) % 3)};
  }

  // Groups cells that share edges with a free end, and connects what bounds them.
  void connect() {
    std::set<std::size_t> done;
    for (Cell_handle seed : m_complex.cells()) {
      if (!is_left(seed) || !done.insert(seed->time_stamp()).second)
        continue;
      std::vector<Cell_handle> group(1, seed);
      std::vector<std::size_t> rungs;
      for (std::size_t k = 0; k < group.size(); ++k)
        for (int i = 0; i < 3; ++i) {
          const Cell_handle c = group[k], n = c->neighbor(i);
          const auto [v, w] = ends(c, i);
          if (!is_left(n))
            continue;
          if (v->is_interface() && w->is_interface())
            rungs.push_back(rung(v, w));
          else if (done.insert(n->time_stamp()).second)
            group.push_back(n);
        }
      if (rungs.size() == 2)
        m_neighborhoods.join(rungs[0], rungs[1]);
      else if (rungs.size() > 2)
        add_junction(rungs);
    }
  }

  std::size_t rung(Vertex_handle v, Vertex_handle w) {
    if (v->time_stamp() > w->time_stamp())
      std::swap(v, w);
    const auto [it, is_new] = m_rungs.insert({{v->time_stamp(), w->time_stamp()}, m_nodes.size()});
    if (is_new)
      add({{v, w}, m_complex.position(v) + m_complex.displacement(v, w) / 2});
    return it->second;
  }

  void add_junction(const std::vector<std::size_t>& rungs) {
    Node node;
    for (std::size_t r : rungs)
      for (Vertex_handle v : m_nodes[r].front)
        if (std::find(node.front.begin(), node.front.end(), v) == node.front.end())
          node.front.push_back(v);
    const Point p = m_complex.position(node.front[0]);
    auto sum = p - p;
    for (Vertex_handle v : node.front)
      sum = sum + (m_complex.position_near(p, v) - p);
    node.position = p + sum / double(node.front.size());
    add(node);
    for (std::size_t r : rungs)
      m_neighborhoods.join(r, m_nodes.size() - 1);
  }

  void add(const Node& node) {
    m_nodes.push_back(node);
    m_neighborhoods.add_node();
  }

  const Complex& m_complex;
  std::vector<Node> m_nodes;
  Neighborhoods m_neighborhoods;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      m_rungs; // by time stamps of their ends
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CHORDAL_AXIS_2_H
