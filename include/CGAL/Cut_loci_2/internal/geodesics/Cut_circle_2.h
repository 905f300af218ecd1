// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_CIRCLE_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_CIRCLE_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_equations_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_fan_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

/*
The circle of directions at the source, with the cut point of each direction. The cut point is the
point where the geodesic of the direction first meets another geodesic of the same length. The
direction of the other geodesic is the partner. While the direction turns to the left, the partner
turns to the right. The partner is continuous between breaks. A break is a junction or an end. At a
junction, the partner jumps. At an end, which is a conjugate point, a direction is its own partner.
Each arc of the cut locus therefore belongs to two intervals between breaks.
*/
template <class Metric> class Cut_circle_2
{
public:
  using Equations = Geodesic_equations_2<Metric>;
  using Fan = Geodesic_fan_2<Metric>;
  using Point = typename Equations::Point;

  // The cut point of a direction, where its geodesic ceases to be a shortest path.
  struct Cut
  {
    double angle, partner, length;
    Point point;
  };

  // The end of an interval of directions and the beginning of the next interval.
  struct Break
  {
    double angle, length;
    Point point;
    std::vector<double> angles; // of all shortest geodesics to the point; one angle at an end
  };

  // The cut points between two breaks, sorted by angle, and the break after them.
  struct Interval
  {
    std::vector<Cut> cuts;
    std::optional<Break> end; // empty if the break was not found, or if there is no break
  };

  Cut_circle_2(const Equations& equations, const Fan& fan)
      : m_equations(equations), m_fan(fan), m_is_complete(fan.is_complete()) {
    std::vector<Cut> cuts;
    const auto directions = fan.directions();
    for (const auto& direction : directions)
      m_rays.push_back(direction.angle);
    for (const auto& direction : directions)
      if (const auto cut = first_cut(direction)) // none next to an end
        cuts.push_back(*cut);
    if (cuts.empty() || is_point(cuts))
      return;
    m_intervals.emplace_back();
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      m_intervals.back().cuts.push_back(cuts[i]);
      connect(cuts[i], cuts[(i + 1) % cuts.size()], 0);
    }
    close();
  }

  // Returns whether each direction has a cut point and all breaks were found.
  bool is_complete() const { return m_is_complete; }
  // Returns the intervals. Each interval ends at the beginning of the next one, and the last
  // interval ends at the beginning of the first one.
  const std::vector<Interval>& intervals() const { return m_intervals; }
  // Returns the cut point if it is the same for all directions.
  const std::optional<Cut>& only_point() const { return m_only_point; }

private:
  static constexpr double same_length = 1e-6; // in steps, difference of equal lengths
  static constexpr double longest = 1.;       // in spacings, distance between cut points
  static constexpr double narrowest = 1e-9;   // in radians, angle between directions
  static constexpr int deepest = 40;          // number of bisections of an angle
  static constexpr int most_failures = 32;    // number of missing breaks at which the search ends

  // Bounds on angles between geodesics. The unit is the angle between neighboring rays of the fan.
  // The fan is dense where geodesics diverge.
  static constexpr double same_angle = 1e-3; // below: the same geodesic
  static constexpr double own_partner = .05; // below: too near an end for the equations
  static constexpr double near_end = 3;      // below: other geodesics may lie between partners

  // Returns the angle between the two rays of the fan around a direction.
  double unit(double angle) const {
    const auto left = std::upper_bound(m_rays.begin(), m_rays.end(), canonical_angle(angle));
    return left == m_rays.begin() || left == m_rays.end()
               ? gap_between(m_rays.back(), m_rays.front())
               : *left - *(left - 1);
  }

  std::vector<Geodesic_2> geodesics_to(const Point& p) const {
    std::vector<Geodesic_2> result;
    for (const Geodesic_2& c : m_fan.candidates(p))
      if (const auto g = m_equations.geodesic_to(p, c))
        if (std::none_of(result.begin(), result.end(), [&](const Geodesic_2& other) {
              return std::abs(turn(other.angle, g->angle)) < same_angle * unit(g->angle);
            }))
          result.push_back(*g);
    return result;
  }

  std::optional<Cut> first_cut(const typename Fan::Direction& direction) const {
    if (!direction.shorter)
      return std::nullopt;
    const auto found = cut(direction.angle, (direction.length + direction.shorter->length) / 2,
                           direction.shorter->angle);
    return found ? found
                 : cut_by_bisection(direction.angle, direction.length - m_equations.step(),
                                    direction.length);
  }

  // Returns the cut point in a direction by bisection between two lengths. At the upper length a
  // shorter geodesic exists, at the lower length it does not. The bisection gives Newton's method a
  // near start, which it needs where geodesics diverge fast. Returns nothing next to an end.
  std::optional<Cut> cut_by_bisection(double angle, double low, double high) const {
    static constexpr int iterations = 24;
    for (int i = 0; i < iterations; ++i) {
      const double length = (low + high) / 2;
      const Point p = Equations::point(m_equations.geodesics().shoot(angle, length));
      const auto shorter = shorter_than(p, length, {angle});
      if (shorter && std::abs(turn(angle, shorter->angle)) < near_end * unit(angle))
        return std::nullopt;
      if (shorter && meeting(angle, shorter->angle, (length + shorter->length) / 2))
        if (const auto found = cut(angle, (length + shorter->length) / 2, shorter->angle))
          return found;
      (shorter ? high : low) = length;
    }
    return std::nullopt;
  }

  // Returns the cut point in a direction, from approximate values of its length and its partner.
  std::optional<Cut> cut(double angle, double length, double partner) const {
    static constexpr int most = 10; // number of partners that are tried
    auto found = meeting(angle, partner, length);
    if (!found)
      found = nearest_meeting(angle, length);
    for (int i = 0; i < most && found; ++i) {
      Progress_scope::check();
      // Near an end, shorter geodesics may lie between the two partners.
      const bool is_near_end = std::abs(turn(angle, found->angles[1])) < near_end * unit(angle);
      const auto shorter = shorter_than(found->point, found->length,
                                        is_near_end ? std::vector<double>() : found->angles);
      if (!shorter)
        return Cut{angle, found->angles[1], found->length, found->point};
      found = meeting(angle, shorter->angle, (found->length + shorter->length) / 2);
    }
    return std::nullopt;
  }

  // Returns the point where the geodesic of a direction meets the geodesic of a partner.
  std::optional<typename Equations::Meeting> meeting(double angle, double partner,
                                                     double length) const {
    const auto result = m_equations.meeting({angle, partner}, length);
    return result && std::abs(turn(angle, result->angles[1])) > own_partner * unit(angle)
               ? result
               : std::optional<typename Equations::Meeting>();
  }

  // Returns the nearest such point if the partner is unknown. Near an end, the partner is near the
  // direction.
  std::optional<typename Equations::Meeting> nearest_meeting(double angle, double length) const {
    std::optional<typename Equations::Meeting> result;
    for (double distance : {.1, .3, 1., 3.})
      for (double partner : {angle + distance * unit(angle), angle - distance * unit(angle)})
        if (const auto found = meeting(angle, partner, length))
          if (!result || found->length < result->length)
            result = found;
    return result;
  }

  // Returns the shortest geodesic to a point, if it is shorter than the given length. Geodesics
  // with angles similar to the given ones are ignored.
  std::optional<Geodesic_2> shorter_than(const Point& p, double length,
                                         const std::vector<double>& angles) const {
    static constexpr double similar = .2; // in the unit of angles above
    std::optional<Geodesic_2> result;
    double shortest = length - same_length * m_equations.step();
    for (const Geodesic_2& c : m_fan.candidates(p)) {
      if (c.length > shortest + m_equations.step() / 2 ||
          std::any_of(angles.begin(), angles.end(), [&](double angle) {
            return std::abs(turn(angle, c.angle)) < similar * unit(angle);
          }))
        continue;
      const auto g = m_equations.geodesic_to(p, c);
      if (g && g->length < shortest) {
        result = g;
        shortest = g->length;
      }
    }
    return result;
  }

  double distance(const Point& p, const Point& q) const {
    const Point r = m_equations.domain().nearest_image(p, q);
    return std::sqrt((r - p).squared_length()) / m_equations.spacing();
  }

  bool is_point(const std::vector<Cut>& cuts) {
    static constexpr double same_point = 1e-5; // in spacings
    if (!std::all_of(cuts.begin(), cuts.end(), [&](const Cut& c) {
          return distance(c.point, cuts.front().point) < same_point;
        }))
      return false;
    m_only_point = cuts.front();
    return true;
  }

  // Appends the cut points and the breaks between two consecutive cut points.
  void connect(const Cut& right, const Cut& left, int depth) {
    Progress_scope::check();
    const double gap = gap_between(right.angle, left.angle);
    if (is_around_end(right, left, gap)) {
      if (const auto found = end_between(right, left, gap)) {
        const Cut end = {found->angle, found->angle, found->length, found->point};
        approach(right, end, depth);
        add_break(*found);
        approach(end, left, depth);
        return;
      }
    } else if (are_on_an_arc(right, left)) {
      if (distance(right.point, left.point) <= longest)
        return;
    } else if (const auto found = junction_between(right, left, gap)) {
      add_break(*found);
      return;
    }
    const auto middle = depth < deepest && gap > narrowest && m_failures < most_failures
                            ? cut_between(right, left, gap)
                            : std::optional<Cut>();
    if (!middle) {
      m_is_complete = false;
      ++m_failures;
      add_break({right.angle + gap / 2, right.length, right.point, {}});
      return;
    }
    connect(right, *middle, depth + 1);
    m_intervals.back().cuts.push_back(*middle);
    connect(*middle, left, depth + 1);
  }

  // Appends the cut points between an end and the next cut point. Near an end, partners are
  // symmetric about the direction of the end.
  void approach(const Cut& right, const Cut& left, int depth) {
    if (distance(right.point, left.point) <= longest)
      return;
    const bool is_end_right = right.partner == right.angle;
    const Cut& end = is_end_right ? right : left;
    const double angle = right.angle + gap_between(right.angle, left.angle) / 2,
                 length = (right.length + left.length) / 2;
    const auto middle = depth < deepest ? cut(angle, length, end.angle + turn(angle, end.angle))
                                        : std::optional<Cut>();
    if (!middle) {
      m_is_complete = false;
      return;
    }
    is_end_right ? approach(right, *middle, depth + 1) : connect(right, *middle, depth + 1);
    m_intervals.back().cuts.push_back(*middle);
    is_end_right ? connect(*middle, left, depth + 1) : approach(*middle, left, depth + 1);
  }

  std::optional<Cut> cut_between(const Cut& right, const Cut& left, double gap) const {
    const double length = (right.length + left.length) / 2;
    for (double partner : {right.partner - gap / 2, left.partner + gap / 2})
      if (const auto found = cut(right.angle + gap / 2, length, partner))
        return found;
    const auto [low, high] = std::minmax(right.length, left.length);
    return cut_by_bisection(right.angle + gap / 2, low - m_equations.step(),
                            high + m_equations.step());
  }

  // Returns whether the partner changes continuously from the right to the left cut point.
  bool are_on_an_arc(const Cut& right, const Cut& left) const {
    static constexpr double part = .2; // largest difference, as part of the angle between partners
    const auto next = m_equations.meeting({left.angle, right.partner}, right.length);
    return next && std::abs(turn(next->angles[1], left.partner)) <
                       (std::max)(same_angle * unit(left.partner),
                                  (std::min)(near_end * unit(left.angle),
                                             part * std::abs(turn(left.angle, left.partner))));
  }

  // Returns whether a direction between two directions is its own partner. The partner of each
  // direction then lies on the side of the other direction.
  static bool is_around_end(const Cut& right, const Cut& left, double gap) {
    static constexpr double margin = 1.2;
    const double ahead = turn(right.angle, right.partner), behind = turn(left.partner, left.angle);
    return ahead > 0 && behind > 0 && ahead < margin * 2 * gap && behind < margin * 2 * gap;
  }

  // Returns the nearest conjugate point of the directions between two cut points.
  std::optional<Break> end_between(const Cut& right, const Cut& left, double gap) const {
    const auto end = m_equations.nearest_conjugate(right.angle, right.angle + gap,
                                                   (right.length + left.length) / 2);
    if (!end)
      return std::nullopt;
    const Point p = Equations::point(m_equations.geodesics().shoot(end->angle, end->length));
    return Break{end->angle, end->length, m_equations.domain().canonical(p), {end->angle}};
  }

  // Returns the junction at which the partner jumps between two cut points.
  std::optional<Break> junction_between(const Cut& right, const Cut& left, double gap) const {
    static constexpr double widest = .2; // in radians
    if (gap > widest)
      return std::nullopt;
    const auto found = m_equations.meeting({right.angle + gap / 2, right.partner, left.partner},
                                           (right.length + left.length) / 2);
    if (!found)
      return std::nullopt;
    const double angle = found->angles[0], after = turn(right.angle, angle);
    if (after < -same_angle * gap || after > (1 + same_angle) * gap)
      return std::nullopt;
    for (int i = 0; i < 3; ++i)
      if (std::abs(turn(found->angles[i], found->angles[(i + 1) % 3])) <
          own_partner * unit(found->angles[i]))
        return std::nullopt;
    Break result = {angle, found->length, found->point, {}};
    for (const Geodesic_2& g : geodesics_to(found->point)) {
      if (g.length < found->length - same_length * m_equations.step())
        return std::nullopt;
      if (g.length < found->length + 10 * same_length * m_equations.step())
        result.angles.push_back(g.angle);
    }
    if (result.angles.size() < 3)
      return std::nullopt;
    return result;
  }

  void add_break(const Break& b) {
    m_intervals.back().end = b;
    m_intervals.emplace_back();
  }

  // Joins the last interval with the first one.
  void close() {
    if (m_intervals.size() == 1)
      return;
    Interval last = std::move(m_intervals.back());
    m_intervals.pop_back();
    auto& first = m_intervals.front().cuts;
    first.insert(first.begin(), last.cuts.begin(), last.cuts.end());
  }

  const Equations& m_equations;
  const Fan& m_fan;
  std::vector<double> m_rays; // angles of the rays of the fan
  std::vector<Interval> m_intervals;
  std::optional<Cut> m_only_point;
  bool m_is_complete;
  int m_failures = 0;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_CIRCLE_2_H
