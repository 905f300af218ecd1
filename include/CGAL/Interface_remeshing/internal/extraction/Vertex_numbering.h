// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_VERTEX_NUMBERING_H
#define CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_VERTEX_NUMBERING_H

#include <CGAL/Deformable_simplicial_complexes/internal/complex/sort_by_time_stamp.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A numbering of vertices from zero by increasing time stamp.
template <class Vertex_handle> class Vertex_numbering
{
public:
  // The vertices can be given in any order and repeatedly.
  explicit Vertex_numbering(std::vector<Vertex_handle> vertices) : m_vertices(std::move(vertices)) {
    sort_by_time_stamp(m_vertices);
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
    m_time_stamps.reserve(m_vertices.size());
    for (Vertex_handle v : m_vertices)
      m_time_stamps.push_back(v->time_stamp());
  }

  const std::vector<Vertex_handle>& vertices() const { return m_vertices; }

  // Returns the number of v.
  // \pre v is one of the vertices
  std::size_t operator()(Vertex_handle v) const {
    const auto i = std::lower_bound(m_time_stamps.begin(), m_time_stamps.end(), v->time_stamp());
    return static_cast<std::size_t>(i - m_time_stamps.begin());
  }

private:
  std::vector<Vertex_handle> m_vertices;
  std::vector<std::size_t> m_time_stamps; // separate, for fast search
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_REMESHING_INTERNAL_EXTRACTION_VERTEX_NUMBERING_H
