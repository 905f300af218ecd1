// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_REMOVE_FRAGMENTS_H
#define DSC_REMOVE_FRAGMENTS_H

#include "input/label_components.h"

#include <algorithm>
#include <cstdint>
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
                                     const Component_cells<Complex>& fragment) {
  std::map<typename Complex::Label, std::size_t> facets;
  for (const auto c : fragment.cells)
    for (int i = 0; i < Complex::corners; ++i)
      if (const auto n = c->neighbor(i);
          !complex.triangulation().is_infinite(n) && n->subdomain_index() != c->subdomain_index())
        ++facets[n->subdomain_index()];
  const auto most =
      std::max_element(facets.begin(), facets.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == facets.end() ? fragment.cells.front()->subdomain_index() : most->first;
}

} // namespace internal

/// Relabels fragments with the label around them. Fragments are the smallest components of a label
/// in excess of the expected number, if their total volume is a small fraction of the volume of the
/// label. They arise from cells at sharp edges, because cells are labeled by their barycenters
/// only.
/// \return the number of fragments
template <class Complex>
std::size_t remove_fragments(Complex& complex, const Component_ranges& expected) {
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
    of_label[component.second.cells.front()->subdomain_index()].push_back(&component.second);
  std::vector<std::pair<const Cells*, typename Complex::Label>> fragments;
  for (auto& [label, found] : of_label) {
    const auto range = expected.find(label);
    if (range == expected.end() || found.size() <= range->second.most)
      continue;
    std::stable_sort(found.begin(), found.end(),
                     [](const Cells* a, const Cells* b) { return a->volume > b->volume; });
    double volume = 0, volume_of_fragments = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      volume += found[i]->volume;
      volume_of_fragments += i < range->second.most ? 0 : found[i]->volume;
    }
    if (volume_of_fragments <= small * volume)
      for (std::size_t i = range->second.most; i < found.size(); ++i)
        fragments.emplace_back(found[i], internal::label_around(complex, *found[i]));
  }
  for (const auto& [fragment, label] : fragments)
    for (const auto c : fragment->cells)
      complex.relabel(c, label);
  if (!fragments.empty()) {
    complex.measure_interface_edges();
    complex.take_component_events();
  }
  return fragments.size();
}

} // namespace dsc

#endif // DSC_REMOVE_FRAGMENTS_H
