// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluid_report.h"

#include "errors.h"
#include "legendre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {
namespace {

// Returns a number rounded to three digits. More digits of a residual have no meaning.
double three_digits(double x) {
  if (!(x > 0))
    return x;
  const double unit = std::pow(10., std::floor(std::log10(x)) - 2);
  return std::round(x / unit) * unit;
}

using Complex = Tracked_complex_3::Complex;

template <class Vector> Json vector_json(const Vector& v) { return {v.x(), v.y(), v.z()}; }

Json balance_json(const Fluid::Balance& balance) {
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
Json events_json(const Fluid::Report& report) {
  Json result = Json::array();
  for (const auto& event : report.deformation.events) {
    Json entry = event_json(event, {event.where.x(), event.where.y(), event.where.z()}, 3);
    entry.update({{"before", balance_json(report.moved)}, {"after", balance_json(report.after)}});
    result.push_back(std::move(entry));
  }
  return result;
}

/// The bounding box of points.
class Extent
{
public:
  void add(const Complex::Approximate_point& p) {
    for (int i = 0; i < 3; ++i) {
      m_least[std::size_t(i)] = std::min(m_least[std::size_t(i)], p[i]);
      m_largest[std::size_t(i)] = std::max(m_largest[std::size_t(i)], p[i]);
    }
  }
  Json json() const { return {m_least, m_largest}; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> m_least = {infinity, infinity, infinity},
                        m_largest = {-infinity, -infinity, -infinity};
};

/// Returns the bounding box of the interface.
Json extent_json(const Complex& complex) {
  Extent result;
  for (const auto v : complex.interface_vertices())
    result.add(complex.position(v));
  return result.json();
}

/// Returns the amplitude of a Legendre polynomial in the distance of the interface from a point,
/// relative to the mean distance. The interface is weighted by solid angle.
double amplitude(const Complex& complex, std::size_t degree, const std::array<double, 3>& center) {
  const Complex::Approximate_point c(center[0], center[1], center[2]);
  double sum = 0, squares = 0, mean = 0, angles = 0;
  struct Sample
  {
    double weight, distance, value;
  };
  std::vector<Sample> samples;
  for (const auto& f : complex.interface_facets()) {
    const auto v = complex.facet_vertices(f);
    const auto p = complex.position(v[0]), q = complex.position(v[1]), r = complex.position(v[2]);
    const auto m = CGAL::centroid(p, q, r);
    const double distance = std::sqrt((m - c).squared_length());
    const double weight =
        std::abs(CGAL::cross_product(q - p, r - p) * (m - c)) / (distance * distance * distance);
    const double value = legendre(degree, (m.z() - c.z()) / distance);
    samples.push_back({weight, distance, value});
    mean += weight * distance;
    angles += weight;
  }
  mean /= angles;
  for (const Sample& s : samples) {
    sum += s.weight * s.value * (s.distance / mean - 1);
    squares += s.weight * s.value * s.value;
  }
  return sum / squares;
}

/// Returns the largest z-coordinate of the interface at a point (x, y); null if there is none.
Json height(const Complex& complex, const std::array<double, 2>& place) {
  static constexpr double rounding = 1e-9;
  Json result;
  for (const auto& f : complex.interface_facets()) {
    const auto v = complex.facet_vertices(f);
    const auto p = complex.position(v[0]), q = complex.position(v[1]), r = complex.position(v[2]);
    const auto twice_area = [](double ax, double ay, double bx, double by) {
      return ax * by - ay * bx;
    };
    const double whole = twice_area(q.x() - p.x(), q.y() - p.y(), r.x() - p.x(), r.y() - p.y());
    if (whole == 0)
      continue;
    const double x = place[0] - p.x(), y = place[1] - p.y(),
                 b = twice_area(x, y, r.x() - p.x(), r.y() - p.y()) / whole,
                 c = twice_area(q.x() - p.x(), q.y() - p.y(), x, y) / whole;
    if (b < -rounding || c < -rounding || b + c > 1 + rounding)
      continue;
    const double z = p.z() + b * (q.z() - p.z()) + c * (r.z() - p.z());
    if (result.is_null() || z > result.get<double>())
      result = z;
  }
  return result;
}

Json probes_json(const Fluid_scene& scene, const Complex& complex) {
  Json result = Json::object();
  for (const Scene_probe& probe : scene.probes)
    result[probe.name] = probe.mode ? Json(amplitude(complex, *probe.mode, probe.center))
                                    : height(complex, *probe.place);
  return result;
}

Json components_json(const Fluid& fluid) {
  Json result = Json::array();
  struct Component
  {
    int label = 0;
    double volume = 0;
    Extent extent;
  };
  std::map<std::uint32_t, Component> present;
  for (const auto c : fluid.complex().cells()) {
    Component& component = present[c->component()];
    component.label = c->label();
    component.volume += fluid.complex().measure(c);
    for (int i = 0; i < 4; ++i)
      component.extent.add(fluid.complex().position(c->vertex(i)));
  }
  for (const auto& [number, volume] : fluid.volumes()) {
    const Component& component = present[number];
    result.push_back({{"label", component.label},
                      {"volume", component.volume},
                      {"wanted_volume", volume},
                      {"extent", component.extent.json()}});
  }
  return result;
}

Json gases_json(const Fluid& fluid) {
  Json result = Json::array();
  for (const auto& gas : fluid.gases())
    result.push_back({{"label", gas.label}, {"volume", gas.volume}, {"pressure", gas.pressure}});
  return result;
}

const char* name_of(CGAL::Deformable_simplicial_complexes::Fluid_failure cause) {
  using Failure = CGAL::Deformable_simplicial_complexes::Fluid_failure;
  switch (cause) {
  case Failure::equations:
    return "equations";
  case Failure::motion:
    return "motion";
  case Failure::mesh:
    break;
  }
  return "mesh";
}

/// Returns the rejected attempts of a step.
Json repetitions_json(const Fluid::Report& report) {
  Json result = Json::array();
  for (const auto& repetition : report.repetitions)
    result.push_back({{"cause", name_of(repetition.cause)},
                      {"time", repetition.time},
                      {"dt", repetition.dt},
                      {"amount", repetition.amount},
                      {"where", vector_json(repetition.place)}});
  return result;
}

} // namespace

Json step_json(const Fluid& fluid, const Fluid_scene& scene, unsigned step,
               const std::optional<Fluid::Report>& report) {
  const Complex& complex = fluid.complex();
  Json json = {{"step", step}, {"time", fluid.time()}};
  json.update(balance_json(report ? report->after : fluid.balance()));
  json["parts"] = components_json(fluid);
  json["gases"] = gases_json(fluid);
  json["extent"] = extent_json(complex);
  json["probes"] = probes_json(scene, complex);
  json["vertices"] = complex.number_of_vertices();
  json["tetrahedra"] = complex.number_of_cells();
  json["interface_triangles"] = complex.interface_facets().size();
  if (!report)
    return json;
  Json forces = Json::array();
  for (const auto& force : report->forces_on_solids)
    forces.push_back(vector_json(force));
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
               {"events", events_json(*report)},
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
               {"repetitions", repetitions_json(*report)},
               {"seconds_of_solver", report->seconds_of_solver},
               {"seconds_of_mesh", report->seconds_of_mesh}});
  return json;
}

void Repetitions::add(const Fluid::Report& report) {
  m_steps += !report.repetitions.empty();
  for (const auto& repetition : report.repetitions)
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
