// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_fields.h"

namespace dsc {
namespace {

using DSC::Mesh_array;
using DSC::Mesh_arrays;

Mesh_array array_of_numbers(const std::string& name) { return {name, "Float64", 1, {}}; }
Mesh_array array_of_vectors(const std::string& name) { return {name, "Float64", 3, {}}; }

void append(Mesh_array& array, double number) { array.values.push_back(number); }
void append(Mesh_array& array, const std::array<double, 3>& vector) {
  array.values.insert(array.values.end(), vector.begin(), vector.end());
}

/// Returns the field that liquids carry, at some vertices. It is 0 outside of liquids.
template <class Complex, class Vertices>
Mesh_array field_array(const Fluid<Complex>& fluid, const Vertices& vertices) {
  Mesh_array result = array_of_numbers("field");
  for (const auto v : vertices)
    append(result, fluid.field(v));
  return result;
}

} // namespace

template <class Complex> Mesh_arrays cell_arrays(const Fluid<Complex>& fluid) {
  const Complex& complex = fluid.complex();
  const Fluid_fields<Complex> fields(fluid);
  Mesh_array velocity = array_of_vectors("velocity"), pressure = array_of_numbers("pressure");
  for (const auto v : complex.vertices()) {
    append(velocity, coordinates_of(fluid.velocity(v)));
    append(pressure, fluid.pressure(v));
  }
  Mesh_arrays result;
  result.points = {velocity, pressure};
  if (fluid.has_field())
    result.points.push_back(field_array(fluid, complex.vertices()));

  Mesh_array component{"component", "UInt32", 1, {}};
  velocity = array_of_vectors("velocity");
  pressure = array_of_numbers("pressure");
  Mesh_array vorticity =
      Complex::dimension == 2 ? array_of_numbers("vorticity") : array_of_vectors("vorticity");
  for (const auto c : complex.cells()) {
    const auto vertices = fields.vertices_of(c);
    append(component, complex.component(c));
    append(velocity, fields.mean_velocity(vertices, c));
    append(pressure, fields.mean_pressure(vertices, c));
    if constexpr (Complex::dimension == 2)
      append(vorticity, fluid.vorticity(c));
    else
      append(vorticity, coordinates_of(fluid.vorticity(c)));
  }
  result.cells = {component, velocity, pressure, vorticity};
  return result;
}

template <class Complex> Mesh_arrays interface_arrays(const Fluid<Complex>& fluid) {
  const Complex& complex = fluid.complex();
  const Fluid_fields<Complex> fields(fluid);
  Mesh_arrays result;
  result.points = {array_of_vectors("velocity")};
  for (const auto v : complex.interface_vertices())
    append(result.points[0], coordinates_of(fluid.velocity(v)));
  if (fluid.has_field())
    result.points.push_back(field_array(fluid, complex.interface_vertices()));
  Mesh_array back_velocity = array_of_vectors("velocity_back"),
             front_velocity = array_of_vectors("velocity_front"),
             back_pressure = array_of_numbers("pressure_back"),
             front_pressure = array_of_numbers("pressure_front");
  for (const auto& f : complex.interface_facets()) {
    const auto vertices = complex.facet_vertices(f);
    const auto back = f.first, front = back->neighbor(f.second);
    append(back_velocity, fields.mean_velocity(vertices, back));
    append(front_velocity, fields.mean_velocity(vertices, front));
    append(back_pressure, fields.mean_pressure(vertices, back));
    append(front_pressure, fields.mean_pressure(vertices, front));
  }
  result.cells = {back_velocity, front_velocity, back_pressure, front_pressure};
  return result;
}

template Mesh_arrays cell_arrays(const Fluid<Tracked_complex_2::Complex>&);
template Mesh_arrays cell_arrays(const Fluid<Tracked_complex_3::Complex>&);
template Mesh_arrays interface_arrays(const Fluid<Tracked_complex_2::Complex>&);
template Mesh_arrays interface_arrays(const Fluid<Tracked_complex_3::Complex>&);

} // namespace dsc
