// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REPAIR_SURFACE_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REPAIR_SURFACE_3_H

#include <CGAL/Deformable_simplicial_complexes/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complexes/Surface_repair_options_3.h>
#include <CGAL/Deformable_simplicial_complexes/Surface_repair_report_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/repair/Surface_repairer_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/repair/repair_options.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

template <class Point> Triangle_soup_3 soup_of(const Labelled_surface_3<Point>& surface) {
  Triangle_soup_3 soup;
  for (const Point& p : surface.points)
    soup.points.push_back(coordinates(p));
  soup.triangles = surface.triangles;
  return soup;
}

template <class Point>
void assign(Labelled_surface_3<Point>& surface, const Triangle_soup_3& soup) {
  surface.points.clear();
  for (const Coordinates_3& p : soup.points)
    surface.points.push_back(Point(p[0], p[1], p[2]));
  surface.triangles = soup.triangles;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a surface bound a solid, as the overload below. Only this overload takes `merge_distance` and
`longest_border`. If `merge_distance` is more than 0, near vertices are merged first, even if the
surface bounds a solid.
*/
template <class Point>
Surface_repair_report_3 repair_surface_3(Labelled_surface_3<Point>& surface,
                                         const Surface_repair_options_3& options) {
  internal::Surface_repairer_3 repairer(internal::soup_of(surface), options);
  repairer.run();
  if (!repairer.report().was_sound())
    internal::assign(surface, repairer.soup());
  return repairer.report();
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Makes a surface bound a solid, as `make_deformable_simplicial_complex_3()` requires, if it nearly
does. The following steps are done in this order until the surface bounds a solid:

- equal points are merged, and triangles without area are removed. Of triangles with the same
corners one is kept, or none if they are a wall between parts that touch.
- Boundary vertices become one if their distance is less than a thousandth of the mean edge and a
  tenth of the boundary edges at them.
- T-junctions are closed: a boundary edge is split at a boundary vertex if the distance of the
vertex from the edge is less than a thousandth of that edge and of the shortest boundary edge at the
  vertex.
- Fins are removed: triangles with a boundary edge that hang on an otherwise closed surface. They
stay if they reach farther than two mean edges from it.
- Holes are filled. A surface with a long border is refused: it is a sheet, not a solid with a hole.
- Parts that cross each other or themselves are united: triangles are split where they cross, by
exact arithmetic, and those that do not bound the union are removed. A closed part that is inside an
odd number of other parts without crossing them stays a cavity. Walls inside a solid are removed.
The step is omitted if it would remove triangles outside the solid farther than two mean edges from
it.
- The surface is replaced by an alpha wrap, which is closed and has no crossings; cavities are
filled.

No length in this is absolute: a surface that is scaled by a power of two has the same result,
scaled.

CGAL's polygon mesh processing and alpha wrapping do the work.

\tparam Point a point type with `double` coordinates, as that of `Labelled_surface_3`
\tparam NP a sequence of named parameters

\param surface is replaced by the repaired one; if it bounds a solid already, it is unchanged
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{largest_hole}
    \cgalParamDescription{The longest border of holes that are filled, in diagonals of the bounding
                          box of the part that has it, at least 0. The border of a flat sheet is at
                          least two of them long.}
    \cgalParamType{`double`}
    \cgalParamDefault{1.6}
  \cgalParamNEnd
  \cgalParamNBegin{wrap_alpha}
    \cgalParamDescription{The parameter alpha of CGAL's alpha wrap, in mean edges of the surface,
                          at least 0; 0 for no wrap. A ball of this radius does not pass holes that
                          are smaller than it. At least a thousandth of the diagonal of the bounding
                          box is used.}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{wrap_offset}
    \cgalParamDescription{How far from the surface the wrap is, in mean edges, more than 0.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.1}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was done, and how far the surface is from what it was
\throws Invalid_surface_error if coordinates are not finite, indices
        are wrong, there are no triangles, or nothing helps; if `open`, a hole may be too large.
        The surface is unchanged then.
\throws Error if a parameter is out of range, or the mean edge is less
        than 1e-30 or the extent more than 1e30. The surface is unchanged then.

n log n in the number of triangles, plus the square of the edges of holes, and the wrap.
*/
template <class Point, class NP = parameters::Default_named_parameters>
Surface_repair_report_3 repair_surface_3(Labelled_surface_3<Point>& surface,
                                         const NP& np = parameters::default_values()) {
  return repair_surface_3(surface, internal::repair_options(np));
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Replaces a surface by its alpha wrap, even if it bounds a solid. Where surfaces nearly meet, a
tetrahedralizer may fail on the surface and succeed on the wrap.

\tparam Point a point type with `double` coordinates, as that of `Labelled_surface_3`

\param surface is replaced by the wrap
\param options `wrap_alpha` and `wrap_offset` are used

\return the distances to the input, and the alpha and the offset of the wrap

\throws Invalid_surface_error if coordinates are not finite, indices
        are wrong, there are no triangles, or the wrap does not bound a solid
\throws Error if `wrap_alpha` is 0, an option is out of range, CGAL
        cannot wrap the surface, or the mean edge is less than 1e-30 or the extent more than 1e30.
        The surface is unchanged if an exception is thrown.
*/
template <class Point>
Surface_repair_report_3 wrap_surface_3(Labelled_surface_3<Point>& surface,
                                       const Surface_repair_options_3& options = {}) {
  if (options.wrap_alpha == 0)
    throw Error("the alpha of a wrap is 0: use more than 0");
  internal::Surface_repairer_3 repairer(internal::soup_of(surface), options);
  repairer.run_wrap();
  internal::assign(surface, repairer.soup());
  return repairer.report();
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_REPAIR_SURFACE_3_H
