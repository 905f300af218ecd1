// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_COLLECTED_POINTS_H
#define CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_COLLECTED_POINTS_H

#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL {

template <typename Point, typename Vector> class Point_set_3;

namespace Deformable_simplicial_complexes {
namespace internal {

// Points of any kernel, and their normals. There are no normals, or as many as points.
struct Collected_points
{
  std::vector<Epick::Point_3> points;
  std::vector<Epick::Vector_3> normals;

  template <class P> void add_point(const P& p) {
    points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  template <class V> void add_normal(const V& v) {
    normals.emplace_back(to_double(v.x()), to_double(v.y()), to_double(v.z()));
  }
};

// The points and normals of a range if no maps are given. Only a `Point_set_3` has normals.
template <class Range> struct Own_maps
{
  template <class Key> static void add_point(const Range&, const Key& key, Collected_points& to) {
    to.add_point(key);
  }
  template <class Key> static void add_normal(const Range&, const Key&, Collected_points&) {}
};

template <class Point, class Vector> struct Own_maps<Point_set_3<Point, Vector>>
{
  using Set = Point_set_3<Point, Vector>;

  static void add_point(const Set& set, typename Set::Index i, Collected_points& to) {
    to.add_point(set.point(i));
  }
  static void add_normal(const Set& set, typename Set::Index i, Collected_points& to) {
    if (set.has_normal_map())
      to.add_normal(set.normal(i));
  }
};

template <class Range, class NamedParameters>
Collected_points collect_points(const Range& range, const NamedParameters& np) {
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  Collected_points result;
  for (const auto& key : range) {
    Progress_scope::check();
    if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::point_t>::value)
      Own_maps<Range>::add_point(range, key, result);
    else
      result.add_point(get(get_parameter(np, CGAL::internal_np::point_map), key));
    if constexpr (is_default_parameter<NamedParameters, CGAL::internal_np::normal_t>::value)
      Own_maps<Range>::add_normal(range, key, result);
    else
      result.add_normal(get(get_parameter(np, CGAL::internal_np::normal_map), key));
  }
  return result;
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_SOLID_RECONSTRUCTION_3_INTERNAL_CLOUDS_COLLECTED_POINTS_H
