// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ENERGY_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ENERGY_H

#include <CGAL/Mesh_support/Error.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

The energy of a complex, and the mobility of its interface.

\f[ E = \sum_{a<b} \sigma_{ab} \, |\Gamma_{ab}| + \sum_a e_a \, |\Omega_a| \f]

Here, \f$\Gamma_{ab}\f$ is the interface between the labels a and b, \f$\Omega_a\f$ are the cells
with the label a, \f$\sigma_{ab}\f$ is the surface tension, and \f$e_a\f$ is the energy density of a
label. Differences of energy densities drive the interface. By default, all tensions are 1, and all
densities are 0. Then the energy is the measure of the interface.

The interface between a and b moves with the velocity \f$m_{ab} (\sigma_{ab} \kappa + e_f - e_b)\f$
towards its front, see `Mean_curvature_flow`. Here, \f$m_{ab}\f$ is the mobility. The sum of the
principal curvatures \f$\kappa\f$ is positive where the front is on the inner side. The densities in
front and behind are \f$e_f\f$ and \f$e_b\f$. By default, all mobilities are 1. An interface with
the mobility 0 does not move along its normal. Other interfaces that end at it slide along it.

Functions of pairs of labels must be symmetric. They are called with the smaller label first. Copies
share the functions.
*/
class Interface_energy
{
public:
  using Label = int;                                   ///< a label
  using Of_pair = std::function<double(Label, Label)>; ///< a function of two labels
  using Of_label = std::function<double(Label)>;       ///< a function of a label

  /// Sets the surface tension of all pairs of labels: an energy per area, in the plane per length.
  /// \param tension a positive, finite number
  /// \throws Error if it is not
  void set_tension(double tension) {
    require(tension > 0 && std::isfinite(tension), "surface tension", "a positive, finite number");
    m_tension = [tension](Label, Label) { return tension; };
  }
  /// Sets the surface tension as a function of two labels. `tension()` checks its values.
  void set_tension(Of_pair tension) { m_tension = std::move(tension); }

  /// Sets the mobility of all pairs of labels: velocity per force per area.
  /// \param mobility a finite number, not negative
  /// \throws Error if it is not
  void set_mobility(double mobility) {
    require(mobility >= 0 && std::isfinite(mobility), "mobility", "a finite number of 0 or more");
    m_mobility = [mobility](Label, Label) { return mobility; };
  }
  /// Sets the mobility as a function of two labels. `mobility()` checks its values.
  void set_mobility(Of_pair mobility) { m_mobility = std::move(mobility); }

  /// Sets the energy density of each label: an energy per volume, in the plane per area. A label
  /// with a lower density grows. `density()` checks the values.
  void set_density(Of_label density) { m_density = std::move(density); }

  /// Returns the surface tension between two labels.
  /// \throws Error if the function of the user returns a value that is not positive or not finite
  double tension(Label a, Label b) const {
    const double result = of_pair(m_tension, a, b);
    require(result > 0 && std::isfinite(result), "surface tension", "a positive, finite number", a,
            b);
    return result;
  }

  /// Returns the mobility of the interface between two labels.
  /// \throws Error if the function of the user returns a negative value, or one that is not finite
  double mobility(Label a, Label b) const {
    const double result = of_pair(m_mobility, a, b);
    require(result >= 0 && std::isfinite(result), "mobility", "a finite number of 0 or more", a, b);
    return result;
  }

  /// Returns the energy density of a label.
  /// \throws Error if the function of the user returns a value that is not finite
  double density(Label label) const {
    const double result = m_density ? m_density(label) : 0;
    if (!std::isfinite(result))
      throw Error("the energy density of label " + std::to_string(label) +
                  " is not finite: return a finite number");
    return result;
  }

  /// Returns whether `set_tension()` was called; otherwise all tensions are 1.
  bool has_tensions() const { return bool(m_tension); }
  /// Returns whether `set_mobility()` was called; otherwise all mobilities are 1.
  bool has_mobilities() const { return bool(m_mobility); }
  /// Returns whether `set_density()` was called; otherwise all densities are 0.
  bool has_densities() const { return bool(m_density); }

  /// Returns the energy of a complex. Linear in the number of cells.
  /// \throws Error as `tension()` and `density()` do
  template <class Complex> double operator()(const Complex& complex) const {
    double result = 0;
    for (const auto& facet : complex.interface_facets())
      result += tension(facet.first->subdomain_index(),
                        facet.first->neighbor(facet.second)->subdomain_index()) *
                complex.measure(facet);
    if (has_densities())
      for (const Label label : complex.labels())
        result += density(label) * complex.measure(label);
    return result;
  }

  /// Returns the energy of the boundary of a region with a given label.
  /// \param label the label
  /// \param areas map from labels to the measures of the common boundary with the region; the part
  ///        with the same label has no energy
  /// \throws Error as `tension()` does
  template <class Areas> double of_boundary(Label label, const Areas& areas) const {
    double result = 0;
    for (const auto& [other, area] : areas)
      result += other == label ? 0 : tension(other, label) * area;
    return result;
  }

  /// Returns the angles of three labels at their common line in equilibrium, in radians: Young's
  /// law. The angle of a label is opposite to the tension between the two others, as in a triangle
  /// of the three tensions, and it is \f$\pi\f$ minus the angle of this triangle. Returns nothing
  /// if one tension is at least the sum of the other two. Then the third label wets the interface
  /// between the two labels with this tension.
  /// \throws Error as `tension()` does
  std::optional<std::array<double, 3>> young_angles(Label a, Label b, Label c) const {
    const std::array<double, 3> opposite = {tension(b, c), tension(a, c), tension(a, b)};
    std::array<double, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = opposite[i], y = opposite[(i + 1) % 3], z = opposite[(i + 2) % 3];
      if (!(x < y + z))
        return std::nullopt;
      result[i] = CGAL_PI -
                  std::acos((std::min)(1., (std::max)(-1., (y * y + z * z - x * x) / (2 * y * z))));
    }
    return result;
  }

private:
  static double of_pair(const Of_pair& function, Label a, Label b) {
    return function ? function((std::min)(a, b), (std::max)(a, b)) : 1;
  }

  static void require(bool holds, const char* what, const char* range) {
    if (!holds)
      throw Error("the " + std::string(what) + " is out of its range: use " + range);
  }
  static void require(bool holds, const char* what, const char* range, Label a, Label b) {
    if (!holds)
      throw Error("the " + std::string(what) + " of the labels " + std::to_string(a) + " and " +
                  std::to_string(b) + " is out of its range: return " + range);
  }

  Of_pair m_tension, m_mobility; // 1 if empty
  Of_label m_density;            // 0 if empty
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ENERGY_H
