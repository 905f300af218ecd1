// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_DISTANCE_H
#define DSC_START_DISTANCE_H

#include "statistics.h"
#include "surface.h"

#include <CGAL/Deformable_simplicial_complexes/internal/complex/cgal_compat.h>

#include <CGAL/AABB_tree.h>

#include <optional>
#include <vector>

namespace dsc {

/// How far an interface is from the surfaces that it started from.
class Start_distance
{
public:
  explicit Start_distance(const std::vector<Surface>& surfaces);

  /// Of points, in units of `edge`; nothing if there are none.
  std::optional<Distance_statistics> of(const std::vector<Surface_point>& points,
                                        double edge) const;

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Tree_traits =
      CGAL::Deformable_simplicial_complexes::internal::Tree_traits_3<Kernel,
                                                                     Triangles::const_iterator>;

  Triangles m_triangles;
  CGAL::AABB_tree<Tree_traits> m_tree;
};

} // namespace dsc

#endif // DSC_START_DISTANCE_H
