// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_H

#include <CGAL/Mesh_support/Error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// A liquid, which fills the cells of a label. All units must be consistent.
struct Liquid
{
  double density;       ///< mass of a unit of volume, greater than 0
  double viscosity = 0; ///< dynamic viscosity, 0 or more
  /// The dynamic viscosity as a function of the shear rate, 0 or more. The shear rate is the square
  /// root of 2 D : D, where D is the symmetric part of the gradient of the velocity. It is 0 or
  /// more and has the unit 1 / time. If the function is empty, `viscosity` applies. The friction
  /// between two liquids depends on `viscosity` only. `Incompressible_fluid::advance()` and
  /// `Incompressible_fluid::relax()` throw an `Error` if the function returns a number that is
  /// negative or not finite.
  std::function<double(double)> viscosity_at_shear_rate = {};
  /// The diffusivity of the field that liquids carry, 0 or more: area in a unit of time. See
  /// `Incompressible_fluid::set_field()`.
  double diffusivity = 0;

  /// Returns whether the liquid can have a viscosity other than 0.
  bool is_viscous() const { return viscosity > 0 || viscosity_at_shear_rate; }
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A gas, which fills the cells of a label and has no mass. Each connected component of a gas has
/// one pressure. The product of the pressure and the power volume^exponent is constant.
struct Gas
{
  double pressure; ///< initial pressure, relative to void, 0 or more
  /// Exponent, 0 or more: 1.4 for air without heat exchange, 1 for a constant temperature, 0 for a
  /// constant pressure, as in the atmosphere.
  double exponent = 1.4;
};

/*!
\ingroup PkgIncompressibleFluids3Ref

The media of the labels of a complex, the surface tensions between them, and gravity. A medium is a
liquid, a gas or void. Void has neither mass nor pressure.
*/
class Fluid_properties
{
public:
  /// Makes a label a liquid. Labels that are neither liquid nor gas are void.
  /// \throws Error if the density, the viscosity or the diffusivity is out of its range, or if the
  /// label is a gas
  void set_liquid(int label, const Liquid& liquid) {
    if (!(liquid.density > 0) || !std::isfinite(liquid.density))
      throw Error(
          "the density of label " + std::to_string(label) +
          " is not positive and finite: use more than 0, or leave out the label to make it void");
    require_not_negative(liquid.viscosity, "the viscosity of label " + std::to_string(label));
    require_not_negative(liquid.diffusivity, "the diffusivity of label " + std::to_string(label));
    if (m_gases.count(label) > 0)
      throw Error("label " + std::to_string(label) + " is already a gas: choose another label");
    m_liquids[label] = liquid;
  }

  /// Makes a label a gas.
  /// \throws Error if the pressure or the exponent is out of its range, or if the label is a liquid
  void set_gas(int label, const Gas& gas) {
    require_not_negative(gas.pressure, "the pressure of label " + std::to_string(label));
    require_not_negative(gas.exponent, "the exponent of label " + std::to_string(label));
    if (m_liquids.count(label) > 0)
      throw Error("label " + std::to_string(label) + " is already a liquid: choose another label");
    m_gases[label] = gas;
  }

  /// Sets the surface tension between two labels: the energy of a unit of area of the interface. It
  /// is 0 by default.
  /// \throws Error if the tension is negative or not finite, or if the labels are the same
  void set_surface_tension(int a, int b, double tension) {
    require_not_negative(tension, name_of_tension(a, b));
    set_surface_tension(a, b, [tension](double) { return tension; });
  }

  /// Sets the surface tension between two labels as a function of the field that liquids carry, see
  /// `Incompressible_fluid::set_field()`. The function is called for each facet of the interface,
  /// with the mean of the field at the vertices of the facet. `Incompressible_fluid` throws an
  /// `Error` if the function returns a number that is negative or not finite.
  /// \throws Error if the function is empty, or if the labels are the same
  void set_surface_tension(int a, int b, std::function<double(double)> tension_at) {
    if (!tension_at)
      throw Error(name_of_tension(a, b) + " is an empty function: give a function or a number");
    if (a == b)
      throw Error("the surface tension needs two labels, but label " + std::to_string(a) +
                  " is given twice: give different labels");
    m_tensions[std::minmax(a, b)] = std::move(tension_at);
  }

  /// Sets gravity, an acceleration, which is 0 by default.
  /// \throws Error if the acceleration is not finite
  void set_gravity(const std::array<double, 3>& acceleration) {
    for (double a : acceleration)
      if (!std::isfinite(a))
        throw Error("gravity is not finite: give finite coordinates");
    m_gravity = acceleration;
  }

  /// Returns the liquid of a label, or null if the label is not a liquid.
  const Liquid* liquid(int label) const {
    const auto found = m_liquids.find(label);
    return found == m_liquids.end() ? nullptr : &found->second;
  }
  /// Returns the liquids by label.
  const std::map<int, Liquid>& liquids() const { return m_liquids; }
  /// Returns the gas of a label, or null if the label is not a gas.
  const Gas* gas(int label) const {
    const auto found = m_gases.find(label);
    return found == m_gases.end() ? nullptr : &found->second;
  }
  /// Returns the gases by label.
  const std::map<int, Gas>& gases() const { return m_gases; }
  /// Returns the surface tension between two labels at a value of the field.
  /// \throws Error if the function of the tension returns a number that is negative or not finite
  double surface_tension(int a, int b, double field = 0) const {
    const auto found = m_tensions.find(std::minmax(a, b));
    const double result = found == m_tensions.end() ? 0 : found->second(field);
    if (!is_not_negative(result))
      throw Error(name_of_tension(a, b) + " is negative or not finite at a field of " +
                  std::to_string(field) + ": bound the function for small and large values");
    return result;
  }
  /// Returns the acceleration of gravity.
  const std::array<double, 3>& gravity() const { return m_gravity; }

private:
  static bool is_not_negative(double value) { return value >= 0 && std::isfinite(value); }
  static void require_not_negative(double value, const std::string& name) {
    if (!is_not_negative(value))
      throw Error(name + " is negative or not finite: use 0 or more");
  }
  static std::string name_of_tension(int a, int b) {
    return "the surface tension between labels " + std::to_string(a) + " and " + std::to_string(b);
  }

  std::map<int, Liquid> m_liquids;
  std::map<int, Gas> m_gases;
  std::map<std::pair<int, int>, std::function<double(double)>> m_tensions; // by field
  std::array<double, 3> m_gravity = {};
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_H
