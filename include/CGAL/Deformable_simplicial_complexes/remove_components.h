// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REMOVE_COMPONENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REMOVE_COMPONENTS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Removes connected components as a whole: all cells of a component get the label of one of its
neighbors. It is the neighbor for which the energy is least afterwards. A component that is alone in
the domain stays. Components are removed one after another, so a component takes the labels that the
ones before it have given to its neighbors. The mesh does not change. Linear in the number of cells.

\param complex the complex
\param selects `selects(label, number, measure)` returns whether a component is removed: its label,
       its number as in `Complex::component()`, and its volume, in the plane its area
\param energy the energy. The default is the measure of the interface
\param visitor visitor of the changes, such as a `Visitor_adaptor`; none if null
\return the labels of the components that were removed, in the order of the numbers of components
\throws Error if a tension or a density is out of its range; some components may have been removed
*/
template <class Complex, class Selects>
std::vector<typename Complex::Label> remove_components(Complex& complex, const Selects& selects,
                                                       const Interface_energy& energy = {},
                                                       Any_visitor<Complex>* visitor = nullptr) {
  using Label = typename Complex::Label;
  using Cell_handle = typename Complex::Cell_handle;
  complex.update_components();
  std::map<std::uint32_t, std::pair<double, std::vector<Cell_handle>>> components;
  for (Cell_handle c : complex.cells()) {
    auto& [measure, cells] = components[complex.component(c)];
    measure += complex.measure(c);
    cells.push_back(c);
  }
  std::vector<Label> result;
  for (const auto& [number, component] : components) {
    const auto& [measure, cells] = component;
    const Label before = cells.front()->label();
    if (!selects(before, number, measure))
      continue;
    std::map<Label, double> areas; // of the interfaces to the neighbors
    for (Cell_handle c : cells)
      for (int i = 0; i < Complex::corners; ++i)
        if (const std::pair<Cell_handle, int> facet(c, i); complex.is_interface(facet))
          areas[c->neighbor(i)->label()] += complex.measure(facet);
    double least = std::numeric_limits<double>::infinity();
    Label after = before;
    for (const auto& candidate : areas) {
      double sum = energy.density(candidate.first) * measure;
      for (const auto& [label, area] : areas)
        sum += label == candidate.first ? 0 : energy.tension(label, candidate.first) * area;
      if (sum < least) {
        least = sum;
        after = candidate.first;
      }
    }
    if (after == before)
      continue;
    for (Cell_handle c : cells)
      complex.relabel(c, after);
    for (Cell_handle c : cells)
      if (visitor)
        visitor->after_relabel(c, before);
    result.push_back(before);
  }
  return result;
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Removes all components of a label except the largest one, for each label, see `remove_components()`.
Linear in the number of cells.
*/
template <class Complex>
std::vector<typename Complex::Label>
keep_largest_components(Complex& complex, const Interface_energy& energy = {},
                        Any_visitor<Complex>* visitor = nullptr) {
  using Label = typename Complex::Label;
  complex.update_components();
  std::map<std::uint32_t, std::pair<Label, double>> components;
  for (auto c : complex.cells()) {
    auto& component = components[complex.component(c)];
    component.first = c->label();
    component.second += complex.measure(c);
  }
  std::map<Label, std::pair<double, std::uint32_t>> largest;
  for (const auto& [number, component] : components) {
    auto& of_label = largest.try_emplace(component.first, component.second, number).first->second;
    if (component.second > of_label.first)
      of_label = {component.second, number};
  }
  return remove_components(
      complex,
      [&](Label label, std::uint32_t number, double) { return largest.at(label).second != number; },
      energy, visitor);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REMOVE_COMPONENTS_H
