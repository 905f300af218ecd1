// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Cut_loci_2, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_ARCS_2_H
#define CGAL_CUT_LOCI_2_INTERNAL_GEODESICS_CUT_ARCS_2_H

#include <CGAL/Cut_loci_2/internal/geodesics/Cut_certificate_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_circle_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/directions.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
      const Point p = m_vertices[i].point, q = m_equations.domain().near(p, end.point);
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
