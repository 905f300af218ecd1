// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_BISECTOR_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_BISECTOR_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <limits>
#include <queue>
#include <tuple>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Bisects triangles of a soup until they are small enough. Coplanar neighbors form a face. First,
// edges between faces are split at their midpoints. Then triangles are bisected at the midpoints of
// their longest edges; if a triangle at such an edge has a longer edge, that one is split first.
// Faces stay Delaunay triangulations, so that needles are cut across.
class Soup_bisector_3
{
public:
  using Places = std::vector<std::pair<Coordinates_3, double>>; // with lengths

  // The length of the edges of a triangle, and of the parts of the triangle at places.
  struct Requirement
  {
    std::size_t triangle;
    double longest;
    Places places;
  };

  explicit Soup_bisector_3(const Joined_soup_3& soup) : m_soup(soup) {}

  const Joined_soup_3& soup() const { return m_soup; }

  // Bisects the triangles, those with the longest edges first, until the soup has `most` triangles.
  // Returns whether a triangle was bisected.
  bool run(const std::vector<Requirement>& requirements, std::size_t most) {
    const std::size_t before = m_soup.triangles.size();
    if (requirements.empty() || before >= most)
      return false;
    static constexpr double any = std::numeric_limits<double>::infinity();
    m_requirements.assign(before, {0, any, {}});
    for (std::size_t t = 0; t < before; ++t)
      for (int i = 0; i < 3; ++i)
        m_triangles_at[edge(t, i)].push_back(t);
    find_faces();
    for (const Requirement& requirement : requirements)
      m_requirements[requirement.triangle] = requirement;
    for (const bool is_between_faces : {true, false}) {
      m_is_between_faces = is_between_faces;
      for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
        push(t);
      while (!m_queue.empty() && m_soup.triangles.size() < most) {
        Progress_scope::check();
        const auto [length, t] = m_queue.top();
        m_queue.pop();
        while (is_too_large(t) && length == length_of(t) && m_soup.triangles.size() < most)
          split(is_between_faces ? longest_edge(t) : terminal_edge(t));
      }
    }
    return m_soup.triangles.size() > before;
  }

private:
  using Vector = Predicates_kernel::Vector_3;
  using Edge = std::pair<std::size_t, std::size_t>; // points in increasing order

  static Edge between(std::size_t a, std::size_t b) { return {(std::min)(a, b), (std::max)(a, b)}; }

  Edge edge(std::size_t t, int i) const {
    const Triangle_indices& triangle = m_soup.triangles[t];
    return between(triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
  }

  double squared_length(const Edge& e) const {
    return difference(e.first, e.second).squared_length();
  }

  // A total order of edges.
  std::tuple<double, Edge> rank(const Edge& e) const { return {squared_length(e), e}; }

  // Returns the longest edge, or in the first round, the longest edge between faces, if any.
  Edge longest_edge(std::size_t t) const {
    std::tuple<bool, double, Edge> last = {false, -1, {}};
    for (int i = 0; i < 3; ++i) {
      const Edge e = edge(t, i);
      last = (std::max)(last, {m_is_between_faces && !is_in_face(e), squared_length(e), e});
    }
    return std::get<Edge>(last);
  }

  // Returns the squared length of the edge that would be split, 0 if there is none.
  double length_of(std::size_t t) const {
    const Edge e = longest_edge(t);
    return m_is_between_faces && is_in_face(e) ? 0 : squared_length(e);
  }

  // Returns whether the edge is between two triangles of a face.
  bool is_in_face(const Edge& e) const {
    const auto& triangles = m_triangles_at.at(e);
    return triangles.size() == 2 && m_faces[triangles[0]] == m_faces[triangles[1]];
  }

  // Unites neighbors that are coplanar up to the rounding of files with few digits.
  void find_faces() {
    static constexpr double flat = 1e-6; // distance from the plane, in longest edges
    Disjoint_sets sets(m_soup.triangles.size());
    for (const auto& [e, triangles] : m_triangles_at) {
      if (triangles.size() != 2 || m_soup.triangle_origins[triangles[0]].surface !=
                                       m_soup.triangle_origins[triangles[1]].surface)
        continue;
      const std::size_t c = opposite(triangles[0], e), d = opposite(triangles[1], e);
      const Vector along = difference(e.first, e.second), to_c = difference(e.first, c),
                   to_d = difference(e.first, d), normal = cross_product(along, to_c);
      const double longest = std::sqrt(
          (std::max)({along.squared_length(), to_c.squared_length(), to_d.squared_length()}));
      if (std::abs(normal * to_d) <= flat * longest * std::sqrt(normal.squared_length()) &&
          cross_product(along, to_d) * normal < 0)
        sets.join(triangles[0], triangles[1]);
    }
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t)
      m_faces.push_back(sets.find(t));
  }

  Edge terminal_edge(std::size_t t) const {
    Edge result = longest_edge(t);
    for (bool is_terminal = false; !is_terminal;) { // ends, because the rank increases
      is_terminal = true;
      for (std::size_t other : m_triangles_at.at(result))
        if (const Edge longer = longest_edge(other); rank(longer) > rank(result)) {
          result = longer;
          is_terminal = false;
          break;
        }
    }
    return result;
  }

  bool is_too_large(std::size_t t) const {
    const Requirement& requirement = m_requirements[t];
    double longest = requirement.longest;
    for (const auto& place : requirement.places)
      longest = (std::min)(longest, place.second);
    return length_of(t) > longest * longest;
  }

  void push(std::size_t t) {
    if (is_too_large(t))
      m_queue.emplace(length_of(t), t);
  }

  void split(const Edge& e) {
    const auto [a, b] = e;
    const std::size_t m = m_soup.points.size();
    Coordinates_3 middle;
    for (int k = 0; k < 3; ++k)
      middle[k] = m_soup.points[a][k] + (m_soup.points[b][k] - m_soup.points[a][k]) / 2;
    m_soup.points.push_back(middle);
    m_soup.point_origins.push_back(m_soup.point_origins[a]);
    const std::vector<std::size_t> triangles = m_triangles_at.at(e);
    m_triangles_at.erase(e);
    for (std::size_t t : triangles) {
      const std::size_t other = m_soup.triangles.size();
      const Triangle_indices whole = m_soup.triangles[t];
      const std::size_t c = whole[0] + whole[1] + whole[2] - a - b;
      Triangle_indices half = whole;
      std::replace(half.begin(), half.end(), b, m);
      m_soup.triangles[t] = half;
      half = whole;
      std::replace(half.begin(), half.end(), a, m);
      m_soup.triangles.push_back(half);
      m_soup.triangle_origins.push_back(m_soup.triangle_origins[t]);
      m_faces.push_back(m_faces[t]);
      m_requirements.push_back({other, m_requirements[t].longest, {}});
      separate(m_requirements[t].places, m_requirements[other].places, a, c, m);
      auto& at_b = m_triangles_at[between(b, c)];
      std::replace(at_b.begin(), at_b.end(), t, other);
      m_triangles_at[between(a, m)].push_back(t);
      m_triangles_at[between(b, m)].push_back(other);
      for (std::size_t half_index : {t, other})
        m_triangles_at[between(c, m)].push_back(half_index);
      push(t);
      push(other);
    }
    for (std::size_t t : triangles) {
      const Triangle_indices triangle = m_soup.triangles[t];
      for (std::size_t c : triangle)
        if (c != a && c != b && c != m)
          for (std::size_t end : {a, b})
            make_delaunay(between(c, end));
    }
  }

  // Flips an edge in a face unless its triangles are Delaunay, then the edges around it.
  void make_delaunay(const Edge& e) {
    const auto found = m_triangles_at.find(e);
    if (found == m_triangles_at.end() || !is_in_face(e))
      return;
    const auto [a, b] = e;
    const std::size_t s = found->second[0], t = found->second[1];
    const std::size_t c = opposite(s, e), d = opposite(t, e);
    static constexpr double rounding = 1e-9; // of the sum of the sines of angles
    if (!(sine_of_angles(c, d, a, b) < -rounding))
      return;
    m_triangles_at.erase(found);
    Triangle_indices with_a = m_soup.triangles[s], with_b = m_soup.triangles[t];
    std::replace(with_a.begin(), with_a.end(), b, d);
    std::replace(with_b.begin(), with_b.end(), a, c);
    m_soup.triangles[s] = with_a;
    m_soup.triangles[t] = with_b;
    auto& at_bc = m_triangles_at[between(b, c)];
    std::replace(at_bc.begin(), at_bc.end(), s, t);
    auto& at_ad = m_triangles_at[between(a, d)];
    std::replace(at_ad.begin(), at_ad.end(), t, s);
    m_triangles_at[between(c, d)] = {s, t};
    auto &places = m_requirements[s].places, &others = m_requirements[t].places;
    places.insert(places.end(), others.begin(), others.end());
    others.clear();
    separate(places, others, a, c, d);
    for (std::size_t part : {s, t})
      m_requirements[part].longest =
          (std::min)(m_requirements[s].longest, m_requirements[t].longest);
    push(s);
    push(t);
    for (const Edge& next : {between(a, c), between(a, d), between(b, c), between(b, d)})
      make_delaunay(next);
  }

  std::size_t opposite(std::size_t t, const Edge& e) const {
    const Triangle_indices& triangle = m_soup.triangles[t];
    return triangle[0] + triangle[1] + triangle[2] - e.first - e.second;
  }

  // Returns the sine of the sum of the angles at c and d over the edge from a to b, which is
  // negative if a circle through three of the corners contains the fourth one.
  double sine_of_angles(std::size_t c, std::size_t d, std::size_t a, std::size_t b) const {
    const auto [sine_c, cosine_c] = angle(c, a, b);
    const auto [sine_d, cosine_d] = angle(d, a, b);
    return sine_c * cosine_d + cosine_c * sine_d;
  }

  std::pair<double, double> angle(std::size_t at, std::size_t a, std::size_t b) const {
    const Vector u = difference(at, a), v = difference(at, b);
    const double sine = std::sqrt(cross_product(u, v).squared_length()), cosine = u * v,
                 length = std::hypot(sine, cosine);
    return {sine / length, cosine / length};
  }

  Vector difference(std::size_t from, std::size_t to) const {
    return exact_point(m_soup.points[to]) - exact_point(m_soup.points[from]);
  }

  // Moves the places that are not on the same side of the line from c to m as the point a.
  void separate(Places& places, Places& others, std::size_t a, std::size_t c, std::size_t m) const {
    const Vector line = difference(m, c), side = cross_product(line, difference(m, a));
    const auto origin = exact_point(m_soup.points[m]);
    const auto middle = std::stable_partition(places.begin(), places.end(), [&](const auto& p) {
      return cross_product(line, exact_point(p.first) - origin) * side >= 0;
    });
    others.assign(middle, places.end());
    places.erase(middle, places.end());
  }

  Joined_soup_3 m_soup;
  std::vector<Requirement> m_requirements; // of each triangle
  std::vector<std::size_t> m_faces;        // of each triangle
  std::map<Edge, std::vector<std::size_t>> m_triangles_at;
  bool m_is_between_faces = false; // whether only edges between faces are split
  std::priority_queue<std::pair<double, std::size_t>> m_queue; // squared lengths, triangles
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_SOUPS_SOUP_BISECTOR_3_H
