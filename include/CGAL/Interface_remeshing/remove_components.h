// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_REMOVE_COMPONENTS_H
#define CGAL_INTERFACE_REMESHING_REMOVE_COMPONENTS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>

#include <map>
#include <set>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes {

namespace internal {

// A connected component: its label, its measure and its cells.
template <class Complex> struct Component_cells
{
  typename Complex::Label label;
  double measure = 0;
  std::vector<typename Complex::Cell_handle> cells = {};
};

// Returns the components of a complex by their numbers.
template <class Complex>
std::map<std::uint32_t, Component_cells<Complex>> components_of(Complex& complex) {
  complex.update_components();
  std::map<std::uint32_t, Component_cells<Complex>> result;
  for (auto c : complex.cells()) {
    auto& component =
        result.try_emplace(complex.component(c), Component_cells<Complex>{c->subdomain_index()})
            .first->second;
    component.measure += complex.measure(c);
    component.cells.push_back(c);
  }
  return result;
}

// Returns the neighbor whose label decreases the energy most if the component gets it; the label of
// the component if it has no neighbor across a mobile interface. Neighbors in cells for which
// `is_left_out(c)` is true count only if there are no others.
template <class Complex, class Is_left_out>
typename Complex::Label
best_neighbor(const Complex& complex, const Component_cells<Complex>& component,
              const Interface_energy& energy, const Is_left_out& is_left_out) {
  using Label = typename Complex::Label;
  std::map<Label, double> areas; // of the interfaces to the neighbors
  std::set<Label> candidates, all;
  for (auto c : component.cells)
    for (int i = 0; i < Complex::corners; ++i)
      if (const std::pair<typename Complex::Cell_handle, int> facet(c, i);
          complex.is_interface(facet)) {
        const auto neighbor = c->neighbor(i);
        areas[neighbor->subdomain_index()] += complex.measure(facet);
        if (energy.mobility(component.label, neighbor->subdomain_index()) > 0)
          (is_left_out(neighbor) ? all : candidates).insert(neighbor->subdomain_index());
      }
  double least = std::numeric_limits<double>::infinity();
  Label result = component.label;
  for (const Label candidate : candidates.empty() ? all : candidates) {
    const double sum =
        energy.density(candidate) * component.measure + energy.of_boundary(candidate, areas);
    if (sum < least) {
      least = sum;
      result = candidate;
    }
  }
  return result;
}

// Returns the number of a component that is still to be removed and touches a component with a
// given label; nothing if a component that stays has this label there.
template <class Complex>
std::optional<std::uint32_t> number_of_neighbor(const Complex& complex,
                                                const Component_cells<Complex>& component,
                                                typename Complex::Label label,
                                                const std::map<std::size_t, std::uint32_t>& left) {
  std::optional<std::uint32_t> result;
  for (auto c : component.cells)
    for (int i = 0; i < Complex::corners; ++i) {
      const auto neighbor = c->neighbor(i);
      if (complex.is_infinite(neighbor) || neighbor->subdomain_index() != label)
        continue;
      const auto found = left.find(neighbor->time_stamp());
      if (found == left.end())
        return std::nullopt;
      result = found->second;
    }
  return result;
}

template <class Complex>
void append(const Component_cells<Complex>& from, Component_cells<Complex>& to) {
  to.measure += from.measure;
  to.cells.insert(to.cells.end(), from.cells.begin(), from.cells.end());
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Removes connected components as a whole: all cells of a component get the label of one of its
neighbors. It is the neighbor for which the energy is least afterwards. Components that are also
removed are chosen only if there is no other neighbor. Labels behind an interface of mobility 0 are
not chosen, because it does not move. A component without other neighbors stays. The mesh does not
change. Linear in the number of cells, times the logarithm of the number of components.

\param complex the complex
\param selects `selects(label, number, measure)` returns whether a component is removed: its label,
       its number as in `Complex::component()`, and its volume, in the plane its area. It is called
       for all components before the first one is removed.
\param energy the energy. The default is the measure of the interface
\param visitor visitor of the changes; none if null
\return the labels of the components that were removed, in the order of the numbers of components
\throws Error if a tension, a mobility or a density is out of its range. After this exception, or
        one of the visitor, some components may have been removed, and the complex is valid.
*/
template <class Complex, class Selects>
std::vector<typename Complex::Label>
remove_components(Complex& complex, const Selects& selects, const Interface_energy& energy = {},
                  Deformation_visitor<Complex>* visitor = nullptr) {
  using Label = typename Complex::Label;
  auto components = internal::components_of(complex);
  std::map<std::size_t, std::uint32_t>
      left; // the components to be removed, by time stamps of cells
  for (auto component = components.begin(); component != components.end();) {
    const auto& [label, measure, cells] = component->second;
    if (!selects(label, component->first, measure)) {
      component = components.erase(component);
      continue;
    }
    for (auto c : cells)
      left.emplace(c->time_stamp(), component->first);
    ++component;
  }
  std::vector<Label> result;
  for (const auto& [number, component] : components) {
    const Label before = component.label,
                after = internal::best_neighbor(complex, component, energy, [&left](auto c) {
                  return left.count(c->time_stamp()) > 0;
                });
    for (auto c : component.cells)
      left.erase(c->time_stamp());
    if (after == before)
      continue;
    // If the neighbor is also removed later, the cells are removed with it.
    if (const auto next = internal::number_of_neighbor(complex, component, after, left)) {
      internal::append(component, components.at(*next));
      for (auto c : component.cells)
        left.emplace(c->time_stamp(), *next);
    }
    for (auto c : component.cells) {
      complex.relabel(c, after);
      if (visitor)
        visitor->after_relabel(c, before);
    }
    result.push_back(before);
  }
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Removes all components of a label except the largest one, see `remove_components()`.

\param complex the complex
\param energy, visitor as above
\param selects `selects(label)` returns whether the components of a label are removed; by default,
       this holds for all labels
\return the labels of the components that were removed
\throws Error as above
*/
template <class Complex, class Selects>
std::vector<typename Complex::Label>
keep_largest_components(Complex& complex, const Interface_energy& energy,
                        std::common_type_t<Deformation_visitor<Complex>*> visitor,
                        const Selects& selects) {
  using Label = typename Complex::Label;
  std::map<Label, std::pair<double, std::uint32_t>> largest;
  for (const auto& [number, component] : internal::components_of(complex)) {
    auto& of_label = largest.try_emplace(component.label, component.measure, number).first->second;
    if (component.measure > of_label.first)
      of_label = {component.measure, number};
  }
  return remove_components(
      complex,
      [&](Label label, std::uint32_t number, double) {
        return largest.at(label).second != number && selects(label);
      },
      energy, visitor);
}

/// \ingroup PkgInterfaceRemeshingRef
/// The same for all labels.
template <class Complex>
std::vector<typename Complex::Label>
keep_largest_components(Complex& complex, const Interface_energy& energy = {},
                        Deformation_visitor<Complex>* visitor = nullptr) {
  return keep_largest_components(complex, energy, visitor,
                                 [](typename Complex::Label) { return true; });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_REMOVE_COMPONENTS_H
