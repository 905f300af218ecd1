// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CONTRACTS_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CONTRACTS_INTERFACE_H

#include <type_traits>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Whether a velocity declares that it decreases the measure of the interface:
// `static constexpr bool contracts_interface = true`.
template <class Velocity, class = void> inline constexpr bool contracts_interface = false;

template <class Velocity>
inline constexpr bool
    contracts_interface<Velocity, std::void_t<decltype(Velocity::contracts_interface)>> =
        Velocity::contracts_interface;

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_INTERFACE_CONTRACTS_INTERFACE_H
