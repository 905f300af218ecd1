// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINTS_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINTS_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Chordal_axis_2.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Finds where geodesics of a front meet, beginning near the nodes of its axis.
template <class Front> class Cut_point_finder_2
{
public:
  using Axis = Chordal_axis_2<Front>;
  using Node = typename Axis::Node;
  using Point = typename Front::Point_2;
  using Vertex_handle = typename Front::Vertex_handle;

  struct Cut_point
  {
    Point point;
    double distance;
  };

  explicit Cut_point_finder_2(const Front& front) : m_front(front) {}

  // Where geodesics like those of the ends of a rung meet, across the axis: the parts of the front
  // need not have come equally far.
  std::optional<Cut_point> on_rung(std::size_t i, const Axis& axis) const {
    const Node& rung = axis.nodes()[i];
    const auto &one = m_front.ray(rung.front[0]), &other = m_front.ray(rung.front[1]);
    const Point a = rung.position;
    const auto way = across(i, axis);
    const Unknowns start(one.angle, other.angle, (one.length + other.length) / 2, 0);
    const auto solution = solve(start, [&](const Unknowns& x, Jacobian& jacobian) {
      const Point target = a + x[3] * way;
      const Arrival p(*this, target, x[0], x[2]), q(*this, target, x[1], x[2]);
      const Pair along(way.x(), way.y());
      jacobian << p.by_angle, Pair::Zero(), p.by_length, -along, //
          Pair::Zero(), q.by_angle, q.by_length, -along;
      return Unknowns(p.x - target.x(), p.y - target.y(), q.x - target.x(), q.y - target.y());
    });
    if (!solution || !are_distinct((*solution)[0], (*solution)[1]))
      return std::nullopt;
    const Point p = a + (*solution)[3] * way;
    return near(p, (*solution)[2], a, start[2]);
  }

  // Where three of the geodesics around a junction meet, and none of the others comes earlier.
  // These are those of some vertices of the front around it.
  std::optional<Cut_point> at_junction(const Node& junction,
                                       const std::vector<Vertex_handle>& around) const {
    for (const auto& angles : triples(around))
      if (const auto found = at_junction(junction, angles); found && is_shortest(*found, around))
        return found;
    return std::nullopt;
  }

  // Whether no geodesic of some vertices of the front comes to a point before those that it was
  // found from.
  bool is_shortest(const Cut_point& p, const std::vector<Vertex_handle>& around) const {
    static constexpr double rounding = 1e-7; // of distances, beside what is solved for
    for (Vertex_handle v : around) {
      const auto length = length_to(p.point, m_front.ray(v));
      if (length && *length < (1 - rounding) * p.distance)
        return false;
    }
    return true;
  }

  // Where an arc begins that ends in a rung: at the nearest of the points where geodesics between
  // those of the ends are conjugate to the source.
  std::optional<Cut_point> beyond(const Node& rung) const {
    static constexpr int halvings = 60;
    static const double golden = (std::sqrt(5.) - 1) / 2;
    const double pi = std::acos(-1.), a = m_front.ray(rung.front[0]).angle;
    double low = a, high = a + std::remainder(m_front.ray(rung.front[1]).angle - a, 2 * pi);
    double x = high - golden * (high - low), y = low + golden * (high - low);
    double at_x = conjugate_distance(x, rung), at_y = conjugate_distance(y, rung);
    static constexpr double precision = 1e-6; // radians
    for (int i = 0; i < halvings && std::abs(high - low) > precision; ++i)
      if (at_x < at_y) {
        high = y;
        y = x;
        at_y = at_x;
        x = high - golden * (high - low);
        at_x = conjugate_distance(x, rung);
      } else {
        low = x;
        x = y;
        at_x = at_y;
        y = low + golden * (high - low);
        at_y = conjugate_distance(y, rung);
      }
    const double angle = (low + high) / 2, length = (std::min)(at_x, at_y);
    if (!std::isfinite(length))
      return std::nullopt;
    return near(place(rung.position, angle, length), length, rung.position, mean_length(rung));
  }

private:
  // Where three geodesics meet that have about these angles.
  std::optional<Cut_point> at_junction(const Node& junction,
                                       const std::array<double, 3>& angles) const {
    const double length = mean_length(junction);
    const Unknowns start(angles[0], angles[1], angles[2], length);
    const auto solution = solve(start, [&](const Unknowns& x, Jacobian& jacobian) {
      const Arrival p(*this, junction.position, x[0], x[3]),
          q(*this, junction.position, x[1], x[3]), r(*this, junction.position, x[2], x[3]);
      jacobian << -p.by_angle, q.by_angle, Pair::Zero(), q.by_length - p.by_length, //
          -p.by_angle, Pair::Zero(), r.by_angle, r.by_length - p.by_length;
      return Unknowns(q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y);
    });
    if (!solution || !are_distinct((*solution)[0], (*solution)[1]) ||
        !are_distinct((*solution)[1], (*solution)[2]) ||
        !are_distinct((*solution)[0], (*solution)[2]))
      return std::nullopt;
    const Point p = place(junction.position, (*solution)[0], (*solution)[3]);
    return near(p, (*solution)[3], junction.position, length);
  }

  // The length of a geodesic to a point that has about the angle of a ray; nothing if none is
  // found.
  std::optional<double> length_to(const Point& target, const typename Front::Ray& ray) const {
    static constexpr int iterations = 8;
    static constexpr double precision = 1e-10, farthest = .5;
    Pair x(ray.angle, ray.length);
    for (int k = 0; k < iterations; ++k) {
      const Arrival p(*this, target, x[0], x[1]);
      Eigen::Matrix2d jacobian;
      jacobian << p.by_angle, p.by_length;
      const Pair step = jacobian.fullPivLu().solve(Pair(p.x - target.x(), p.y - target.y()));
      x -= step;
      if (!(std::abs(x[0] - ray.angle) < farthest && x[1] > 0))
        return std::nullopt;
      if (step.norm() < precision)
        return x[1];
    }
    return std::nullopt;
  }

  // Triples of the angles of the geodesics of vertices, those first whose nearest two are farthest
  // from each other: there are three parts of the front around a junction.
  std::vector<std::array<double, 3>> triples(const std::vector<Vertex_handle>& around) const {
    static constexpr std::size_t most = 40; // of them
    std::vector<double> angles;
    for (Vertex_handle v : around)
      if (std::all_of(angles.begin(), angles.end(),
                      [&](double angle) { return are_distinct(angle, m_front.ray(v).angle); }))
        angles.push_back(m_front.ray(v).angle);
    std::vector<std::array<double, 3>> result;
    for (std::size_t i = 0; i < angles.size(); ++i)
      for (std::size_t j = i + 1; j < angles.size(); ++j)
        for (std::size_t k = j + 1; k < angles.size(); ++k)
          result.push_back({angles[i], angles[j], angles[k]});
    const auto spread = [](const std::array<double, 3>& a) {
      const auto apart = [&](int i, int j) {
        return std::abs(std::remainder(a[i] - a[j], 2 * std::acos(-1.)));
      };
      return (std::min)({apart(0, 1), apart(1, 2), apart(2, 0)});
    };
    std::stable_sort(result.begin(), result.end(),
                     [&](const auto& a, const auto& b) { return spread(a) > spread(b); });
    result.resize((std::min)(result.size(), most));
    return result;
  }

  double mean_length(const Node& node) const {
    double sum = 0;
    for (Vertex_handle v : node.front)
      sum += m_front.ray(v).length;
    return sum / double(node.front.size());
  }

  using Unknowns = Eigen::Vector4d;
  using Jacobian = Eigen::Matrix4d;
  using Pair = Eigen::Vector2d;

  // Where a geodesic ends, as seen from p, and how that depends on its angle and its length.
  struct Arrival
  {
    Arrival(const Cut_point_finder_2& finder, const Point& p, double angle, double length) {
      static constexpr double difference = 1e-5;
      const auto state = finder.m_front.shoot(angle, length),
                 next = finder.m_front.shoot(angle + difference, length);
      const Point here = finder.m_front.complex().domain().near(p, Point(state[0], state[1]));
      x = here.x();
      y = here.y();
      by_angle = Pair(next[0] - state[0], next[1] - state[1]) / difference;
      by_length = Pair(state[2], state[3]);
    }

    double x, y;
    Pair by_angle, by_length;
  };

  // Where a geodesic ends, as seen from p.
  Point place(const Point& p, double angle, double length) const {
    const auto state = m_front.shoot(angle, length);
    return m_front.complex().domain().near(p, Point(state[0], state[1]));
  }

  // A point at a distance, if both are about where the front has stopped.
  std::optional<Cut_point> near(const Point& p, double distance, const Point& front_point,
                                double front_length) const {
    static constexpr double farthest = 10; // spacings, and steps
    const double way =
        std::sqrt((m_front.complex().domain().near(p, front_point) - p).squared_length());
    if (way < farthest * m_front.spacing() &&
        std::abs(distance - front_length) < farthest * m_front.step())
      return Cut_point{p, distance};
    return std::nullopt;
  }

  // Two geodesics that have become one meet everywhere.
  static bool are_distinct(double a, double b) {
    static constexpr double same = 1e-3; // radians
    return std::abs(std::remainder(a - b, 2 * std::acos(-1.))) > same;
  }

  // Perpendicular to the axis, or along the rung where it ends. Of the length 1.
  typename Front::Complex::Approximate_vector_2 across(std::size_t i, const Axis& axis) const {
    const Node& rung = axis.nodes()[i];
    const auto& neighbors = axis.neighborhoods()[i];
    auto way = m_front.complex().displacement(rung.front[0], rung.front[1]);
    if (neighbors.size() == 2) {
      const Point p = axis.nodes()[*neighbors.begin()].position;
      const Point q =
          m_front.complex().domain().near(p, axis.nodes()[*neighbors.rbegin()].position);
      if (p != q)
        way = decltype(way)(p.y() - q.y(), q.x() - p.x());
    }
    return way / std::sqrt(way.squared_length());
  }

  // By Newton's method; nothing if it does not converge near its start.
  template <class Function>
  std::optional<Unknowns> solve(const Unknowns& start, const Function& f) const {
    static constexpr int iterations = 20;
    static constexpr double precision = 1e-9, farthest = .5;
    Unknowns x = start;
    for (int k = 0; k < iterations; ++k) {
      Jacobian jacobian;
      const Unknowns value = f(x, jacobian);
      const Unknowns step = jacobian.fullPivLu().solve(value);
      if (!step.allFinite())
        return std::nullopt;
      x -= step;
      if (!((x - start).head<2>().cwiseAbs().maxCoeff() < farthest))
        return std::nullopt;
      if (step.norm() < precision)
        return x;
    }
    return std::nullopt;
  }

  // How far it is along a geodesic to the first point that is conjugate to the source: where its
  // neighbors cross it. Infinity if that is much farther than the front.
  double conjugate_distance(double angle, const Node& rung) const {
    static constexpr double apart = 1e-4, farthest = 1.5; // radians, lengths of the front
    static constexpr int steps = 60;
    const double bound = farthest * mean_length(rung), step = bound / steps;
    auto left = m_front.shoot(angle + apart, step), right = m_front.shoot(angle - apart, step);
    const auto side = [](const auto& l, const auto& r) {
      return (l[1] - r[1]) * (l[2] + r[2]) - (l[0] - r[0]) * (l[3] + r[3]);
    };
    double before = side(left, right);
    for (int k = 2; k <= steps; ++k) {
      left = m_front.continue_ray(left, step);
      right = m_front.continue_ray(right, step);
      const double now = side(left, right);
      if (now * before <= 0)
        return (k - now / (now - before)) * step;
      before = now;
    }
    return std::numeric_limits<double>::infinity();
  }

  const Front& m_front;
};

// The cut locus that the axis of a front stands for. What was not found is left out; points that
// were found twice become one.
template <class Cut_locus, class Front>
Cut_locus cut_points(const Front& front, const Chordal_axis_2<Front>& axis) {
  using Finder = Cut_point_finder_2<Front>;
  using Cut_point = typename Finder::Cut_point;
  static constexpr double same = .02, crossed = .5, shortest_spur = 4, shortest_arc = 2; // spacings
  static constexpr std::size_t around = 3, reach = 8; // edges of the axis from a junction
  const Finder finder(front);
  const auto& nodes = axis.nodes();
  const auto& domain = front.complex().domain();
  const auto between = [&](const auto& p, const auto& q) {
    return std::sqrt((domain.near(p, q) - p).squared_length());
  };

  Neighborhoods graph = axis.neighborhoods();
  graph.prune(
      [&](std::size_t i, std::size_t j) { return between(nodes[i].position, nodes[j].position); },
      shortest_spur * front.spacing());
  const auto front_around = [&](std::size_t i) {
    std::vector<typename Finder::Vertex_handle> result;
    for (std::size_t j : graph.within(i, around))
      for (auto v : nodes[j].front)
        if (std::find(result.begin(), result.end(), v) == result.end())
          result.push_back(v);
    return result;
  };
  std::vector<std::optional<Cut_point>> found(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!graph[i].empty())
      found[i] = nodes[i].is_rung() ? finder.on_rung(i, axis)
                                    : finder.at_junction(nodes[i], front_around(i));
  // Beside where three parts of the front meet, two of them may meet beyond the third.
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!graph[i].empty() && !nodes[i].is_rung()) {
      const auto front = front_around(i);
      for (std::size_t j : graph.within(i, reach))
        if (nodes[j].is_rung() && found[j] && !finder.is_shortest(*found[j], front))
          found[j].reset();
    }
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!found[i] && !graph[i].empty())
      graph.merge(i, *graph[i].begin());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < i && !graph[i].empty(); ++j)
      if (!graph[j].empty() && between(found[i]->point, found[j]->point) < same * front.spacing())
        graph.merge(i, j);
  const auto distance = [&](std::size_t i, std::size_t j) {
    return between(found[i]->point, found[j]->point);
  };
  // Next to where three parts of the front meet, two of them may meet beyond it.
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (graph[i].size() > 2)
      for (bool has_merged = true; has_merged;) {
        has_merged = false;
        const std::set<std::size_t> neighbors = graph[i];
        for (std::size_t j : neighbors)
          if (graph[j].size() == 2 && distance(i, j) < crossed * front.spacing()) {
            graph.merge(j, i);
            has_merged = true;
          }
      }
  graph.prune(distance, shortest_arc * front.spacing());

  for (std::size_t i = 0, size = nodes.size(); i < size; ++i)
    if (graph[i].size() == 1 && nodes[i].is_rung())
      if (const auto tip = finder.beyond(nodes[i])) {
        graph.add_node();
        graph.join(i, found.size());
        found.push_back(tip);
      }

  Cut_locus result;
  std::vector<std::size_t> index(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!graph[i].empty()) {
      index[i] = result.vertices.size();
      result.vertices.push_back(
          {domain.canonical(found[i]->point), found[i]->distance, graph[i].size()});
    }
  std::set<std::size_t> seen;
  const auto add_polyline = [&](std::size_t from, std::size_t next) {
    result.polylines.emplace_back();
    for (std::size_t i : graph.chain(from, next)) {
      seen.insert(i);
      result.polylines.back().push_back(index[i]);
    }
  };
  for (std::size_t i = 0; i < found.size(); ++i)
    if (graph[i].size() == 1 || graph[i].size() > 2)
      for (std::size_t next : graph[i])
        if (const auto chain = graph.chain(i, next);
            i < chain.back() || (i == chain.back() && next <= chain[chain.size() - 2]))
          add_polyline(i, next);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (graph[i].size() == 2 && seen.count(i) == 0)
      add_polyline(i, *graph[i].begin());
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINTS_2_H
