// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_WELD_SOUP_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_WELD_SOUP_3_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/Soup_contacts_3.h>
#include <CGAL/Triangle_soup_repair/internal/arrangement/Triangle_division_3.h>
#include <CGAL/Triangle_soup_repair/internal/soups/Triangle_soup_3.h>

#include <iterator>
#include <set>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A soup of divided triangles. Triangle i is a part of triangle `origins[i]` of the input and has
// its orientation.
struct Split_soup_3 : Triangle_soup_3
{
  std::vector<std::size_t> origins;
};

// Returns a soup whose triangles are those of the input.
inline Split_soup_3 undivided(const Triangle_soup_3& soup) {
  Split_soup_3 result{soup, std::vector<std::size_t>(soup.triangles.size())};
  std::iota(result.origins.begin(), result.origins.end(), std::size_t(0));
  return result;
}

// Removes the triangles that are not kept.
inline void keep(Split_soup_3& soup, const std::vector<char>& is_kept) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (is_kept[t]) {
      soup.triangles[kept] = soup.triangles[t];
      soup.origins[kept++] = soup.origins[t];
    }
  soup.triangles.resize(kept);
  soup.origins.resize(kept);
}

// Merges points nearer to each other than a distance, and removes triangles that thus lose a
// corner.
inline void merge_near_points(Split_soup_3& soup, double distance) {
  static_cast<Triangle_soup_3&>(soup) = merge_points(soup);
  merge_near_points(soup, distance, Merged_points::ALL);
  static_cast<Triangle_soup_3&>(soup) = merge_points(soup);
  std::vector<char> is_kept;
  for (const Triangle_indices& t : soup.triangles)
    is_kept.push_back(has_corners(t));
  keep(soup, is_kept);
}

// Removes pairs of triangles with the same corners that are parts of the same triangle of the
// input.
inline void cancel_folds(Split_soup_3& soup) {
  std::map<std::pair<std::size_t, Triangle_indices>, std::size_t> unpaired;
  std::vector<char> is_kept(soup.triangles.size(), 1);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto [place, is_new] = unpaired.insert({{soup.origins[t], sorted(soup.triangles[t])}, t});
    if (!is_new) {
      is_kept[t] = is_kept[place->second] = 0;
      unpaired.erase(place);
    }
  }
  keep(soup, is_kept);
}

// Divides the triangles of a soup at the contacts.
class Contact_division_3
{
public:
  Contact_division_3(const Split_soup_3& soup, const Soup_contacts_3& contacts)
      : m_soup(soup), m_contacts(contacts), m_points(soup.points),
        m_triangles_at(soup.points.size() + contacts.new_points().size()),
        m_segments(soup.triangles.size()) {
    m_points.insert(m_points.end(), contacts.new_points().begin(), contacts.new_points().end());
    find_triangles_at_vertices();
    find_segments();
  }

  Split_soup_3 run() {
    Split_soup_3 result;
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t) {
      Progress_scope::check();
      for (const Triangle_indices& part : parts(t)) {
        result.triangles.push_back(part);
        result.origins.push_back(m_soup.origins[t]);
      }
    }
    result.points = std::move(m_points);
    return result;
  }

private:
  using Polygon = Triangle_division_3::Polygon;

  // Returns the vertices along the edges of a triangle, in the order of the corners. Where edges
  // fold back, vertices are left out.
  Polygon polygon(std::size_t t) const {
    Polygon result;
    const auto append = [&](std::size_t v) {
      if (result.size() >= 2 && result[result.size() - 2] == v)
        result.pop_back();
      else
        result.push_back(v);
    };
    for (int i : {2, 0, 1}) {
      const std::size_t corner = m_soup.triangles[t][(i + 1) % 3];
      const auto& edge = m_contacts.edges()[m_contacts.edges_of(t)[i]];
      append(corner);
      if (corner == edge.ends[0])
        for (auto place = edge.places.begin(); place != edge.places.end(); ++place)
          append(place->vertex);
      else
        for (auto place = edge.places.rbegin(); place != edge.places.rend(); ++place)
          append(place->vertex);
    }
    while (result.size() >= 3 && (result[1] == result.back() || result[0] == result.end()[-2])) {
      if (result[1] == result.back())
        result.erase(result.begin());
      result.pop_back();
    }
    return result;
  }

  // Lists the triangles with a vertex at a corner, on an edge, or inside.
  void find_triangles_at_vertices() {
    for (std::size_t t = 0; t < m_soup.triangles.size(); ++t) {
      std::vector<std::size_t> vertices = m_contacts.inside(t);
      for (int i = 0; i < 3; ++i) {
        vertices.push_back(m_soup.triangles[t][i]);
        for (const auto& place : m_contacts.edges()[m_contacts.edges_of(t)[i]].places)
          vertices.push_back(place.vertex);
      }
      for (std::size_t v : vertices)
        if (m_triangles_at[v].empty() || m_triangles_at[v].back() != t)
          m_triangles_at[v].push_back(t);
    }
  }

  // Finds the parts of edges that lie in triangles with other edges.
  void find_segments() {
    std::vector<std::size_t> common;
    for (std::size_t e = 0; e < m_contacts.edges().size(); ++e) {
      const auto& edge = m_contacts.edges()[e];
      std::size_t v = edge.ends[0];
      for (std::size_t i = 0; i <= edge.places.size(); ++i) {
        const std::size_t w = i < edge.places.size() ? edge.places[i].vertex : edge.ends[1];
        const auto &at_v = m_triangles_at[v], &at_w = m_triangles_at[w];
        common.clear();
        std::set_intersection(at_v.begin(), at_v.end(), at_w.begin(), at_w.end(),
                              std::back_inserter(common));
        for (std::size_t t : common) {
          const auto& own = m_contacts.edges_of(t);
          if (std::find(own.begin(), own.end(), e) == own.end())
            m_segments[t].push_back({v, w});
        }
        v = w;
      }
    }
  }

  // Returns the parts of a triangle.
  std::vector<Triangle_indices> parts(std::size_t t) {
    const Polygon boundary = polygon(t);
    if (m_contacts.inside(t).empty() && boundary.size() == 3)
      return {{boundary[0], boundary[1], boundary[2]}};
    if (boundary.size() < 3)
      return {};
    if (std::set<std::size_t>(boundary.begin(), boundary.end()).size() == boundary.size()) {
      Triangle_division_3 division(m_points, m_soup.triangles[t], boundary);
      for (std::size_t v : m_contacts.inside(t))
        division.insert(v);
      for (const auto& [v, w] : m_segments[t])
        division.insert(v, w);
      const auto result = division.triangles();
      if (is_boundary(boundary, result))
        return result;
    }
    return fan(boundary);
  }

  using Edge_set = std::set<std::pair<std::size_t, std::size_t>>;

  // Adds an edge, or removes it if it is in the set.
  static void toggle(Edge_set& edges, std::size_t v, std::size_t w) {
    if (v != w)
      if (const auto [place, is_new] = edges.insert(std::minmax(v, w)); !is_new)
        edges.erase(place);
  }

  // Returns whether triangles fill a closed polygon: whether other edges have an even number of
  // triangles.
  static bool is_boundary(const Polygon& polygon, const std::vector<Triangle_indices>& triangles) {
    Edge_set edges;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      toggle(edges, polygon[i], polygon[(i + 1) % polygon.size()]);
    for (const Triangle_indices& t : triangles)
      for (int i = 0; i < 3; ++i)
        toggle(edges, t[i], t[(i + 1) % 3]);
    return edges.empty();
  }

  // Fills a polygon with little area, which may cross itself, with triangles at its first vertex.
  static std::vector<Triangle_indices> fan(const Polygon& polygon) {
    std::vector<Triangle_indices> result;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      if (polygon[i - 1] != polygon[i] && polygon[i - 1] != polygon[0] && polygon[i] != polygon[0])
        result.push_back({polygon[0], polygon[i - 1], polygon[i]});
    return result;
  }

  const Split_soup_3& m_soup;
  const Soup_contacts_3& m_contacts;
  std::vector<Coordinates_3> m_points;
  std::vector<std::vector<std::size_t>> m_triangles_at;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> m_segments;
};

// Returns the corners of all triangles, sorted.
inline std::vector<Triangle_indices> sorted_corners(const Triangle_soup_3& soup) {
  std::vector<Triangle_indices> result = soup.triangles;
  std::transform(result.begin(), result.end(), result.begin(), sorted);
  std::sort(result.begin(), result.end());
  return result;
}

// Welds the triangles of a soup: points, edges and triangles that are nearer to each other than a
// distance become common points, edges and triangles. Points move by about this distance at most.
// In each edge, the number of triangles remains even or odd.
//
// Walls between solids that were divided differently thus get the same triangles, though rounding
// has moved them apart or through each other. The distance should exceed the rounding, but not the
// size of features. Flat triangles stay where their removal would only make others.
//
// Returns `false` if the distance is too large beside the features or less than the rounding, so
// that welds make new contacts. Each round is O(n log n).
inline bool weld(Split_soup_3& soup, double distance) {
  static constexpr int most_rounds = 20, first_rounds = 3; // three are usual
  std::size_t first_contacts = 0;
  std::vector<Triangle_indices> last, before_last;
  for (int round = 0; round < most_rounds; ++round) {
    merge_near_points(soup, distance);
    const Soup_contacts_3 contacts(soup, distance);
    if (contacts.size() == 0)
      return true;
    if (round < first_rounds)
      first_contacts = (std::max)(first_contacts, contacts.size());
    else if (contacts.size() > first_contacts)
      return false;
    else if (contacts.new_points().empty()) {
      const auto present = sorted_corners(soup);
      if (present == last || present == before_last)
        return true;
      before_last = std::exchange(last, present);
    }
    soup = Contact_division_3(soup, contacts).run();
    cancel_folds(soup);
  }
  return false;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_TRIANGLE_SOUP_REPAIR_INTERNAL_ARRANGEMENT_WELD_SOUP_3_H
