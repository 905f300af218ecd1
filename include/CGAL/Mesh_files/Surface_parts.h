// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_SURFACE_PARTS_H
#define CGAL_MESH_FILES_SURFACE_PARTS_H

#include <CGAL/Mesh_support/internal/sets/equal_points.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>

#include <string>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshFilesRef

The parts of a surface that a file names: the solids of an STL file, or the objects of an OBJ file.
If an OBJ file has fewer than two objects, its groups. Solids with the same name are one part.

\sa `read_labeled_surface()`
\sa `separate_parts()`
*/
struct Surface_parts
{
  /// names of the parts, in the order of their first triangles; the name of triangles without a
  /// name is empty
  std::vector<std::string> names;
  std::vector<std::size_t> of_triangles; ///< part of each triangle, an index into `names`
};

namespace internal {

// An edge of a triangle of a part.
struct Edge_of_part
{
  std::array<std::size_t, 2> ends; // increasing
  std::size_t part;

  friend bool operator<(const Edge_of_part& a, const Edge_of_part& b) {
    return a.ends == b.ends ? a.part < b.part : a.ends < b.ends;
  }
};

template <class Point>
std::vector<Edge_of_part> sorted_edges(const Labeled_surface_3<Point>& surface,
                                       const Surface_parts& parts) {
  std::vector<std::array<double, 3>> coordinates;
  coordinates.reserve(surface.points.size());
  for (const Point& p : surface.points)
    coordinates.push_back({to_double(p.x()), to_double(p.y()), to_double(p.z())});
  const std::vector<std::size_t> place = first_equal_points(coordinates);
  std::vector<Edge_of_part> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = place[surface.triangles[t][i]],
                        b = place[surface.triangles[t][(i + 1) % 3]];
      result.push_back({{(std::min)(a, b), (std::max)(a, b)}, parts.of_triangles[t]});
    }
  std::sort(result.begin(), result.end());
  return result;
}

// Returns whether an edge with a single triangle in one part has triangles in other parts.
template <class Point>
bool do_parts_close_each_other(const Labeled_surface_3<Point>& surface,
                               const Surface_parts& parts) {
  const std::vector<Edge_of_part> edges = sorted_edges(surface, parts);
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto end =
        std::find_if(edge, edges.end(), [&](const auto& e) { return e.ends != edge->ends; });
    for (auto first = edge; first != end;) {
      const auto next =
          std::find_if(first, end, [&](const auto& e) { return e.part != first->part; });
      if (next - first == 1 && end - edge > 1)
        return true;
      first = next;
    }
    edge = end;
  }
  return false;
}

} // namespace internal

/*!
\ingroup PkgMeshFilesRef

Returns the surface of each part. The labels are `surface.label`, `surface.label` + 1 and so on, in
the order of the parts. If a part has a boundary edge at which another part has triangles, the parts
bound solids only together, like the smoothing groups of a surface. Then the whole surface is the
only element of the result. n log n in the number of triangles.

\param surface a surface
\param parts its parts

\sa `read_labeled_surface()`
*/
template <class Point>
std::vector<Labeled_surface_3<Point>> separate_parts(const Labeled_surface_3<Point>& surface,
                                                     const Surface_parts& parts) {
  const std::size_t n = parts.names.size();
  if (n < 2 || internal::do_parts_close_each_other(surface, parts))
    return {surface};
  std::vector<Labeled_surface_3<Point>> result(n);
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::array<std::size_t, 2>> place(surface.points.size(), {none, none});
  std::vector<std::vector<std::size_t>> triangles(n);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    triangles[parts.of_triangles[t]].push_back(t);
  for (std::size_t part = 0; part < n; ++part) {
    result[part].label = surface.label + int(part);
    for (const std::size_t t : triangles[part]) {
      std::array<std::size_t, 3> corners = surface.triangles[t];
      for (std::size_t& corner : corners) {
        auto& [of, index] = place[corner];
        if (of != part) {
          of = part;
          index = result[part].points.size();
          result[part].points.push_back(surface.points[corner]);
        }
        corner = index;
      }
      result[part].triangles.push_back(corners);
    }
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_FILES_SURFACE_PARTS_H
