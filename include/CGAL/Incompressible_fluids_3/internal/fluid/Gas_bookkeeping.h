// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_H

#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Liquid_bookkeeping.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Gas_components.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The bookkeeping of the connected components of gases, by the number of the component.
class Gas_bookkeeping
{
public:
  using Number = Liquid_bookkeeping::Number;
  using Components = std::map<Number, Gas_component>;

  const Components& components() const { return m_components; }
  void set_components(const Components& components) { m_components = components; }

  // Returns the gases of a mesh with their initial pressures.
  template <class Mesh>
  static Components measure(const Mesh& mesh, const Fluid_properties& properties) {
    Components result;
    for (const auto& component : mesh.gases) {
      const Gas gas = *properties.gas(component.label);
      result[component.component] = {gas, component.volume, gas.pressure, component.volume};
    }
    return result;
  }

  // Returns the gases in the order of a mesh, with the volumes of the mesh.
  // \pre The mesh has the components of the bookkeeping.
  template <class Mesh> std::vector<Gas_component> components_of(const Mesh& mesh) const {
    std::vector<Gas_component> result;
    for (const auto& component : mesh.gases) {
      result.push_back(m_components.at(component.component));
      result.back().volume = component.volume;
    }
    return result;
  }

  // Replaces the components after changes of the mesh. `now` contains the present components, as
  // `measure()` returns them. Components that merged have the mean of their pressures, weighted by
  // volumes, which preserves energy. Components that split have the same pressure.
  void update(const Liquid_bookkeeping::Lineage& lineage, Components now) {
    const std::size_t size = Liquid_bookkeeping::size_of(m_components, now, lineage);
    Disjoint_sets groups(2 * size); // of previous and present components
    for (const auto& [before, after] : lineage)
      groups.join(before, size + after);

    struct Group
    {
      unsigned components = 0, components_now = 0;
      double energy = 0, volume = 0, volume_now = 0; // energy: pressure times volume
      std::array<double, 2> reference = {};          // pressure and volume
    };
    std::map<std::size_t, Group> owned;
    for (const auto& [number, component] : m_components) {
      Group& group = owned[groups.find(number)];
      ++group.components;
      group.reference = {component.reference_pressure, component.reference_volume};
      group.energy += component.pressure() * component.volume;
      group.volume += component.volume;
    }
    for (const auto& [number, component] : now) {
      Group& group = owned[groups.find(size + number)];
      ++group.components_now;
      group.volume_now += component.volume;
    }
    for (auto& [number, component] : now) {
      const Group& group = owned[groups.find(size + number)];
      if (group.components == 1 && group.components_now == 1) {
        component.reference_pressure = group.reference[0];
        component.reference_volume = group.reference[1];
      } else if (group.components > 0) {
        component.reference_pressure = group.energy / group.volume;
        component.reference_volume = component.volume * (group.volume / group.volume_now);
      }
    }
    m_components.swap(now);
  }

private:
  Components m_components;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_H
