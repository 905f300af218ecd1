// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Interface_remeshing, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H
#define CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H

#include <CGAL/license/Interface_remeshing.h>

#include <CGAL/Interface_remeshing/extract_interface_3.h>
#include <CGAL/Interface_remeshing/internal/extraction/Loop_subdivider_3.h>
#include <CGAL/Mesh_support/Error.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Subdivides an interface with Loop's scheme, for rendering (C. Loop, <em>Smooth subdivision surfaces
based on triangles</em>, Master's thesis, University of Utah, 1987). In each subdivision, a triangle
is divided into four, and points move towards a smooth surface. n log n in the size of the result,
which is multiplied by four in each subdivision.

An edge is on a curve if it has one triangle or more than two, or if the labels change at it. On the
manifold patches between curves, points are those of `Subdivision_method_3::Loop_subdivision()`, up
to rounding. Curves are subdivided by the rule for borders, 1/8, 3/4, 1/8. Each curve is subdivided
once for all patches that meet there, so that the patches still share its points. Some points do not
move:

- points where curves branch or end, as in quadruple points, and points where sheets touch in a
  single point;
- points on the edges of a box, so that the interface still ends in the sides of the box;
- original vertices on the boundary of a domain that is not a box.

The interface between two labels, extracted alone, has a border where other labels meet it. Its
subdivision agrees with the corresponding part of the whole interface if no curve branches on it. On
a torus, a component that was cut open has a border at the cut.

\tparam Complex an instance of `Deformable_simplicial_complex_3`

\param surface a result of `extract_interface()` or of this function
\param number_of_subdivisions number of subdivisions, at least 0; with 0, the surface is unchanged
\return the subdivided surface. In each subdivision, triangle i becomes the triangles 4 i to 4 i + 3
        with its labels and its orientation; the last one is in the middle. New points are on edges.
        They follow the old points, ordered by the indices of the ends of their edges. In
        `vertices`, new points have a default-constructed handle, and old points keep their vertex.

\throws Error if `number_of_subdivisions` is negative
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`

\sa `extract_interface()`
*/
template <class Complex>
Interface_surface_3<Complex> subdivide_interface(Interface_surface_3<Complex> surface,
                                                 int number_of_subdivisions = 1) {
  if (number_of_subdivisions < 0)
    throw Error("the number of subdivisions is negative: use 0 or "
                "more");
  for (int i = 0; i < number_of_subdivisions; ++i)
    surface = internal::Loop_subdivider_3<Interface_surface_3<Complex>>(surface).subdivided();
  return surface;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_SUBDIVIDE_INTERFACE_3_H
