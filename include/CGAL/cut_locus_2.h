// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCUS_2_H
#define CGAL_CUT_LOCUS_2_H

#include <CGAL/Deformable_simplicial_complex_2/Geodesic_front_2.h>
#include <CGAL/Deformable_simplicial_complex_2/Riemannian_metric_2.h>
#include <CGAL/Deformable_simplicial_complex_2/Sphere_like_surface_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Chordal_axis_2.h>
#include <CGAL/Deformable_simplicial_complex_2/internal/geodesics/Cut_graph_2.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref
The cut locus of a point of a Riemannian 2-manifold, in its chart: the closure of the points that
more than one shortest geodesic leads to.
*/
struct Cut_locus_2
{
  /// A point of it.
  struct Vertex
  {
    Simple_cartesian<double>::Point_2 point; ///< of the chart, in the box of the torus
    double distance;                         ///< the length of the shortest geodesics
    std::size_t multiplicity; ///< number of edges that end here: as many shortest geodesics lead to
                              ///< it, but for ends, where two have become one
  };

  std::vector<Vertex> vertices; ///< in no particular order, always the same
  /// chains of vertices, by their indices, between those of other multiplicities than 2; what is
  /// closed begins and ends in the same vertex
  std::vector<std::vector<std::size_t>> polylines;
  /// whether it is connected, leaves a disk of the surface, and ends in conjugate points only; if
  /// not, the spacing or the step is too large, or the front did not go far enough
  bool is_complete = false;
};

namespace Deformable_simplicial_complexes {
namespace internal {

template <class Front>
Cut_locus_2 cut_locus_of_front(Front front, double step, double longest_distance) {
  static constexpr double shortest = 1e-3; // of the longest step
  if (!(step >= shortest * front.longest_step() && std::isfinite(step)))
    throw Error(
        "the step of the front is out of range: use about half the spacing, as long as that "
        "is on the surface");
  if (!(longest_distance > 0))
    throw Error("the longest distance is not positive");
  const Progress_phase phase("looking for the cut locus");
  while (front.radius() < longest_distance && front.advance(step)) {
  }
  const Chordal_axis_2<Front> axis(front);
  return make_cut_locus<Cut_locus_2>(Cut_graph_2(front, axis), front.complex().domain());
}

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Finds the cut locus of a point, in a chart that is a flat torus: a `Geodesic_front_2` goes until all
of it has stopped. From the axis of what is left between its parts, the shortest of all geodesics
near are followed to where two or three are equally long, to rounding, by Newton's method. Arcs meet
where points of two of them share a geodesic. An arc begins at the nearest conjugate point of the
geodesics around its end. What the cut locus leaves of the torus is a disk; edges that would
contradict this are left out.

\param metric model of `RiemannianMetric_2`, which repeats itself with the torus
\param domain the torus
\param point in the chart
\param spacing about how long the edges of the mesh, and of the cut locus, are in the chart
\param step by how much the front advances at once, on the manifold; half the spacing, measured at
       the point, is a good choice; at least a thousandth, and divided if it is more than that
\param longest_distance the front goes no farther: what it would meet beyond is not found

\return nothing at all if the spacing is too large for the arcs. See `Cut_locus_2::is_complete`.

\throws Deformable_simplicial_complexes::Error if the metric is not positive at the point or on the
        way of a geodesic, or a parameter is out of its range

Features of less than a few spacings are not resolved: spurs that are shorter are taken away. Takes
the integration of some geodesics for each point and edge, and is quadratic in the number of points.
*/
template <class Metric>
Cut_locus_2 cut_locus_2(const Metric& metric,
                        const Deformable_simplicial_complexes::Torus_domain<2>& domain,
                        const Simple_cartesian<double>::Point_2& point, double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  return Deformable_simplicial_complexes::internal::cut_locus_of_front(
      Geodesic_front_2<Metric>(metric, domain, point, spacing), step, longest_distance);
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Finds the cut locus of a point of a closed surface without holes, such as an ellipsoid, as above: it
is a tree.

\param surface and the point: its source
\param spacing about how long the edges of the mesh, and of the cut locus, are in the chart of the
       surface, whose width is 8
\param step by how much the front advances at once, more than 0
\param longest_distance the front goes no farther

\return nothing at all if the spacing is too large for the arcs, or the cut locus is a point

\throws Deformable_simplicial_complexes::Error if the metric is not positive at the point or on the
        way of a geodesic, or a parameter is out of its range
*/
template <class Embedding, template <class> class Differentiated>
Cut_locus_2 cut_locus_2(const Sphere_like_surface_2<Embedding, Differentiated>& surface,
                        double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  using Surface = Sphere_like_surface_2<Embedding, Differentiated>;
  return Deformable_simplicial_complexes::internal::cut_locus_of_front(
      Geodesic_front_2<Surface>(surface, spacing), step, longest_distance);
}

} // namespace CGAL

#endif // CGAL_CUT_LOCUS_2_H
