// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REPAIR_SURFACE_3_H
#define CGAL_REPAIR_SURFACE_3_H

#include <CGAL/Deformable_simplicial_complex_3/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complex_3/Surface_repair_report_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/repair/Surface_repairer_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/parameters/repair_options.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a surface bound a solid, as `make_deformable_simplicial_complex_3()` asks for, if it nearly
does. Steps that change more and more are done until that is so, and no more than these:

- equal points are merged, triangles without area removed, and of triangles with the same corners
all but one, or all if they are a wall between parts that touch;
- points of borders that are nearer to each other than a thousandth of the mean edge, and a tenth of
  the edges there, become one;
- holes are filled, unless their border is long: then the surface is a sheet that bounds nothing;
- triangles that cross are removed together with their neighborhood, and the holes filled, if the
  result is nowhere more than two mean edges from them;
- all is replaced by an alpha wrap, which is closed whatever is wrong inside; voids are filled.

CGAL's polygon mesh processing and alpha wrapping do the work.

\tparam Point a point type with `double` coordinates, as that of `Labelled_surface_3`
\tparam NP a sequence of named parameters

\param surface is replaced by the repaired one, unless it bounds a solid: then it stays bit for bit
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
    \cgalParamDescription{The diameter of the ball that rolls around, in mean edges of the surface,
                          at least 0; 0 for no wrap. Not less than a thousandth of the diagonal of
                          the bounding box is used.}
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
\throws Deformable_simplicial_complexes::Invalid_surface_error if coordinates are not finite, indices
        are wrong, there are no triangles, or nothing helps; if `open`, a hole may be too large.
        The surface is unchanged then.
\throws Deformable_simplicial_complexes::Error if a parameter is out of range, or the mean edge is less
        than 1e-30 or the extent more than 1e30. The surface is unchanged then.

n log n in the number of triangles, plus the square of the edges of holes, and the wrap.
*/
template <class Point,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Surface_repair_report_3
repair_surface_3(Labelled_surface_3<Point>& surface,
                 const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  internal::Triangle_soup_3 soup;
  for (const Point& p : surface.points)
    soup.points.push_back(internal::coordinates(p));
  soup.triangles = surface.triangles;
  internal::Surface_repairer_3 repairer(std::move(soup), internal::repair_options(np));
  repairer.run();
  if (!repairer.report().was_sound()) {
    surface.points.clear();
    for (const auto& p : repairer.soup().points)
      surface.points.push_back(Point(p[0], p[1], p[2]));
    surface.triangles = repairer.soup().triangles;
  }
  return repairer.report();
}

} // namespace CGAL

#endif // CGAL_REPAIR_SURFACE_3_H
