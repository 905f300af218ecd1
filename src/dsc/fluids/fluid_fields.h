// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FLUID_FIELDS_H
#define DSC_FLUID_FIELDS_H

#include "fluids/fluid_of_dimension.h"

#include <CGAL/Mesh_files/Mesh_arrays.h>

namespace dsc {

/// The velocities and pressures in the cells of a fluid. At a vertex of the interface they depend
/// on the cell, because two liquids have different values there. Vectors have three coordinates,
/// also in the plane. Velocities of gases and all values of the void are 0.
template <class Complex> class Fluid_fields
{
public:
  using Vertex_handle = typename Complex::Vertex_handle;
  using Cell_handle = typename Complex::Cell_handle;

  explicit Fluid_fields(const Fluid<Complex>& fluid) : m_fluid(fluid) {
    for (const auto& gas : fluid.gases())
      m_gas_pressures.emplace(gas.component, gas.pressure);
  }

  const Fluid<Complex>& fluid() const { return m_fluid; }

  bool is_liquid(Cell_handle c) const {
    return m_fluid.properties().liquids().count(c->subdomain_index()) > 0;
  }
  bool is_gas(Cell_handle c) const { return m_gas_pressures.count(component(c)) > 0; }

  /// Returns the velocity at a vertex of a cell.
  std::array<double, 3> velocity(Vertex_handle v, Cell_handle c) const {
    return is_liquid(c) ? coordinates_of(m_fluid.velocity(v, c->subdomain_index()))
                        : std::array<double, 3>();
  }
  /// Returns the pressure at a vertex of a cell. The pressure of a gas is relative to vacuum.
  double pressure(Vertex_handle v, Cell_handle c) const {
    if (is_liquid(c))
      return m_fluid.pressure(v, c->subdomain_index());
    const auto gas = m_gas_pressures.find(component(c));
    return gas == m_gas_pressures.end() ? 0 : gas->second;
  }

  /// Returns the mean velocity at some vertices of a cell.
  template <class Vertices>
  std::array<double, 3> mean_velocity(const Vertices& vertices, Cell_handle c) const {
    std::array<double, 3> result = {};
    for (const Vertex_handle v : vertices) {
      const std::array<double, 3> u = velocity(v, c);
      for (std::size_t axis = 0; axis < 3; ++axis)
        result[axis] += u[axis] / double(vertices.size());
    }
    return result;
  }
  /// Returns the mean pressure at some vertices of a cell.
  template <class Vertices> double mean_pressure(const Vertices& vertices, Cell_handle c) const {
    double result = 0;
    for (const Vertex_handle v : vertices)
      result += pressure(v, c) / double(vertices.size());
    return result;
  }

  static std::array<Vertex_handle, std::size_t(Complex::corners)> vertices_of(Cell_handle c) {
    std::array<Vertex_handle, std::size_t(Complex::corners)> result;
    for (int i = 0; i < Complex::corners; ++i)
      result[std::size_t(i)] = c->vertex(i);
    return result;
  }

private:
  std::uint32_t component(Cell_handle c) const { return m_fluid.complex().component(c); }

  const Fluid<Complex>& m_fluid;
  std::map<std::uint32_t, double> m_gas_pressures; // by component
};

/// Returns the arrays of the cells and of all vertices, for `Output_arrays`.
template <class Complex> DSC::Mesh_arrays cell_arrays(const Fluid<Complex>& fluid);

/// Returns the arrays of the facets and vertices of the interface, for `Output_arrays`. The back of
/// a facet is the side with the larger label.
template <class Complex> DSC::Mesh_arrays interface_arrays(const Fluid<Complex>& fluid);

} // namespace dsc

#endif // DSC_FLUID_FIELDS_H
