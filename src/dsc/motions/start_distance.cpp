// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/start_distance.h"

namespace dsc {

Start_distance::Start_distance(const std::vector<Surface>& surfaces) {
  for (const Surface& surface : surfaces)
    for (const auto& [a, b, c] : surface.triangles)
      m_triangles.emplace_back(surface.points[a], surface.points[b], surface.points[c]);
  m_tree.rebuild(m_triangles.cbegin(), m_triangles.cend());
}

Start_distance::Start_distance(const Curves& curves) {
  const auto in_space = [](const auto& p) { return Surface_point(p.x(), p.y(), 0); };
  for_each_segment(curves, [&](const auto& p, const auto& q) {
    m_segments.emplace_back(in_space(p), in_space(q));
  });
  m_segment_tree.rebuild(m_segments.cbegin(), m_segments.cend());
}

std::optional<Distance_statistics> Start_distance::of(const std::vector<Surface_point>& points,
                                                      double edge) const {
  if (points.empty())
    return std::nullopt;
  Distance_statistics result = {};
  for (const Surface_point& p : points) {
    const double squared =
        m_segments.empty() ? m_tree.squared_distance(p) : m_segment_tree.squared_distance(p);
    const double distance = std::sqrt(squared) / edge;
    result.mean += distance / static_cast<double>(points.size());
    result.maximum = (std::max)(result.maximum, distance);
  }
  return result;
}

} // namespace dsc
