// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_start.h"

#include "fluids/fluid_shapes.h"
#include "input/files.h"
#include "input/surface.h"
#include "programs/errors.h"
#include "scenes/add_solid.h"

#include <CGAL/Mesh_support/coordinates.h>

#include <filesystem>

namespace dsc {
namespace {

bool is_in_source(const Scene_source& source, const std::array<double, 3>& p) {
  const auto& c = source.center;
  return std::hypot(p[0] - c[0], p[1] - c[1], p[2] - c[2]) < source.radius;
}

template <class Complex> void add_sources(const Fluid_scene& scene, Fluid<Complex>& fluid) {
  using Point = typename Fluid<Complex>::Point;
  const auto has_rate = [](const Scene_source& source) { return source.rate != 0; };
  if (std::any_of(scene.sources.begin(), scene.sources.end(), has_rate))
    fluid.set_sources([sources = scene.sources](const Point& p, double) {
      double rate = 0;
      for (const Scene_source& source : sources)
        if (is_in_source(source, coordinates_of(p)))
          rate += source.rate;
      return rate;
    });
  for (const Scene_source& source : scene.sources)
    if (source.flux)
      fluid.add_source([source](const Point& p) { return is_in_source(source, coordinates_of(p)); },
                       [flux = *source.flux](double t) { return *flux.at({t}); });
}

bool is_in(const std::array<double, 6>& box, const std::array<double, 3>& p) {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < box[i] || p[i] > box[i + 3])
      return false;
  return true;
}

template <class Complex>
void add_inflows_and_openings(const Fluid_scene& scene, Fluid<Complex>& fluid) {
  using Coordinates = std::array<double, 3>;
  for (std::size_t side = 0; side < scene.sides.size(); ++side) {
    DSC::Side_behavior behavior;
    if (const auto& opening = scene.openings[side]) {
      behavior.velocity = opening->velocity;
      behavior.pressure = [given = *opening](const Coordinates& p, double t) {
        return is_in(given.box, p)
                   ? std::optional<double>(*given.pressure.at_point(p, Complex::dimension, t))
                   : std::nullopt;
      };
    } else if (const auto& inflow = scene.inflows[side]) {
      behavior.inflow = [given = *inflow](const Coordinates& p, double t) {
        return is_in(given.box, p) ? std::optional<Coordinates>(given.velocity.at(t))
                                   : std::nullopt;
      };
    } else
      continue;
    fluid.set_side(int(side / 2), side % 2 == 1, behavior);
  }
}

template <class Complex>
void set_field(const Scene_field& field, const Fluid_scene& scene, Fluid<Complex>& fluid) {
  using Point = typename Fluid<Complex>::Point;
  constexpr int d = Complex::dimension;
  fluid.set_field([&](const Point& p) { return *field.initial.at_point(p, d); });
  static constexpr double rounding = 1e-9; // relative to the edge length
  fluid.fix_field([field, domain = scene.domain, nearby = rounding * scene.edge](
                      const Point& p, double t) -> std::optional<double> {
    bool is_on_side = false;
    for (std::size_t side = 0; side < std::size_t(2 * d); ++side)
      if (std::abs(p[int(side / 2)] - domain[side / 2 + 3 * (side % 2)]) <= nearby) {
        is_on_side = true;
        if (field.on_sides[side])
          return *field.on_sides[side]->at_point(p, Complex::dimension, t);
      }
    if (is_on_side || !field.on_surface)
      return std::nullopt;
    return *field.on_surface->at_point(p, Complex::dimension, t);
  });
}

/// Throws unless every liquid and gas has cells. Where shapes of one label overlap, the cells
/// belong to the last shape.
template <class Complex>
void require_cells_of_all(const Fluid_scene& scene, const Complex& complex) {
  const auto shapes = shapes_of(scene);
  std::vector<std::size_t> cells(shapes.size(), 0);
  for (const auto c : complex.cells()) {
    const auto middle = middle_of(complex, c);
    for (std::size_t i = shapes.size(); i-- > 0;)
      if (shapes[i].first == c->subdomain_index() &&
          is_about(*shapes[i].second, middle, Complex::dimension)) {
        ++cells[i];
        break;
      }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] == 0)
      throw Input_error(name_of_shape(scene, i) +
                        " of the scene has no cells: other shapes or solids cover it, or it is "
                        "outside the domain; move it or remove it");
}

template <class Complex>
void require_liquid_at_sources(const Fluid_scene& scene, const Complex& complex) {
  std::vector<bool> meets_liquid(scene.sources.size(), false);
  for (const auto c : complex.cells())
    if (is_liquid(scene, c->subdomain_index()))
      for (std::size_t i = 0; i < scene.sources.size(); ++i)
        if (!meets_liquid[i])
          meets_liquid[i] = is_in_source(scene.sources[i], middle_of(complex, c));
  for (std::size_t i = 0; i < scene.sources.size(); ++i)
    if (!meets_liquid[i])
      throw Input_error("sources[" + std::to_string(i) +
                        "] of the scene contains no liquid; move it or choose a larger radius");
}

template <class Complex>
void require_liquid_at_sides(const Fluid_scene& scene, const Complex& complex) {
  unsigned met = 0; // sides as bits
  for (const auto c : complex.cells())
    if (is_liquid(scene, c->subdomain_index()))
      for (int i = 0; i < Complex::corners; ++i)
        met |= c->vertex(i)->boundary_class();
  for (std::size_t side = 0; side < scene.sides.size(); ++side)
    if ((scene.sides[side] || scene.inflows[side] || scene.openings[side]) && !(met >> side & 1))
      throw Input_error("no liquid touches the side '" + std::string(names_of_sides[side]) +
                        "' of the domain, so its condition has no effect; remove it");
  for (std::size_t side = 0; scene.field && side < scene.sides.size(); ++side)
    if (scene.field->on_sides[side] && !(met >> side & 1))
      throw Input_error("no liquid touches the side '" + std::string(names_of_sides[side]) +
                        "' of the domain, so the field fixed there has no effect; remove it");
}

} // namespace

template <class Complex>
std::unique_ptr<Fluid<Complex>> fluid_of_scene(const Fluid_scene& scene, Complex& complex) {
  using namespace DSC;
  Fluid_properties properties;
  for (const Scene_liquid& liquid : scene.liquids)
    properties.set_liquid(
        liquid.label, {liquid.density,
                       liquid.viscosity,
                       {},
                       liquid.diffusivity.value_or(scene.field ? scene.field->diffusivity : 0)});
  for (const Scene_gas& gas : scene.gases)
    properties.set_gas(gas.label, {gas.pressure, gas.exponent});
  for (const auto& tension : scene.tensions)
    if (tension.expression)
      properties.set_surface_tension(tension.labels[0], tension.labels[1],
                                     [at = *tension.expression](double c) { return *at.at({c}); });
    else
      properties.set_surface_tension(tension.labels[0], tension.labels[1], tension.value);
  auto result = std::make_unique<Fluid<Complex>>(complex, properties);
  Fluid<Complex>& fluid = *result;
  add_sources(scene, fluid);
  static constexpr double difference = 1e-4; // of places of solids, in time steps
  for (const Scene_solid& solid : scene.solids)
    add_solid(solid, difference * scene.time_step, fluid);
  add_inflows_and_openings(scene, fluid);
  if (scene.field)
    set_field(*scene.field, scene, fluid);
  set_time(scene, 0, fluid);
  return result;
}

template <class Complex> void set_time(const Fluid_scene& scene, double t, Fluid<Complex>& fluid) {
  fluid.set_gravity(scene.gravity.at(t));
  for (std::size_t side = 0; side < scene.sides.size(); ++side)
    if (const auto& given = scene.sides[side]) {
      const auto velocity = given->at(t);
      if (velocity[side / 2] != 0)
        given->expression->refuse("must be a velocity along the side");
      fluid.set_side(int(side / 2), side % 2 == 1, {velocity});
    }
}

template <class Complex> void require_effect(const Fluid_scene& scene, const Complex& complex) {
  require_cells_of_all(scene, complex);
  require_liquid_at_sources(scene, complex);
  require_liquid_at_sides(scene, complex);
}

template <class Complex>
void require_outside_of_solids(const Fluid_scene& scene, const Fluid<Complex>& fluid) {
  static constexpr double rounding = 1e-6; // relative to the edge length
  if (fluid.depth_in_solids() > rounding * scene.edge)
    throw Input_error("a liquid of the scene is inside a solid at the start, at a depth of " +
                      Json(fluid.depth_in_solids()).dump() + "; move the liquid or the solid");
}

template <class Complex> void set_velocities(const Fluid_scene& scene, Fluid<Complex>& fluid) {
  const Complex& complex = fluid.complex();
  // A connected component gets the velocity of the liquid of its label that contains most of its
  // cells.
  std::map<std::uint32_t, std::vector<std::size_t>> cells; // by component and liquid
  for (const auto c : complex.cells()) {
    std::vector<std::size_t>& of_component = cells[c->component()];
    of_component.resize(scene.liquids.size(), 0);
    const auto middle = middle_of(complex, c);
    for (std::size_t i = 0; i < scene.liquids.size(); ++i)
      of_component[i] += scene.liquids[i].label == c->subdomain_index() &&
                         is_about(scene.liquids[i].shape, middle, Complex::dimension);
  }
  using Vertex_handle = typename Complex::Vertex_handle;
  using Vector = typename Fluid<Complex>::Vector;
  std::map<std::pair<Vertex_handle, int>, std::size_t> liquid_of; // of vertex and label
  for (const auto c : complex.cells()) {
    const std::vector<std::size_t>& of_component = cells[c->component()];
    const auto most = std::max_element(of_component.begin(), of_component.end());
    if (*most > 0)
      for (int i = 0; i < Complex::corners; ++i)
        liquid_of[{c->vertex(i), c->subdomain_index()}] = std::size_t(most - of_component.begin());
  }
  fluid.set_velocities([&](Vertex_handle v, int label) {
    const auto found = liquid_of.find({v, label});
    if (found == liquid_of.end() || !scene.liquids[found->second].velocity)
      return Vector(CGAL::NULL_VECTOR);
    const Expression& velocity = *scene.liquids[found->second].velocity;
    constexpr int d = Complex::dimension;
    return DSC::from_coordinates<Vector>(velocity.at_point(complex.position(v), d),
                                         std::make_integer_sequence<int, d>());
  });
}

template void require_effect(const Fluid_scene&, const Tracked_complex_2::Complex&);
template std::unique_ptr<Fluid<Tracked_complex_2::Complex>>
fluid_of_scene(const Fluid_scene&, Tracked_complex_2::Complex&);
template void set_time(const Fluid_scene&, double, Fluid<Tracked_complex_2::Complex>&);
template void require_outside_of_solids(const Fluid_scene&,
                                        const Fluid<Tracked_complex_2::Complex>&);
template void set_velocities(const Fluid_scene&, Fluid<Tracked_complex_2::Complex>&);
template void require_effect(const Fluid_scene&, const Tracked_complex_3::Complex&);
template std::unique_ptr<Fluid<Tracked_complex_3::Complex>>
fluid_of_scene(const Fluid_scene&, Tracked_complex_3::Complex&);
template void set_time(const Fluid_scene&, double, Fluid<Tracked_complex_3::Complex>&);
template void require_outside_of_solids(const Fluid_scene&,
                                        const Fluid<Tracked_complex_3::Complex>&);
template void set_velocities(const Fluid_scene&, Fluid<Tracked_complex_3::Complex>&);

std::string place_of(const std::string& file, const std::string& folder) {
  const std::filesystem::path path(file);
  return path.is_absolute() || folder.empty() ? file
                                              : (std::filesystem::path(folder) / path).string();
}

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
    if (const std::string place = place_of(file, folder); !exists(place))
      throw Input_error("the file '" + place +
                        "' of the scene does not exist; give its folder by --data");
}

void read_meshes(const std::string& folder, Fluid_scene& scene) {
  for (Scene_solid& solid : scene.solids) {
    if (solid.kind != Scene_solid::Kind::mesh)
      continue;
    Scene_solid::Mesh mesh;
    const Surface surface = read_part(place_of(solid.file, folder), solid.part);
    for (const Surface_point& p : surface.points)
      mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const auto& t : surface.triangles)
      mesh.add_face(CGAL::SM_Vertex_index(std::uint32_t(t[0])),
                    CGAL::SM_Vertex_index(std::uint32_t(t[1])),
                    CGAL::SM_Vertex_index(std::uint32_t(t[2])));
    solid.set_mesh(std::move(mesh));
  }
}

} // namespace dsc
