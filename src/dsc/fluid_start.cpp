// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_start.h"

#include "errors.h"
#include "fluid_shapes.h"
#include "surface.h"
#include "velocity_expressions.h"

#include <CGAL/Deformable_simplicial_complex_3/exceptions.h>
#include <CGAL/IO/labelled_surface_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>
#include <CGAL/deform_interface_3.h>
#include <CGAL/make_deformable_simplicial_complex_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Point = Complex::Approximate_point;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

CGAL::Bbox_3 box(const std::array<double, 6>& d) { return {d[0], d[1], d[2], d[3], d[4], d[5]}; }

std::string place_of(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  return path.is_absolute() || folder.empty() ? file
                                              : (std::filesystem::path(folder) / path).string();
}

Complex complex_of_surfaces(const Fluid_scene& scene, const std::string& folder) {
  std::vector<Surface> surfaces;
  for (const auto& [label, shape] : shapes_of(scene)) {
    if (const auto* ball = std::get_if<Ball_shape>(shape)) {
      surfaces.push_back(surface_of(*ball, scene.edge));
    } else if (const auto* block = std::get_if<Box_shape>(shape)) {
      surfaces.push_back(surface_of(*block, scene.edge));
    } else if (const auto* column = std::get_if<Cylinder_shape>(shape)) {
      surfaces.push_back(surface_of(*column, scene.edge));
    } else if (const auto* file = std::get_if<File_shape>(shape)) {
      Run_start start;
      start.inputs = {place_of(file->file, folder)};
      start.ball = file->ball;
      start.triangles = file->triangles;
      surfaces.push_back(start_surfaces(start).front());
    } else {
      continue; // around the others
    }
    surfaces.back().label = label;
  }
  if (surfaces.empty())
    throw Input_error("the scene has no liquid with a shape of its own");
  return CGAL::make_deformable_simplicial_complex_3<Complex>(
      surfaces, CGAL::Tetgen_tetrahedralizer_3(), parameters::enclosing_box(box(scene.domain)));
}

void require_inside(const Fluid_scene& scene, const Pool_shape& pool) {
  if (!(pool.level > scene.domain[2] && pool.level < scene.domain[5]))
    throw Input_error("the level of the pool is not inside the domain");
}

/// Cubes, each of six tetrahedra, which have a plane at a level between them.
Complex complex_of_pool(const Fluid_scene& scene, int label, const Pool_shape& pool) {
  const auto& d = scene.domain;
  require_inside(scene, pool);
  const auto number = [&](double length) { return number_of_parts(length / scene.edge); };
  const std::size_t nx = number(d[3] - d[0]), ny = number(d[4] - d[1]),
                    below = number(pool.level - d[2]), nz = below + number(d[5] - pool.level);
  number_of_parts(double(nx) * double(ny) * double(nz));
  const auto z = [&](std::size_t k) {
    return k <= below ? d[2] + (pool.level - d[2]) * double(k) / double(below)
                      : pool.level + (d[5] - pool.level) * double(k - below) / double(nz - below);
  };
  std::vector<Complex::Point> points;
  for (std::size_t k = 0; k <= nz; ++k)
    for (std::size_t j = 0; j <= ny; ++j)
      for (std::size_t i = 0; i <= nx; ++i)
        points.emplace_back(d[0] + (d[3] - d[0]) * double(i) / double(nx),
                            d[1] + (d[4] - d[1]) * double(j) / double(ny),
                            k == below ? pool.level : z(k));
  const std::array<std::size_t, 3> stride = {1, nx + 1, (nx + 1) * (ny + 1)};
  std::vector<std::array<std::size_t, 4>> tetrahedra;
  std::vector<int> labels;
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i) {
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do { // a way from corner to corner for each order of the axes
          std::array<std::size_t, 4> t;
          t[0] = i + j * stride[1] + k * stride[2];
          for (std::size_t a = 0; a < 3; ++a)
            t[a + 1] = t[a] + stride[axes[a]];
          tetrahedra.push_back(t);
          labels.push_back(k < below ? label : 0);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  Complex complex = CGAL::make_deformable_simplicial_complex_3<Complex>(
      points, std::move(tetrahedra), labels, parameters::improve(false));
  if (!pool.height.empty()) {
    const Velocity_expressions height("0,0," + pool.height, 3);
    CGAL::deform_interface(complex, [&](Complex::Vertex_handle v) {
      const Point p = complex.position(v);
      return Complex::Point(p.x(), p.y(), height.at({p.x(), p.y(), p.z()}, 0)[2]);
    });
  }
  return complex;
}

/// Whether a place is in a shape, or may be.
bool is_about(const Fluid_shape& shape, const Point& p) {
  if (const auto* ball = std::get_if<Ball_shape>(&shape))
    return std::hypot(p.x() - ball->center[0], p.y() - ball->center[1], p.z() - ball->center[2]) <
           ball->radius * (1 + std::abs(ball->amplitude));
  if (const auto* file = std::get_if<File_shape>(&shape))
    return std::hypot(p.x() - file->ball.center[0], p.y() - file->ball.center[1],
                      p.z() - file->ball.center[2]) < file->ball.radius;
  if (const auto* block = std::get_if<Box_shape>(&shape))
    return p.x() > block->from[0] && p.x() < block->to[0] && p.y() > block->from[1] &&
           p.y() < block->to[1] && p.z() > block->from[2] && p.z() < block->to[2];
  if (const auto* column = std::get_if<Cylinder_shape>(&shape)) {
    const Point from(column->from[0], column->from[1], column->from[2]),
        to(column->to[0], column->to[1], column->to[2]);
    const double part = (p - from) * (to - from) / (to - from).squared_length();
    return part > 0 && part < 1 &&
           (p - from - part * (to - from)).squared_length() <
               std::pow(column->radius * (1 + std::abs(column->amplitude)), 2);
  }
  if (const auto* pool = std::get_if<Pool_shape>(&shape))
    return p.z() < pool->level;
  return true;
}

/// By the labels of places: pools beside others.
Complex complex_of_places(const Fluid_scene& scene) {
  number_of_parts((scene.domain[3] - scene.domain[0]) * (scene.domain[4] - scene.domain[1]) *
                  (scene.domain[5] - scene.domain[2]) / std::pow(scene.edge, 3));
  const auto shapes = shapes_of(scene);
  for (const auto& filling : shapes) {
    const Fluid_shape& shape = *filling.second;
    const auto* ball = std::get_if<Ball_shape>(&shape);
    const auto* column = std::get_if<Cylinder_shape>(&shape);
    if (const auto* pool = std::get_if<Pool_shape>(&shape)) {
      require_inside(scene, *pool);
      if (!pool->height.empty())
        throw Input_error("the pool of a scene with other shapes is flat; leave its height out");
    }
    if (std::holds_alternative<File_shape>(shape) || (column && column->amplitude != 0) ||
        (ball && (ball->mode > 0 || ball->triangles > 0)))
      throw Input_error("beside a pool there can be boxes, round balls and straight cylinders with "
                        "the edges of the scene, but no modes, amplitudes, numbers of triangles or "
                        "shapes of files");
  }
  const auto label_at = [&](const Point& p) {
    int result = 0;
    for (const auto& [label, shape] : shapes)
      if (!std::holds_alternative<Surroundings>(*shape) && is_about(*shape, p))
        result = label;
    return result;
  };
  return CGAL::make_deformable_simplicial_complex_3<Complex>(box(scene.domain), scene.edge,
                                                             label_at);
}

template <class Solid> void add_solid(Fluid& fluid, const Scene_solid& given, const Solid& solid) {
  using CGAL::Deformable_simplicial_complexes::Moving_solid_3;
  using Vector = Fluid::Vector;
  const CGAL::Deformable_simplicial_complexes::Wall_behavior behavior = {
      given.contact_angle, given.sticks, given.separates};
  const auto vector = [](const std::array<double, 3>& v) { return Vector(v[0], v[1], v[2]); };
  const Vector velocity = vector(given.velocity), turn = vector(given.angular_velocity);
  if (velocity == CGAL::NULL_VECTOR && turn == CGAL::NULL_VECTOR)
    fluid.add_solid(solid, behavior);
  else
    fluid.add_solid(
        Moving_solid_3<Solid>(solid, velocity, CGAL::ORIGIN + vector(given.point), turn), behavior);
}

} // namespace

Complex start_of_scene(const Fluid_scene& scene, const std::string& folder) {
  const Pool_shape* pool = nullptr;
  int label_of_pool = 0;
  std::size_t others = 0;
  for (const auto& [label, shape] : shapes_of(scene))
    if (const auto* found = std::get_if<Pool_shape>(shape); found && !pool) {
      pool = found;
      label_of_pool = label;
    } else {
      others += !std::holds_alternative<Surroundings>(*shape);
    }
  if (!pool)
    return complex_of_surfaces(scene, folder);
  return others == 0 ? complex_of_pool(scene, label_of_pool, *pool) : complex_of_places(scene);
}

std::unique_ptr<Fluid> fluid_of_scene(const Fluid_scene& scene, const std::string& folder,
                                      Complex& complex) {
  using namespace CGAL::Deformable_simplicial_complexes;
  Fluid_properties_3 properties;
  for (const Scene_liquid& liquid : scene.liquids)
    properties.set_liquid(liquid.label, {liquid.density, liquid.viscosity});
  for (const Scene_gas& gas : scene.gases)
    properties.set_gas(gas.label, {gas.pressure, gas.exponent});
  for (const auto& tension : scene.tensions)
    properties.set_surface_tension(tension.labels[0], tension.labels[1], tension.value);
  properties.set_gravity(scene.gravity);
  auto result = std::make_unique<Fluid>(complex, properties);
  Fluid& fluid = *result;
  if (!scene.sources.empty())
    fluid.set_sources([sources = scene.sources](const Fluid::Point& p, double) {
      double rate = 0;
      for (const Scene_source& source : sources)
        if (std::hypot(p.x() - source.center[0], p.y() - source.center[1],
                       p.z() - source.center[2]) < source.radius)
          rate += source.rate;
      return rate;
    });
  for (const Scene_solid& solid : scene.solids) {
    const Fluid::Point point(solid.point[0], solid.point[1], solid.point[2]);
    const Fluid::Vector direction(solid.direction[0], solid.direction[1], solid.direction[2]);
    const Solid_side side = solid.contains_liquid ? Solid_side::outside : Solid_side::inside;
    switch (solid.kind) {
    case Scene_solid::Kind::plane:
      add_solid(fluid, solid, Plane_solid_3(point, direction));
      break;
    case Scene_solid::Kind::tank:
      add_solid(fluid, solid, Tank_solid_3(box(solid.box), solid.is_open));
      break;
    case Scene_solid::Kind::ball:
      add_solid(fluid, solid, Ball_solid_3(point, solid.radius, side));
      break;
    case Scene_solid::Kind::cylinder:
      add_solid(fluid, solid, Cylinder_solid_3(point, direction, solid.radius, side));
      break;
    case Scene_solid::Kind::mesh: {
      Mesh_solid_3::Mesh mesh;
      const Surface surface = read_surfaces({place_of(solid.file, folder)}).front();
      for (const Surface_point& p : surface.points)
        mesh.add_vertex(Fluid::Point(p.x(), p.y(), p.z()));
      for (const auto& t : surface.triangles)
        mesh.add_face(CGAL::SM_Vertex_index(std::uint32_t(t[0])),
                      CGAL::SM_Vertex_index(std::uint32_t(t[1])),
                      CGAL::SM_Vertex_index(std::uint32_t(t[2])));
      add_solid(fluid, solid, Mesh_solid_3(std::move(mesh), side));
      break;
    }
    }
  }
  return result;
}

void require_outside_of_solids(const Fluid_scene& scene, const Fluid& fluid) {
  static constexpr double rounding = 1e-6; // edges
  if (fluid.depth_in_solids() > rounding * scene.edge)
    throw Input_error("a liquid of the scene begins inside a solid, " +
                      Json(fluid.depth_in_solids()).dump() + " deep");
}

void set_velocities(const Fluid_scene& scene, Fluid& fluid) {
  const Complex& complex = fluid.complex();
  // Of the liquids of its label, a connected part is the one that has most of its cells.
  std::map<std::uint32_t, std::vector<std::size_t>> cells; // by part and liquid
  for (const auto c : complex.cells()) {
    std::vector<std::size_t>& of_part = cells[c->component()];
    of_part.resize(scene.liquids.size(), 0);
    const Point middle =
        CGAL::centroid(complex.position(c->vertex(0)), complex.position(c->vertex(1)),
                       complex.position(c->vertex(2)), complex.position(c->vertex(3)));
    for (std::size_t i = 0; i < scene.liquids.size(); ++i)
      of_part[i] +=
          scene.liquids[i].label == c->label() && is_about(scene.liquids[i].shape, middle);
  }
  std::deque<Velocity_expressions> velocities; // not to be moved
  for (const Scene_liquid& liquid : scene.liquids)
    velocities.emplace_back(liquid.velocity, 3);
  std::map<Complex::Vertex_handle, std::size_t> liquid_of;
  for (const auto c : complex.cells()) {
    const std::vector<std::size_t>& of_part = cells[c->component()];
    const auto most = std::max_element(of_part.begin(), of_part.end());
    if (*most > 0)
      for (int i = 0; i < 4; ++i)
        liquid_of[c->vertex(i)] = std::size_t(most - of_part.begin());
  }
  fluid.set_velocities([&](Complex::Vertex_handle v) {
    const auto found = liquid_of.find(v);
    if (found == liquid_of.end())
      return Fluid::Vector(0, 0, 0);
    const Point p = complex.position(v);
    const auto u = velocities[found->second].at({p.x(), p.y(), p.z()}, 0);
    return Fluid::Vector(u[0], u[1], u[2]);
  });
}

} // namespace dsc
