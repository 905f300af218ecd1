// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_INTERFACE_AT_START_H
#define DSC_BENCHMARK_INTERFACE_AT_START_H

#include "inputs.h"
#include "measures.h"

#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>

#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dsc_benchmark {

/// Distances from the triangles of the initial interface.
class Interface_at_start
{
public:
  explicit Interface_at_start(const Complex& complex) {
    for (const auto& facet : complex.interface_facets()) {
      const auto v = complex.facet_vertices(facet);
      m_triangles.emplace_back(kernel_point(complex.position(v[0])),
                               kernel_point(complex.position(v[1])),
                               kernel_point(complex.position(v[2])));
    }
    m_tree.rebuild(m_triangles.begin(), m_triangles.end());
  }

  /// Mean and maximum distance of the vertices of an interface.
  std::array<double, 2> distances(const Complex& complex) const {
    double sum = 0, maximum = 0;
    const auto vertices = complex.interface_vertices();
    for (const auto v : vertices) {
      const double d = std::sqrt(m_tree.squared_distance(kernel_point(complex.position(v))));
      sum += d;
      maximum = (std::max)(maximum, d);
    }
    return {sum / double(vertices.size()), maximum};
  }

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Tree_traits =
      CGAL::Deformable_simplicial_complexes::Tree_traits_3<Kernel, Triangles::const_iterator>;

  static Kernel::Point_3 kernel_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

  Triangles m_triangles;
  CGAL::AABB_tree<Tree_traits> m_tree;
};

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_INTERFACE_AT_START_H
