// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SUBDIVIDE_INTERFACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SUBDIVIDE_INTERFACE_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/extract_interface_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Loop_subdivider_3.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

subdivides an interface by Loop's scheme, for rendering: each time, a triangle becomes four, and
points move towards a smooth surface.

Where more than two triangles meet in an edge, where there is only one, and where the labels change,
the edge is on a curve. On the manifold patches between curves, points are those of
`Subdivision_method_3::Loop_subdivision()`, up to rounding. Curves are subdivided by the rule for
borders, 1/8, 3/4, 1/8, each once for all patches that meet there, so that these still share their
points. Points stay where they are

- where curves branch or end, as in quadruple points, and where sheets touch in the point alone,
- on the edges of a box, so that the interface still ends in the sides of the box; on the boundary
of a domain that is no box, all that were vertices.

The interface between two labels, extracted alone, has a border where further labels meet it: it
agrees with a part of the whole interface if no curve branches on it. On a torus, a part that was
cut open has a border there.

\tparam Complex is an instance of `Deformable_simplicial_complex_3`.

\param surface is what `extract_interface()` or this function returned.
\param number_of_subdivisions is how many times, at least 0; with 0, the surface stays as it is.
\return the subdivided surface. Of each subdivision, triangle i becomes the triangles 4 i to
4 i + 3 with its labels and its orientation, the last of which is in the middle. Points of edges
follow the points that there were, by the indices of the ends of their edges; in `vertices`, they
have a default-constructed handle, while the others keep that of the vertex they come from.

\throws Error if `number_of_subdivisions` is negative.
\throws Interrupted_error if the callback of a
`Progress_scope` returns `false`

n log n in the size of the result, which is four times as large each time.

The scheme is that of C. Loop, <em>Smooth subdivision surfaces based on triangles</em>, Master's
thesis, University of Utah, 1987.

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

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_SUBDIVIDE_INTERFACE_3_H
