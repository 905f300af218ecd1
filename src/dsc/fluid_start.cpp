// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_start.h"

#include "domain_box.h"
#include "errors.h"
#include "fluid_shapes.h"
#include "label_components.h"
#include "remove_fragments.h"
#include "surface.h"

#include <CGAL/Deformable_simplicial_complexes/IO/labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/make_deformable_simplicial_complex_3.h>
#include <CGAL/Tetgen_tetrahedralizer_3.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

using Complex = Tracked_complex_3::Complex;
using Point = Complex::Approximate_point;
namespace parameters = CGAL::Deformable_simplicial_complexes::parameters;

std::string place_of(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  return path.is_absolute() || folder.empty() ? file
                                              : (std::filesystem::path(folder) / path).string();
}

std::array<double, 3> middle_of(const Complex& complex, Complex::Cell_handle c) {
  const Point p = CGAL::centroid(complex.position(c->vertex(0)), complex.position(c->vertex(1)),
                                 complex.position(c->vertex(2)), complex.position(c->vertex(3)));
  return {p.x(), p.y(), p.z()};
}

bool is_in_source(const Scene_source& source, const std::array<double, 3>& p) {
  const auto& c = source.center;
  return std::hypot(p[0] - c[0], p[1] - c[1], p[2] - c[2]) < source.radius;
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
      continue; // fills the space around the others
    }
    surfaces.back().label = label;
  }
  if (surfaces.empty())
    throw Input_error(
        "all liquids and gases of the scene have the shape 'surroundings'; add another shape");
  return DSC::make_deformable_simplicial_complex_3<Complex>(
      surfaces, CGAL::Tetgen_tetrahedralizer_3(), parameters::enclosing_box(box(scene.domain)));
}

void require_inside(const Fluid_scene& scene, const Pool_shape& pool) {
  if (!(pool.level > scene.domain[2] && pool.level < scene.domain[5]))
    throw Input_error("the level of the pool is outside the domain; correct 'level' or 'domain'");
}

/// Returns a complex of cubes divided into six tetrahedra each. A plane between two layers of cubes
/// is at the level of the pool.
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
        do { // one tetrahedron for each order of the axes: a path from corner to corner
          std::array<std::size_t, 4> t;
          t[0] = i + j * stride[1] + k * stride[2];
          for (std::size_t a = 0; a < 3; ++a)
            t[a + 1] = t[a] + stride[axes[a]];
          tetrahedra.push_back(t);
          labels.push_back(k < below ? label : 0);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  Complex complex = DSC::make_deformable_simplicial_complex_3<Complex>(
      points, std::move(tetrahedra), labels, parameters::improve(false));
  if (pool.height)
    DSC::deform_interface(complex, [&](Complex::Vertex_handle v) {
      const Point p = complex.position(v);
      return Complex::Point(p.x(), p.y(), *pool.height->at({p.x(), p.y()}));
    });
  return complex;
}

/// Returns a complex for a pool beside other shapes, built from the labels of points.
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
      if (pool->height)
        throw Input_error(
            "a pool with a 'height' cannot be combined with other shapes; remove 'height'");
    }
    if (std::holds_alternative<File_shape>(shape) || (column && column->amplitude != 0) ||
        (ball && (ball->mode > 0 || ball->triangles > 0)))
      throw Input_error(
          "a pool can be combined only with boxes, balls and cylinders; remove shapes "
          "of type 'file' and the fields 'mode', 'amplitude' and 'triangles'");
  }
  const auto label_at = [&](const std::array<double, 3>& p) {
    int result = 0;
    for (const auto& [label, shape] : shapes)
      if (!std::holds_alternative<Surroundings>(*shape) && is_about(*shape, p))
        result = label;
    return result;
  };
  auto result = DSC::make_deformable_simplicial_complex_3<Complex>(
      box(scene.domain), scene.edge, [&](const Point& p) {
        return label_at({p.x(), p.y(), p.z()});
      });
  std::map<int, std::string> names;
  for (const auto& filling : shapes)
    if (filling.first != 0)
      names[filling.first] = "label " + std::to_string(filling.first) + " of the scene";
  const Component_ranges expected = count_components(scene.domain, scene.edge, label_at);
  remove_fragments(result, expected);
  require_resolved(scene.domain, scene.edge, label_at, expected, numbers_of_components(result),
                   names);
  return result;
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

void require_files(const Fluid_scene& scene, const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& filling : shapes_of(scene))
    if (const auto* shape = std::get_if<File_shape>(filling.second))
      files.push_back(shape->file);
  for (const Scene_solid& solid : scene.solids)
    if (solid.kind == Scene_solid::Kind::mesh)
      files.push_back(solid.file);
  if (files.empty() && !folder.empty())
    throw Usage_error("--data has no effect because the scene names no files; leave it out");
  for (const std::string& file : files)
    if (const std::string place = place_of(file, folder); !std::filesystem::exists(place))
      throw Input_error("the file '" + place +
                        "' of the scene does not exist; give its folder by --data");
}

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
  Fluid_properties properties;
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
        if (is_in_source(source, {p.x(), p.y(), p.z()}))
          rate += source.rate;
      return rate;
    });
  for (std::size_t side = 0; side < scene.sides.size(); ++side)
    if (scene.sides[side])
      fluid.set_side(int(side / 2), side % 2 == 1, {scene.sides[side]});
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

namespace {

/// Throws unless every liquid and gas has cells. Where shapes of one label overlap, the cells
/// belong to the last shape.
void require_cells_of_all(const Fluid_scene& scene, const Complex& complex) {
  const auto shapes = shapes_of(scene);
  std::vector<std::size_t> cells(shapes.size(), 0);
  for (const auto c : complex.cells()) {
    const auto middle = middle_of(complex, c);
    for (std::size_t i = shapes.size(); i-- > 0;)
      if (shapes[i].first == c->label() && is_about(*shapes[i].second, middle)) {
        ++cells[i];
        break;
      }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] == 0) {
      const bool is_liquid = i < scene.liquids.size();
      throw Input_error((is_liquid ? "liquids[" + std::to_string(i)
                                   : "gases[" + std::to_string(i - scene.liquids.size())) +
                        "] of the scene has no cells: other shapes cover it, or it is outside "
                        "the domain; move it or remove it");
    }
}

void require_liquid_at_sources(const Fluid_scene& scene, const Complex& complex) {
  const auto is_liquid = [&](int label) {
    return std::any_of(scene.liquids.begin(), scene.liquids.end(),
                       [&](const Scene_liquid& liquid) { return liquid.label == label; });
  };
  std::vector<bool> meets_liquid(scene.sources.size(), false);
  for (const auto c : complex.cells())
    if (is_liquid(c->label()))
      for (std::size_t i = 0; i < scene.sources.size(); ++i)
        if (!meets_liquid[i])
          meets_liquid[i] = is_in_source(scene.sources[i], middle_of(complex, c));
  for (std::size_t i = 0; i < scene.sources.size(); ++i)
    if (!meets_liquid[i])
      throw Input_error("sources[" + std::to_string(i) +
                        "] of the scene contains no liquid; move it or choose a larger radius");
}

void require_liquid_at_sides(const Fluid_scene& scene, const Complex& complex) {
  unsigned met = 0; // sides as bits
  for (const auto c : complex.cells())
    if (std::any_of(scene.liquids.begin(), scene.liquids.end(),
                    [&](const Scene_liquid& liquid) { return liquid.label == c->label(); }))
      for (int i = 0; i < 4; ++i)
        met |= c->vertex(i)->boundary_class();
  for (std::size_t side = 0; side < scene.sides.size(); ++side)
    if (scene.sides[side] && !(met >> side & 1))
      throw Input_error("no liquid touches the side '" + std::string(names_of_sides[side]) +
                        "' of the domain, so its velocity has no effect; remove it");
}

} // namespace

void require_effect(const Fluid_scene& scene, const Complex& complex) {
  require_cells_of_all(scene, complex);
  require_liquid_at_sources(scene, complex);
  require_liquid_at_sides(scene, complex);
}

void require_outside_of_solids(const Fluid_scene& scene, const Fluid& fluid) {
  static constexpr double rounding = 1e-6; // relative to the edge length
  if (fluid.depth_in_solids() > rounding * scene.edge)
    throw Input_error("a liquid of the scene is inside a solid at the start, at a depth of " +
                      Json(fluid.depth_in_solids()).dump() + "; move the liquid or the solid");
}

void set_velocities(const Fluid_scene& scene, Fluid& fluid) {
  const Complex& complex = fluid.complex();
  // A connected component gets the velocity of the liquid of its label that contains most of its
  // cells.
  std::map<std::uint32_t, std::vector<std::size_t>> cells; // by component and liquid
  for (const auto c : complex.cells()) {
    std::vector<std::size_t>& of_component = cells[c->component()];
    of_component.resize(scene.liquids.size(), 0);
    const auto middle = middle_of(complex, c);
    for (std::size_t i = 0; i < scene.liquids.size(); ++i)
      of_component[i] +=
          scene.liquids[i].label == c->label() && is_about(scene.liquids[i].shape, middle);
  }
  std::map<std::pair<Complex::Vertex_handle, int>, std::size_t> liquid_of; // of vertex and label
  for (const auto c : complex.cells()) {
    const std::vector<std::size_t>& of_component = cells[c->component()];
    const auto most = std::max_element(of_component.begin(), of_component.end());
    if (*most > 0)
      for (int i = 0; i < 4; ++i)
        liquid_of[{c->vertex(i), c->label()}] = std::size_t(most - of_component.begin());
  }
  fluid.set_velocities([&](Complex::Vertex_handle v, int label) {
    const auto found = liquid_of.find({v, label});
    if (found == liquid_of.end() || !scene.liquids[found->second].velocity)
      return Fluid::Vector(0, 0, 0);
    const Point p = complex.position(v);
    const double* u = scene.liquids[found->second].velocity->at({p.x(), p.y(), p.z()});
    return Fluid::Vector(u[0], u[1], u[2]);
  });
}

} // namespace dsc
