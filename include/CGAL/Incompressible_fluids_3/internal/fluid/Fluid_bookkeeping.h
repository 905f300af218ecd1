// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_BOOKKEEPING_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_BOOKKEEPING_H

#include <CGAL/Incompressible_fluids_3/Fluid_properties.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Component_momenta.h>
#include <CGAL/Incompressible_fluids_3/internal/mesh/Gas_components.h>
#include <CGAL/Mesh_support/internal/sets/Disjoint_sets.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The bookkeeping of the connected components of liquids, by the number of the component. It
// contains the volumes to be preserved and the momenta. When components merge, their volumes are
// added. When a component splits, its volume is distributed. A momentum belongs to a set of
// components: those that merged or split in a step, or that touch each other.
class Liquid_bookkeeping
{
public:
  using Number = std::uint32_t;
  using Volumes = std::map<Number, double>;
  using Lineage = std::vector<std::pair<Number, Number>>; // pairs of previous and present
                                                          // components with common cells

  // Returns the volumes of the connected components of a mesh.
  template <class Mesh> static Volumes measure(const Mesh& mesh, const Vectors_3& positions) {
    Volumes result;
    auto last = result.end(); // most cells have the component of the previous cell
    for (const auto& cell : mesh.cells) {
      if (last == result.end() || last->first != cell.component)
        last = result.emplace(cell.component, 0.).first;
      last->second += volume(mesh.corners_at(cell.vertices, positions));
    }
    return result;
  }

  const Volumes& volumes() const { return m_volumes; }
  void set_volumes(const Volumes& volumes) { m_volumes = volumes; }

  // Returns the greatest error of a volume, relative to the volume to be preserved.
  double error(const Volumes& present) const {
    double result = 0;
    for (const auto& [component, volume] : m_volumes)
      result = (std::max)(result, std::abs(present.at(component) - volume) / volume);
    return result;
  }

  // Sets the momenta of all sets, and the set of each component by its number.
  void set_momenta(std::vector<Momentum> momenta,
                   const std::vector<std::size_t>& set_of_component) {
    m_set_of_component.clear();
    for (const auto& [component, volume] : m_volumes)
      m_set_of_component[component] = set_of_component[component];
    m_momenta = std::move(momenta);
  }
  const std::vector<Momentum>& momenta() const { return m_momenta; } // by set
  std::size_t set_of(Number component) const { return m_set_of_component.at(component); }

  // Replaces the components after changes of the mesh. `present` contains the measured volumes of
  // the present components. The volumes to be preserved and the momenta are transferred by the
  // lineage. Returns the volume of components that vanished.
  double update(const Lineage& lineage, const Volumes& present) {
    // Groups unite previous and present components. Sets also unite the previous sets of momenta.
    const std::size_t size = size_of(m_volumes, present, lineage);
    Disjoint_sets groups(2 * size), sets(2 * size + m_momenta.size());
    for (const auto& [then, now] : lineage) {
      groups.join(then, size + now);
      sets.join(then, size + now);
    }
    for (const auto& [component, set] : m_set_of_component)
      sets.join(component, 2 * size + set);

    std::vector<double> owned(2 * size, 0), found(2 * size, 0);
    for (const auto& [component, volume] : m_volumes)
      owned[groups.find(component)] += volume;
    for (const auto& [component, volume] : present)
      found[groups.find(size + component)] += volume;
    double lost = 0;
    for (const auto& [component, volume] : m_volumes)
      lost += found[groups.find(component)] > 0 ? 0 : volume;
    std::vector<Momentum> momenta(sets.size());
    for (std::size_t set = 0; set < m_momenta.size(); ++set) {
      Momentum& sum = momenta[sets.find(2 * size + set)];
      sum.linear += m_momenta[set].linear;
      sum.angular += m_momenta[set].angular;
    }
    m_volumes.clear();
    m_set_of_component.clear();
    for (const auto& [component, volume] : present) {
      const std::size_t group = groups.find(size + component);
      m_volumes[component] = owned[group] > 0 ? volume / found[group] * owned[group] : volume;
      m_set_of_component[component] = sets.find(size + component);
    }
    m_momenta.swap(momenta);
    return lost;
  }

  // Returns a number greater than the numbers of all previous and present components.
  template <class By_component>
  static std::size_t size_of(const By_component& then, const By_component& now,
                             const Lineage& lineage) {
    Number result = 0;
    for (const By_component* components : {&then, &now})
      if (!components->empty())
        result = (std::max)(result, components->rbegin()->first);
    for (const auto& [a, b] : lineage)
      result = (std::max)({result, a, b});
    return std::size_t(result) + 1;
  }

private:
  Volumes m_volumes;
  std::map<Number, std::size_t> m_set_of_component;
  std::vector<Momentum> m_momenta;
};

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

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_INTERNAL_FLUID_FLUID_BOOKKEEPING_H
