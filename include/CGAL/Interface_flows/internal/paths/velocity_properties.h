// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_VELOCITY_PROPERTIES_H
#define CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_VELOCITY_PROPERTIES_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Tells whether a velocity declares that it decreases the measure of the interface:
// `static constexpr bool contracts_interface = true`.
template <class Velocity, class = void> inline constexpr bool contracts_interface = false;

template <class Velocity>
inline constexpr bool
    contracts_interface<Velocity, std::void_t<decltype(Velocity::contracts_interface)>> =
        Velocity::contracts_interface;

// The result of the member function `preserves_volumes()` of a velocity; `false` if there is no
// such member.
template <class Velocity, class = void> struct Volume_preservation
{
  static bool of(const Velocity&) { return false; }
};

template <class Velocity>
struct Volume_preservation<
    Velocity, std::void_t<decltype(std::declval<const Velocity&>().preserves_volumes())>>
{
  static bool of(const Velocity& velocity) { return velocity.preserves_volumes(); }
};

template <class Velocity> bool preserves_volumes(const Velocity& velocity) {
  return Volume_preservation<Velocity>::of(velocity);
}

// Returns the result of the member function `energy()` of a velocity; `other` if there is no such
// member.
template <class Velocity>
auto energy_of(const Velocity& velocity, const Interface_energy&, int)
    -> decltype(Interface_energy(velocity.energy())) {
  return velocity.energy();
}
template <class Velocity>
Interface_energy energy_of(const Velocity&, const Interface_energy& other, long) {
  return other;
}
template <class Velocity>
Interface_energy energy_of(const Velocity& velocity, const Interface_energy& other) {
  return energy_of(velocity, other, 0);
}

// Tells whether a velocity opens corners: it has the member function `open_corners()`, which
// inserts vertices into the interface before a step and tells their destinations.
template <class Complex, class Velocity, class = void> inline constexpr bool opens_corners = false;

template <class Complex, class Velocity>
inline constexpr bool
    opens_corners<Complex, Velocity,
                  std::void_t<decltype(std::declval<const Velocity&>().open_corners(
                      std::declval<Complex&>(), std::declval<Interface_snapshot<Complex>>(), 0.,
                      std::declval<Deformation_visitor<Complex>&>()))>> = true;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_INTERFACE_FLOWS_INTERNAL_PATHS_VELOCITY_PROPERTIES_H
