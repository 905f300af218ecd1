// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_MESH_IMPL_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_MESH_IMPL_H

// Member functions of Incompressible_fluid that change the mesh, and that update the bookkeeping of
// components. The class includes this file.
#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

namespace CGAL::Deformable_simplicial_complexes {

// Adapts the mesh before a step. The interface and the edges inside liquids are remeshed, except if
// the treatment is `improved`. Cells are improved before the first step and before repeated
// attempts, and triangles of viscous liquids always.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::adapt(const Options& chosen,
                                                  internal::Mesh_treatment treatment,
                                                  Report& report) {
  static constexpr double quality = .3; // of new meshes
  // In the plane, flips undo the shear by viscous flows at each adaptation: viscous forces in
  // sheared triangles are less accurate.
  static constexpr double quality_of_viscous = .6;
  const auto& liquids = m_properties.liquids();
  const bool undoes_shear =
      Complex::dimension == 2 && std::any_of(liquids.begin(), liquids.end(), [](const auto& entry) {
        return entry.second.is_viscous();
      });
  if (!Mesh::is_periodic && m_complex.interface_vertices().empty())
    return;
  require_interface_edge(m_complex);
  const Flow flow(*this, m_properties);
  const Contacts contacts = flow.contacts(*this);
  m_motion.set_wetting(flow.mesh, [&contacts](std::size_t v) { return contacts.touches(v); });
  record_momenta(flow, [&](const internal::Masses& masses) {
    return internal::momentum(flow.mesh, masses, flow.positions, flow.velocities);
  });
  using Treatment = internal::Mesh_treatment;
  Improvement_report& result = report.adaptation;
  change_mesh([&](Deformation_visitor<Complex>* visitor) {
    if (treatment != Treatment::improved)
      result = result + adapt_lengths(chosen.interface_tolerance, visitor);
    Mesh_improvement_options<Complex> improvement;
    improvement.quality_threshold = undoes_shear ? quality_of_viscous : quality;
    improvement.visitor = visitor;
    if (undoes_shear || m_steps == 0 || treatment != Treatment::chosen)
      result = result + improve_mesh(m_complex, improvement);
  });
  restore_components(chosen, report);
}

// Remeshes the interface if too many of its edges are too long or too short. Splits and collapses
// edges inside liquids. Before the first step, edges inside liquids are split until they are about
// as long as those of the interface. Later, only edges that the flow has stretched or compressed a
// lot are changed.
template <class Complex, class Solver>
Improvement_report
Incompressible_fluid<Complex, Solver>::adapt_lengths(double tolerance,
                                                     Deformation_visitor<Complex>* visitor) {
  // In mean edge lengths of the initial interface. An edge that is split later has halves that are
  // longer than the bound for collapses.
  static constexpr double longest_of_new = 1.7, longest = 2.5, shortest = .3;
  using Defaults = defaults::Adaptive_advection<Complex::dimension>;
  Adaptation_options adaptation{tolerance, Defaults::feature_angle};
  const Improvement_report result = keep_interface_fit(
      m_complex, adaptation, [](const auto&) { return true; }, visitor);
  const bool is_new = m_steps == 0;
  Detail_options<Complex> detail;
  detail.sizing_field = [edge = mean_edge()](const auto&) { return edge; };
  detail.where = [this](typename Complex::Cell_handle c) {
    return m_properties.liquid(c->subdomain_index()) != nullptr;
  };
  detail.split_length = is_new ? longest_of_new : longest;
  detail.collapse_length = is_new ? 0. : shortest;
  detail.visitor = visitor;
  return result + control_detail(m_complex, detail);
}

// Restores the volumes and momenta of connected components after changes of the mesh. Returns the
// present flow.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::restore_components(const Options& chosen,
                                                               Report& report) -> Flow {
  Flow result(*this, m_properties);
  report.lost_volume += update_components(result.mesh, result.volumes());
  restore_volumes(result, chosen, report);
  m_motion.set_wetting(result.mesh, [](std::size_t) { return false; });
  report.greatest_correction = (std::max)(report.greatest_correction, restore_momenta(result));
  return result;
}

// Moves the vertices of liquids to destinations, corrected such that the volumes of connected
// components are preserved. Vertices inside liquids follow the flow.
template <class Complex, class Solver>
Deformation_report<Complex>
Incompressible_fluid<Complex, Solver>::move(const Flow& flow, const Contacts& contacts,
                                            const Vectors& destinations, const Options& chosen) {
  const Mesh& mesh = flow.mesh;
  const Liquid_interface interface_(m_complex, m_properties, flow.volumes());
  const Vertex_numbers number(
      m_complex,
      {mesh.vertices.begin(), mesh.vertices.begin() + std::ptrdiff_t(mesh.number_of_vertices())});
  const auto inflow = inflow_velocities(mesh, m_sides, flow.positions, m_time);
  const auto from = interface_.snapshot().positions(m_complex);
  auto to = from;
  std::vector<char> is_constrained(to.size(), false);
  for (std::size_t k = 0; k < to.size(); ++k)
    if (const std::size_t i = number(interface_.snapshot().vertices[k]); i < mesh.vertices.size()) {
      to[k] = point(destinations[i]);
      is_constrained[k] = contacts.is_constrained(i) || internal::is_inflow(inflow, i);
    }
  m_motion.set_wetting(mesh, [&contacts](std::size_t v) { return contacts.is_constrained(v); });
  interface_.restore(
      m_liquids.volumes(), from, [&](std::size_t v) { return is_constrained[v] != 0; }, to);

  std::unordered_map<std::size_t, Point> inside; // destinations by time stamp
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!mesh.is_on_interface[i])
      inside.emplace(mesh.vertices[i]->time_stamp(), point(destinations[i]));
  Deformation_options<Complex> options = chosen.deformation;
  options.domain_rule = Domain_rule::stop; // at the walls
  options.flow = [&inside](const std::vector<Vertex_handle>& vertices) {
    const Point unknown =
        point(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    std::vector<Point> result;
    for (Vertex_handle v : vertices) {
      const auto found = inside.find(v->time_stamp());
      result.push_back(found != inside.end() ? found->second : unknown);
    }
    return result;
  };
  options.flow_moves_all = true;
  return change_mesh([&](Deformation_visitor<Complex>* visitor) {
    options.visitor = visitor;
    return deform_interface_to(m_complex, interface_.snapshot(), to, options);
  });
}

// Calls a function that changes the mesh, with a visitor that interpolates velocities. If the
// function throws, the bookkeeping of components is updated nevertheless. The update calls no
// function of the user, which could throw again.
template <class Complex, class Solver>
template <class Change>
auto Incompressible_fluid<Complex, Solver>::change_mesh(const Change& change) {
  Carrier visitor = carrier();
  try {
    return change(&visitor);
  } catch (...) {
    const Mesh mesh(updated_complex(), m_properties);
    update_components(mesh, Liquid_bookkeeping::measure(mesh, mesh.positions(m_complex)));
    throw;
  }
}

// Moves the interface until the volumes of connected components are restored, no vertex is in a
// solid, and vertices from walls are on walls. The number of rounds is bounded. The report contains
// the remaining error.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::restore_volumes(Flow& flow, const Options& chosen,
                                                            Report& report) {
  static constexpr double rounding = 1e-14;
  static constexpr int rounds = 3;
  for (int k = 0; k <= rounds; ++k) {
    report.volume_error = m_liquids.error(flow.volumes());
    if (k == 0)
      report.volume_correction = (std::max)(report.volume_correction, report.volume_error);
    if (k == rounds || flow.mesh.facets.empty())
      break;
    const Contacts contacts = flow.contacts(*this);
    if (report.volume_error <= rounding && flow.fits_solids(*this, contacts))
      break;
    flow = move_interface(flow, contacts, coordinates_of_interface(), chosen, report);
  }
}

// Moves the interface to given coordinates, corrected such that no vertex is in a solid and the
// volumes of connected components are preserved. The mesh does not change otherwise if the motion
// permits this. Returns the present flow.
template <class Complex, class Solver>
auto Incompressible_fluid<Complex, Solver>::move_interface(const Flow& flow,
                                                           const Contacts& contacts,
                                                           const Eigen::VectorXd& coordinates,
                                                           const Options& chosen, Report& report)
    -> Flow {
  const Mesh& mesh = flow.mesh;
  Vectors positions = flow.positions;
  std::unordered_map<std::size_t, std::size_t> number; // in the mesh, by time stamp
  for (std::size_t v = 0; v < positions.size(); ++v)
    number.emplace(mesh.vertices[v]->time_stamp(), v);
  const Liquid_interface interface_(m_complex, m_properties, flow.volumes());
  const auto& vertices = interface_.snapshot().vertices;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    if (const auto found = number.find(vertices[k]->time_stamp()); found != number.end())
      positions[found->second] =
          mesh.nearest_image(positions[found->second], coordinates.segment<3>(3 * Eigen::Index(k)));
  const auto inflow = inflow_velocities(mesh, m_sides, flow.positions, m_time);
  std::vector<char> returns(positions.size(), false); // to a wall
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    if (m_motion.is_from_wall(mesh.vertices[v])) {
      const Eigen::Vector3d displacement = contacts.displacement_to_wall(v, m_time);
      positions[v] += displacement;
      returns[v] = !displacement.isZero(0);
    }
  contacts.project_out_of_solids(positions, m_time);

  std::vector<Point> to;
  std::vector<char> is_constrained(vertices.size(), false);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto found = number.find(vertices[k]->time_stamp());
    to.push_back(found != number.end() ? point(positions[found->second])
                                       : m_complex.position(vertices[k]));
    is_constrained[k] =
        found != number.end() && (contacts.touches(found->second) || returns[found->second] ||
                                  internal::is_inflow(inflow, found->second));
  }
  interface_.restore(
      m_liquids.volumes(), interface_.snapshot().positions(m_complex),
      [&](std::size_t v) { return is_constrained[v] != 0; }, to);
  Deformation_options<Complex> options = chosen.deformation;
  options.domain_rule = Domain_rule::stop; // at the walls
  options.preserve_mesh();
  options.flow = nullptr;
  const auto deformation = change_mesh([&](Deformation_visitor<Complex>* visitor) {
    options.visitor = visitor;
    return deform_interface_to(m_complex, interface_.snapshot(), to, options);
  });
  auto& events = report.deformation.events;
  events.insert(events.end(), deformation.events.begin(), deformation.events.end());
  Flow result(*this, m_properties);
  report.lost_volume += update_components(result.mesh, result.volumes());
  return result;
}

// Stores the momenta of connected components. Components that touch have a common momentum.
template <class Complex, class Solver>
template <class MomentumOf>
void Incompressible_fluid<Complex, Solver>::record_momenta(const Flow& flow,
                                                           const MomentumOf& momentum_of) {
  std::size_t size = 0;
  for (const auto& cell : flow.mesh.cells)
    size = (std::max)(size, std::size_t(cell.component) + 1);
  Disjoint_sets touching(size + flow.mesh.vertices.size());
  for (const auto& cell : flow.mesh.cells)
    for (auto v : cell.vertices)
      touching.join(size + flow.mesh.first(v), cell.component);
  std::vector<std::size_t> set_of_component;
  for (std::size_t component = 0; component < size; ++component)
    set_of_component.push_back(touching.find(component));
  std::vector<internal::Momentum> momenta;
  for (const auto& masses :
       internal::masses_of_sets(flow.mesh, flow.positions, size, [&](std::uint32_t component) {
         return set_of_component[component];
       }))
    momenta.push_back(momentum_of(masses));
  m_liquids.set_momenta(std::move(momenta), set_of_component);
}

// Updates the bookkeeping of components after changes of the mesh, to the present mesh and volumes.
// Returns the volume of components that vanished.
template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::update_components(
    const Mesh& mesh, const Liquid_bookkeeping::Volumes& volumes) {
  const auto lineage = m_complex.take_component_lineage();
  m_gases.update(lineage, Gas_bookkeeping::measure(mesh, m_properties));
  return m_liquids.update(lineage, volumes);
}

// Restores the momenta of connected components by rigid motions, on a torus by translations.
// Returns the greatest change of a velocity.
template <class Complex, class Solver>
double Incompressible_fluid<Complex, Solver>::restore_momenta(Flow& flow) {
  // Components that touch now share vertices, so they are corrected together.
  Disjoint_sets sets(m_liquids.momenta().size());
  std::vector<std::size_t> set_of_vertex(flow.positions.size(), sets.size());
  for (const auto& cell : flow.mesh.cells)
    for (auto v : cell.vertices) {
      const std::size_t set = m_liquids.set_of(cell.component);
      std::size_t& of_vertex = set_of_vertex[flow.mesh.first(v)];
      if (of_vertex < sets.size())
        sets.join(set, of_vertex);
      of_vertex = set;
    }
  std::vector<internal::Momentum> target(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    target[sets.find(k)].linear += m_liquids.momenta()[k].linear;
    target[sets.find(k)].angular += m_liquids.momenta()[k].angular;
  }
  const auto masses = internal::masses_of_sets(
      flow.mesh, flow.positions, target.size(),
      [&](std::uint32_t component) { return sets.find(m_liquids.set_of(component)); });
  double result = 0;
  Vectors velocities = flow.velocities;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    internal::Momentum missing =
        internal::momentum(flow.mesh, masses[k], flow.positions, flow.velocities);
    missing.linear = target[k].linear - missing.linear;
    missing.angular = target[k].angular - missing.angular;
    const auto correction = internal::rigid_velocity(flow.mesh, masses[k], flow.positions, missing);
    for (const auto& [v, mass] : masses[k].of_vertices)
      velocities[v] = flow.velocities[v] + correction.at(flow.positions[v]);
  }
  stop_on_sides(flow.mesh, m_sides, inflow_velocities(flow.mesh, m_sides, flow.positions, m_time),
                internal::Open_sides(flow.mesh, m_sides, flow.positions, m_time), velocities);
  for (std::size_t v = 0; v < velocities.size(); ++v)
    result = (std::max)(result, (velocities[v] - flow.velocities[v]).norm());
  m_motion.set(flow.mesh, velocities, flow.accelerations);
  flow.velocities.swap(velocities);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_MESH_IMPL_H
