// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H
#define CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H

#include <CGAL/Cut_loci_2/Geodesic_front_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>

#include <Eigen/Dense>

#include <memory>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Finds the shortest geodesics of a front to a point, up to rounding. Newton's method starts at
// known geodesics that come near the point.
template <class Front> class Geodesic_finder_2
{
public:
  using Point = typename Front::Point_2;
  using Pair = Eigen::Vector2d;

  // A geodesic from the source, by its angle in radians and its length.
  struct Geodesic
  {
    double angle, length;
  };

  // The end of a geodesic and its derivatives by the angle and the length.
  struct Arrival
  {
    Geodesic geodesic;
    typename Front::State state;
    Pair by_angle, by_length;
  };

  explicit Geodesic_finder_2(const Front& front) : m_front(front) {}

  void add(const Arrival& a) { m_arrivals[square(Point(a.state[0], a.state[1]))].push_back(a); }

  Arrival arrival(const Geodesic& g) const {
    static constexpr double difference = 1e-5; // in radians
    const auto state = m_front.shoot(g.angle, g.length),
               next = m_front.shoot(g.angle + difference, g.length);
    return {g, state, Pair(next[0] - state[0], next[1] - state[1]) / difference,
            Pair(state[2], state[3])};
  }

  // Returns the length of the shortest geodesic to a point; infinity if none comes near it.
  double shortest_to(const Point& p) const {
    static constexpr double similar = .05, same = 1e-3, inexact = 2; // radians, radians, steps
    double result = std::numeric_limits<double>::infinity();
    std::vector<Geodesic> known; // equal geodesics meet everywhere
    for (const Arrival* a : arrivals_near(p)) {
      const Geodesic g = corrected(*a, p);
      if (is_farther(a->geodesic, g) || g.length > result + inexact * m_front.step())
        continue;
      if (std::any_of(known.begin(), known.end(), [&](const Geodesic& k) {
            return std::abs(turn(k.angle, g.angle)) < similar;
          }))
        continue;
      const auto found = geodesic_to(p, g);
      if (found && std::all_of(known.begin(), known.end(), [&](const Geodesic& k) {
            return std::abs(turn(k.angle, found->angle)) > same;
          })) {
        known.push_back(*found);
        result = (std::min)(result, found->length);
      }
    }
    return result;
  }

  // Returns the vector from a point to a state, in the copy of the torus that is nearest.
  Pair miss(const Point& p, const typename Front::State& state) const {
    const Point q = m_front.complex().domain().nearest_image(p, Point(state[0], state[1]));
    return Pair(q.x() - p.x(), q.y() - p.y());
  }

  // Returns whether a step of Newton's method is too long to be trusted.
  static bool is_farther(const Geodesic& from, const Geodesic& to) {
    static constexpr double farthest = .5; // in radians
    return !(std::abs(to.angle - from.angle) < farthest && to.length > 0 &&
             to.length < 2 * from.length);
  }

  // Returns the geodesic to a point that Newton's method finds from the geodesic `start`.
  std::optional<Geodesic> geodesic_to(const Point& p, const Geodesic& start) const {
    static constexpr int iterations = 30; // many, because convergence is slow at conjugate points
    static constexpr double precision = 1e-9;
    Geodesic g = start;
    for (int k = 0; k < iterations; ++k) {
      const Arrival a = arrival(g);
      const Geodesic next = corrected(a, p);
      if (is_farther(start, next))
        return std::nullopt;
      if (std::hypot(next.angle - g.angle, (next.length - g.length) / m_front.length_of_spacing()) <
              precision &&
          miss(p, a.state).norm() < precision * m_front.spacing())
        return next;
      g = next;
    }
    return std::nullopt;
  }

private:
  using Square = std::array<int, 2>;

  // The approximate size of the squares of the chart, in spacings. Geodesics at larger distances
  // from a point do not count as near.
  static constexpr double size_of_squares = 4;

  int number_of_squares(int axis) const {
    return int(m_front.complex().domain().periods()[std::size_t(axis)] /
               (size_of_squares * m_front.spacing()));
  }

  Square square(const Point& p) const {
    const Point q = m_front.complex().domain().canonical(p);
    const auto index = [&](double x, int axis) {
      const int n = number_of_squares(axis);
      const double part = x / m_front.complex().domain().periods()[std::size_t(axis)];
      return (std::min)(int(part * n), n - 1);
    };
    return {index(q.x(), 0), index(q.y(), 1)};
  }

  // Returns the known geodesics near a point, the nearest one first.
  std::vector<const Arrival*> arrivals_near(const Point& p) const {
    const Square s = square(p);
    const int n = number_of_squares(0), m = number_of_squares(1);
    const double farthest = size_of_squares * m_front.spacing();
    std::vector<std::pair<double, const Arrival*>> nearby;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (const auto it = m_arrivals.find({(s[0] + i + n) % n, (s[1] + j + m) % m});
            it != m_arrivals.end())
          for (const Arrival& a : it->second)
            if (const double distance = miss(p, a.state).norm(); distance < farthest)
              nearby.emplace_back(distance, &a);
    std::stable_sort(nearby.begin(), nearby.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Arrival*> result;
    for (const auto& item : nearby)
      result.push_back(item.second);
    return result;
  }

  // Returns the result of one Newton step.
  Geodesic corrected(const Arrival& a, const Point& p) const {
    const double spacing = m_front.spacing(), length = m_front.length_of_spacing();
    Eigen::Matrix2d jacobian;
    jacobian << a.by_angle / spacing, a.by_length * (length / spacing);
    const Pair step = jacobian.fullPivLu().solve(miss(p, a.state) / spacing);
    return {a.geodesic.angle - step[0], a.geodesic.length - length * step[1]};
  }

  const Front& m_front;
  std::map<Square, std::vector<Arrival>> m_arrivals;
};

} // namespace internal

/*!
\ingroup PkgCutLoci2Ref

The distance function of a point of a Riemannian 2-manifold, in its chart. The distance of a point
is the length of its shortest geodesic, among the geodesics that a front has followed.

\tparam Metric model of `RiemannianMetric_2`
*/
template <class Metric> class Geodesic_distance_2
{
public:
  using Front = Geodesic_front_2<Metric>;  ///< the type of the front
  using Point_2 = typename Front::Point_2; ///< a point of the chart

  /*!
  Prepares the distance function of a front. It integrates the geodesics of all vertices of the
  front again, which takes about as long as the motion of the front.

  \param front the front. It must have passed all points whose distances are needed, or it must have
         stopped everywhere.

  \throws Error if the metric is not positive definite on a geodesic.
  \throws Interrupted_error if a callback of a `Progress_scope` returned `false`.
  */
  explicit Geodesic_distance_2(Front front)
      : m_front(std::make_shared<Front>(std::move(front))), m_finder(*m_front) {
    static constexpr double difference = 1e-5; // in radians
    const double step = m_front->longest_step();
    for (auto v : m_front->complex().interface_vertices()) {
      const auto& ray = m_front->ray(v);
      const int number = int(std::ceil(ray.length / step));
      const double part = ray.length / number;
      auto state = m_front->shoot(ray.angle, part),
           next = m_front->shoot(ray.angle + difference, part);
      for (int k = 1; k <= number; ++k) {
        if (k > 1) {
          state = m_front->continue_ray(state, part);
          next = m_front->continue_ray(next, part);
        }
        if (m_front->is_in_chart(state))
          m_finder.add({{ray.angle, k * part},
                        state,
                        {(next[0] - state[0]) / difference, (next[1] - state[1]) / difference},
                        {state[2], state[3]}});
      }
    }
  }

  /// Returns the distance of a point of the chart, with an error of about 1e-9 of the width of the
  /// chart. Returns infinity if the front did not come near the point. The function integrates some
  /// geodesics to the point.
  /// \throws Error if the metric is not positive definite on a geodesic.
  double operator()(const Point_2& p) const {
    // Near the source, one geodesic leads to the point. A flat metric gives a good initial guess.
    static constexpr double nearby = 3, at_source = 1e-6; // in spacings
    const auto straight = m_front->departure(p);
    const double spacing = m_front->length_of_spacing();
    if (straight.length <= at_source * spacing)
      return straight.length;
    if (straight.length < nearby * spacing)
      if (const auto found = m_finder.geodesic_to(p, {straight.angle, straight.length}))
        return found->length;
    return m_finder.shortest_to(p);
  }

  /// Returns the front.
  const Front& front() const { return *m_front; }

private:
  std::shared_ptr<const Front> m_front; // shared by copies
  internal::Geodesic_finder_2<Front> m_finder;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_GEODESIC_DISTANCE_2_H
