// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_scene_parts.h"

#include <set>

namespace dsc {
namespace {

void require_one_phase_per_label(const Fluid_scene& scene, const Json_fields& json) {
  for (const Scene_liquid& a : scene.liquids)
    for (const Scene_liquid& b : scene.liquids)
      if (a.label == b.label &&
          (a.density != b.density || a.viscosity != b.viscosity || a.diffusivity != b.diffusivity))
        json.refuse("liquids", "liquids of the same label must have the same density, viscosity "
                               "and diffusivity");
  for (const Scene_gas& gas : scene.gases) {
    for (const Scene_liquid& liquid : scene.liquids)
      if (gas.label == liquid.label)
        json.refuse("gases", "a gas must not have the label of a liquid; choose another label");
    for (const Scene_gas& other : scene.gases)
      if (gas.label == other.label &&
          (gas.pressure != other.pressure || gas.exponent != other.exponent))
        json.refuse("gases", "gases of the same label must have the same pressure and exponent");
  }
  std::size_t surroundings = 0;
  for (const auto& filling : shapes_of(scene))
    surroundings += std::holds_alternative<Surroundings>(*filling.second);
  if (surroundings > 1)
    json.refuse("liquids",
                "only one liquid or gas can have the shape 'surroundings'; remove the others");
}

void require_pairs_of_labels(const Fluid_scene& scene, const Json_fields& json) {
  std::set<int> labels = {0};
  for (const auto& filling : shapes_of(scene))
    labels.insert(filling.first);
  std::set<std::pair<int, int>> known;
  for (const auto& tension : scene.tensions) {
    const auto [a, b] = std::minmax(tension.labels[0], tension.labels[1]);
    for (int label : {a, b})
      if (labels.count(label) == 0)
        json.refuse("surface_tension", "no liquid or gas has the label " + std::to_string(label) +
                                           "; correct the label");
    const std::string pair = std::to_string(a) + " and " + std::to_string(b);
    if (a == b)
      json.refuse("surface_tension", "must have two different labels, not " + pair);
    if (!known.emplace(a, b).second)
      json.refuse("surface_tension", "the labels " + pair + " occur twice; remove one entry");
  }
}

bool measures_label(Scene_probe::Kind kind) {
  using Kind = Scene_probe::Kind;
  return kind == Kind::circularity || kind == Kind::centroid || kind == Kind::velocity;
}

/// Throws unless the label of a probe belongs to a liquid or, if no velocity is measured, to a gas.
void require_label(const Scene_probe& probe, const Fluid_scene& scene, const Json_fields& json) {
  const bool is_gas = std::any_of(scene.gases.begin(), scene.gases.end(),
                                  [&](const Scene_gas& gas) { return gas.label == probe.label; });
  const bool has_velocity = probe.kind == Scene_probe::Kind::velocity;
  if (!is_liquid(scene, probe.label) && (has_velocity || !is_gas))
    json.refuse("probes", "no liquid " + std::string(has_velocity ? "" : "or gas ") +
                              "has the label " + std::to_string(probe.label) + " of the probe '" +
                              probe.name + "'; correct the label");
}

/// Throws unless the place or point of a probe is in the domain.
void require_in_domain(const Scene_probe& probe, const Fluid_scene& scene,
                       const Json_fields& json) {
  const bool has_point = probe.kind == Scene_probe::Kind::point;
  const auto d = std::size_t(scene.dimension);
  for (std::size_t i = 0; i < (has_point ? d : d - 1); ++i) {
    const double x = has_point ? probe.point[i] : probe.place[i];
    if (!(scene.domain[i] <= x && x <= scene.domain[i + 3]))
      json.refuse("probes", "the probe '" + probe.name + "' is outside the domain; move it");
  }
}

void require_probes(const Fluid_scene& scene, const Json_fields& json) {
  std::set<std::string> names;
  for (const Scene_probe& probe : scene.probes) {
    if (!names.insert(probe.name).second)
      json.refuse("probes", "two probes have the name '" + probe.name + "'; rename one of them");
    if (probe.kind == Scene_probe::Kind::height || probe.kind == Scene_probe::Kind::point)
      require_in_domain(probe, scene, json);
    if (measures_label(probe.kind))
      require_label(probe, scene, json);
  }
}

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns the smallest and the largest distance of a point from a box.
std::pair<double, double> distances(const Vector& p, const std::array<double, 6>& box) {
  Vector nearest, farthest;
  for (std::size_t i = 0; i < 3; ++i) {
    nearest[i] = (std::max)({box[i] - p[i], p[i] - box[i + 3], 0.});
    farthest[i] = (std::max)(std::abs(box[i] - p[i]), std::abs(box[i + 3] - p[i]));
  }
  return {std::sqrt(dot(nearest, nearest)), std::sqrt(dot(farthest, farthest))};
}

/// Returns whether the whole domain is in front of a plane.
bool is_in_front(const Scene_solid& plane, const std::array<double, 6>& box) {
  double least = 0; // signed distance times the length of the normal
  for (std::size_t i = 0; i < 3; ++i)
    least += plane.direction[i] * ((plane.direction[i] > 0 ? box[i] : box[i + 3]) - plane.point[i]);
  return least > 0;
}

/// Returns whether all walls of a tank are outside the domain of a scene. An open tank has no wall
/// at its largest last coordinate.
bool is_around(const Scene_solid& tank, const Fluid_scene& scene) {
  const auto d = std::size_t(scene.dimension);
  for (std::size_t i = 0; i < d; ++i)
    if (scene.domain[i] <= tank.box[i] ||
        (scene.domain[i + 3] >= tank.box[i + 3] && !(i + 1 == d && tank.is_open)))
      return false;
  return true;
}

/// Returns whether a solid box is outside the domain of a scene.
bool is_outside(const Scene_solid& box, const Fluid_scene& scene) {
  for (std::size_t i = 0; i < std::size_t(scene.dimension); ++i)
    if (box.box[i] > scene.domain[i + 3] || box.box[i + 3] < scene.domain[i])
      return true;
  return false;
}

/// Returns whether no liquid inside the domain can touch a solid. Returns false for solids with a
/// given motion, which may enter the domain, and for cylinders and meshes, which are not tested.
bool is_out_of_reach(const Scene_solid& solid, const Fluid_scene& scene) {
  if (solid.moves() && !solid.is_body())
    return false;
  const auto [least, largest] = distances(solid.point, scene.domain);
  switch (solid.kind) {
  case Scene_solid::Kind::plane:
    return is_in_front(solid, scene.domain);
  case Scene_solid::Kind::tank:
    return is_around(solid, scene);
  case Scene_solid::Kind::box:
    return is_outside(solid, scene);
  case Scene_solid::Kind::ball:
    return solid.contains_liquid ? largest < solid.radius : least > solid.radius;
  case Scene_solid::Kind::cylinder:
  case Scene_solid::Kind::mesh:
    break;
  }
  return false;
}

void require_effect_of_solids(const Fluid_scene& scene, const Json_fields& json) {
  const bool has_tension =
      std::any_of(scene.tensions.begin(), scene.tensions.end(),
                  [](const auto& tension) { return tension.value > 0 || tension.expression; });
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    if (is_out_of_reach(scene.solids[i], scene))
      json.refuse("solids", numbered("solids", i) +
                                " has no effect because it is outside the domain; remove it");
    static constexpr double usual = 90;
    if (!has_tension && scene.solids[i].contact_angle != usual)
      json.refuse("solids", "the contact_angle of " + numbered("solids", i) +
                                " has no effect without surface_tension; remove it");
  }
}

void require_effect_of_sources(const Fluid_scene& scene, const Json_fields& json) {
  for (std::size_t i = 0; i < scene.sources.size(); ++i)
    if (distances(scene.sources[i].center, scene.domain).first >= scene.sources[i].radius)
      json.refuse("sources", numbered("sources", i) +
                                 " contains no liquid because it is outside the domain; move it");
}

void require_field(const Fluid_scene& scene, const Json_fields& json) {
  if (scene.field)
    return;
  for (const auto& tension : scene.tensions)
    if (tension.expression)
      json.refuse("surface_tension",
                  "depends on the field c, but the scene has no field; add the field 'field'");
  for (const Scene_liquid& liquid : scene.liquids)
    if (liquid.diffusivity)
      json.refuse("liquids", "a diffusivity has no effect without the field 'field'; remove it");
}

} // namespace

void require_consistent(const Fluid_scene& scene, const Json_fields& json) {
  require_one_phase_per_label(scene, json);
  require_pairs_of_labels(scene, json);
  require_field(scene, json);
  require_probes(scene, json);
  require_effect_of_solids(scene, json);
  require_effect_of_sources(scene, json);
}

} // namespace dsc
