// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_solids.h"

#include "fluids/fluid_files.h"
#include "input/domain_box.h"
#include "input/surface.h"

#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace dsc {
namespace {

using Solid_point = CGAL::Simple_cartesian<double>::Point_3;
using Solid_vector = CGAL::Simple_cartesian<double>::Vector_3;

Solid_vector solid_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::array<double, 3> array_of(const Solid_vector& v) { return {v.x(), v.y(), v.z()}; }

/// Returns the place of a solid that expressions move.
CGAL::Deformable_simplicial_complexes::Solid_place_3 place_at(const Scene_solid& solid, double t) {
  CGAL::Deformable_simplicial_complexes::Solid_place_3 result;
  std::array<double, 3> v = {};
  if (solid.displacement) {
    std::copy_n(solid.displacement->at({t}), solid.displacement->size(), v.begin());
    result.displacement = solid_vector(v);
  }
  if (!solid.rotation)
    return result;
  const double* angles = solid.rotation->at({t});
  result.rotation = solid.rotation->size() == 1 ? Solid_vector(0, 0, angles[0])
                                                : Solid_vector(angles[0], angles[1], angles[2]);
  return result;
}

CGAL::Deformable_simplicial_complexes::Mesh_solid_3::Mesh solid_mesh(const std::string& path) {
  CGAL::Deformable_simplicial_complexes::Mesh_solid_3::Mesh mesh;
  const Surface surface = read_surfaces({path}).front();
  for (const Surface_point& p : surface.points)
    mesh.add_vertex(Solid_point(p.x(), p.y(), p.z()));
  for (const auto& t : surface.triangles)
    mesh.add_face(CGAL::SM_Vertex_index(std::uint32_t(t[0])),
                  CGAL::SM_Vertex_index(std::uint32_t(t[1])),
                  CGAL::SM_Vertex_index(std::uint32_t(t[2])));
  return mesh;
}

/// Returns the body of a solid, at rest.
CGAL::Deformable_simplicial_complexes::Rigid_body_3
body_at_rest(const Scene_solid& solid, int dimension, const std::string& folder) {
  using namespace CGAL::Deformable_simplicial_complexes;
  if (solid.kind == Scene_solid::Kind::mesh)
    return rigid_body_of_mesh(solid_mesh(place_of(solid.file, folder)), *solid.density);
  const Solid_point center = CGAL::ORIGIN + solid_vector(solid.center);
  if (solid.kind == Scene_solid::Kind::ball)
    return dimension == 2 ? rigid_disk(center, solid.radius, *solid.density)
                          : rigid_ball(center, solid.radius, *solid.density);
  const auto& b = solid.box;
  return dimension == 2
             ? rigid_box(Solid_point(b[0], b[1], -.5), Solid_point(b[3], b[4], .5), *solid.density)
             : rigid_box(Solid_point(b[0], b[1], b[2]), Solid_point(b[3], b[4], b[5]),
                         *solid.density);
}

/// Returns the body of a solid with its initial motion.
CGAL::Deformable_simplicial_complexes::Rigid_body_3 body_of(const Scene_solid& solid, int dimension,
                                                            const std::string& folder) {
  auto result = body_at_rest(solid, dimension, folder);
  result.velocity = solid_vector(solid.velocity);
  result.angular_velocity = solid_vector(solid.angular_velocity);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.translates[axis] = !solid.is_fixed[axis];
    result.rotates[axis] = !solid.is_rotation_fixed;
  }
  return result;
}

/// Adds the solids of a scene to a fluid, with their behaviors and motions.
template <class Complex> class Solid_adder
{
public:
  Solid_adder(const Fluid_scene& scene, const std::string& folder, Fluid<Complex>& fluid)
      : m_scene(scene), m_folder(folder), m_fluid(fluid) {}

  /// Adds a solid of the scene.
  /// \param solid its shape
  template <class Solid> void operator()(const Scene_solid& given, const Solid& solid) const {
    using CGAL::Deformable_simplicial_complexes::Moving_solid_3;
    const Solid_point center = CGAL::ORIGIN + solid_vector(given.center);
    const CGAL::Deformable_simplicial_complexes::Wall_behavior behavior = {
        given.contact_angle, given.sticks, given.separates};
    if (given.is_body())
      m_fluid.add_body(solid, body_of(given, m_scene.dimension, m_folder), behavior);
    else if (given.is_moved_by_expressions())
      m_fluid.add_solid(
          Moving_solid_3<Solid>(
              solid, center,
              CGAL::Deformable_simplicial_complexes::motion_of_places(
                  [given](double t) { return place_at(given, t); }, step * m_scene.time_step)),
          behavior);
    else if (given.moves())
      m_fluid.add_solid(Moving_solid_3<Solid>(solid, solid_vector(given.velocity), center,
                                              solid_vector(given.angular_velocity)),
                        behavior);
    else
      m_fluid.add_solid(solid, behavior);
  }

private:
  static constexpr double step = 1e-4; // of differences, in time steps

  const Fluid_scene& m_scene;
  const std::string& m_folder;
  Fluid<Complex>& m_fluid;
};

} // namespace

void set_centers_of_meshes(const std::string& folder, Fluid_scene& scene) {
  for (Scene_solid& solid : scene.solids)
    if (solid.kind == Scene_solid::Kind::mesh && !solid.has_given_center) {
      const auto mesh = solid_mesh(place_of(solid.file, folder));
      Solid_vector sum(0, 0, 0);
      for (const auto v : mesh.vertices())
        sum = sum + (mesh.point(v) - CGAL::ORIGIN);
      solid.center = array_of(sum / std::max(1., double(mesh.number_of_vertices())));
    }
}

std::array<double, 3> center_of(const Scene_solid& solid, double t) {
  const Solid_vector displacement = solid.is_moved_by_expressions()
                                        ? place_at(solid, t).displacement
                                        : t * solid_vector(solid.velocity);
  return array_of(solid_vector(solid.center) + displacement);
}

template <class Complex>
void add_solids(const Fluid_scene& scene, const std::string& folder, Fluid<Complex>& fluid) {
  using namespace CGAL::Deformable_simplicial_complexes;
  const Solid_adder<Complex> add(scene, folder, fluid);
  for (const Scene_solid& solid : scene.solids) {
    const Solid_point point = CGAL::ORIGIN + solid_vector(solid.point);
    const Solid_vector direction = solid_vector(solid.direction);
    const Solid_side side = solid.contains_liquid ? Solid_side::outside : Solid_side::inside;
    const auto box = box_of_dimension<Complex::dimension>(solid.box);
    switch (solid.kind) {
    case Scene_solid::Kind::plane:
      add(solid, Plane_solid_3(point, direction));
      break;
    case Scene_solid::Kind::tank:
      add(solid, Tank_solid_3(box, solid.is_open));
      break;
    case Scene_solid::Kind::box:
      add(solid, Box_solid_3(box));
      break;
    case Scene_solid::Kind::ball:
      add(solid, Ball_solid_3(point, solid.radius, side));
      break;
    case Scene_solid::Kind::cylinder:
      add(solid, Cylinder_solid_3(point, direction, solid.radius, side));
      break;
    case Scene_solid::Kind::mesh:
      add(solid, Mesh_solid_3(solid_mesh(place_of(solid.file, folder)), side));
      break;
    }
  }
}

template void add_solids(const Fluid_scene&, const std::string&,
                         Fluid<Tracked_complex_2::Complex>&);
template void add_solids(const Fluid_scene&, const std::string&,
                         Fluid<Tracked_complex_3::Complex>&);

} // namespace dsc
