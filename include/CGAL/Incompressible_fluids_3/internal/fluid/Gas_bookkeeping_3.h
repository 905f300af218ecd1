// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Incompressible_fluids_3, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_3_H

#include <CGAL/Incompressible_fluids_3/Fluid_properties_3.h>
#include <CGAL/Incompressible_fluids_3/internal/fluid/Liquid_bookkeeping_3.h>
#include <CGAL/Incompressible_fluids_3/internal/steps/Gas_components_3.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The bookkeeping of the connected components of gases, by the number of the component.
class Gas_bookkeeping_3
{
public:
  using Part = Liquid_bookkeeping_3::Part;
  using Bodies = std::map<Part, Gas_body_3>;

  const Bodies& bodies() const { return m_bodies; }
  void set_bodies(const Bodies& bodies) { m_bodies = bodies; }

  // Returns the gases of a mesh with their initial pressures.
  template <class Mesh>
  static Bodies measure(const Mesh& mesh, const Fluid_properties_3& properties) {
    Bodies result;
    for (const auto& part : mesh.gases) {
      const Gas gas = *properties.gas(part.label);
      result[part.component] = {gas, part.volume, gas.pressure, part.volume};
    }
    return result;
  }

  // Returns the gases in the order of a mesh, with the volumes of the mesh.
  // \pre The mesh has the components of the bookkeeping.
  template <class Mesh> std::vector<Gas_body_3> bodies_of(const Mesh& mesh) const {
    std::vector<Gas_body_3> result;
    for (const auto& part : mesh.gases) {
      result.push_back(m_bodies.at(part.component));
      result.back().volume = part.volume;
    }
    return result;
  }

  // Replaces the components after changes of the mesh. `now` contains the present components, as
  // `measure()` returns them. Components that merged have the mean of their pressures, weighted by
  // volumes, which preserves energy. Components that split have the same pressure.
  void follow(const Liquid_bookkeeping_3::Lineage& lineage, Bodies now) {
    const std::size_t size = Liquid_bookkeeping_3::size_of(m_bodies, now, lineage);
    Number_groups groups(2 * size); // of previous and present components
    for (const auto& [before, after] : lineage)
      groups.join(before, size + after);

    struct Group
    {
      unsigned parts = 0, parts_now = 0;
      double energy = 0, volume = 0, volume_now = 0; // energy: pressure times volume
      std::array<double, 2> reference = {};          // pressure and volume
    };
    std::map<std::size_t, Group> owned;
    for (const auto& [part, body] : m_bodies) {
      Group& group = owned[groups.of(part)];
      ++group.parts;
      group.reference = {body.reference_pressure, body.reference_volume};
      group.energy += body.pressure() * body.volume;
      group.volume += body.volume;
    }
    for (const auto& [part, body] : now) {
      Group& group = owned[groups.of(size + part)];
      ++group.parts_now;
      group.volume_now += body.volume;
    }
    for (auto& [part, body] : now) {
      const Group& group = owned[groups.of(size + part)];
      if (group.parts == 1 && group.parts_now == 1) {
        body.reference_pressure = group.reference[0];
        body.reference_volume = group.reference[1];
      } else if (group.parts > 0) {
        body.reference_pressure = group.energy / group.volume;
        body.reference_volume = body.volume * (group.volume / group.volume_now);
      }
    }
    m_bodies.swap(now);
  }

private:
  Bodies m_bodies;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_GAS_BOOKKEEPING_3_H
