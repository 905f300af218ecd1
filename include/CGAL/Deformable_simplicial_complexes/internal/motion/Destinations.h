// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DESTINATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DESTINATIONS_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Where vertices are to be at the end of a deformation, and where they were at its beginning.
template <class Complex> class Destinations
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Position = typename Complex::Approximate_point;

  explicit Destinations(const Complex& complex) : m_complex(complex) {}

  // A point that v may go to. By increasing time stamp, and before anything moves.
  void add(Vertex_handle v, const Point& destination) {
    if (v->point() == destination)
      return;
    m_open.push_back(m_ways.size());
    m_unfinished.push_back(v);
    m_ways.push_back({v, v->time_stamp(), m_complex.position(v), destination, true});
  }

  // Those that have not arrived, by increasing time stamp.
  const std::vector<Vertex_handle>& unfinished() const { return m_unfinished; }

  // Finds those that have arrived since the last call. Returns the number of those that will not,
  // as they are gone or have left the interface.
  std::size_t update() {
    std::size_t vanished = 0, kept = 0;
    for (std::size_t k = 0; k < m_open.size(); ++k) {
      Way& way = m_ways[m_open[k]];
      const bool is_alive = m_complex.is_alive(way.vertex, way.time_stamp),
                 has_arrived = is_alive && way.vertex->point() == way.destination;
      way.is_open = is_alive && !has_arrived && way.vertex->is_interface();
      if (way.is_open) {
        m_open[kept] = m_open[k];
        m_unfinished[kept] = way.vertex;
        ++kept;
      } else if (!has_arrived) {
        ++vanished;
      }
    }
    m_open.resize(kept);
    m_unfinished.resize(kept);
    return vanished;
  }

  // Whether v has not arrived.
  bool has(Vertex_handle v) const {
    const Way* way = find(v);
    return way && way->is_open;
  }

  // \pre has(v)
  const Point& operator[](Vertex_handle v) const {
    CGAL_precondition(has(v));
    return find(v)->destination;
  }

  // Where v is to be in the end.
  Position final_position(Vertex_handle v) const {
    const Way* way = find(v);
    return way && way->is_open ? m_complex.approximate(way->destination) : m_complex.position(v);
  }

  // Where v was.
  Position position_before(Vertex_handle v) const {
    const Way* way = find(v);
    return way ? way->before : m_complex.position(v);
  }

  // Whether it was at another place than its destination.
  bool had(Vertex_handle v) const { return find(v) != nullptr; }

  // Those that had another place than their destination and are still on the interface.
  std::vector<Vertex_handle> moved() const {
    std::vector<Vertex_handle> result;
    for (const Way& way : m_ways)
      if (m_complex.is_alive(way.vertex, way.time_stamp) && way.vertex->is_interface())
        result.push_back(way.vertex);
    return result;
  }

  // Where one of the unfinished vertices goes, and how far it still has to.
  const Point& destination(std::size_t k) const { return m_ways[m_open[k]].destination; }
  double remaining_distance(std::size_t k) const {
    const Way& way = m_ways[m_open[k]];
    return Complex::Space::length(
        m_complex.displacement(way.vertex, m_complex.approximate(way.destination)));
  }

  // Of all of them.
  double remaining_distance() const {
    double sum = 0;
    for (std::size_t k = 0; k < m_open.size(); ++k)
      sum += remaining_distance(k);
    return sum;
  }

  // The one of them with the longest way, if there is one.
  std::size_t farthest() const {
    std::size_t result = 0;
    double longest = 0;
    for (std::size_t k = 0; k < m_open.size(); ++k)
      if (const double distance = remaining_distance(k); distance > longest) {
        result = k;
        longest = distance;
      }
    return result;
  }

private:
  struct Way
  {
    Vertex_handle vertex;
    std::size_t time_stamp; // the vertex may have been removed
    Position before;
    Point destination;
    bool is_open;
  };

  const Way* find(Vertex_handle v) const {
    const auto it = std::lower_bound(
        m_ways.begin(), m_ways.end(), v->time_stamp(),
        [](const Way& way, std::size_t time_stamp) { return way.time_stamp < time_stamp; });
    return it != m_ways.end() && it->time_stamp == v->time_stamp() ? &*it : nullptr;
  }

  const Complex& m_complex;
  std::vector<Way> m_ways;                 // by time stamp
  std::vector<std::size_t> m_open;         // indices of ways
  std::vector<Vertex_handle> m_unfinished; // their vertices
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_MOTION_DESTINATIONS_H
