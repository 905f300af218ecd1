// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_DESTINATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_DESTINATIONS_H

#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL::Deformable_simplicial_complexes {

// Throws an exception if points or vectors are not finite. Linear in their number.
//
// \param values points or vectors, one for each vertex of an interface
// \param name name of one value in the message of the exception, such as `a velocity`
// \throws Invalid_destination_error with the indices of all values that have an infinite or NaN
//         coordinate
template <class Values> void require_finite(const Values& values, const std::string& name) {
  std::vector<std::size_t> refused;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!has_finite_coordinates(values[i]))
      refused.push_back(i);
  if (!refused.empty())
    throw Invalid_destination_error(name + " is not finite; check the velocities and the time step",
                                    refused);
}

} // namespace CGAL::Deformable_simplicial_complexes

namespace CGAL::Deformable_simplicial_complexes::internal {

// The destinations of vertices at the end of a deformation, and their positions at its beginning.
template <class Complex> class Destinations
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Point = typename Complex::Point;
  using Position = typename Complex::Point;

  explicit Destinations(const Complex& complex) : m_complex(complex) {}

  // Adds the destination of v, unless it is the point of v. Must be called by increasing time
  // stamp, and before anything moves.
  void add(Vertex_handle v, const Point& destination) {
    if (v->point() == destination)
      return;
    m_open.push_back(m_items.size());
    m_unfinished.push_back(v);
    m_items.push_back({v, v->time_stamp(), m_complex.position(v), destination, true});
  }

  // Adds a vertex of a motion that began earlier: the vertex was at `before`, and its destination
  // is open if it can still be reached. Must be called by increasing time stamp.
  void resume(Vertex_handle v, const Position& before, const Point& destination, bool is_open) {
    if (is_open) {
      m_open.push_back(m_items.size());
      m_unfinished.push_back(v);
    }
    m_items.push_back({v, v->time_stamp(), before, destination, is_open});
  }

  // Returns the vertices that have not reached their destinations, by increasing time stamp.
  const std::vector<Vertex_handle>& unfinished() const { return m_unfinished; }

  // Numbers of vertices that can no longer reach their destinations.
  struct Lost
  {
    std::size_t removed = 0; // by a collapse
    std::size_t merged = 0;  // they are no longer on the interface
  };

  // Removes the vertices that have reached their destinations since the last call. Returns the
  // vertices that can no longer reach them.
  Lost update() {
    Lost lost;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < m_open.size(); ++k) {
      Item& item = m_items[m_open[k]];
      const bool is_alive = m_complex.is_alive(item.vertex, item.time_stamp),
                 has_arrived = is_alive && item.vertex->point() == item.destination;
      item.is_open = is_alive && !has_arrived && item.vertex->is_interface();
      if (item.is_open) {
        m_open[kept] = m_open[k];
        m_unfinished[kept] = item.vertex;
        ++kept;
      } else if (!has_arrived) {
        ++(is_alive ? lost.merged : lost.removed);
      }
    }
    m_open.resize(kept);
    m_unfinished.resize(kept);
    return lost;
  }

  // Returns whether v has a destination that it has not reached yet.
  bool has(Vertex_handle v) const {
    const Item* item = find(v);
    return item && item->is_open;
  }

  // Returns the destination of v.
  // \pre has(v)
  const Point& operator[](Vertex_handle v) const {
    CGAL_precondition(has(v));
    return find(v)->destination;
  }

  // Returns the destination of v, or its current position if it has none.
  Position final_position(Vertex_handle v) const {
    const Item* item = find(v);
    return item && item->is_open ? item->destination : m_complex.position(v);
  }

  // Returns the position of v before the deformation, or its current position if it had no
  // destination.
  Position position_before(Vertex_handle v) const {
    const Item* item = find(v);
    return item ? item->before : m_complex.position(v);
  }

  // Returns whether v had a destination different from its initial position.
  bool had(Vertex_handle v) const { return find(v) != nullptr; }

  // Returns the vertices with had(v) that are still on the interface.
  std::vector<Vertex_handle> moved() const {
    std::vector<Vertex_handle> result;
    for (const Item& item : m_items)
      if (m_complex.is_alive(item.vertex, item.time_stamp) && item.vertex->is_interface())
        result.push_back(item.vertex);
    return result;
  }

  // Return the destination and the remaining distance of the k-th unfinished vertex.
  const Point& destination(std::size_t k) const { return m_items[m_open[k]].destination; }
  double remaining_distance(std::size_t k) const {
    const Item& item = m_items[m_open[k]];
    return Complex::Space::length(m_complex.displacement(item.vertex, item.destination));
  }

  // Returns the sum of the remaining distances of all unfinished vertices.
  double remaining_distance() const {
    double sum = 0;
    for (std::size_t k = 0; k < m_open.size(); ++k)
      sum += remaining_distance(k);
    return sum;
  }

  // Returns the index of the unfinished vertex with the largest remaining distance; 0 without any.
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
  struct Item
  {
    Vertex_handle vertex;
    std::size_t time_stamp; // the vertex may have been removed
    Position before;
    Point destination;
    bool is_open;
  };

  const Item* find(Vertex_handle v) const {
    const auto it = std::lower_bound(
        m_items.begin(), m_items.end(), v->time_stamp(),
        [](const Item& item, std::size_t time_stamp) { return item.time_stamp < time_stamp; });
    return it != m_items.end() && it->time_stamp == v->time_stamp() ? &*it : nullptr;
  }

  const Complex& m_complex;
  std::vector<Item> m_items;               // sorted by time stamp
  std::vector<std::size_t> m_open;         // indices of unfinished entries of `m_items`
  std::vector<Vertex_handle> m_unfinished; // vertices of these entries
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_DESTINATIONS_DESTINATIONS_H
