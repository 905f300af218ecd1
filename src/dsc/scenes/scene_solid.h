// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SCENE_SOLID_H
#define DSC_SCENE_SOLID_H

#include "scenes/json_fields.h"

#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>

namespace dsc {

/// A solid in a fluid. In the plane, points, vectors and boxes have the third coordinate 0.
struct Scene_solid
{
  enum class Kind { plane, tank, box, ball, cylinder, mesh };
  using Mesh = DSC::Mesh_solid_3::Mesh;
  using Place = DSC::Solid_place_3;

  Kind kind;
  std::array<double, 3> point = {}, direction = {}; ///< of plane and cylinder; center of a ball
  double radius = 0;
  std::array<double, 6> box = {}; ///< of a tank or box
  bool is_open = false;
  bool contains_liquid = false;     ///< of a ball, cylinder or mesh
  std::string file, part;           ///< of a mesh; part: of the file, empty for the whole surface
  std::shared_ptr<const Mesh> mesh; ///< set by set_mesh()
  double contact_angle = 90;
  bool sticks = false, separates = true;
  /// In the plane, only the third coordinate of the angular velocity is not 0. For a body, they are
  /// the initial motion. Other solids move with constant velocities, and rotate about `center`.
  std::array<double, 3> velocity = {}, angular_velocity = {};
  std::optional<double> density; ///< of a body that liquids move
  /// For each axis: whether a body cannot move along it.
  std::array<bool, 3> is_fixed = {};
  bool is_rotation_fixed = false; ///< whether a body cannot rotate
  /// The place of a solid that moves as a function of time, and rotates about `center`; empty for
  /// other solids.
  std::function<Place(double)> place;
  /// A given center of a tank, box or mesh that is no body. Otherwise, the middle of a tank, box or
  /// ball, the mean of the vertices of a mesh, `point` of other solids.
  std::array<double, 3> center = {};
  bool has_given_center = false; ///< of a tank, box or mesh

  bool is_body() const { return density.has_value(); }
  /// Returns whether the solid can move.
  bool moves() const {
    return is_body() || place || velocity != std::array<double, 3>() ||
           angular_velocity != std::array<double, 3>();
  }

  /// Sets the surface of a mesh, and its center, if no center is given.
  void set_mesh(Mesh given);
};

/// Reads a solid. The dimension of the fields is the dimension of the fluid.
/// \throws Usage_error if a field is unknown, missing, out of range or without effect
Scene_solid read_solid(const Json_fields& solid);

} // namespace dsc

#endif // DSC_SCENE_SOLID_H
