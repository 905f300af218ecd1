// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_TEXT_H
#define CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_TEXT_H

#include <CGAL/Mesh_files/Mesh_entities.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The triangles of a MEDIT file: the triangles of a mesh, followed by the interface triangles that
// are not among them. Each pair of labels gets a reference of its own.
class Medit_triangles
{
public:
  using Triangle = Mesh_entities::Simplex<3>;

  // Collects the triangles. `labels` contains the two labels at each interface triangle.
  Medit_triangles(const std::vector<Triangle>& listed,
                  const std::vector<std::array<std::size_t, 3>>& interface_,
                  const std::vector<std::array<int, 2>>& labels)
      : m_triangles(listed) {
    std::vector<std::array<std::size_t, 3>> known;
    for (const Triangle& t : listed) {
      known.push_back(sorted(t.vertices));
      m_first_reference = (std::max)(m_first_reference, t.reference + 1LL);
    }
    std::sort(known.begin(), known.end());
    std::vector<std::size_t> added;
    for (std::size_t i = 0; i < interface_.size(); ++i)
      if (!std::binary_search(known.begin(), known.end(), sorted(interface_[i]))) {
        added.push_back(i);
        m_pairs.push_back(labels[i]);
      }
    std::sort(m_pairs.begin(), m_pairs.end());
    m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
    for (const std::size_t i : added) {
      const auto pair = std::lower_bound(m_pairs.begin(), m_pairs.end(), labels[i]);
      m_triangles.push_back({interface_[i], reference(std::size_t(pair - m_pairs.begin()))});
    }
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // Returns the pairs of labels of the added triangles, in the order of their references.
  const std::vector<std::array<int, 2>>& pairs() const { return m_pairs; }
  int reference(std::size_t pair) const {
    return static_cast<int>(m_first_reference + static_cast<long long>(pair));
  }

private:
  static std::array<std::size_t, 3> sorted(std::array<std::size_t, 3> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  std::vector<Triangle> m_triangles;
  std::vector<std::array<int, 2>> m_pairs;
  long long m_first_reference = 1;
};

template <std::size_t n>
void write_medit_simplices(std::ostream& out,
                           const std::vector<Mesh_entities::Simplex<n>>& simplices) {
  for (const auto& simplex : simplices) {
    for (const std::size_t v : simplex.vertices)
      out << v + 1 << ' ';
    out << simplex.reference << '\n';
  }
}

// Writes a section, or nothing if there are no elements.
template <std::size_t n>
void write_medit_section(std::ostream& out, const char* keyword,
                         const std::vector<Mesh_entities::Simplex<n>>& simplices) {
  if (simplices.empty())
    return;
  out << keyword << '\n' << simplices.size() << '\n';
  write_medit_simplices(out, simplices);
}

inline void write_medit_section(std::ostream& out, const char* keyword,
                                const std::vector<std::size_t>& indices) {
  if (indices.empty())
    return;
  out << keyword << '\n' << indices.size() << '\n';
  for (const std::size_t i : indices)
    out << i + 1 << '\n';
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_GRIDS_MEDIT_TEXT_H
