// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_solids.h"

#include "domain_box.h"
#include "fluid_files.h"
#include "surface.h"

#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using Solid_point = CGAL::Simple_cartesian<double>::Point_3;
using Solid_vector = CGAL::Simple_cartesian<double>::Vector_3;
using CGAL::Deformable_simplicial_complexes::Wall_3;

Solid_vector solid_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Solid_vector along(int axis) { return {double(axis == 0), double(axis == 1), double(axis == 2)}; }

/// A tank in the plane: the outside of a rectangle, with four walls, or three if it is open.
class Planar_tank
{
public:
  Planar_tank(const std::array<double, 6>& box, bool is_open) : m_box(box), m_is_open(is_open) {}

  void walls(const Solid_point& p, double /*t*/, std::vector<Wall_3>& result) const {
    for (int axis = 0; axis < 2; ++axis) {
      result.push_back({p[axis] - m_box[std::size_t(axis)], along(axis)});
      if (axis == 0 || !m_is_open)
        result.push_back({m_box[std::size_t(axis + 3)] - p[axis], -along(axis)});
    }
  }

private:
  std::array<double, 6> m_box;
  bool m_is_open;
};

/// A box with liquids outside. In the plane, it has no extent along z. A point sees only the
/// nearest part of the surface as a wall.
class Box_solid
{
public:
  Box_solid(const std::array<double, 6>& box, int dimension) : m_box(box), m_dimension(dimension) {}

  void walls(const Solid_point& p, double /*t*/, std::vector<Wall_3>& result) const {
    std::array<double, 3> outward = {}; // from the nearest point of the box
    Wall_3 nearest_face = {-1, Solid_vector(0, 0, 0)};
    for (int axis = 0; axis < m_dimension; ++axis) {
      const double below = m_box[std::size_t(axis)] - p[axis],
                   above = p[axis] - m_box[std::size_t(axis + 3)];
      outward[std::size_t(axis)] = above > 0 ? above : below > 0 ? -below : 0;
      const double distance = std::max(below, above);
      if (axis == 0 || distance > nearest_face.distance)
        nearest_face = {distance, above >= below ? along(axis) : -along(axis)};
    }
    const double distance = std::hypot(outward[0], outward[1], outward[2]);
    result.push_back(distance > 0 ? Wall_3{distance, solid_vector(outward) / distance}
                                  : nearest_face);
  }

private:
  std::array<double, 6> m_box;
  int m_dimension;
};

CGAL::Deformable_simplicial_complexes::Mesh_solid_3
mesh_solid(const std::string& path, CGAL::Deformable_simplicial_complexes::Solid_side side) {
  using CGAL::Deformable_simplicial_complexes::Mesh_solid_3;
  Mesh_solid_3::Mesh mesh;
  const Surface surface = read_surfaces({path}).front();
  for (const Surface_point& p : surface.points)
    mesh.add_vertex(Solid_point(p.x(), p.y(), p.z()));
  for (const auto& t : surface.triangles)
    mesh.add_face(CGAL::SM_Vertex_index(std::uint32_t(t[0])),
                  CGAL::SM_Vertex_index(std::uint32_t(t[1])),
                  CGAL::SM_Vertex_index(std::uint32_t(t[2])));
  return Mesh_solid_3(std::move(mesh), side);
}

/// Adds a solid of a given shape to a fluid, with its behavior and its motion.
template <class Complex, class Solid>
void add_solid(Fluid<Complex>& fluid, const Scene_solid& given, const Solid& solid) {
  using CGAL::Deformable_simplicial_complexes::Moving_solid_3;
  const CGAL::Deformable_simplicial_complexes::Wall_behavior behavior = {
      given.contact_angle, given.sticks, given.separates};
  const Solid_vector velocity = solid_vector(given.velocity),
                     turn = solid_vector(given.angular_velocity);
  if (velocity == CGAL::NULL_VECTOR && turn == CGAL::NULL_VECTOR)
    fluid.add_solid(solid, behavior);
  else
    fluid.add_solid(
        Moving_solid_3<Solid>(solid, velocity, CGAL::ORIGIN + solid_vector(given.point), turn),
        behavior);
}

} // namespace

template <class Complex>
void add_solids(const Fluid_scene& scene, const std::string& folder, Fluid<Complex>& fluid) {
  using namespace CGAL::Deformable_simplicial_complexes;
  for (const Scene_solid& solid : scene.solids) {
    const Solid_point point = CGAL::ORIGIN + solid_vector(solid.point);
    const Solid_vector direction = solid_vector(solid.direction);
    const Solid_side side = solid.contains_liquid ? Solid_side::outside : Solid_side::inside;
    switch (solid.kind) {
    case Scene_solid::Kind::plane:
      add_solid(fluid, solid, Plane_solid_3(point, direction));
      break;
    case Scene_solid::Kind::tank:
      if (scene.dimension == 2)
        add_solid(fluid, solid, Planar_tank(solid.box, solid.is_open));
      else
        add_solid(fluid, solid, Tank_solid_3(box(solid.box), solid.is_open));
      break;
    case Scene_solid::Kind::box:
      add_solid(fluid, solid, Box_solid(solid.box, scene.dimension));
      break;
    case Scene_solid::Kind::ball:
      add_solid(fluid, solid, Ball_solid_3(point, solid.radius, side));
      break;
    case Scene_solid::Kind::cylinder:
      add_solid(fluid, solid, Cylinder_solid_3(point, direction, solid.radius, side));
      break;
    case Scene_solid::Kind::mesh:
      add_solid(fluid, solid, mesh_solid(place_of(solid.file, folder), side));
      break;
    }
  }
}

template void add_solids(const Fluid_scene&, const std::string&,
                         Fluid<Tracked_complex_2::Complex>&);
template void add_solids(const Fluid_scene&, const std::string&,
                         Fluid<Tracked_complex_3::Complex>&);

} // namespace dsc
