// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_CUT_LOCI_2_CUT_LOCUS_2_H
#define CGAL_CUT_LOCI_2_CUT_LOCUS_2_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_arcs_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_circle_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_equations_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_fan_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref

The cut locus of a point of a Riemannian 2-manifold, in its chart: the closure of the set of all
points with two or more shortest geodesics from the point.
*/
struct Cut_locus_2
{
  /// A point of the cut locus.
  struct Vertex
  {
    Epick::Point_2 point;     ///< in the chart, in the box of the torus
    double distance;          ///< length of the shortest geodesics to the point
    std::size_t multiplicity; ///< number of edges at the vertex. It is the number of shortest
                              ///< geodesics, except at an end: its multiplicity is 1, because two
                              ///< shortest geodesics coincide
  };

  std::vector<Vertex> vertices; ///< in no particular order, but deterministic
  /// chains of indices of vertices, from one vertex with a multiplicity other than 2 to the next. A
  /// closed chain begins and ends at the same vertex
  std::vector<std::vector<std::size_t>> polylines;
  /// whether the complement of the cut locus is a disk, all its ends are conjugate points, and no
  /// vertex is doubtful. If it is `false`, the spacing or the step is too large, or the longest
  /// distance is too short
  bool is_complete = false;
  /// vertices that failed the verification: a geodesic in one of 512 directions shows a shorter
  /// path to the vertex, or the geodesics of the vertex do not arrive there
  std::vector<std::size_t> doubtful;
};

namespace internal {

template <class Metric>
Cut_locus_2 cut_locus_of_geodesics(const Geodesics_2<Metric>& geodesics,
                                   const Torus_domain<2>& domain, double spacing, double step,
                                   double longest_distance) {
  static constexpr double coarsest = 1. / 20; // of the smaller period
  static constexpr double shortest = 1e-3;    // of the longest step
  const double longest_step = geodesics.shortest(spacing);
  if (!(spacing > 0 && spacing <= coarsest * (std::min)(domain.periods()[0], domain.periods()[1])))
    throw Error("the spacing is out of range: use at most a twentieth of the periods");
  if (!(step >= shortest * longest_step && std::isfinite(step)))
    throw Error("the step of the geodesics is out of range: use about half the length of the "
                "spacing on the surface");
  if (!(longest_distance > 0))
    throw Error("the longest distance is not positive: use more than 0");
  const Progress_phase phase("computing the cut locus");
  const Geodesic_equations_2<Metric> equations(geodesics, domain, spacing,
                                               (std::min)(step, longest_step));
  const Geodesic_fan_2<Metric> fan(equations, longest_distance);
  const Cut_circle_2<Metric> circle(equations, fan);
  const Cut_arcs_2<Metric> arcs(circle, equations);
  const Progress_phase checking("checking the cut locus");
  Cut_locus_2 result;
  result.doubtful = Cut_certificate_2<Metric>(geodesics, domain, spacing, equations.step())
                        .refuted(arcs.vertices());
  result.is_complete = arcs.is_complete() && result.doubtful.empty();
  result.polylines = arcs.arcs();
  for (const Cut_claim_2& claim : arcs.vertices())
    result.vertices.push_back({claim.point, claim.distance, 0});
  for (const auto& arc : arcs.arcs()) {
    for (std::size_t k = 1; k + 1 < arc.size(); ++k)
      result.vertices[arc[k]].multiplicity = 2;
    ++result.vertices[arc.front()].multiplicity;
    ++result.vertices[arc.back()].multiplicity;
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgCutLoci2Ref

Computes the cut locus of a point, in a chart that is a flat torus.

A fan of geodesics leaves the point in all directions. Each geodesic ends when a shorter geodesic
leads to the same point. Each direction has a partner: their geodesics meet with the same length in
the cut point of the direction. Newton's method finds the cut point. Along the circle of directions,
the partner changes continuously, except at junctions and ends. At a junction, three or more
geodesics meet. An end is the nearest conjugate point of the directions around it. The cut locus is
the circle of directions in which each direction is identified with its partner. Its complement in
the torus is a disk.

At the end, all vertices are verified by geodesics in other directions. A vertex that such a
geodesic reaches earlier is reported.

\param metric the metric, a model of `RiemannianMetric_2`. It has the periods of the torus.
\param domain the torus of the chart
\param point the source, in the chart
\param spacing the approximate length of the longest edges of the cut locus, in the chart. The range
       is (0, p / 20], where p is the smaller period.
\param step the step of the geodesics and the approximate distance between neighboring geodesics, on
       the manifold. Half of the spacing, measured at the point, is a good choice. It must be at
       least a thousandth of the spacing. At most the spacing is used.
\param longest_distance the length at which geodesics end, positive. Parts of the cut locus beyond
       this distance are not found.

\return the cut locus. It is a single vertex without edges if all geodesics meet in one point. See
        `Cut_locus_2::is_complete`.

\throws Error if the metric is not positive definite at the point or on a geodesic, if a parameter
        is out of its range, or if too many geodesics are needed.
\throws Interrupted_error if a callback of a `Progress_scope` returned `false`.

Arcs that are shorter than a step may be missed. The function integrates some geodesics for each
vertex.
*/
template <class Metric>
Cut_locus_2 cut_locus_2(const Metric& metric, const Torus_domain<2>& domain,
                        const Epick::Point_2& point, double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  return internal::cut_locus_of_geodesics(internal::Geodesics_2<Metric>(metric, domain, point),
                                          domain, spacing, step, longest_distance);
}

/*!
\ingroup PkgCutLoci2Ref

Computes the cut locus of a point of a closed surface of genus 0, such as an ellipsoid. The cut
locus is a tree. The method is that of the function above.

\param surface the surface and its source
\param spacing the approximate length of the longest edges of the cut locus, in the chart of the
       surface. The chart has the width 8. The range is (0, 0.4].
\param step the step of the geodesics and the approximate distance between neighboring geodesics, on
       the surface, as above. The spacing is measured opposite to the source.
\param longest_distance the length at which geodesics end, positive

\return the cut locus, as above. The cut locus of a sphere is a single vertex.

\throws Error if the metric is not positive definite at the source or on a geodesic, if a parameter
        is out of its range, or if too many geodesics are needed.
\throws Interrupted_error if a callback of a `Progress_scope` returned `false`.
*/
template <class Embedding, template <class> class Differentiated>
Cut_locus_2 cut_locus_2(const Sphere_like_surface_2<Embedding, Differentiated>& surface,
                        double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  using Surface = Sphere_like_surface_2<Embedding, Differentiated>;
  return internal::cut_locus_of_geodesics(internal::Geodesics_2<Surface>(surface), surface.domain(),
                                          spacing, step, longest_distance);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_CUT_LOCI_2_CUT_LOCUS_2_H
