// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_holes.h"

#include "fluids/fluid_of_dimension.h"
#include "programs/errors.h"

#include <CGAL/Incompressible_fluids_3/Solids_3.h>

namespace dsc {
namespace {

using Place_of_hole = std::array<double, 3>;

/// Returns the displacement of a solid at time 0.
/// \throws Input_error if the solid is a box that is rotated at time 0
Place_of_hole displacement_at_start(const Scene_solid& solid, std::size_t index) {
  if (!solid.place)
    return {};
  const Scene_solid::Place place = solid.place(0);
  if (solid.kind == Scene_solid::Kind::box && place.rotation != CGAL::NULL_VECTOR)
    throw Input_error("the rotation of solids[" + std::to_string(index) +
                      "] of the scene must be 0 at the time 0 because the solid is a box");
  return coordinates_of(place.displacement);
}

Nearest_boundary nearest_boundary(const Box_shape& box, const Place_of_hole& p, int dimension) {
  using DSC::Box_solid_3;
  const auto& [from, to] = box;
  const Box_solid_3 solid =
      dimension == 2 ? Box_solid_3(CGAL::Bbox_2(from[0], from[1], to[0], to[1]))
                     : Box_solid_3(CGAL::Bbox_3(from[0], from[1], from[2], to[0], to[1], to[2]));
  const auto wall = solid.nearest_wall({p[0], p[1], p[2]});
  return {wall.distance, coordinates_of(-wall.distance * wall.normal)};
}

Nearest_boundary nearest_boundary(const Ball_shape& ball, const Place_of_hole& p) {
  double r = 0;
  for (std::size_t i = 0; i < 3; ++i)
    r = std::hypot(r, p[i] - ball.center[i]);
  Nearest_boundary result = {r - ball.radius, {}};
  for (std::size_t i = 0; i < 3; ++i)
    result.offset[i] = r > 0 ? (p[i] - ball.center[i]) * (ball.radius / r - 1) : 0;
  return result;
}

/// Returns the bounding box of a hole.
Box_shape bounds_of_hole(const Hole& hole) {
  if (const auto* box = std::get_if<Box_shape>(&hole.shape))
    return *box;
  const auto& ball = std::get<Ball_shape>(hole.shape);
  Box_shape result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.from[i] = ball.center[i] - ball.radius;
    result.to[i] = ball.center[i] + ball.radius;
  }
  return result;
}

/// Returns whether a hole and the inside of a box have a common point.
bool meets_box(const Hole& hole, const Box_shape& box, int dimension) {
  if (!boxes_overlap(bounds_of_hole(hole), box, dimension))
    return false;
  const auto* ball = std::get_if<Ball_shape>(&hole.shape);
  Place_of_hole nearest = {}; // point of the box to the center of the ball
  for (std::size_t i = 0; ball && i < std::size_t(dimension); ++i)
    nearest[i] = std::clamp(ball->center[i], box.from[i], box.to[i]);
  return !ball || nearest_boundary(*ball, nearest).distance < 0;
}

/// Returns whether a ray from a point crosses a curve an odd number of times: whether the curve is
/// around the point.
bool is_around(const Curve& curve, const Place_of_hole& p) {
  bool result = false;
  for (const auto& [i, j] : curve.segments) {
    const Curve_point &a = curve.points[i], &b = curve.points[j];
    if ((a.y() > p[1]) != (b.y() > p[1]) &&
        p[0] < a.x() + (p[1] - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      result = !result;
  }
  return result;
}

/// Returns whether a surface is around a point, by a ray along the z-axis.
bool is_around(const Surface& surface, const Place_of_hole& p) {
  // Edges of the projections are compared in the same order in both of their triangles.
  const auto crosses = [&](std::size_t i, std::size_t j) {
    const Surface_point &a = surface.points[(std::min)(i, j)],
                        &b = surface.points[(std::max)(i, j)];
    return (a.y() > p[1]) != (b.y() > p[1]) &&
           p[0] < a.x() + (p[1] - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
  };
  bool result = false;
  for (const auto& [i, j, k] : surface.triangles) {
    if ((crosses(i, j) != crosses(j, k)) == crosses(k, i))
      continue; // an even number of edges
    const Surface_point& a = surface.points[i];
    const auto normal = CGAL::cross_product(surface.points[j] - a, surface.points[k] - a);
    const double height = a.z() - (normal.x() * (p[0] - a.x()) + normal.y() * (p[1] - a.y())) /
                                      normal.z(); // not horizontal, because the ray crosses it
    if (p[2] < height)
      result = !result;
  }
  return result;
}

enum class Position { outside, inside, crossing };

/// Returns the position of a hole relative to a boundary. It is `crossing`, too, if the boundary is
/// inside the hole.
template <class Boundary>
Position position_of_hole(const Hole& hole, const Boundary& of_hole, const Boundary& boundary) {
  constexpr int dimension = std::is_same_v<Boundary, Curve> ? 2 : 3;
  static constexpr double rounding = 1e-6; // relative to the size of the hole
  static constexpr std::size_t samples = 64;
  const Box_shape bounds = bounds_of_hole(hole);
  const double size = bounds.to[0] - bounds.from[0];
  Place_of_hole center = {};
  for (std::size_t i = 0; i < dimension; ++i)
    center[i] = (bounds.from[i] + bounds.to[i]) / 2;
  for (const auto& p : boundary.points)
    if (nearest_boundary(hole, coordinates_of(p), dimension).distance < -rounding * size)
      return Position::crossing;
  const std::size_t stride = of_hole.points.size() / samples + 1;
  std::size_t all = 0, inside = 0;
  for (std::size_t k = 0; k < of_hole.points.size(); k += stride, ++all) {
    Place_of_hole p = coordinates_of(of_hole.points[k]);
    for (std::size_t i = 0; i < dimension; ++i)
      p[i] += rounding * (center[i] - p[i]);
    inside += is_around(boundary, p);
  }
  return inside == 0 ? Position::outside : inside == all ? Position::inside : Position::crossing;
}

} // namespace

Nearest_boundary nearest_boundary(const Hole& hole, const std::array<double, 3>& p, int dimension) {
  if (const auto* ball = std::get_if<Ball_shape>(&hole.shape))
    return nearest_boundary(*ball, p);
  return nearest_boundary(std::get<Box_shape>(hole.shape), p, dimension);
}

std::vector<Hole> holes_of(const Fluid_scene& scene) {
  std::vector<Hole> result;
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    const Scene_solid& solid = scene.solids[s];
    if (solid.kind == Scene_solid::Kind::box) {
      const Place_of_hole d = displacement_at_start(solid, s);
      Box_shape box = box_shape(solid.box);
      for (std::size_t i = 0; i < 3; ++i) {
        box.from[i] += d[i];
        box.to[i] += d[i];
      }
      result.push_back({s, box});
    } else if (solid.kind == Scene_solid::Kind::ball && !solid.contains_liquid) {
      const Place_of_hole d = displacement_at_start(solid, s);
      Ball_shape ball{solid.point, solid.radius, 0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i)
        ball.center[i] += d[i];
      result.push_back({s, ball});
    }
  }
  return result;
}

int label_of_holes(const Fluid_scene& scene) {
  if (!is_liquid(scene, 0))
    return 0;
  int largest = 0;
  for (const auto& filling : shapes_of(scene))
    largest = (std::max)(largest, filling.first);
  return largest + 1;
}

bool boxes_overlap(const Box_shape& a, const Box_shape& b, int dimension) {
  for (std::size_t i = 0; i < std::size_t(dimension); ++i)
    if (!(a.from[i] < b.to[i] && b.from[i] < a.to[i]))
      return false;
  return true;
}

bool may_meet(const Hole& hole, const Fluid_shape& shape, const Fluid_scene& scene) {
  if (!meets_box(hole, box_shape(scene.domain), scene.dimension))
    return false;
  if (const auto* given = std::get_if<Box_shape>(&shape))
    return meets_box(hole, *given, scene.dimension);
  const auto* pool = std::get_if<Pool_shape>(&shape);
  return !pool || bounds_of_hole(hole).from[std::size_t(scene.dimension - 1)] < pool->level;
}

template <class Boundary>
bool is_in_liquid(const Fluid_scene& scene, const Hole& hole, const Boundary& of_hole,
                  const std::vector<Boundary>& others) {
  bool result = is_liquid(scene, 0);
  double least_size = std::numeric_limits<double>::infinity();
  for (const Boundary& boundary : others) {
    const Position position = position_of_hole(hole, of_hole, boundary);
    if (position == Position::crossing && is_liquid(scene, boundary.label))
      throw Input_error("a liquid of the scene is partly inside a solid at the start: its surface "
                        "crosses solids[" +
                        std::to_string(hole.solid) +
                        "], or is inside it; move the liquid or the solid");
    if (position != Position::inside)
      continue;
    auto box = boundary.points.front().bbox();
    for (const auto& p : boundary.points)
      box += p.bbox();
    const double size = box.xmax() - box.xmin() + box.ymax() - box.ymin();
    if (size < least_size) {
      least_size = size;
      result = is_liquid(scene, boundary.label);
    }
  }
  return result;
}

template bool is_in_liquid(const Fluid_scene&, const Hole&, const Curve&,
                           const std::vector<Curve>&);
template bool is_in_liquid(const Fluid_scene&, const Hole&, const Surface&,
                           const std::vector<Surface>&);

} // namespace dsc
