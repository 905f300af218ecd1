// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_INTERNAL_CGAL_CONFORMING_TRIANGULATION_3_H
#define CGAL_MESH_SUPPORT_INTERNAL_CGAL_CONFORMING_TRIANGULATION_3_H

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060100000
#include <CGAL/Conforming_constrained_Delaunay_triangulation_3.h>
#endif

namespace CGAL::Deformable_simplicial_complexes {

#if CGAL_VERSION_NR >= 1060100000
// Whether this version of \cgal has the conforming constrained Delaunay triangulation in 3D.
inline constexpr bool has_conforming_triangulation_3 = true;
template <class Kernel>
using Conforming_triangulation_3 = Conforming_constrained_Delaunay_triangulation_3<Kernel>;
#else
inline constexpr bool has_conforming_triangulation_3 = false;
template <class Kernel> class Conforming_triangulation_3;
#endif

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_INTERNAL_CGAL_CONFORMING_TRIANGULATION_3_H
