// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_GRAPH_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_GRAPH_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Chordal_axis_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Cut_point_finder_2.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
The cut locus that the axis of a front stands for, as a graph. Each node of the axis becomes a point
where shortest geodesics meet; which of these are neighbors on an arc follows from the points: where
the front has folded there are two axes for one arc, and where it is not closed, a junction of the
axis is not where the arcs meet.
*/
template <class Front> class Cut_graph_2
{
public:
  using Finder = Cut_point_finder_2<Front>;
  using Cut_point = typename Finder::Cut_point;

  Cut_graph_2(const Front& front, const Chordal_axis_2<Front>& axis)
      : m_domain(front.complex().domain()), m_spacing(front.spacing()), m_finder(front),
        m_graph(axis.neighborhoods()) {
    find_points(axis);
    find_junctions();
    merge_points();
    connect();
    m_graph.prune([&](std::size_t i, std::size_t j) { return distance(i, j); },
                  shortest_arc * m_spacing);
    fill_gaps();
    add_begins();
  }

  // Those without neighbors are not on the cut locus.
  const Neighborhoods& neighborhoods() const { return m_graph; }
  const Cut_point& point(std::size_t i) const { return *m_points[i]; }

  // Whether it leaves one disk: it is connected, has as many cycles as it can, and each of its arcs
  // that ends begins there.
  bool is_complete() const {
    if (m_has_loose_ends)
      return false;
    std::vector<char> is_reached(m_graph.size(), 0);
    std::vector<std::size_t> front;
    std::size_t number = 0, edges = 0, reached = 0;
    for (std::size_t i = 0; i < m_graph.size(); ++i) {
      number += !m_graph[i].empty();
      edges += m_graph[i].size();
      if (front.empty() && !m_graph[i].empty()) {
        front.push_back(i);
        is_reached[i] = 1;
      }
    }
    for (; reached < front.size(); ++reached)
      for (std::size_t next : m_graph[front[reached]])
        if (!is_reached[next]) {
          is_reached[next] = 1;
          front.push_back(next);
        }
    return number > 0 && reached == number && edges / 2 + 1 == number + Front::cycles_of_cut_locus;
  }

private:
  using Point = typename Front::Point_2;
  using Vector = typename Front::Complex::Approximate_vector_2;
  using Edge = std::tuple<double, std::size_t, std::size_t>; // its length first

  // In units of the spacing: what is noise of the axis and of the cut locus, when two points are
  // one, and how far neighbors may be from each other, around a junction and on an arc.
  static constexpr double shortest_spur = 4, shortest_arc = 2, same = .4, next_arc = 2,
                          farthest = 5;

  double distance(const Point& p, const Point& q) const {
    return std::sqrt((m_domain.near(p, q) - p).squared_length());
  }
  double distance(std::size_t i, std::size_t j) const {
    return distance(point(i).point, point(j).point);
  }

  // What is not found becomes a neighbor.
  void find_points(const Chordal_axis_2<Front>& axis) {
    const auto& nodes = axis.nodes();
    m_graph.prune([&](std::size_t i,
                      std::size_t j) { return distance(nodes[i].position, nodes[j].position); },
                  shortest_spur * m_spacing);
    m_points.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!m_graph[i].empty())
        m_points[i] = nodes[i].is_rung() ? m_finder.between({m_finder.geodesic(nodes[i].front[0]),
                                                             m_finder.geodesic(nodes[i].front[1])},
                                                            nodes[i].position, axis.direction(i))
                                         : m_finder.junction(nodes[i].position);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!m_points[i] && !m_graph[i].empty())
        m_graph.merge(i, *m_graph[i].begin());
  }

  // Whether two points are close, and two shortest geodesics or more to them are like each other.
  bool are_on_an_arc(std::size_t i, std::size_t j, double farthest) const {
    return !m_graph[i].empty() && !m_graph[j].empty() && distance(i, j) < farthest * m_spacing &&
           m_finder.common(point(i), point(j)).size() >= 2;
  }

  // The axis need not fork where arcs do. Of two arcs that meet, points share one geodesic, that of
  // the face between.
  void find_junctions() {
    std::vector<Edge> pairs;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!m_graph[i].empty() && !m_graph[j].empty() && distance(i, j) < next_arc * m_spacing)
          pairs.emplace_back(distance(i, j), i, j);
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::size_t> junctions;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points[i] && point(i).geodesics.size() > 2)
        junctions.push_back(i);
    for (const auto& [length, i, j] : pairs) {
      if (std::any_of(junctions.begin(), junctions.end(), [&, i = i, j = j](std::size_t k) {
            return are_on_an_arc(i, k, farthest) && are_on_an_arc(j, k, farthest);
          }))
        continue;
      if (const auto junction = m_finder.junction(point(i), point(j))) {
        junctions.push_back(add(*junction));
        m_graph.join(i, junctions.back());
        m_graph.join(j, junctions.back());
      }
    }
  }

  void merge_points() {
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (are_on_an_arc(i, j, same)) {
          if (point(i).geodesics.size() <= point(j).geodesics.size())
            m_graph.merge(i, j);
          else
            m_graph.merge(j, i);
        }
  }

  // Two points of an arc are neighbors if no third one is closer to both. The edges of the axis
  // join what these do not.
  void connect() {
    const std::size_t size = m_points.size();
    std::vector<std::vector<std::size_t>> close(size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        if (i != j && are_on_an_arc(i, j, farthest))
          close[i].push_back(j);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j : close[i])
        if (i < j && std::none_of(close[i].begin(), close[i].end(), [&](std::size_t k) {
              return (std::max)(distance(i, k), distance(k, j)) < distance(i, j) &&
                     are_on_an_arc(k, j, farthest);
            }))
          edges.emplace_back(distance(i, j), i, j);
    std::sort(edges.begin(), edges.end());
    const std::size_t number = edges.size();
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j : m_graph[i])
        if (i < j)
          edges.emplace_back(distance(i, j), i, j);
    std::sort(edges.begin() + std::ptrdiff_t(number), edges.end());
    m_graph = Neighborhoods(size);
    join_around_a_disk(edges);
  }

  // What a cut locus leaves of a torus is a disk: its cycles go around the torus, each in a
  // direction of its own. Edges that would close others are left out.
  void join_around_a_disk(const std::vector<Edge>& edges) {
    std::vector<std::size_t> part(m_points.size());
    std::iota(part.begin(), part.end(), std::size_t(0));
    std::vector<Point> unwrapped; // within its part
    for (const auto& p : m_points)
      unwrapped.push_back(p ? p->point : Point(0, 0));
    std::vector<Vector> turns;
    for (const auto& [length, i, j] : edges) {
      const Vector gap = unwrapped[i] +
                         (m_domain.near(point(i).point, point(j).point) - point(i).point) -
                         unwrapped[j];
      if (part[i] != part[j]) {
        const std::size_t old = part[j];
        for (std::size_t k = 0; k < part.size(); ++k)
          if (part[k] == old) {
            part[k] = part[i];
            unwrapped[k] = unwrapped[k] + gap;
          }
      } else {
        const Vector turn(std::round(gap.x() / m_domain.periods()[0]),
                          std::round(gap.y() / m_domain.periods()[1]));
        if (turn == Vector(0, 0) || turns.size() == Front::cycles_of_cut_locus ||
            (turns.size() == 1 && turn.x() * turns[0].y() == turn.y() * turns[0].x()))
          continue;
        turns.push_back(turn);
      }
      m_graph.join(i, j);
    }
  }

  // Edges of an arc are not much longer than the spacing.
  void fill_gaps() {
    static constexpr double longest = 2; // spacings
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      for (std::size_t j : m_graph[i])
        if (i < j)
          edges.emplace_back(i, j);
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto [i, j] = edges[k];
      if (distance(i, j) < longest * m_spacing)
        continue;
      const auto middle = m_finder.middle(point(i), point(j));
      if (!middle)
        continue;
      const std::size_t m = add(*middle);
      if (distance(i, m) < distance(i, j) && distance(m, j) < distance(i, j)) {
        m_graph.part(i, j);
        m_graph.join(i, m);
        m_graph.join(m, j);
        edges.emplace_back(i, m);
        edges.emplace_back(m, j);
      }
    }
  }

  void add_begins() {
    for (std::size_t i = 0, size = m_points.size(); i < size; ++i)
      if (m_graph[i].size() == 1) {
        if (const auto begin = m_finder.begin_of_arc(point(i)))
          m_graph.join(i, add(*begin));
        else
          m_has_loose_ends = true;
      }
  }

  std::size_t add(const Cut_point& p) {
    m_graph.add_node();
    m_points.push_back(p);
    return m_points.size() - 1;
  }

  const typename Front::Domain& m_domain;
  double m_spacing;
  Finder m_finder;
  Neighborhoods m_graph;
  bool m_has_loose_ends = false;
  std::vector<std::optional<Cut_point>> m_points; // nothing for those without neighbors
};

// As a result of a function.
template <class Cut_locus, class Front>
Cut_locus make_cut_locus(const Cut_graph_2<Front>& cut_graph,
                         const typename Front::Domain& domain) {
  const Neighborhoods& graph = cut_graph.neighborhoods();
  Cut_locus result;
  result.is_complete = cut_graph.is_complete();
  std::vector<std::size_t> index(graph.size());
  Progress_scope::check();
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (!graph[i].empty()) {
      index[i] = result.vertices.size();
      const auto& p = cut_graph.point(i);
      result.vertices.push_back({domain.canonical(p.point), p.distance, graph[i].size()});
    }
  std::set<std::size_t> seen;
  const auto add_polyline = [&](std::size_t from, std::size_t next) {
    result.polylines.emplace_back();
    for (std::size_t i : graph.chain(from, next)) {
      seen.insert(i);
      result.polylines.back().push_back(index[i]);
    }
  };
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (graph[i].size() == 1 || graph[i].size() > 2)
      for (std::size_t next : graph[i])
        if (const auto chain = graph.chain(i, next);
            i < chain.back() || (i == chain.back() && next <= chain[chain.size() - 2]))
          add_polyline(i, next);
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (graph[i].size() == 2 && seen.count(i) == 0)
      add_polyline(i, *graph[i].begin());
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_GRAPH_2_H
