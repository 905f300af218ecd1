// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_ARCS_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_ARCS_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Cut_circle_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A claim about a point of a cut locus: geodesics in the given directions reach the point at the
// given distance. A claim with one direction states that the point is conjugate to the source along
// it.
struct Cut_claim_2
{
  Epick::Point_2 point;
  double distance;
  std::vector<double> angles;
};

// Verifies points of a cut locus by geodesics from the source. The geodesics of a point must arrive
// there, and geodesics in many other directions must not reach the point earlier. The verification
// does not depend on the method that found the points.
template <class Metric> class Cut_certificate_2
{
public:
  using Geodesics = Geodesics_2<Metric>;
  using Point = Epick::Point_2;

  // \param spacing the unit of lengths in the chart
  // \param step the unit of lengths of geodesics
  Cut_certificate_2(const Geodesics& geodesics, const Torus_domain<2>& domain, double spacing,
                    double step)
      : m_geodesics(geodesics), m_domain(domain), m_spacing(spacing), m_step(step) {}

  // Returns the indices of the claims that are wrong.
  std::vector<std::size_t> refuted(const std::vector<Cut_claim_2>& claims) const {
    std::vector<char> is_wrong(claims.size());
    double farthest = 0;
    for (std::size_t i = 0; i < claims.size(); ++i) {
      Progress_scope::check();
      is_wrong[i] = !is_reached(claims[i]);
      farthest = (std::max)(farthest, claims[i].distance);
    }
    const auto squares = claims_by_squares(claims);
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * std::acos(-1.) * k / directions;
      double length = m_geodesics.shortest_length(m_step);
      Geodesic_state state = m_geodesics.shoot(angle, length);
      for (; length < farthest && m_geodesics.is_in_chart(state); length += m_step) {
        const auto nearby = squares.find(square(point(state)));
        if (nearby != squares.end())
          for (std::size_t i : nearby->second)
            if (length + distance(point(state), claims[i].point) <
                claims[i].distance - tolerance * m_step)
              is_wrong[i] = true;
        state = m_geodesics.advance(state, m_step);
      }
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < claims.size(); ++i)
      if (is_wrong[i])
        result.push_back(i);
    return result;
  }

private:
  using Square = std::array<int, 2>;

  static constexpr int directions = 512;    // number of directions that are tried
  static constexpr double tolerance = .02;  // steps; a path that refutes is shorter by it
  static constexpr double precision = 1e-5; // spacings; largest error of a claimed geodesic
  static constexpr double size = 2;         // spacings; size of the squares of the chart

  static Point point(const Geodesic_state& s) { return Point(s[0], s[1]); }

  bool is_reached(const Cut_claim_2& claim) const {
    for (double angle : claim.angles) {
      const Point p = claim.point,
                  q = m_domain.nearest_image(p, point(m_geodesics.shoot(angle, claim.distance)));
      if (!((q - p).squared_length() <= precision * precision * m_spacing * m_spacing))
        return false;
    }
    return claim.angles.size() > 1 || (claim.angles.size() == 1 && is_conjugate(claim));
  }

  // Returns whether the neighboring geodesics converge at the point, but not before it.
  bool is_conjugate(const Cut_claim_2& claim) const {
    static constexpr double beside = 1e-3, before = .9, part = .1; // radians, lengths, widths
    const auto width = [&](double length) {
      const Point p = point(m_geodesics.shoot(claim.angles.front() - beside, length)),
                  q = point(m_geodesics.shoot(claim.angles.front() + beside, length));
      return distance(p, q);
    };
    return width(claim.distance) < part * width(before * claim.distance);
  }

  // Returns an upper bound of the distance: the length of the straight segment in the chart, times
  // a margin for the error of the integration.
  double distance(const Point& p, const Point& to) const {
    static constexpr int parts = 4;
    static constexpr double margin = 1.03;
    const Point q = m_domain.nearest_image(p, to);
    const auto difference = q - p;
    double result = 0;
    for (int i = 0; i < parts; ++i)
      result += m_geodesics.length(p + (i + .5) / parts * difference, difference.x() / parts,
                                   difference.y() / parts);
    return margin * result;
  }

  Square square(const Point& p) const {
    const Point q = m_domain.canonical(p);
    return {int(q.x() / (size * m_spacing)), int(q.y() / (size * m_spacing))};
  }

  // Returns the claims for each square. A claim belongs to its square and to the neighbors of this
  // square.
  std::map<Square, std::vector<std::size_t>>
  claims_by_squares(const std::vector<Cut_claim_2>& claims) const {
    std::map<Square, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < claims.size(); ++i) {
      std::vector<Square> squares;
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          squares.push_back(square(Point(claims[i].point.x() + j * size * m_spacing,
                                         claims[i].point.y() + k * size * m_spacing)));
      std::sort(squares.begin(), squares.end());
      squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
      for (const Square& s : squares)
        result[s].push_back(i);
    }
    return result;
  }

  const Geodesics& m_geodesics;
  Torus_domain<2> m_domain;
  double m_spacing, m_step;
};

// The cut locus as a graph. Two intervals of directions that are partners form one arc. Breaks at
// the same point form one vertex.
template <class Metric> class Cut_arcs_2
{
public:
  using Circle = Cut_circle_2<Metric>;

  Cut_arcs_2(const Circle& circle, const Geodesic_equations_2<Metric>& equations)
      : m_circle(circle), m_equations(equations), m_is_complete(circle.is_complete()) {
    if (circle.only_point()) {
      const auto& cut = *circle.only_point();
      m_vertices.push_back({cut.point, cut.length, {cut.angle, cut.partner}});
      return;
    }
    const auto& intervals = circle.intervals();
    for (const auto& interval : intervals)
      m_ends.push_back(interval.end ? vertex(*interval.end) : none);
    for (std::size_t i = 0; i < intervals.size(); ++i)
      m_partners.push_back(partner(i));
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const std::size_t j = m_partners[i];
      m_is_complete = m_is_complete && j != none && j != i && m_partners[j] == i;
      if (j == none || i < j)
        add_arc(i);
    }
    m_is_complete = m_is_complete && all_junctions_are_whole() && leaves_a_disk();
  }

  const std::vector<Cut_claim_2>& vertices() const { return m_vertices; }
  const std::vector<std::vector<std::size_t>>& arcs() const { return m_arcs; }

  // Returns whether each interval has a partner, each junction is complete, and the complement of
  // the graph is a disk.
  bool is_complete() const { return m_is_complete; }

private:
  static constexpr std::size_t none = std::size_t(-1);
  using Point = typename Circle::Point;

  // Returns the vertex of a break. Breaks at the same point have the same vertex.
  std::size_t vertex(const typename Circle::Break& end) {
    static constexpr double same = 1e-3; // in spacings
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
      const Point p = m_vertices[i].point, q = m_equations.domain().nearest_image(p, end.point);
      if ((q - p).squared_length() < std::pow(same * m_equations.spacing(), 2) &&
          m_vertices[i].angles.size() == end.angles.size() && end.angles.size() > 1) {
        ++m_breaks[i];
        return i;
      }
    }
    m_vertices.push_back({end.point, end.length, end.angles});
    m_breaks.push_back(1);
    return m_vertices.size() - 1;
  }

  double angle_at_end(std::size_t i) const { return m_circle.intervals()[i].end->angle; }

  // Returns the interval that contains the partners of an interval.
  std::size_t partner(std::size_t i) const {
    const auto& intervals = m_circle.intervals();
    const std::size_t n = intervals.size();
    if (intervals[i].cuts.empty() || !intervals[i].end)
      return none;
    const double angle = intervals[i].cuts[intervals[i].cuts.size() / 2].partner;
    for (std::size_t j = 0; j < n; ++j) {
      const double begin = angle_at_end((j + n - 1) % n);
      if (gap_between(begin, angle) < gap_between(begin, angle_at_end(j)))
        return j;
    }
    return n == 1 ? 0 : none;
  }

  void add_arc(std::size_t i) {
    const std::size_t n = m_circle.intervals().size();
    std::vector<std::size_t> arc;
    if (const std::size_t begin = m_ends[(i + n - 1) % n]; begin != none)
      arc.push_back(begin);
    for (const auto& cut : m_circle.intervals()[i].cuts) {
      arc.push_back(m_vertices.size());
      m_vertices.push_back({cut.point, cut.length, {cut.angle, cut.partner}});
    }
    if (m_ends[i] != none)
      arc.push_back(m_ends[i]);
    m_arcs.push_back(arc);
  }

  // Returns whether each geodesic to a junction ends an interval.
  bool all_junctions_are_whole() const {
    for (std::size_t i = 0; i < m_breaks.size(); ++i)
      if (m_vertices[i].angles.empty() || m_vertices[i].angles.size() != m_breaks[i])
        return false;
    return true;
  }

  bool leaves_a_disk() const {
    Disjoint_sets components(m_breaks.size());
    std::size_t number = m_breaks.size();
    for (const auto& arc : m_arcs) {
      number -= components.find(arc.front()) != components.find(arc.back());
      components.join(arc.front(), arc.back());
    }
    return number == 1 &&
           m_arcs.size() + 1 == m_breaks.size() + Geodesics_2<Metric>::cycles_of_cut_locus;
  }

  const Circle& m_circle;
  const Geodesic_equations_2<Metric>& m_equations;
  std::vector<Cut_claim_2> m_vertices; // vertices of breaks first
  std::vector<std::size_t> m_breaks;   // number of breaks at each vertex
  std::vector<std::size_t> m_ends;     // vertices at the ends of the intervals
  std::vector<std::size_t> m_partners; // partner of each interval
  std::vector<std::vector<std::size_t>> m_arcs;
  bool m_is_complete;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_ARCS_2_H
