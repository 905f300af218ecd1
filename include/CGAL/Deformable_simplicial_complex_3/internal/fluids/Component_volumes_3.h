// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_COMPONENT_VOLUMES_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_COMPONENT_VOLUMES_3_H

#include <CGAL/Deformable_simplicial_complex_3/Fluid_properties_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

using Component_lineage = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// The connected parts of now that have to do with each other through those of then: a merge or a
// split and all that takes part is one group.
class Component_groups_3
{
public:
  explicit Component_groups_3(const Component_lineage& lineage) {
    for (const auto& [then, now] : lineage) {
      const std::size_t a = group(m_then, then), b = group(m_now, now);
      const std::size_t kept = (std::min)(a, b), gone = (std::max)(a, b);
      for (auto* groups : {&m_then, &m_now})
        for (auto& [component, group] : *groups)
          group = group == gone ? kept : group;
    }
  }

  // Of components then and now; none: that of no other.
  std::optional<std::size_t> then(std::uint32_t component) const { return find(m_then, component); }
  std::optional<std::size_t> now(std::uint32_t component) const { return find(m_now, component); }
  std::size_t size() const { return m_size; }

private:
  using Groups = std::map<std::uint32_t, std::size_t>;

  std::size_t group(Groups& groups, std::uint32_t component) {
    const auto [place, is_new] = groups.try_emplace(component, m_size);
    m_size += is_new;
    return place->second;
  }
  static std::optional<std::size_t> find(const Groups& groups, std::uint32_t component) {
    const auto found = groups.find(component);
    return found == groups.end() ? std::nullopt : std::optional<std::size_t>(found->second);
  }

  Groups m_then, m_now;
  std::size_t m_size = 0; // with groups that have joined others
};

// The volumes that the connected parts of liquids are to have: parts that merge add theirs, what a
// part falls into shares it.
class Component_volumes_3
{
public:
  using Volumes = std::map<std::uint32_t, double>; // by number of the component

  // Of liquids as they are. \pre components are up to date
  template <class Complex>
  static Volumes measure(const Complex& complex, const Fluid_properties_3& properties) {
    Volumes result;
    for (auto c : complex.cells())
      if (properties.liquid(c->label()))
        result[c->component()] += complex.measure(c);
    return result;
  }

  const Volumes& wanted() const { return m_wanted; }
  void set_wanted(const Volumes& volumes) { m_wanted = volumes; }

  // Those that there are now. Returns what is gone with parts that vanished.
  double follow(const Component_groups_3& groups, const Volumes& present) {
    std::vector<double> wanted(groups.size(), 0), found(groups.size(), 0);
    double lost = 0;
    for (const auto& [component, volume] : m_wanted)
      if (const auto group = groups.then(component))
        wanted[*group] += volume;
      else
        lost += volume;
    for (const auto& [component, volume] : present)
      if (const auto group = groups.now(component))
        found[*group] += volume;
    Volumes result;
    for (const auto& [component, volume] : present) {
      const auto group = groups.now(component);
      result[component] =
          group && wanted[*group] > 0 ? volume / found[*group] * wanted[*group] : volume;
    }
    m_wanted.swap(result);
    return lost;
  }

private:
  Volumes m_wanted;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_FLUIDS_COMPONENT_VOLUMES_3_H
