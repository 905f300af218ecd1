// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_3_H
#define CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgIncompressibleFluids3Ref
/// A liquid: what fills the cells of a label. Any units that fit together.
struct Liquid
{
  double density;       ///< mass of a unit of volume, more than 0
  double viscosity = 0; ///< dynamic, 0 or more
};

/// \ingroup PkgIncompressibleFluids3Ref
/// A gas: what fills the cells of a label without mass. Each connected part of it keeps its
/// pressure times volume^exponent, and has one pressure everywhere.
struct Gas
{
  double pressure; ///< in the beginning, against void, 0 or more
  double exponent =
      1.4; ///< 1.4 for air that neither takes nor gives heat, 1 where that stays as warm
           ///< as it is, 0 for a pressure that never changes, as of air all around
};

/*!
\ingroup PkgIncompressibleFluids3Ref

What the labels of a complex stand for: liquids, gases, and void, which has no mass and no pressure;
and how interfaces between them contract.
*/
class Fluid_properties_3
{
public:
  /// Label `label` is this liquid. Labels that are neither liquid nor gas are void.
  /// \throws Error if a number is out of its range, or the label is a gas
  void set_liquid(int label, const Liquid& liquid) {
    if (!(liquid.density > 0) || !std::isfinite(liquid.density))
      throw Error("the density of label " + std::to_string(label) +
                  " is not positive and finite: leave labels without mass out, they are void");
    if (!(liquid.viscosity >= 0) || !std::isfinite(liquid.viscosity))
      throw Error("the viscosity of label " + std::to_string(label) + " is negative or not finite");
    if (m_gases.count(label) > 0)
      throw Error("label " + std::to_string(label) + " is a gas already");
    m_liquids[label] = liquid;
  }

  /// Label `label` is this gas.
  /// \throws Error if a number is out of its range, or the label is a liquid
  void set_gas(int label, const Gas& gas) {
    if (!(gas.pressure >= 0) || !std::isfinite(gas.pressure))
      throw Error("the pressure of label " + std::to_string(label) + " is negative or not finite");
    if (!(gas.exponent >= 0) || !std::isfinite(gas.exponent))
      throw Error("the exponent of label " + std::to_string(label) + " is negative or not finite");
    if (m_liquids.count(label) > 0)
      throw Error("label " + std::to_string(label) + " is a liquid already");
    m_gases[label] = gas;
  }

  /// The energy of a unit of area of the interface between two labels is `tension`, 0 where none is
  /// set. \throws Error if it is negative or not finite, or the labels are the same
  void set_surface_tension(int a, int b, double tension) {
    if (!(tension >= 0) || !std::isfinite(tension))
      throw Error("the surface tension between labels " + std::to_string(a) + " and " +
                  std::to_string(b) + " is negative or not finite");
    if (a == b)
      throw Error("there is no interface between label " + std::to_string(a) + " and itself");
    m_tensions[std::minmax(a, b)] = tension;
  }

  /// The acceleration that everything feels, such as gravity. \throws Error if it is not finite
  void set_gravity(const std::array<double, 3>& acceleration) {
    for (double a : acceleration)
      if (!std::isfinite(a))
        throw Error("gravity is not finite");
    m_gravity = acceleration;
  }

  /// Null for void.
  const Liquid* liquid(int label) const {
    const auto found = m_liquids.find(label);
    return found == m_liquids.end() ? nullptr : &found->second;
  }
  /// By label.
  const std::map<int, Liquid>& liquids() const { return m_liquids; }
  /// Null for liquids and void.
  const Gas* gas(int label) const {
    const auto found = m_gases.find(label);
    return found == m_gases.end() ? nullptr : &found->second;
  }
  /// By label.
  const std::map<int, Gas>& gases() const { return m_gases; }
  /// Between two labels.
  double surface_tension(int a, int b) const {
    const auto found = m_tensions.find(std::minmax(a, b));
    return found == m_tensions.end() ? 0 : found->second;
  }
  /// What everything feels.
  const std::array<double, 3>& gravity() const { return m_gravity; }

private:
  std::map<int, Liquid> m_liquids;
  std::map<int, Gas> m_gases;
  std::map<std::pair<int, int>, double> m_tensions;
  std::array<double, 3> m_gravity = {};
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_INCOMPRESSIBLE_FLUIDS_3_FLUID_PROPERTIES_3_H
