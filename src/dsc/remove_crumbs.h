// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_REMOVE_CRUMBS_H
#define DSC_REMOVE_CRUMBS_H

#include "label_components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace dsc {
namespace internal {

template <class Complex> struct Component_cells
{
  double volume = 0;
  std::vector<typename Complex::Cell_handle> cells;
};

/// Returns the label with the largest number of facets around a component; the smallest such label
/// if there are several.
template <class Complex>
typename Complex::Label label_around(const Complex& complex,
                                     const Component_cells<Complex>& crumb) {
  std::map<typename Complex::Label, std::size_t> facets;
  for (const auto c : crumb.cells)
    for (int i = 0; i < Complex::corners; ++i)
      if (const auto n = c->neighbor(i);
          !complex.triangulation().is_infinite(n) && n->label() != c->label())
        ++facets[n->label()];
  const auto most =
      std::max_element(facets.begin(), facets.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == facets.end() ? crumb.cells.front()->label() : most->first;
}

} // namespace internal

/// Relabels crumbs with the label around them. Crumbs are the smallest components of a label in
/// excess of the expected number, if their total volume is a small fraction of the volume of the
/// label. They arise from cells at sharp edges, because cells are labelled by their barycenters
/// only.
/// \return the number of crumbs
template <class Complex>
std::size_t remove_crumbs(Complex& complex, const Component_ranges& expected) {
  static constexpr double small = .01; // relative to the volume of the label
  using Cells = internal::Component_cells<Complex>;
  std::map<std::uint32_t, Cells> components;
  complex.update_components();
  for (const auto c : complex.cells()) {
    Cells& component = components[complex.component(c)];
    component.volume += complex.measure(c);
    component.cells.push_back(c);
  }
  std::map<typename Complex::Label, std::vector<const Cells*>> of_label;
  for (const auto& component : components)
    of_label[component.second.cells.front()->label()].push_back(&component.second);
  std::vector<std::pair<const Cells*, typename Complex::Label>> crumbs;
  for (auto& [label, parts] : of_label) {
    const auto range = expected.find(label);
    if (range == expected.end() || parts.size() <= range->second.most)
      continue;
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Cells* a, const Cells* b) { return a->volume > b->volume; });
    double volume = 0, volume_of_crumbs = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      volume += parts[i]->volume;
      volume_of_crumbs += i < range->second.most ? 0 : parts[i]->volume;
    }
    if (volume_of_crumbs <= small * volume)
      for (std::size_t i = range->second.most; i < parts.size(); ++i)
        crumbs.emplace_back(parts[i], internal::label_around(complex, *parts[i]));
  }
  for (const auto& [crumb, label] : crumbs)
    for (const auto c : crumb->cells)
      complex.relabel(c, label);
  if (!crumbs.empty()) {
    complex.measure_interface_edges();
    complex.take_component_events();
  }
  return crumbs.size();
}

} // namespace dsc

#endif // DSC_REMOVE_CRUMBS_H
