// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_FIELD_IMPL_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_FIELD_IMPL_H

// Member functions of Incompressible_fluid that change the field that liquids carry. The class
// includes this file.
#include <CGAL/Incompressible_fluids_3/Incompressible_fluid.h>

namespace CGAL::Deformable_simplicial_complexes {

// Sets the field at vertices of the boundary to the values that are given there at the present
// time. The field is given by first occurrence of vertices. Returns which values are given.
// \throws Error if a given value is not finite
template <class Complex, class Solver>
template <class Selects>
std::vector<char>
Incompressible_fluid<Complex, Solver>::give_field(const Mesh& mesh, const Vectors& positions,
                                                  const Selects& selects,
                                                  std::vector<double>& field) const {
  const std::size_t n = mesh.number_of_vertices();
  std::vector<char> is_boundary(n, false), is_given(n, false);
  for (std::size_t v = 0; v < n; ++v)
    is_boundary[v] = mesh.vertices[v]->boundary_class() != 0;
  for (const auto& facet : mesh.facets)
    for (auto v : facet.vertices)
      is_boundary[mesh.first(v)] = is_boundary[mesh.first(v)] || facet.is_free;
  for (std::size_t v = 0; v < n && m_fixed_field; ++v)
    if (const auto value =
            is_boundary[v] && selects(v) ? m_fixed_field(positions[v], m_time) : std::nullopt) {
      if (!std::isfinite(*value))
        throw Error("a given value of the field is not finite: give finite values");
      field[v] = *value;
      is_given[v] = true;
    }
  return is_given;
}

// Carries the field to the destinations of vertices. Where liquid enters, it has the given values.
// Other vertices get given values after the motion, because facets keep their tensions in the
// motion.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::carry_field(const Flow& flow, const Step& step) {
  std::vector<double> field = step.carried(flow.field);
  give_field(
      flow.mesh, step.destinations(), [&step](std::size_t v) { return step.is_passage(v); }, field);
  m_motion.set_field(flow.mesh, field);
}

// Lets the field diffuse for a time dt, after it takes the given values on the boundary. Updates
// the surface tensions of the flow, and the report.
template <class Complex, class Solver>
void Incompressible_fluid<Complex, Solver>::diffuse_field(Flow& flow, double dt, Report& report) {
  Mesh& mesh = flow.mesh;
  std::vector<double> field(flow.field.begin(),
                            flow.field.begin() + std::ptrdiff_t(mesh.number_of_vertices()));
  const std::vector<char> is_given = give_field(
      mesh, flow.positions, [](std::size_t) { return true; }, field);
  internal::Field_diffusion<Complex>(mesh, flow.positions, dt).diffuse(field, is_given);
  m_motion.set_field(mesh, field);
  for (std::size_t v = 0; v < flow.field.size(); ++v)
    flow.field[v] = field[mesh.first(typename Mesh::Index(v))];
  internal::set_tensions(mesh, m_properties, flow.field);
  const double before = report.after.surface_energy;
  report.after = flow.balance(*this, flow.positions, flow.velocities, m_time);
  report.work_of_tensions += report.after.surface_energy - before;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_INCOMPRESSIBLE_FLUID_FIELD_IMPL_H
