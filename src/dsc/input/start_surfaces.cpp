// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/surface.h"

#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/bounding_box.h>

namespace dsc {
namespace {

using Surface_vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;

constexpr std::size_t triangles_of_balls = 5120;

Surface_point center(const Ball& ball) { return {ball.center[0], ball.center[1], ball.center[2]}; }

double length(const Surface_vector& v) { return std::sqrt(v.squared_length()); }

/// Returns a sphere: an icosahedron whose faces are divided into n^2 triangles and projected to the
/// sphere. The number n is chosen so that the number of triangles is nearest to `triangles`.
Surface sphere(const Ball& ball, std::size_t triangles) {
  const auto n = (std::max)(1, static_cast<int>(std::lround(std::sqrt(triangles / 20.))));
  CGAL::Surface_mesh<Surface_point> icosahedron;
  CGAL::make_icosahedron(icosahedron, Surface_point(0, 0, 0));
  Surface surface;
  surface.label = 1;
  // A point is identified by the corners of its simplex and by its barycentric coordinates.
  std::map<std::map<std::size_t, int>, std::size_t> known;
  for (const auto face : icosahedron.faces()) {
    std::array<std::size_t, 3> corners;
    std::size_t k = 0;
    for (const auto v : icosahedron.vertices_around_face(icosahedron.halfedge(face)))
      corners[k++] = v;
    const auto point = [&](int i, int j) {
      std::map<std::size_t, int> weights;
      const std::array<int, 3> weight = {n - i - j, i, j};
      for (std::size_t c = 0; c < 3; ++c)
        if (weight[c] > 0)
          weights[corners[c]] = weight[c];
      const auto [place, is_new] = known.emplace(weights, surface.points.size());
      if (is_new) {
        Surface_vector sum(0, 0, 0);
        for (const auto& [corner, times] : weights)
          sum += times * (icosahedron.points()[CGAL::SM_Vertex_index(corner)] - CGAL::ORIGIN);
        surface.points.push_back(center(ball) + ball.radius / length(sum) * sum);
      }
      return place->second;
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        surface.triangles.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
        if (i + j + 1 < n)
          surface.triangles.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
      }
  }
  return surface;
}

/// Moves and scales surfaces together, so that they touch the ball from inside. The center of their
/// common bounding box is moved to the center of the ball.
void fit(std::vector<Surface>& surfaces, const Ball& ball) {
  CGAL::Bbox_3 box;
  for (const Surface& surface : surfaces)
    for (const auto& triangle : surface.triangles)
      for (const std::size_t corner : triangle)
        box += surface.points[corner].bbox();
  const Surface_point middle = CGAL::midpoint(Surface_point(box.xmin(), box.ymin(), box.zmin()),
                                              Surface_point(box.xmax(), box.ymax(), box.zmax()));
  double farthest = 0;
  for (const Surface& surface : surfaces)
    for (const auto& triangle : surface.triangles)
      for (const std::size_t corner : triangle)
        farthest = (std::max)(farthest, length(surface.points[corner] - middle));
  for (Surface& surface : surfaces)
    for (Surface_point& p : surface.points)
      p = center(ball) + ball.radius * ((p - middle) / farthest);
}

/// Returns whether surfaces are closed and do not touch. The others are divided when they are
/// filled, and their interface is resampled then.
bool are_separate(const std::vector<Surface>& surfaces) {
  try {
    DSC::internal::check_surfaces(DSC::internal::soups_of(surfaces));
  } catch (const DSC::Invalid_surface_error&) {
    return false;
  }
  return !DSC::have_contacts_3(surfaces);
}

} // namespace

Surfaces start_surfaces(const Run_start& start, std::size_t most_triangles) {
  return start_surfaces(start, read_surfaces(start), most_triangles);
}

Surfaces start_surfaces(const Run_start& start, Surfaces surfaces, std::size_t most_triangles) {
  if (start.inputs.empty())
    return {{sphere(*start.ball, start.triangles > 0 ? start.triangles : triangles_of_balls)},
            {"the ball"},
            {}};
  if (start.triangles > 0) {
    std::size_t present = 0;
    for (const Surface& surface : surfaces.all)
      present += surface.triangles.size();
    const std::size_t target = (std::min)(start.triangles, (std::max)(present, most_triangles));
    if (target != present && are_separate(surfaces.all))
      resample(surfaces, target);
  }
  if (start.ball)
    fit(surfaces.all, *start.ball);
  return surfaces;
}

} // namespace dsc
