// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_solids.h"

#include "domain_box.h"
#include "fluid_files.h"
#include "surface.h"

#include <CGAL/Incompressible_fluids_3/Moving_solid_3.h>
#include <CGAL/Incompressible_fluids_3/Rigid_body_3.h>
#include <CGAL/Incompressible_fluids_3/Solids_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

namespace dsc {
namespace {

using Solid_point = CGAL::Simple_cartesian<double>::Point_3;
using Solid_vector = CGAL::Simple_cartesian<double>::Vector_3;

Solid_vector solid_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::array<double, 3> array_of(const Solid_vector& v) { return {v.x(), v.y(), v.z()}; }

/// Returns the rotation by a rotation vector.
Eigen::Quaterniond quaternion_of(const Solid_vector& rotation) {
  const Eigen::Vector3d v(rotation.x(), rotation.y(), rotation.z());
  return Eigen::Quaterniond(Eigen::AngleAxisd(v.norm(), v.stableNormalized()));
}

/// Returns a vector rotated by a rotation vector.
Solid_vector turned(const Solid_vector& v, const Solid_vector& rotation) {
  const Eigen::Vector3d result = quaternion_of(rotation) * Eigen::Vector3d(v.x(), v.y(), v.z());
  return {result.x(), result.y(), result.z()};
}

/// Returns the rotation vector between two rotations.
Solid_vector rotation_between(const Solid_vector& before, const Solid_vector& after) {
  const Eigen::AngleAxisd result(quaternion_of(after) * quaternion_of(before).conjugate());
  const Eigen::Vector3d v = result.angle() * result.axis();
  return {v.x(), v.y(), v.z()};
}

/// The displacement and rotation of a solid at a time.
struct Solid_placement
{
  Solid_vector displacement = Solid_vector(0, 0, 0), rotation = Solid_vector(0, 0, 0);

  Solid_placement(const Scene_solid& solid, double t) {
    std::array<double, 3> v = {};
    if (solid.displacement) {
      std::copy_n(solid.displacement->at({t}), solid.displacement->size(), v.begin());
      displacement = solid_vector(v);
    }
    if (!solid.rotation)
      return;
    const double* angles = solid.rotation->at({t});
    rotation = solid.rotation->size() == 1 ? Solid_vector(0, 0, angles[0])
                                           : Solid_vector(angles[0], angles[1], angles[2]);
  }
};

/// The motion of a solid by expressions. Velocities are central differences. Copies share the
/// motion at the last time. Several threads can use them.
class Motion_by_expressions
{
public:
  using Motion = CGAL::Deformable_simplicial_complexes::Solid_motion_3;

  /// \param step step of the differences
  Motion_by_expressions(const Scene_solid& solid, double step)
      : m_solid(solid), m_step(step), m_last(std::make_shared<Last>()) {}

  Motion operator()(double t) const {
    const std::lock_guard<std::mutex> lock(m_last->mutex);
    if (m_last->time != t) {
      m_last->motion = motion(t);
      m_last->time = t;
    }
    return m_last->motion;
  }

private:
  struct Last
  {
    std::mutex mutex;
    std::optional<double> time;
    Motion motion;
  };

  Motion motion(double t) const {
    const Solid_placement now(m_solid, t), before(m_solid, t - m_step), after(m_solid, t + m_step);
    const double dt = (t + m_step) - (t - m_step);
    Motion result;
    result.displacement = now.displacement;
    result.rotation = now.rotation;
    result.velocity = (after.displacement - before.displacement) / dt;
    result.angular_velocity = rotation_between(before.rotation, after.rotation) / dt;
    return result;
  }

  Scene_solid m_solid;
  double m_step;
  std::shared_ptr<Last> m_last;
};

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
    const CGAL::Deformable_simplicial_complexes::Wall_behavior behavior = {
        given.contact_angle, given.sticks, given.separates};
    if (given.is_body())
      m_fluid.add_body(solid, body_of(given, m_scene.dimension, m_folder), behavior);
    else if (given.is_moved_by_expressions())
      m_fluid.add_solid(
          Moving_solid_3<Solid>(solid, CGAL::ORIGIN + solid_vector(given.center),
                                Motion_by_expressions(given, step * m_scene.time_step)),
          behavior);
    else if (given.moves())
      m_fluid.add_solid(Moving_solid_3<Solid>(solid, solid_vector(given.velocity),
                                              CGAL::ORIGIN + solid_vector(given.point),
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
    if (solid.kind == Scene_solid::Kind::mesh) {
      const auto mesh = solid_mesh(place_of(solid.file, folder));
      Solid_vector sum(0, 0, 0);
      for (const auto v : mesh.vertices())
        sum = sum + (mesh.point(v) - CGAL::ORIGIN);
      solid.center = array_of(sum / std::max(1., double(mesh.number_of_vertices())));
    }
}

std::array<double, 3> center_of(const Scene_solid& solid, double t) {
  const Solid_vector center = solid_vector(solid.center);
  if (solid.is_moved_by_expressions())
    return array_of(center + Solid_placement(solid, t).displacement);
  const Solid_vector pivot = solid_vector(solid.point);
  return array_of(pivot + t * solid_vector(solid.velocity) +
                  turned(center - pivot, t * solid_vector(solid.angular_velocity)));
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
