// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_BENCHMARK_TRIANGLE_DISTANCES_H
#define DSC_BENCHMARK_TRIANGLE_DISTANCES_H

#include "inputs.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>

#include <cmath>
#include <utility>
#include <vector>

namespace dsc_benchmark {

/// Distances from triangles.
class Triangle_distances
{
public:
  using Triangles = std::vector<Kernel::Triangle_3>;

  explicit Triangle_distances(Triangles triangles)
      : m_triangles(std::move(triangles)), m_tree(m_triangles.begin(), m_triangles.end()) {
    m_tree.accelerate_distance_queries();
  }
  Triangle_distances(const Triangle_distances&) = delete;
  Triangle_distances& operator=(const Triangle_distances&) = delete;

  double operator()(const Kernel::Point_3& p) const {
    return std::sqrt(m_tree.squared_distance(p));
  }

private:
  using Traits =
      CGAL::Deformable_simplicial_complexes::Tree_traits_3<Kernel, Triangles::const_iterator>;

  Triangles m_triangles;
  CGAL::AABB_tree<Traits> m_tree;
};

} // namespace dsc_benchmark

#endif // DSC_BENCHMARK_TRIANGLE_DISTANCES_H
