// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_CGAL_CGAL_COMPAT_H
#define CGAL_MESH_SUPPORT_INTERNAL_CGAL_CGAL_COMPAT_H

// Names that differ between CGAL 5.5 and CGAL 6. The documentation is in the branch for CGAL 5.5,
// because Doxygen reads this branch.

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>

#include <variant>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>

#include <boost/variant/get.hpp>
#endif

namespace CGAL::Deformable_simplicial_complexes {

#if CGAL_VERSION_NR >= 1060000000
using Surface_mesh_simplification::Edge_count_stop_predicate;
template <class Type, class Variant> const Type* get_alternative(const Variant& variant) {
  return std::get_if<Type>(&variant);
}
#else
// The names of CGAL 6.
template <class Kernel, class Primitive> using AABB_traits_3 = AABB_traits<Kernel, Primitive>;
template <class Kernel, class Iterator>
using AABB_triangle_primitive_3 = AABB_triangle_primitive<Kernel, Iterator>;
template <class Kernel, class Iterator>
using AABB_segment_primitive_3 = AABB_segment_primitive<Kernel, Iterator>;
// Predicate that stops the simplification of a surface mesh at a number of edges.
template <class Mesh>
using Edge_count_stop_predicate = Surface_mesh_simplification::Count_stop_predicate<Mesh>;
// Returns a pointer to the value of a variant, or null if the value has another type than `Type`.
// The variant is one that \cgal returns: of `std` or of `boost`, depending on the version.
template <class Type, class Variant> const Type* get_alternative(const Variant& variant) {
  return boost::get<Type>(&variant);
}
#endif

// Traits of an `AABB_tree` of triangles in space. `Iterator` has the value type
// `Kernel::Triangle_3`.
template <class Kernel, class Iterator>
using Tree_traits_3 = AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Iterator>>;
// Traits of an `AABB_tree` of segments in space. `Iterator` has the value type
// `Kernel::Segment_3`.
template <class Kernel, class Iterator>
using Segment_tree_traits_3 = AABB_traits_3<Kernel, AABB_segment_primitive_3<Kernel, Iterator>>;

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_CGAL_CGAL_COMPAT_H
