// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINT_FINDER_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINT_FINDER_2_H

#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Geodesic_finder_2.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/*
Finds where shortest geodesics of a front meet, to rounding, by Newton's method.

The shortest two, or three, of the geodesics to a point are followed to where they are equally long.
Others may be shorter there: then it goes on with those.
*/
template <class Front> class Cut_point_finder_2 : Geodesic_finder_2<Front>
{
  using Base = Geodesic_finder_2<Front>;

public:
  using Point = typename Front::Point_2;
  using Vertex_handle = typename Front::Vertex_handle;
  using Vector = typename Front::Complex::Approximate_vector_2;
  using typename Base::Geodesic;
  using typename Base::Pair;

  // The geodesics to it are equally long.
  struct Cut_point
  {
    Point point;
    double distance;
    std::vector<Geodesic> geodesics;
    std::vector<Pair> turns; // of their angles by place, to first order
  };

  explicit Cut_point_finder_2(const Front& front) : Base(front) {
    for (Vertex_handle v : front.complex().interface_vertices())
      this->add(arrival(geodesic(v)));
  }

  Geodesic geodesic(Vertex_handle v) const {
    const auto& ray = m_front.ray(v);
    return {ray.angle, ray.length};
  }

  // Where two geodesics meet, near a point on the line through it that is perpendicular to a
  // direction; they may be like some that are known.
  std::optional<Cut_point> between(const std::vector<Geodesic>& known, const Point& p,
                                   const Vector& direction) const {
    const auto result = follow(known, 2, p, direction);
    return result ? result : follow(geodesics_to(p, 2, {}), 2, p, direction);
  }

  // Where three geodesics or more meet, near a point.
  std::optional<Cut_point> junction(const Point& p) const {
    return follow(geodesics_to(p, 3, {}), 3, p, Vector(0, 0));
  }

  // Where two arcs meet, by a point of each: their points share the geodesic of the face between.
  std::optional<Cut_point> junction(const Cut_point& p, const Cut_point& q) const {
    if (p.geodesics.size() != 2 || q.geodesics.size() != 2)
      return std::nullopt;
    std::vector<Geodesic> three = common(p, q);
    if (three.size() != 1)
      return std::nullopt;
    for (const Cut_point* x : {&p, &q})
      three.push_back(*std::max_element(x->geodesics.begin(), x->geodesics.end(),
                                        [&](const Geodesic& a, const Geodesic& b) {
                                          return std::abs(turn(three[0].angle, a.angle)) <
                                                 std::abs(turn(three[0].angle, b.angle));
                                        }));
    return follow(three, 3, p.point + way_between(p, q) / 2, Vector(0, 0));
  }

  // Where an arc begins that ends in a point: at the nearest of the points where geodesics between
  // those to its end are conjugate to the source. It has no neighbors to be compared with, and thus
  // no turns. Nothing where arcs are missing, as more geodesics meet.
  std::optional<Cut_point> begin_of_arc(const Cut_point& end) const {
    if (end.geodesics.size() != 2)
      return std::nullopt;
    static constexpr double precision = 1e-6; // radians
    static const double golden = (std::sqrt(5.) - 1) / 2;
    double low = end.geodesics[0].angle, high = low + turn(low, end.geodesics[1].angle);
    double x = high - golden * (high - low), y = low + golden * (high - low);
    double at_x = conjugate_distance(x, end.distance), at_y = conjugate_distance(y, end.distance);
    while (std::abs(high - low) > precision)
      if (at_x < at_y) {
        high = y;
        y = x;
        at_y = at_x;
        x = high - golden * (high - low);
        at_x = conjugate_distance(x, end.distance);
      } else {
        low = x;
        x = y;
        at_x = at_y;
        y = low + golden * (high - low);
        at_y = conjugate_distance(y, end.distance);
      }
    const Geodesic geodesic = {(low + high) / 2, (std::min)(at_x, at_y)};
    if (!std::isfinite(geodesic.length))
      return std::nullopt;
    const auto state = m_front.shoot(geodesic.angle, geodesic.length);
    const Cut_point result = {near(end.point, state), geodesic.length, {geodesic, geodesic}, {}};
    if (!is_near(result, end.point, end.distance))
      return std::nullopt;
    return result;
  }

  // The geodesics to a point that are like those to another one near it: of each two that are like
  // each other the mean.
  std::vector<Geodesic> common(const Cut_point& p, const Cut_point& q) const {
    static constexpr double similar = .13; // radians
    const Vector v = way_between(p, q);
    const Pair way(v.x(), v.y());
    std::vector<Geodesic> result;
    std::vector<char> is_taken(q.geodesics.size(), 0);
    for (std::size_t i = 0; i < p.geodesics.size(); ++i) {
      std::vector<double> gaps;
      for (std::size_t j = 0; j < q.geodesics.size(); ++j)
        gaps.push_back(gap(p, i, q, j, way));
      const auto nearest = std::min_element(gaps.begin(), gaps.end());
      const std::size_t j = std::size_t(nearest - gaps.begin());
      if (*nearest >= similar || is_taken[j])
        continue;
      is_taken[j] = 1;
      const Geodesic &g = p.geodesics[i], &h = q.geodesics[j];
      result.push_back({g.angle + turn(g.angle, h.angle) / 2, (g.length + h.length) / 2});
    }
    return result;
  }

  // A point of an arc between two others.
  std::optional<Cut_point> middle(const Cut_point& p, const Cut_point& q) const {
    const Vector way = way_between(p, q);
    const std::vector<Geodesic> known = common(p, q);
    return known.size() < 2 ? std::nullopt : between(known, p.point + way / 2, way);
  }

private:
  using Base::are_distinct;
  using Base::arrival;
  using Base::geodesics_to;
  using Base::is_farther;
  using Base::m_front;
  using Base::miss;
  using Base::near;
  using Base::turn;
  using typename Base::Arrival;

  Vector way_between(const Cut_point& p, const Cut_point& q) const {
    return m_front.complex().domain().near(p.point, q.point) - p.point;
  }

  // By how much the angles of two geodesics differ, but for what their points do: by the turns of
  // either, or by none, as these are large where an arc begins.
  static double gap(const Cut_point& p, std::size_t i, const Cut_point& q, std::size_t j,
                    const Pair& way) {
    const double difference = turn(p.geodesics[i].angle, q.geodesics[j].angle);
    return (std::min)({std::abs(difference), std::abs(difference - p.turns[i].dot(way)),
                       std::abs(difference - q.turns[j].dot(way))});
  }

  std::vector<Pair> turns(const std::vector<Geodesic>& geodesics) const {
    std::vector<Pair> result;
    for (const Geodesic& g : geodesics) {
      const Arrival a = arrival(g);
      const double area = a.by_angle[0] * a.by_length[1] - a.by_angle[1] * a.by_length[0];
      result.push_back(area == 0 ? Pair(0, 0)
                                 : Pair(a.by_length[1] / area, -a.by_length[0] / area));
    }
    return result;
  }

  std::optional<Cut_point> follow(std::vector<Geodesic> geodesics, std::size_t number,
                                  const Point& start, const Vector& direction) const {
    static constexpr int rounds = 10;
    static constexpr double rounding = 1e-8; // of distances, beside what is solved for
    Point p = start;
    for (int k = 0; k < rounds && geodesics.size() >= number; ++k) {
      geodesics.resize(number);
      const double length = geodesics[0].length;
      auto found = meet(geodesics, p, direction);
      if (!found || !is_near(*found, start, length))
        return std::nullopt;
      p = found->point;
      geodesics = geodesics_to(p, number, found->geodesics);
      if (!(geodesics[0].length < (1 - rounding) * found->distance)) {
        const auto is_longer = [&](const Geodesic& g) {
          return g.length > (1 + rounding) * found->distance;
        };
        found->geodesics.assign(geodesics.begin(),
                                std::find_if(geodesics.begin(), geodesics.end(), is_longer));
        found->turns = turns(found->geodesics);
        return found;
      }
    }
    return std::nullopt;
  }

  // Where geodesics like these, two or three, are equally long.
  std::optional<Cut_point> meet(std::vector<Geodesic> geodesics, const Point& start,
                                const Vector& direction) const {
    static constexpr int iterations = 20;
    static constexpr double precision = 1e-9;
    const Eigen::Index n = Eigen::Index(geodesics.size()), length = n, place = n + 1;
    const std::vector<Geodesic> first = geodesics;
    Pair p(start.x(), start.y());
    double distance = geodesics[0].length;
    const double spacing = m_front.spacing(), unit = m_front.length_of_spacing();
    for (int k = 0; k < iterations; ++k) {
      Eigen::VectorXd value = Eigen::VectorXd::Zero(n + 3);
      Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(n + 3, n + 3);
      for (Eigen::Index i = 0; i < n; ++i) {
        const Arrival a = arrival({geodesics[i].angle, distance});
        value.segment<2>(2 * i) = miss(Point(p[0], p[1]), a.state) / spacing;
        jacobian.block<2, 1>(2 * i, i) = a.by_angle / spacing;
        jacobian.block<2, 1>(2 * i, length) = a.by_length * (unit / spacing);
        jacobian.block<2, 2>(2 * i, place) = -Eigen::Matrix2d::Identity();
      }
      if (n == 2) {
        const Pair along = Pair(direction.x(), direction.y()).normalized();
        value[n + 2] = along.dot(p - Pair(start.x(), start.y())) / spacing;
        jacobian.block<1, 2>(n + 2, place) = along.transpose();
      }
      const Eigen::VectorXd step = jacobian.fullPivLu().solve(value);
      distance -= unit * step[length];
      p -= spacing * step.tail<2>();
      for (Eigen::Index i = 0; i < n; ++i) {
        geodesics[i] = {geodesics[i].angle - step[i], distance};
        if (is_farther(first[i], geodesics[i]))
          return std::nullopt;
      }
      if (step.norm() < precision)
        break;
      if (k + 1 == iterations)
        return std::nullopt;
    }
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < i; ++j)
        if (!are_distinct(geodesics[i], geodesics[j]))
          return std::nullopt;
    return Cut_point{Point(p[0], p[1]), distance, geodesics, {}};
  }

  // Whether a point is about where the front has stopped.
  bool is_near(const Cut_point& p, const Point& front_point, double front_length) const {
    static constexpr double farthest = 4; // spacings
    const double way = std::sqrt(
        (m_front.complex().domain().near(p.point, front_point) - p.point).squared_length());
    return way < farthest * m_front.spacing() &&
           std::abs(p.distance - front_length) < farthest * m_front.length_of_spacing();
  }

  // How far it is along a geodesic to the first point that is conjugate to the source: where its
  // neighbors cross it. Infinity if that is much farther than another distance.
  double conjugate_distance(double angle, double distance) const {
    static constexpr double apart = 1e-4, farthest = 1.5; // radians, distances
    static constexpr int steps = 60, finer = 4;
    double length = farthest * distance / steps, step = length;
    auto left = m_front.shoot(angle + apart, length), right = m_front.shoot(angle - apart, length);
    const auto side = [](const auto& l, const auto& r) {
      return (l[1] - r[1]) * (l[2] + r[2]) - (l[0] - r[0]) * (l[3] + r[3]);
    };
    double before = side(left, right);
    int refined = 0;
    while (length < farthest * distance) {
      const auto next_left = m_front.continue_ray(left, step),
                 next_right = m_front.continue_ray(right, step);
      const double now = side(next_left, next_right);
      if (now * before <= 0) {
        if (refined++ == finer)
          return length + before / (before - now) * step;
        step /= finer;
        continue;
      }
      left = next_left;
      right = next_right;
      before = now;
      length += step;
    }
    return std::numeric_limits<double>::infinity();
  }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_2_INTERNAL_GEODESICS_CUT_POINT_FINDER_2_H
