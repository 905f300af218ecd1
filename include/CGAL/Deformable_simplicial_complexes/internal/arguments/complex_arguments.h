// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ARGUMENTS_COMPLEX_ARGUMENTS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ARGUMENTS_COMPLEX_ARGUMENTS_H

// Checks of the template arguments of a complex. The message of a wrong argument is the only one:
// the argument is replaced by a default. The assertions are in functions, because one that fails in
// a class makes all members unknown.

#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Deformable_simplicial_complexes/simplex_bases.h>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Whether the predicates of a kernel are rounded, as kernels of CGAL tell.
template <class Kernel, class = void> inline constexpr bool rounds_predicates = false;
template <class Kernel>
inline constexpr bool
    rounds_predicates<Kernel, std::void_t<typename Kernel::Has_filtered_predicates_tag>> =
        !Kernel::Has_filtered_predicates_tag::value;

template <class Kernel, class = void> inline constexpr bool is_kernel = false;
template <class Kernel>
inline constexpr bool is_kernel<Kernel, std::void_t<typename Kernel::FT>> =
    std::is_same_v<typename Kernel::FT, double> && !rounds_predicates<Kernel>;
template <class Kernel> constexpr bool require_kernel() {
  static_assert(is_kernel<Kernel>,
                "DeformableSimplicialComplexTraits_2 or 3: FT is double, predicates are exact, as "
                "in Exact_predicates_inexact_constructions_kernel");
  return is_kernel<Kernel>;
}

// Tds is a triangulation data structure for points of a type.
template <class Tds, class Point, class = void> inline constexpr bool has_bases = false;
template <class Tds, class Point>
inline constexpr bool
    has_bases<Tds, Point,
              std::void_t<typename Tds::Vertex::Point,
                          decltype(std::declval<typename Tds::Vertex&>().cell())>> =
        std::is_same_v<typename Tds::Vertex::Point, Point>&&
            std::is_base_of_v<Vertex_data, typename Tds::Vertex>&& std::is_base_of_v<
                Cell_data, std::decay_t<decltype(*std::declval<typename Tds::Vertex&>().cell())>>;
template <class Tds, class Point> constexpr bool require_bases() {
  static_assert(has_bases<Tds, Point>,
                "the bases are Deformable_simplicial_complex_vertex_base_3<Traits, Vb> and "
                "cell_base_3<Traits, Cb>, or vertex_base_2 and face_base_2, over any bases");
  return has_bases<Tds, Point>;
}

template <class Domain, class = void> inline constexpr bool is_domain = false;
template <class Domain>
inline constexpr bool is_domain<Domain, std::void_t<decltype(Domain::has_outside)>> = true;
template <class Domain> constexpr bool require_domain() {
  static_assert(is_domain<Domain>, "SimplicialDomain: Ball_domain, Solid_domain or Torus_domain");
  return is_domain<Domain>;
}
template <class Domain>
using Domain_of = std::conditional_t<require_domain<Domain>(), Domain, Ball_domain>;

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_ARGUMENTS_COMPLEX_ARGUMENTS_H
