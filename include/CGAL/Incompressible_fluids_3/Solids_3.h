// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H

#include <CGAL/Deformable_simplicial_complexes/cgal_compat.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// A smooth part of the surface of a solid, as seen from a point: what liquids meet there.
struct Wall_3
{
  using Vector = Simple_cartesian<double>::Vector_3; ///< any

  double distance; ///< of the point, negative inside the solid
  Vector normal;   ///< of unit length, out of the solid: the gradient of the distance
  Vector velocity = Vector(0, 0, 0); ///< of the wall
};

/// \ingroup PkgIncompressibleFluids3Ref
/// Which side of a surface is solid.
enum class Solid_side {
  inside, ///< liquids are around it
  outside ///< liquids are in it
};

namespace internal {

// Of any length, even if its square is no number. \throws Error if it is zero or not finite
inline Wall_3::Vector unit_vector(const Wall_3::Vector& v, const char* name) {
  const double largest = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  const Wall_3::Vector scaled = v / largest, result = scaled / std::sqrt(scaled.squared_length());
  if (!std::isfinite(result.squared_length()))
    throw Error("the " + std::string(name) + " of a solid is zero or not finite");
  return result;
}

template <class Coordinates> void require_place(const Coordinates& c, const char* name) {
  if (!std::isfinite(c.x()) || !std::isfinite(c.y()) || !std::isfinite(c.z()))
    throw Error("the " + std::string(name) + " of a solid is not finite");
}

// What is nearer to a center or an axis than a radius, or farther.
class Radius
{
public:
  Radius(double radius, Solid_side side)
      : m_radius(radius), m_sign(side == Solid_side::inside ? 1 : -1) {
    if (!(radius > 0) || !std::isfinite(radius))
      throw Error("the radius of a solid is not positive and finite");
  }

  // As seen from the center or axis; none if the point is there.
  void walls(const Wall_3::Vector& way, std::vector<Wall_3>& result) const {
    const double r = std::sqrt(way.squared_length());
    if (r > 0)
      result.push_back({m_sign * (r - m_radius), m_sign / r * way});
  }

private:
  double m_radius, m_sign;
};

} // namespace internal

/// \ingroup PkgIncompressibleFluids3Ref
/// Everything behind a plane. \cgalModels `Solid_3`
class Plane_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  /// The plane through `point`; liquids are where `normal` points.
  /// \throws Error if the normal is zero, or something not finite
  Plane_solid_3(const Point& point, const Vector& normal)
      : m_point(point), m_normal(internal::unit_vector(normal, "normal")) {
    internal::require_place(point, "point");
  }

  /// Appends the wall. Constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    result.push_back({(p - m_point) * m_normal, m_normal});
  }

private:
  Point m_point;
  Vector m_normal;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A tank: everything outside of a box, with six walls, or fewer. \cgalModels `Solid_3`
class Tank_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  /// \param box what liquids are in
  /// \param is_open whether there is no wall above, at its largest z
  /// \throws Error if the box is empty or not finite
  explicit Tank_solid_3(const Bbox_3& box, bool is_open = false) : m_box(box), m_is_open(is_open) {
    for (int axis = 0; axis < 3; ++axis)
      if (!(box.max(axis) > box.min(axis)) || !std::isfinite(box.min(axis)) ||
          !std::isfinite(box.max(axis)))
        throw Error("the box of a tank is empty or not finite");
  }

  /// Appends the walls. Constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector along(axis == 0, axis == 1, axis == 2);
      result.push_back({p[axis] - m_box.min(axis), along});
      if (axis < 2 || !m_is_open)
        result.push_back({m_box.max(axis) - p[axis], -along});
    }
  }

private:
  Bbox_3 m_box;
  bool m_is_open;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A ball, or everything around one. \cgalModels `Solid_3`
class Ball_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  /// \throws Error if the radius is not positive, or something not finite
  Ball_solid_3(const Point& center, double radius, Solid_side side)
      : m_center(center), m_radius(radius, side) {
    internal::require_place(center, "center");
  }

  /// Appends the wall; none at the center. Constant time.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    m_radius.walls(p - m_center, result);
  }

private:
  Point m_center;
  internal::Radius m_radius;
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A cylinder without ends, or everything around one. \cgalModels `Solid_3`
class Cylinder_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  /// \throws Error if the axis is zero, the radius not positive, or something not finite
  Cylinder_solid_3(const Point& point, const Vector& axis, double radius, Solid_side side)
      : m_point(point), m_axis(internal::unit_vector(axis, "axis")), m_radius(radius, side) {
    internal::require_place(point, "point");
  }

  /// Appends the wall; none on the axis. Constant time.
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
/// What a closed triangle mesh bounds, or everything around it. Copies share the mesh.
/// \cgalModels `Solid_3`
class Mesh_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space
  using Mesh = Surface_mesh<Point>;                  ///< of triangles

  /// Triangles may be oriented outwards or inwards. Where walls meet at an angle, a point sees the
  /// nearest one. \throws Error if the mesh is not closed, has no triangles or others, or not
  /// finite points. n log n.
  Mesh_solid_3(Mesh mesh, Solid_side side)
      : m_data(std::make_shared<Data>(std::move(mesh))),
        m_sign(side == Solid_side::inside ? 1 : -1) {}

  /// Appends the wall that is nearest. About log n.
  void walls(const Point& p, double /*t*/, std::vector<Wall_3>& result) const {
    const auto [nearest, face] = m_data->tree.closest_point_and_primitive(p);
    const bool is_inside = m_data->side(p) == ON_BOUNDED_SIDE;
    const Vector way = is_inside ? nearest - p : p - nearest;
    const double distance = std::sqrt(way.squared_length());
    // On the surface, or up to rounding, that of the triangle.
    static constexpr double rounding = 1e-9;
    const Vector normal = distance > rounding * m_data->extent
                              ? way / distance
                              : Polygon_mesh_processing::compute_face_normal(face, m_data->mesh);
    result.push_back({m_sign * (is_inside ? -distance : distance), m_sign * normal});
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Primitive = AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = AABB_tree<Primitive_tree_traits_3<Kernel, Primitive>>;

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
        throw Error(
            "the mesh of a solid is not closed, has no facets, or some that are no triangles");
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

/// \ingroup PkgIncompressibleFluids3Ref
/// A solid that turns and goes at constant rates. \cgalModels `Solid_3`
/// \tparam Solid model of `Solid_3`: what it is at time 0
template <class Solid> class Moving_solid_3
{
public:
  using Point = Simple_cartesian<double>::Point_3;   ///< of space
  using Vector = Simple_cartesian<double>::Vector_3; ///< of space

  /// \param solid at time 0
  /// \param velocity of `center`
  /// \param center that it turns about, at time 0
  /// \param angular_velocity along the axis, in radians in a unit of time; zero if it does not turn
  /// \throws Error if something is not finite
  Moving_solid_3(const Solid& solid, const Vector& velocity, const Point& center = Point(0, 0, 0),
                 const Vector& angular_velocity = Vector(0, 0, 0))
      : m_solid(solid), m_velocity(velocity), m_center(center), m_turn(angular_velocity) {
    internal::require_place(velocity, "velocity");
    internal::require_place(center, "center");
    internal::require_place(angular_velocity, "angular velocity");
  }

  /// Appends the walls at time t.
  void walls(const Point& p, double t, std::vector<Wall_3>& result) const {
    const std::size_t first = result.size();
    const Vector from_center = p - (m_center + t * m_velocity);
    m_solid.walls(m_center + turned(from_center, -t), t, result);
    for (std::size_t i = first; i < result.size(); ++i) {
      Wall_3& wall = result[i];
      wall.normal = turned(wall.normal, t);
      wall.velocity = turned(wall.velocity, t) + m_velocity +
                      cross_product(m_turn, from_center - wall.distance * wall.normal);
    }
  }

private:
  // By Rodrigues' formula.
  Vector turned(const Vector& v, double t) const {
    const double rate = std::sqrt(m_turn.squared_length()), angle = rate * t;
    if (!(rate > 0))
      return v;
    const Vector axis = m_turn / rate;
    return std::cos(angle) * v + std::sin(angle) * cross_product(axis, v) +
           (1 - std::cos(angle)) * (axis * v) * axis;
  }

  Solid m_solid;
  Vector m_velocity;
  Point m_center;
  Vector m_turn;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_SOLIDS_3_H
