// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_RIGID_BODY_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_RIGID_BODY_3_H

#include <CGAL/Mesh_support/Error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgIncompressibleFluids3Ref

A rigid body: its mass and inertia, and its present place and motion. Liquids move it, see
`Incompressible_fluid::add_body()`.

In the plane, the body is a layer of thickness 1. It moves in the plane and rotates about the third
axis.
*/
struct Rigid_body_3
{
  using Point = Epick::Point_3;   ///< a point in space
  using Vector = Epick::Vector_3; ///< a vector in space

  double mass = 0; ///< the mass, greater than 0
  /// The tensor of inertia about the center of mass, row by row, before any rotation. It is
  /// symmetric and positive definite.
  std::array<double, 9> inertia = {};
  Point center = Point(0, 0, 0);             ///< the center of mass
  Vector velocity = Vector(0, 0, 0);         ///< the velocity of the center
  Vector angular_velocity = Vector(0, 0, 0); ///< the angular velocity, in radians per unit of time
  /// The rotation since `add_body()`: a quaternion of unit length, with its real part first.
  std::array<double, 4> rotation = {1, 0, 0, 0};
  /// For each axis: whether the center can move along it.
  std::array<bool, 3> translates = {true, true, true};
  /// For each axis: whether the body can rotate about the parallel through its center.
  std::array<bool, 3> rotates = {true, true, true};
};

/// \ingroup PkgIncompressibleFluids3Ref
/// Returns a ball of constant density, at rest.
/// \throws Error if the radius or the density is not positive and finite
inline Rigid_body_3 rigid_ball(const Rigid_body_3::Point& center, double radius, double density) {
  if (!(radius > 0 && density > 0 && std::isfinite(radius * density)))
    throw Error("the radius or the density of a body is not positive and finite: use positive, "
                "finite numbers");
  Rigid_body_3 result;
  result.center = center;
  result.mass = density * 4 / 3 * CGAL_PI * radius * radius * radius;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.inertia[4 * axis] = result.mass * radius * radius * 2 / 5;
  return result;
}

/// \ingroup PkgIncompressibleFluids3Ref
/// Returns a disk of thickness 1 and of constant density, at rest, for fluids in the plane.
/// \throws Error if the radius or the density is not positive and finite
inline Rigid_body_3 rigid_disk(const Rigid_body_3::Point& center, double radius, double density) {
  Rigid_body_3 result = rigid_ball(center, radius, density);
  result.mass = density * CGAL_PI * radius * radius;
  result.inertia = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    result.inertia[4 * axis] = result.mass * radius * radius / (axis == 2 ? 2 : 4);
  return result;
}

/// \ingroup PkgIncompressibleFluids3Ref
/// Returns a box of constant density, at rest. In the plane, its third side has the length 1.
/// \param from,to two opposite corners; the coordinates of `to` are larger
/// \param density the density
/// \throws Error if the box is empty, or if the density is not positive and finite
inline Rigid_body_3 rigid_box(const Rigid_body_3::Point& from, const Rigid_body_3::Point& to,
                              double density) {
  const Rigid_body_3::Vector d = to - from;
  if (!(d.x() > 0 && d.y() > 0 && d.z() > 0 && density > 0) ||
      !std::isfinite(d.x() * d.y() * d.z() * density))
    throw Error("the box of a body is empty, or its density is not positive and finite: use a "
                "finite box with positive sides, and a positive density");
  Rigid_body_3 result;
  result.center = midpoint(from, to);
  result.mass = density * d.x() * d.y() * d.z();
  for (int axis = 0; axis < 3; ++axis)
    result.inertia[std::size_t(4 * axis)] =
        result.mass * (d.squared_length() - d[axis] * d[axis]) / 12;
  return result;
}

/// \ingroup PkgIncompressibleFluids3Ref
/// Returns the body of constant density that a closed triangle mesh bounds, at rest. Takes linear
/// time.
/// \tparam Mesh an instance of `Surface_mesh` with points of `Exact_predicates_inexact_constructions_kernel`
/// \param mesh the surface, oriented outwards or inwards
/// \param density the density
/// \throws Error if the mesh is not closed or not a triangle mesh, if its volume is 0 or not finite,
/// or if the density is not positive and finite
template <class Mesh> Rigid_body_3 rigid_body_of_mesh(const Mesh& mesh, double density) {
  using Vector = Rigid_body_3::Vector;
  if (!is_closed(mesh) || !is_triangle_mesh(mesh))
    throw Error("the mesh of a body is not closed or not a triangle mesh: fill its holes and "
                "triangulate its facets");
  // Sums over the tetrahedra between the triangles and the origin of the first point, which reduces
  // rounding: 6 times the volume, 24 times the first moments, and 120 times the second moments.
  double volume = 0;
  Vector first(0, 0, 0);
  std::array<double, 9> second = {};
  const Rigid_body_3::Point origin =
      mesh.number_of_vertices() > 0 ? mesh.point(*mesh.vertices().begin()) : ORIGIN;
  for (const auto f : mesh.faces()) {
    std::array<Vector, 4> p = {};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      p[k++] = mesh.point(v) - origin;
    const double det = p[0] * cross_product(p[1], p[2]);
    p[3] = p[0] + p[1] + p[2];
    volume += det;
    first = first + det * p[3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (const Vector& a : p)
          second[std::size_t(3 * i + j)] += det * a[i] * a[j];
  }
  if (volume == 0 || !std::isfinite(volume) || !(density > 0) || !std::isfinite(density))
    throw Error("the volume of a body is 0 or not finite, or its density is not positive and "
                "finite: use a closed surface and a positive density");
  const Vector center = first / (4 * volume);
  Rigid_body_3 result;
  result.mass = density * std::abs(volume) / 6;
  result.center = origin + center;
  std::array<double, 9> about_center; // second moments times density
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      about_center[std::size_t(3 * i + j)] =
          result.mass * (second[std::size_t(3 * i + j)] / (20 * volume) - center[i] * center[j]);
  const double trace = about_center[0] + about_center[4] + about_center[8];
  for (std::size_t i = 0; i < 9; ++i)
    result.inertia[i] = (i % 4 == 0 ? trace : 0) - about_center[i];
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_RIGID_BODY_3_H
