// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CGAL_COMPAT_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CGAL_COMPAT_H

// What is different in CGAL 6: nothing else here depends on the version of CGAL.

#include <CGAL/version.h>

#include <cstddef>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <class Kernel, class Iterator>
using Tree_traits_3 = AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Iterator>>;
template <class Mesh>
using Edge_count_stop_predicate = Surface_mesh_simplification::Edge_count_stop_predicate<Mesh>;
#else
template <class Kernel, class Iterator>
using Tree_traits_3 = AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Iterator>>;
template <class Mesh>
using Edge_count_stop_predicate = Surface_mesh_simplification::Count_stop_predicate<Mesh>;
#endif

// Deletes a vertex or a cell. CGAL 6 gives what is created in its place its time stamp again, by which
// it would be taken for it: there is none to give.
template <class Container, class Handle> void erase_item(Container& container, Handle item) {
  item->set_time_stamp(std::size_t(-1));
  container.erase(item);
}

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_CGAL_COMPAT_H
