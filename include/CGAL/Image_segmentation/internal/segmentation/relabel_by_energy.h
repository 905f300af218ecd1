// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_RELABEL_BY_ENERGY_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_RELABEL_BY_ENERGY_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/remove_components.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <unordered_map>
#include <unordered_set>

namespace CGAL::Deformable_simplicial_complexes {

// Options of `relabel_by_energy()` and `relabel_components_by_energy()`.
// \tparam Complex a deformable simplicial complex
template <class Complex> struct Relabeling_options
{
  // The labels that cells can get, also where no neighbor has them. If empty, a cell or a
  // component can only get the label of a neighbor.
  std::vector<typename Complex::Label> labels;
  // The energy of the interface. Energy densities count, too.
  Interface_energy interface_energy;
  // Permits or forbids changes of topology. If empty, all are permitted.
  typename Deformation_options<Complex>::Topology_control topology_control;
  // Visitor of the changes; it must outlive the call. None if null.
  Deformation_visitor<Complex>* visitor = nullptr;
};

namespace internal {

// Chooses labels by the energy of cells, which a function gives, and the energy of their
// boundaries.
template <class Complex, class Energy_of_cell> class Label_chooser
{
public:
  using Cell_handle = typename Complex::Cell_handle;
  using Label = typename Complex::Label;

  Label_chooser(Complex& complex, const Energy_of_cell& energy_of_cell,
                const Relabeling_options<Complex>& options)
      : m_complex(complex), m_energy_of_cell(energy_of_cell), m_options(options) {}

  // Returns the label of least energy for cells that have the same label. `is_own(c)` returns
  // whether a cell is one of them. A label must be better than the present one by more than
  // rounding errors.
  template <class Is_own> Label best(const std::vector<Cell_handle>& cells, const Is_own& is_own) {
    static constexpr double rounding = 1e-12; // relative to the energies
    const bool has_densities = m_options.interface_energy.has_densities();
    m_areas.clear();
    double measure = 0;
    for (auto c : cells) {
      for (int i = 0; i < Complex::corners; ++i)
        if (const auto neighbor = c->neighbor(i);
            !m_complex.is_infinite(neighbor) && !is_own(neighbor))
          m_areas[neighbor->subdomain_index()] += m_complex.measure(std::make_pair(c, i));
      measure += has_densities ? m_complex.measure(c) : 0;
    }
    const Label present = cells.front()->subdomain_index();
    const auto energy_of = [&](Label label) {
      double result = m_options.interface_energy.of_boundary(label, m_areas) +
                      m_options.interface_energy.density(label) * measure;
      for (auto c : cells)
        result += m_energy_of_cell(c, label);
      return result;
    };
    Label result = present;
    double least = energy_of(present);
    const auto consider = [&](Label label) {
      if (label == present)
        return;
      const double energy = energy_of(label);
      if (energy < least - rounding * (std::abs(energy) + std::abs(least))) {
        least = energy;
        result = label;
      }
    };
    if (m_options.labels.empty())
      for (const auto& [label, area] : m_areas)
        consider(label);
    else
      for (const Label label : m_options.labels)
        consider(label);
    return result;
  }

  void relabel(const std::vector<Cell_handle>& cells, Label label) {
    for (auto c : cells) {
      const Label before = c->subdomain_index();
      m_complex.relabel(c, label);
      if (m_options.visitor)
        m_options.visitor->after_relabel(c, before);
    }
  }

private:
  Complex& m_complex;
  const Energy_of_cell& m_energy_of_cell;
  const Relabeling_options<Complex>& m_options;
  std::map<Label, double> m_areas;
};

} // namespace internal

// Gives cells other labels as long as this decreases the energy: the sum of an energy of each cell
// and of the energy of the interface. One cell changes at a time; the result is a local minimum.
// The mesh does not change. The time is linear in the number of cells and changes, times the number
// of labels.
//
// \param complex the complex
// \param energy_of_cell `energy_of_cell(c, label)` returns the energy of a finite cell with a label: a
//        finite number. It must not depend on the labels of the complex.
// \param options the options
// \return the number of changes
// \throws Error if a tension or an energy density is out of its range
// \throws Interrupted_error if the callback of a `Progress_scope` returned `false`. After an exception,
//         also one of a function of the user, the complex is valid.
template <class Complex, class EnergyOfCell>
std::size_t relabel_by_energy(Complex& complex, const EnergyOfCell& energy_of_cell,
                              const Relabeling_options<Complex>& options = {}) {
  using Cell_handle = typename Complex::Cell_handle;
  internal::Label_chooser<Complex, EnergyOfCell> chooser(complex, energy_of_cell, options);
  std::size_t changes = 0;
  std::vector<Cell_handle> cells = complex.cells(), next, single(1);
  std::unordered_set<std::size_t> is_in_next; // time stamps
  while (!cells.empty()) {
    next.clear();
    is_in_next.clear();
    for (auto c : cells) {
      Progress_scope::check();
      single.front() = c;
      const auto label = chooser.best(single, [](Cell_handle) { return false; });
      if (label == c->subdomain_index() ||
          (options.topology_control && !relabeling_keeps_topology(complex, c, label) &&
           !options.topology_control(complex, c, label)))
        continue;
      chooser.relabel(single, label);
      ++changes;
      for (int i = 0; i < Complex::corners; ++i)
        if (const auto neighbor = c->neighbor(i);
            !complex.is_infinite(neighbor) && is_in_next.insert(neighbor->time_stamp()).second)
          next.push_back(neighbor);
    }
    std::swap(cells, next);
  }
  return changes;
}

// Gives whole connected components other labels if this decreases the energy of
// `relabel_by_energy()`. Each component is considered once, the smallest one first. This removes
// components that no sequence of changes of single cells removes if each change decreases the
// energy. The mesh does not change. n log n in the number of cells, times the number of labels.
//
// \param complex, energy_of_cell as above
// \param options the options. The control of topology is asked for each component that would change,
//        with its oldest cell.
// \return the number of components that changed
// \throws Error, Interrupted_error as above
template <class Complex, class EnergyOfCell>
std::size_t relabel_components_by_energy(Complex& complex, const EnergyOfCell& energy_of_cell,
                                         const Relabeling_options<Complex>& options = {}) {
  using Cell_handle = typename Complex::Cell_handle;
  internal::Label_chooser<Complex, EnergyOfCell> chooser(complex, energy_of_cell, options);
  const auto components = internal::components_of(complex);
  std::unordered_map<std::size_t, std::uint32_t> number_of; // by time stamps of cells
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const auto& [number, component] : components) {
    for (auto c : component.cells)
      number_of.emplace(c->time_stamp(), number);
    order.emplace_back(component.measure, number);
  }
  std::sort(order.begin(), order.end());
  std::size_t changes = 0;
  for (const auto& [measure, number] : order) {
    Progress_scope::check();
    const auto& cells = components.at(number).cells;
    const auto label = chooser.best(
        cells, [&, own = number](Cell_handle c) { return number_of.at(c->time_stamp()) == own; });
    if (label == cells.front()->subdomain_index() ||
        (options.topology_control && !options.topology_control(complex, cells.front(), label)))
      continue;
    chooser.relabel(cells, label);
    ++changes;
  }
  return changes;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_SEGMENTATION_RELABEL_BY_ENERGY_H
