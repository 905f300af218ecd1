// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_TRIANGLE_SOUP_REPAIR_REPAIR_SURFACE_3_H
#define CGAL_TRIANGLE_SOUP_REPAIR_REPAIR_SURFACE_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_options_3.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_report_3.h>
#include <CGAL/Triangle_soup_repair/internal/repair/Surface_repairer_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

template <class Point> Triangle_soup_3 soup_of(const Labeled_surface_3<Point>& surface) {
  Triangle_soup_3 soup;
  for (const Point& p : surface.points)
    soup.points.push_back(coordinates(p));
  soup.triangles = surface.triangles;
  return soup;
}

template <class Point> void assign(Labeled_surface_3<Point>& surface, const Triangle_soup_3& soup) {
  surface.points.clear();
  for (const Coordinates_3& p : soup.points)
    surface.points.push_back(Point(p[0], p[1], p[2]));
  surface.triangles = soup.triangles;
}

} // namespace internal

/*!
\ingroup PkgTriangleSoupRepairRef

Makes a surface bound a solid, as the overload below does. Only this overload has the options
`merge_distance` and `longest_border`. If `merge_distance` is positive, near vertices are merged
first, even if the surface bounds a solid.
*/
template <class Point>
Surface_repair_report_3 repair_surface_3(Labeled_surface_3<Point>& surface,
                                         const Surface_repair_options_3& options) {
  internal::Surface_repairer_3 repairer(internal::soup_of(surface), options);
  repairer.run();
  if (!repairer.report().was_sound())
    internal::assign(surface, repairer.soup());
  return repairer.report();
}

/*!
\ingroup PkgTriangleSoupRepairRef

Makes a surface bound a solid if it nearly does, as `make_deformable_simplicial_complex_3()`
requires. The following steps are done in this order until the surface bounds a solid:

- Equal points are merged, and triangles without area are removed. Of triangles with the same
  corners, one is kept; none is kept if the triangles are a wall between components that touch.
- Boundary vertices are stitched if their distance is less than a thousandth of the mean edge and a
  tenth of the boundary edges at them.
- T-junctions are closed: a boundary edge is split at a boundary vertex near it. The distance of the
  vertex from the edge must be less than a thousandth of that edge and of the shortest boundary edge
  at the vertex.
- Fins are removed: triangles with a boundary edge that are attached to an otherwise closed surface.
  They stay if they extend farther than two mean edge lengths from the surface.
- Holes are filled. If a border is too long, an exception is thrown, since the surface is a sheet,
  not a solid with a hole.
- Intersecting and self-intersecting components are united. Triangles are split where they
  intersect, with exact arithmetic, and triangles that do not bound the union are removed. A closed
  component inside an odd number of other components that does not intersect them stays a cavity.
  Walls inside a solid are removed. The step is omitted if it would remove triangles outside the
  solid at a distance of more than two mean edge lengths.
- The surface is replaced by an alpha wrap, which is closed and has no self-intersections; cavities
  are filled.

All lengths are relative: if a surface is scaled by a power of two, the result is the same, scaled.
CGAL's Polygon Mesh Processing and 3D Alpha Wrapping are used. n log n in the number of triangles,
plus the square of the number of edges of holes, plus the wrap.

\tparam Point a point type with `double` coordinates, such as that of `Labeled_surface_3`
\tparam NP a sequence of named parameters

\param surface the surface; it is replaced by the repaired surface, and unchanged if it already
       bounds a solid
\param np named parameters with the names of the members of `Surface_repair_options_3`:
       `largest_hole`, `wrap_alpha` and `wrap_offset`

\return the numbers of changes, and the distances between the input and the result
\throws Invalid_surface_error if coordinates are not finite, indices are wrong, there are no
        triangles, or the surface cannot be repaired; if the reason is `open`, a hole may be too
        large. The surface is then unchanged.
\throws Error if a parameter is out of range, or the mean edge is less than 1e-30 or the extent more
        than 1e30. The surface is then unchanged.

*/
template <class Point, class NP = parameters::Default_named_parameters>
Surface_repair_report_3 repair_surface_3(Labeled_surface_3<Point>& surface,
                                         const NP& np = parameters::default_values()) {
  Surface_repair_options_3 options;
  read_parameters(np, options);
  return repair_surface_3(surface, options);
}

/*!
\ingroup PkgTriangleSoupRepairRef

Replaces a surface by its alpha wrap, even if it bounds a solid. If surfaces nearly meet, a
tetrahedralizer may fail for the surface and succeed for the wrap.

\tparam Point a point type with `double` coordinates, such as that of `Labeled_surface_3`

\param surface the surface; it is replaced by the wrap
\param options `wrap_alpha` and `wrap_offset` are used
\return the distances to the input, and the alpha and the offset of the wrap

\throws Invalid_surface_error if coordinates are not finite, indices are wrong, there are no
        triangles, or the wrap does not bound a solid
\throws Error if `wrap_alpha` is 0, an option is out of range, CGAL cannot wrap the surface, or the
        mean edge length is less than 1e-30 or the extent more than 1e30. The surface is unchanged
        if an exception is thrown.
*/
template <class Point>
Surface_repair_report_3 wrap_surface_3(Labeled_surface_3<Point>& surface,
                                       const Surface_repair_options_3& options = {}) {
  if (options.wrap_alpha == 0)
    throw Error("the alpha of the wrap is 0: use more than 0");
  internal::Surface_repairer_3 repairer(internal::soup_of(surface), options);
  repairer.run_wrap();
  internal::assign(surface, repairer.soup());
  return repairer.report();
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_TRIANGLE_SOUP_REPAIR_REPAIR_SURFACE_3_H
