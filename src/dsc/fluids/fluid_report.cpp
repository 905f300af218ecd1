// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_report.h"

#include "programs/errors.h"

#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/internal/numbers/Extent.h>

namespace dsc {
namespace {

// Returns a number rounded to three digits. More digits of a residual have no meaning.
double three_digits(double x) {
  if (!(x > 0))
    return x;
  const double unit = std::pow(10., std::floor(std::log10(x)) - 2);
  return std::round(x / unit) * unit;
}

/// Returns the coordinates of a point or vector; in the plane, the third one is 0.
template <class Vector> Json vector_json(const Vector& v) { return coordinates_of(v); }

Json balance_json(const DSC::Fluid_balance& balance) {
  return {{"volume", balance.volume},
          {"energy", balance.energy()},
          {"kinetic_energy", balance.kinetic_energy},
          {"potential_energy", balance.potential_energy},
          {"surface_energy", balance.surface_energy},
          {"gas_energy", balance.gas_energy},
          {"momentum", vector_json(balance.momentum)},
          {"angular_momentum", vector_json(balance.angular_momentum)}};
}

/// Returns the topology changes, with the state of the liquids before and after them.
template <class Complex>
Json events_json(const DSC::Fluid_report<Complex>& report, const Label_names& names) {
  Json result = Json::array();
  for (const auto& event : report.deformation.events) {
    Json entry = event_json(event, coordinates_of(event.where), 3, names);
    entry.update({{"before", balance_json(report.moved)}, {"after", balance_json(report.after)}});
    result.push_back(std::move(entry));
  }
  return result;
}

using Extent = DSC::internal::Extent<3>;

Json json_of(const Extent& e) {
  return {{e.lower(0), e.lower(1), e.lower(2)}, {e.upper(0), e.upper(1), e.upper(2)}};
}

/// Returns the bounding box of the interface.
template <class Complex> Json extent_json(const Complex& complex) {
  Extent result;
  for (const auto v : complex.interface_vertices())
    result.add(coordinates_of(complex.position(v)));
  return json_of(result);
}

/// A connected component of a liquid.
struct Measured_component
{
  int label = 0;
  double volume = 0;
  Extent extent;
};

template <class Complex>
Json components_json(const Fluid<Complex>& fluid, const Label_names& names) {
  Json result = Json::array();
  std::map<std::uint32_t, Measured_component> present;
  const Complex& complex = fluid.complex();
  for (const auto c : complex.cells()) {
    Measured_component& component = present[c->component()];
    component.label = c->subdomain_index();
    component.volume += complex.measure(c);
    for (int i = 0; i < Complex::corners; ++i)
      component.extent.add(coordinates_of(complex.position(c->vertex(i))));
  }
  for (const auto& [number, volume] : fluid.volumes()) {
    const Measured_component& component = present[number];
    result.push_back(label_json(component.label, names,
                                {{"volume", component.volume},
                                 {"wanted_volume", volume},
                                 {"extent", json_of(component.extent)}}));
  }
  return result;
}

template <class Complex> Json gases_json(const Fluid<Complex>& fluid, const Label_names& names) {
  Json result = Json::array();
  for (const auto& gas : fluid.gases())
    result.push_back(
        label_json(gas.label, names, {{"volume", gas.volume}, {"pressure", gas.pressure}}));
  return result;
}

const char* name_of(DSC::Fluid_failure cause) {
  using Failure = DSC::Fluid_failure;
  switch (cause) {
  case Failure::equations:
    return "equations";
  case Failure::motion:
    return "motion";
  case Failure::volume:
    return "volume";
  case Failure::walls:
    return "walls";
  case Failure::mesh:
    break;
  }
  return "mesh";
}

/// Returns the number of the body of each solid of a scene; the number of bodies for other solids.
std::vector<std::size_t> numbers_of_bodies(const Fluid_scene& scene) {
  const auto bodies =
      std::size_t(std::count_if(scene.solids.begin(), scene.solids.end(),
                                [](const Scene_solid& solid) { return solid.is_body(); }));
  std::vector<std::size_t> result;
  std::size_t next = 0;
  for (const Scene_solid& solid : scene.solids)
    result.push_back(solid.is_body() ? next++ : bodies);
  return result;
}

/// Returns the places and motions of the bodies.
template <class Complex> Json bodies_json(const Fluid<Complex>& fluid, const Fluid_scene& scene) {
  Json result = Json::array();
  const std::vector<std::size_t> numbers = numbers_of_bodies(scene);
  for (std::size_t s = 0; s < numbers.size(); ++s)
    if (scene.solids[s].is_body()) {
      const DSC::Rigid_body_3& body = fluid.body(numbers[s]);
      result.push_back({{"solid", s},
                        {"center", vector_json(body.center)},
                        {"velocity", vector_json(body.velocity)},
                        {"angular_velocity", vector_json(body.angular_velocity)},
                        {"rotation", body.rotation}});
    }
  return result;
}

/// Returns the center of a solid that is no body at a time.
std::array<double, 3> center_at(const Scene_solid& solid, double t) {
  using Vector = Scene_solid::Place::Vector;
  const Vector displacement =
      solid.place ? solid.place(t).displacement : t * DSC::point_of<Vector>(solid.velocity);
  return coordinates_of(DSC::point_of<Vector>(solid.center) + displacement);
}

/// Returns the torque on each solid about its present center.
template <class Complex>
Json torques_json(const Fluid<Complex>& fluid, const Fluid_scene& scene,
                  const DSC::Fluid_report<Complex>& report) {
  using Vector = typename DSC::Fluid_report<Complex>::Vector;
  Json result = Json::array();
  const std::vector<std::size_t> numbers = numbers_of_bodies(scene);
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    const Scene_solid& solid = scene.solids[s];
    const std::array<double, 3> center = solid.is_body()
                                             ? coordinates_of(fluid.body(numbers[s]).center)
                                             : center_at(solid, fluid.time());
    result.push_back(vector_json(
        report.torques_on_solids[s] -
        CGAL::cross_product(Vector(center[0], center[1], center[2]), report.forces_on_solids[s])));
  }
  return result;
}

/// Returns the rejected attempts of a step.
Json repetitions_json(const std::vector<DSC::Fluid_repetition>& repetitions) {
  Json result = Json::array();
  for (const auto& repetition : repetitions)
    result.push_back({{"cause", name_of(repetition.cause)},
                      {"time", repetition.time},
                      {"dt", repetition.dt},
                      {"amount", repetition.amount},
                      {"where", vector_json(repetition.place)}});
  return result;
}

} // namespace

template <class Complex>
Json step_json(const Fluid<Complex>& fluid, const Fluid_scene& scene, unsigned step,
               const std::optional<DSC::Fluid_report<Complex>>& report) {
  const Complex& complex = fluid.complex();
  Json json = {{"step", step}, {"time", fluid.time()}};
  const DSC::Fluid_balance balance = fluid.balance(); // with the present gravity
  json.update(balance_json(balance));
  if (fluid.has_field())
    json["field"] = {{"integral", balance.field_integral},
                     {"least", balance.least_field},
                     {"greatest", balance.greatest_field}};
  json["parts"] = components_json(fluid, scene.names);
  json["gases"] = gases_json(fluid, scene.names);
  json["bodies"] = bodies_json(fluid, scene);
  json["extent"] = extent_json(complex);
  json["probes"] = probes_json(scene, fluid);
  json["vertices"] = complex.number_of_vertices();
  constexpr bool is_planar = Complex::dimension == 2;
  json[is_planar ? "triangles" : "tetrahedra"] = complex.number_of_cells();
  json[is_planar ? "interface_edges" : "interface_triangles"] = complex.interface_facets().size();
  if (!report)
    return json;
  if (fluid.has_field())
    json["work_of_tensions"] = report->work_of_tensions;
  Json forces = Json::array();
  for (const auto& force : report->forces_on_solids)
    forces.push_back(vector_json(force));
  if (std::any_of(scene.inflows.begin(), scene.inflows.end(), [](const auto& s) { return s; }) ||
      std::any_of(scene.openings.begin(), scene.openings.end(), [](const auto& s) { return s; }))
    for (int side = 0; side < 2 * Complex::dimension; ++side)
      json["volume_through_sides"].push_back(report->volume_through_sides[std::size_t(side)]);
  const auto& motion = report->deformation;
  json.update({{"dt", report->dt},
               {"greatest_velocity", report->greatest_velocity},
               {"greatest_change_of_velocity", report->greatest_change_of_velocity},
               {"greatest_correction", report->greatest_correction},
               {"volume_correction", report->volume_correction},
               {"volume_error", report->volume_error},
               {"lost_volume", report->lost_volume},
               {"gained_volume", report->gained_volume},
               {"energy_before", report->before.energy()},
               {"energy_moved", report->moved.energy()},
               {"contacts", report->contacts},
               {"contacts_settled", report->contacts_settled},
               {"depth_in_solids", report->depth_in_solids},
               {"forces_on_solids", forces},
               {"torques_on_solids", torques_json(fluid, scene, *report)},
               {"events", events_json(*report, scene.names)},
               {"complete", motion.complete},
               {"unfinished_vertices", motion.unfinished.size()},
               {"cells_below_floor", motion.flat.size()},
               {"split", motion.split + report->adaptation.split},
               {"collapsed", motion.collapsed + report->adaptation.collapsed},
               {"flipped", motion.flipped + report->adaptation.flipped},
               {"smoothed", motion.smoothed + report->adaptation.smoothed},
               {"solutions", report->solutions},
               {"iterations", report->iterations},
               {"residual", three_digits(report->residual)},
               {"flat_cells", report->flat_cells},
               {"substeps", report->parts},
               {"repetitions", repetitions_json(report->repetitions)},
               {"seconds_of_solver", report->seconds_of_solver},
               {"seconds_of_mesh", report->seconds_of_mesh}});
  return json;
}

template Json step_json(const Fluid<Tracked_complex_2::Complex>&, const Fluid_scene&, unsigned,
                        const std::optional<DSC::Fluid_report<Tracked_complex_2::Complex>>&);
template Json step_json(const Fluid<Tracked_complex_3::Complex>&, const Fluid_scene&, unsigned,
                        const std::optional<DSC::Fluid_report<Tracked_complex_3::Complex>>&);

void Repetitions::add(const std::vector<DSC::Fluid_repetition>& repetitions) {
  m_steps += !repetitions.empty();
  for (const auto& repetition : repetitions)
    ++m_attempts[name_of(repetition.cause)];
}

std::string Repetitions::text() const {
  if (m_steps == 0)
    return "";
  std::string result;
  for (const auto& [cause, number] : m_attempts)
    result += (result.empty() ? "" : ", ") + cause + " " + std::to_string(number);
  return "; " + std::to_string(m_steps) + noun(m_steps, " step", " steps") +
         " repeated (undone attempts: " + result + ")";
}

} // namespace dsc
