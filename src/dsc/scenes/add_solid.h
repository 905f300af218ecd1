// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_ADD_SOLID_H
#define DSC_ADD_SOLID_H

#include "input/domain_box.h"
#include "scenes/scene_solid.h"

#include <CGAL/Incompressible_fluids_3/Fluid_state.h>
#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>
#include <CGAL/Mesh_support/coordinates.h>

namespace dsc {

/// Returns the body of a solid with its initial motion.
inline DSC::Rigid_body_3 body_of(const Scene_solid& solid, int dimension) {
  using Point = DSC::Ball_solid_3::Point;
  const auto at_rest = [&] {
    if (solid.kind == Scene_solid::Kind::mesh)
      return DSC::rigid_body_of_mesh(*solid.mesh, *solid.density);
    if (solid.kind == Scene_solid::Kind::ball) {
      const auto center = DSC::point_of<Point>(solid.center);
      return dimension == 2 ? DSC::rigid_disk(center, solid.radius, *solid.density)
                            : DSC::rigid_ball(center, solid.radius, *solid.density);
    }
    const auto& b = solid.box;
    const double half = dimension == 2 ? .5 : 0; // the thickness is 1 in the plane
    return DSC::rigid_box(Point(b[0], b[1], b[2] - half), Point(b[3], b[4], b[5] + half),
                          *solid.density);
  };
  DSC::Rigid_body_3 result = at_rest();
  result.velocity = DSC::point_of<DSC::Solid_motion_3::Vector>(solid.velocity);
  result.angular_velocity = DSC::point_of<DSC::Solid_motion_3::Vector>(solid.angular_velocity);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.translates[axis] = !solid.is_fixed[axis];
    result.rotates[axis] = !solid.is_rotation_fixed;
  }
  return result;
}

/// Adds a solid to a fluid, with its behavior and its motion.
/// \param step time step of the differences of the places of a solid that moves as a function
template <class Fluid> void add_solid(const Scene_solid& given, double step, Fluid& fluid) {
  using Point = DSC::Ball_solid_3::Point;
  using Vector = DSC::Solid_motion_3::Vector;
  const auto add = [&](const auto& solid) {
    using Moving_solid = DSC::Moving_solid_3<std::decay_t<decltype(solid)>>;
    const auto center = DSC::point_of<Point>(given.center);
    const DSC::Wall_behavior behavior = {given.contact_angle, given.sticks, given.separates};
    if (given.is_body())
      fluid.add_body(solid, body_of(given, Fluid::dimension), behavior);
    else if (given.place)
      fluid.add_solid(Moving_solid(solid, center, DSC::motion_of_places(given.place, step)),
                      behavior);
    else if (given.moves())
      fluid.add_solid(Moving_solid(solid, DSC::point_of<Vector>(given.velocity), center,
                                   DSC::point_of<Vector>(given.angular_velocity)),
                      behavior);
    else
      fluid.add_solid(solid, behavior);
  };
  const auto point = DSC::point_of<Point>(given.point);
  const auto direction = DSC::point_of<Vector>(given.direction);
  const DSC::Solid_side side =
      given.contains_liquid ? DSC::Solid_side::outside : DSC::Solid_side::inside;
  const auto box = box_of_dimension<Fluid::dimension>(given.box);
  switch (given.kind) {
  case Scene_solid::Kind::plane:
    return add(DSC::Plane_solid_3(point, direction));
  case Scene_solid::Kind::tank:
    return add(DSC::Tank_solid_3(box, given.is_open));
  case Scene_solid::Kind::box:
    return add(DSC::Box_solid_3(box));
  case Scene_solid::Kind::ball:
    return add(DSC::Ball_solid_3(point, given.radius, side));
  case Scene_solid::Kind::cylinder:
    return add(DSC::Cylinder_solid_3(point, direction, given.radius, side));
  case Scene_solid::Kind::mesh:
    return add(DSC::Mesh_solid_3(*given.mesh, side));
  }
}

} // namespace dsc

#endif // DSC_ADD_SOLID_H
