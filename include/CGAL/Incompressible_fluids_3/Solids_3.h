// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/internal/cgal/cgal_compat.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// A wall: a smooth part of the surface of a solid, as seen from a point.
struct Wall_3
{
  using Vector = Epick::Vector_3; ///< a vector in space

  double distance; ///< signed distance of the point, negative inside the solid
  Vector normal;   ///< outward normal of the solid, of unit length: the gradient of the distance
  Vector velocity = Vector(0, 0, 0); ///< velocity of the wall
  /// Whether the wall is seen from behind: it ends other walls of the solid at a convex edge. The
  /// normal points into the solid, and the distance is that to the plane of the wall. Vertices that
  /// slide along the other walls stay in front of this plane, while the liquid flows past the edge.
  bool is_end = false;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The side of a surface on which the solid lies.
enum class Solid_side {
  inside, ///< the solid is inside, liquids are outside
  /// The solid is outside, liquids are inside.
  outside
};

namespace internal {

// Returns a vector scaled to unit length. Vectors whose squared length overflows or underflows are
// accepted.
// \throws Error if the vector is zero or not finite
inline Wall_3::Vector unit_vector(const Wall_3::Vector& v, const char* name) {
  const double largest = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  const Wall_3::Vector scaled = v / largest, result = scaled / std::sqrt(scaled.squared_length());
  if (!std::isfinite(result.squared_length()))
    throw Error("the " + std::string(name) +
                " of a solid is zero or not finite: give a finite vector other than zero");
  return result;
}

// Checks a point or vector.
// \throws Error if a coordinate is not finite
template <class Coordinates> void require_place(const Coordinates& c, const char* name) {
  if (!std::isfinite(c.x()) || !std::isfinite(c.y()) || !std::isfinite(c.z()))
    throw Error("the " + std::string(name) + " of a solid is not finite: give finite coordinates");
}

// Checks a box.
// \throws Error if the box is empty or not finite
inline void require_box(const Bbox_3& box, const char* name) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.max(axis) > box.min(axis)) || !std::isfinite(box.min(axis)) ||
        !std::isfinite(box.max(axis)))
      throw Error(std::string(name) +
                  " is empty or not finite: use a finite box with positive sides");
}

// The set of points nearer to a center or an axis than a radius, or the complement of this set.
class Radius
{
public:
  Radius(double radius, Solid_side side)
      : m_radius(radius), m_sign(side == Solid_side::inside ? 1 : -1) {
    if (!(radius > 0) || !std::isfinite(radius))
      throw Error(
          "the radius of a solid is not positive and finite: use a positive, finite number");
  }

  // Appends the wall as seen from a point, given by its vector from the center or axis. Appends
  // nothing if this vector is zero.
  void walls(const Wall_3::Vector& from_center, std::vector<Wall_3>& result) const {
    const double r = std::sqrt(from_center.squared_length());
    if (r > 0)
      result.push_back({m_sign * (r - m_radius), m_sign / r * from_center});
  }

private:
  double m_radius, m_sign;
};

} // namespace internal

/// \ingroup PkgIncompressibleFluids3Ref
/// The half space behind a plane.
/// \cgalModels{Solid_3}
class Plane_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  /// Constructs the half space behind the plane through `point`. Liquids are on the side to which
  /// `normal` points. The normal can have any length.
  /// \throws Error if the normal is zero, or if an argument is not finite
  Plane_solid_3(const Point& point, const Vector& normal)
      : m_point(point), m_normal(internal::unit_vector(normal, "normal")) {
    internal::require_place(point, "point");
  }

  /// Appends the wall. Takes constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    result.push_back({(p - m_point) * m_normal, m_normal});
  }

private:
  Point m_point;
  Vector m_normal;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A tank: the outside of a box, with six walls, or five if it is open. In the plane, a tank has
/// four walls, or three if it is open.
/// \cgalModels{Solid_3}
class Tank_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  /// Constructs a tank.
  /// \param box the box that contains the liquids
  /// \param is_open whether the wall at the largest z coordinate is missing
  /// \throws Error if the box is empty or not finite
  explicit Tank_solid_3(const Bbox_3& box, bool is_open = false) : Tank_solid_3(box, is_open, 3) {}

  /// Constructs a tank in the plane.
  /// \param box the rectangle that contains the liquids
  /// \param is_open whether the wall at the largest y coordinate is missing
  /// \throws Error if the rectangle is empty or not finite
  explicit Tank_solid_3(const Bbox_2& box, bool is_open = false)
      : Tank_solid_3(Bbox_3(box.xmin(), box.ymin(), -1, box.xmax(), box.ymax(), 1), is_open, 2) {}

  /// Appends the walls. Takes constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    for (int axis = 0; axis < m_dimension; ++axis) {
      const Vector along(axis == 0, axis == 1, axis == 2);
      result.push_back({p[axis] - m_box.min(axis), along});
      if (axis < m_dimension - 1 || !m_is_open)
        result.push_back({m_box.max(axis) - p[axis], -along});
    }
  }

private:
  Tank_solid_3(const Bbox_3& box, bool is_open, int dimension)
      : m_box(box), m_is_open(is_open), m_dimension(dimension) {
    internal::require_box(box, "the box of a tank");
  }

  Bbox_3 m_box;
  bool m_is_open;
  int m_dimension;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A box, or a rectangle in the plane. Liquids are outside.
///
/// Vertices at an edge of the box touch both sides that meet there, so that they stay on the edge.
/// Other sides are ends of walls for the vertices on a side, see `Wall_3::is_end`.
/// \cgalModels{Solid_3}
class Box_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  /// Constructs a box.
  /// \throws Error if the box is empty or not finite
  explicit Box_solid_3(const Bbox_3& box) : Box_solid_3(box, 3) {}

  /// Constructs a rectangle in the plane.
  /// \throws Error if the rectangle is empty or not finite
  explicit Box_solid_3(const Bbox_2& box)
      : Box_solid_3(Bbox_3(box.xmin(), box.ymin(), -1, box.xmax(), box.ymax(), 1), 2) {}

  /// Returns the wall at the nearest point of the surface. Takes constant time.
  Wall_3 nearest_wall(const Point& p) const {
    const int side = outermost_side(p);
    const double distance = distance_of_plane(p, side);
    return distance > 0 ? wall_from_outside(p, m_box) : Wall_3{distance, outward(side)};
  }

  /// Appends the walls. Takes constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    const double outermost = distance_of_plane(p, outermost_side(p));
    for (int side = 0; side < 2 * m_dimension; ++side) {
      const double distance = distance_of_plane(p, side);
      if (outermost > m_width_of_edges)
        result.push_back(wall_from_outside(p, box_of_side(side)));
      else if (distance == outermost || std::abs(distance) <= m_width_of_edges)
        result.push_back({distance, outward(side)});
      else // the edge of the side ends other sides
        result.push_back({-distance, -outward(side), Vector(0, 0, 0), true});
    }
  }

private:
  Box_solid_3(const Bbox_3& box, int dimension) : m_box(box), m_dimension(dimension) {
    internal::require_box(box, "the box of a solid");
    double shortest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < dimension; ++axis)
      shortest = (std::min)(shortest, box.max(axis) - box.min(axis));
    // Changes of the mesh move vertices off an edge by less than this distance.
    static constexpr double width = 1e-3;
    m_width_of_edges = width * shortest;
  }

  // Sides are numbered in the order x minimum, x maximum, y minimum, and so on.
  static Vector outward(int side) {
    const double sign = side % 2 == 0 ? -1 : 1;
    return sign * Vector(side / 2 == 0, side / 2 == 1, side / 2 == 2);
  }
  double distance_of_plane(const Point& p, int side) const {
    const int axis = side / 2;
    return side % 2 == 0 ? m_box.min(axis) - p[axis] : p[axis] - m_box.max(axis);
  }

  // Returns the side of whose plane a point is farthest outside.
  int outermost_side(const Point& p) const {
    int result = 0;
    for (int side = 1; side < 2 * m_dimension; ++side)
      if (distance_of_plane(p, side) > distance_of_plane(p, result))
        result = side;
    return result;
  }
  Bbox_3 box_of_side(int side) const {
    std::array<double, 3> from, to;
    for (int axis = 0; axis < 3; ++axis) {
      from[std::size_t(axis)] = side == 2 * axis + 1 ? m_box.max(axis) : m_box.min(axis);
      to[std::size_t(axis)] = side == 2 * axis ? m_box.min(axis) : m_box.max(axis);
    }
    return {from[0], from[1], from[2], to[0], to[1], to[2]};
  }

  // Returns the wall at the nearest point of a box that does not contain the point.
  Wall_3 wall_from_outside(const Point& p, const Bbox_3& box) const {
    Vector offset(0, 0, 0); // from the nearest point
    for (int axis = 0; axis < m_dimension; ++axis) {
      const double d = p[axis] - std::clamp(p[axis], box.min(axis), box.max(axis));
      offset = offset + Vector(axis == 0 ? d : 0, axis == 1 ? d : 0, axis == 2 ? d : 0);
    }
    const double distance = std::sqrt(offset.squared_length());
    return {distance, offset / distance};
  }

  Bbox_3 m_box;
  int m_dimension;
  double m_width_of_edges;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A ball, or the outside of a ball.
/// \cgalModels{Solid_3}
class Ball_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  /// Constructs a ball, or its outside.
  /// \throws Error if the radius is not positive, or if an argument is not finite
  Ball_solid_3(const Point& center, double radius, Solid_side side)
      : m_center(center), m_radius(radius, side) {
    internal::require_place(center, "center");
  }

  /// Appends the wall, or nothing if the point is the center. Takes constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    m_radius.walls(p - m_center, result);
  }

private:
  Point m_center;
  internal::Radius m_radius;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// An infinite cylinder, or the outside of one.
/// \cgalModels{Solid_3}
class Cylinder_solid_3
{
public:
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  /// Constructs a cylinder, or its outside. The axis goes through `point`, and its vector can have
  /// any length.
  /// \throws Error if the axis is zero, if the radius is not positive, or if an argument is not
  /// finite
  Cylinder_solid_3(const Point& point, const Vector& axis, double radius, Solid_side side)
      : m_point(point), m_axis(internal::unit_vector(axis, "axis")), m_radius(radius, side) {
    internal::require_place(point, "point");
  }

  /// Appends the wall, or nothing if the point is on the axis. Takes constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    const Vector from = p - m_point;
    m_radius.walls(from - (from * m_axis) * m_axis, result);
  }

private:
  Point m_point;
  Vector m_axis;
  internal::Radius m_radius;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// The region bounded by a closed triangle mesh, or the outside of this region. Copies share the
/// mesh.
/// \cgalModels{Solid_3}
class Mesh_solid_3
{
public:
  using Point = Epick::Point_3;     ///< a point in space
  using Vector = Epick::Vector_3;   ///< a vector in space
  using Mesh = Surface_mesh<Point>; ///< a triangle mesh

  /// Constructs a solid from a closed triangle mesh, oriented outwards or inwards. A point sees
  /// only the nearest part of the surface as a wall. Takes O(n log n) time.
  /// \throws Error if the mesh is empty or not closed, if a face is not a triangle, or if a point
  /// is not finite
  Mesh_solid_3(Mesh mesh, Solid_side side)
      : m_data(std::make_shared<Data>(std::move(mesh))),
        m_sign(side == Solid_side::inside ? 1 : -1) {}

  /// Appends the wall at the nearest point of the mesh. Takes about O(log n) time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    const auto [nearest, face] = m_data->tree.closest_point_and_primitive(p);
    const bool is_inside = m_data->side(p) == ON_BOUNDED_SIDE;
    const Vector outward = is_inside ? nearest - p : p - nearest;
    const double distance = std::sqrt(outward.squared_length());
    // On the surface, up to rounding, the normal is the normal of the triangle.
    static constexpr double rounding = 1e-9;
    const Vector normal = distance > rounding * m_data->extent
                              ? outward / distance
                              : Polygon_mesh_processing::compute_face_normal(face, m_data->mesh);
    result.push_back({m_sign * (is_inside ? -distance : distance), m_sign * normal});
  }

private:
  using Kernel = Epick;
  using Primitive = AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive>>;

  struct Data
  {
    Mesh mesh;
    Tree tree;
    Side_of_triangle_mesh<Mesh, Kernel> side;
    double extent;

    explicit Data(Mesh given)
        : mesh(checked(std::move(given))), tree(faces(mesh).first, faces(mesh).second, mesh),
          side(tree) {
      tree.accelerate_distance_queries();
      const Bbox_3 box = tree.bbox();
      extent =
          (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    }
    static Mesh checked(Mesh mesh) {
      if (mesh.number_of_faces() == 0 || !is_closed(mesh) || !is_triangle_mesh(mesh))
        throw Error("the mesh of a solid is empty, not closed or not a triangle mesh: fill its "
                    "holes and triangulate its facets");
      for (const auto v : mesh.vertices())
        internal::require_place(mesh.point(v), "mesh");
      if (!Polygon_mesh_processing::is_outward_oriented(mesh))
        Polygon_mesh_processing::reverse_face_orientations(mesh);
      return mesh;
    }
  };

  std::shared_ptr<const Data> m_data;
  double m_sign;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H
