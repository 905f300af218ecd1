// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_DISTANCE_H
#define DSC_START_DISTANCE_H

#include "input/start_curves.h"
#include "input/surface.h"
#include "output/statistics.h"

#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>

#include <CGAL/AABB_tree.h>

namespace dsc {

/// The distance of an interface from its initial surfaces.
class Start_distance
{
public:
  explicit Start_distance(const std::vector<Surface>& surfaces);
  explicit Start_distance(const Curves& curves);

  /// Returns the statistics of the distances of points, in units of `edge`; `nullopt` without
  /// points.
  std::optional<Distance_statistics> of(const std::vector<Surface_point>& points,
                                        double edge) const;

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Tree_traits = DSC::Tree_traits_3<Kernel, Triangles::const_iterator>;

  using Segments = std::vector<Kernel::Segment_3>; // of curves in the plane, with z = 0
  using Segment_traits = DSC::Segment_tree_traits_3<Kernel, Segments::const_iterator>;

  Triangles m_triangles;
  Segments m_segments;
  CGAL::AABB_tree<Tree_traits> m_tree;
  CGAL::AABB_tree<Segment_traits> m_segment_tree; // one of the two trees is empty
};

} // namespace dsc

#endif // DSC_START_DISTANCE_H
