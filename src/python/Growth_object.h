// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_GROWTH_OBJECT_H
#define DSC_PYTHON_GROWTH_OBJECT_H

#include "Complex_object.h"
#include "callbacks.h"
#include "options.h"
#include "reports.h"

#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Interface_flows/Grain_growth.h>

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

/// The growth of the grains of a complex, for Python. Times have the unit of an area of the user.
template <class Complex> class Growth_object
{
public:
  Growth_object(Complex_object<Complex>& object, const py::dict& options) : m_object(object) {
    const double scale = Space<Complex>(object.read()).scale();
    Options rest(options);
    const auto energy = read_energy(rest, scale);
    DSC::Grain_growth_options growth;
    rest.read("edges", growth.edges_of_grain);
    rest.read("step", growth.step);
    rest.read("fastest", growth.fastest);
    rest.read("threads", growth.number_of_threads);
    std::optional<double> longest_edge;
    rest.read("longest_edge", longest_edge);
    if (longest_edge)
      growth.longest_edge = *longest_edge / scale;
    rest.require_all_read();
    object.change(py::none(), [&](Complex& complex) { m_growth.emplace(complex, energy, growth); });
  }

  double time() const { return unit() * m_growth->time(); }
  void set_time(double time) { m_growth->set_time(time / unit()); }

  py::dict advance(const py::object& progress) {
    const auto report = m_object.change(progress, [&](Complex& complex) {
      Value_visitor<Complex> visitor(complex, m_object);
      return m_growth->advance(m_object.has_values() ? &visitor : nullptr);
    });
    py::dict result;
    result["time"] = report.time * unit();
    result["dt"] = report.dt * unit();
    result["removed"] = report.removed;
    result["report"] = report_to_dict(report.deformation, m_object.read());
    return result;
  }

private:
  double unit() const {
    const double scale = Space<Complex>(m_object.read()).scale();
    return scale * scale;
  }

  Complex_object<Complex>& m_object;
  std::optional<DSC::Grain_growth<Complex>> m_growth;
};

} // namespace dsc_python

#endif // DSC_PYTHON_GROWTH_OBJECT_H
