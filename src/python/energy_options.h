// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_ENERGY_OPTIONS_H
#define DSC_PYTHON_ENERGY_OPTIONS_H

#include "callbacks.h"
#include "options.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>

#include <string>

namespace dsc_python {

/// \throws py::type_error if an option is no number
inline double number_of(const py::object& value, const std::string& name) {
  try {
    return value.cast<double>();
  } catch (const py::cast_error&) {
    throw py::type_error(name + " must be a number or a function of two labels");
  }
}

/// Reads the energy of an interface. Velocities are products of a mobility and a density, or of a
/// mobility, a tension and a curvature. Time has the unit of an area.
inline CGAL::Deformable_simplicial_complexes::Interface_energy read_energy(Options& options,
                                                                           double scale) {
  CGAL::Deformable_simplicial_complexes::Interface_energy result;
  const auto read = [&](const char* name, const auto& set) {
    const py::object value = options.take(name);
    if (py::isinstance<py::function>(value))
      set(Function_of_labels<int, int>(value, name));
    else if (!value.is_none())
      set(number_of(value, name));
  };
  read("tension", [&](const auto& value) { result.set_tension(value); });
  read("mobility", [&](const auto& value) { result.set_mobility(value); });
  const py::object density = options.take("density");
  if (!density.is_none())
    result.set_density(Function_of_labels<int>(density, "density", scale));
  return result;
}

} // namespace dsc_python

#endif // DSC_PYTHON_ENERGY_OPTIONS_H
