// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CUT_LOCI_2_CUT_LOCUS_2_H
#define CGAL_CUT_LOCI_2_CUT_LOCUS_2_H

#include <CGAL/Cut_loci_2/Riemannian_metric_2.h>
#include <CGAL/Cut_loci_2/Sphere_like_surface_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_arcs_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_certificate_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Cut_circle_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_equations_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesic_fan_2.h>
#include <CGAL/Cut_loci_2/internal/geodesics/Geodesics_2.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/Torus_domain.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgCutLoci2Ref
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
  /// whether it leaves a disk of the surface, ends in conjugate points only, and no vertex is in
  /// doubt; if not, the spacing or the step is too large, or the longest distance too short
  bool is_complete = false;
  /// vertices that are in doubt: shooting from the point in 512 directions leads to them earlier,
  /// or their geodesics do not arrive
  std::vector<std::size_t> doubtful;
};

namespace internal {

template <class Metric>
Cut_locus_2 cut_locus_of_geodesics(const Geodesics_2<Metric>& geodesics,
                                   const Torus_domain<2>& domain, double spacing, double step,
                                   double longest_distance) {
  static constexpr double coarsest = 1. / 20; // period
  static constexpr double shortest = 1e-3;    // of the longest step
  const double longest_step = geodesics.shortest(spacing);
  if (!(spacing > 0 && spacing <= coarsest * (std::min)(domain.periods()[0], domain.periods()[1])))
    throw Error("the spacing is out of range: use at most a twentieth of the periods");
  if (!(step >= shortest * longest_step && std::isfinite(step)))
    throw Error("the step of the geodesics is out of range: use about half the spacing, as long as "
                "that is on the surface");
  if (!(longest_distance > 0))
    throw Error("the longest distance is not positive");
  const Progress_phase phase("looking for the cut locus");
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

Finds the cut locus of a point, in a chart that is a flat torus. A fan of geodesics goes from the
point in all directions, until shorter ones lead to where they are. Each direction has a partner,
whose geodesic meets its own in the cut point at the same length; Newton's method finds it. Along
the circle of directions, partners change continuously but at junctions, where three geodesics or
more meet, and at ends, the nearest conjugate points. So the circle, glued, is the cut locus, and
what it leaves of the torus is a disk. In the end, all vertices are checked by shooting in other
directions, and those that are reached earlier are reported.

\param metric model of `RiemannianMetric_2`, which repeats itself with the torus
\param domain the torus
\param point in the chart
\param spacing the longest edges of the cut locus in the chart, about
\param step by how much geodesics of the fan advance at once, and their largest distance, about, on
       the manifold; half the spacing, measured at the point, is a good choice; at least a
       thousandth of the spacing, and at most the spacing is used
\param longest_distance geodesics go no farther: what they would meet beyond is not found

\return the cut locus: a single vertex without edges if all directions meet in one point. See
        `Cut_locus_2::is_complete`.

\throws Error if the metric is not positive at the point or on the
        way of a geodesic, or a parameter is out of its range

Arcs may be missed if they are shorter than steps. Takes the integration of some geodesics for each
point.
*/
template <class Metric>
Cut_locus_2 cut_locus_2(const Metric& metric, const Torus_domain<2>& domain,
                        const Simple_cartesian<double>::Point_2& point, double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  return internal::cut_locus_of_geodesics(internal::Geodesics_2<Metric>(metric, domain, point),
                                          domain, spacing, step, longest_distance);
}

/*!
\ingroup PkgCutLoci2Ref

Finds the cut locus of a point of a closed surface without holes, such as an ellipsoid, as above: it
is a tree.

\param surface and the point: its source
\param spacing the longest edges of the cut locus in the chart of the surface, whose width is 8,
       about
\param step by how much geodesics of the fan advance at once, as above; the spacing is measured
       opposite to the point
\param longest_distance geodesics go no farther

\return the cut locus, as above: of a sphere, a single vertex

\throws Error if the metric is not positive at the point or on the
        way of a geodesic, or a parameter is out of its range
*/
template <class Embedding, template <class> class Differentiated>
Cut_locus_2 cut_locus_2(const Sphere_like_surface_2<Embedding, Differentiated>& surface,
                        double spacing, double step,
                        double longest_distance = std::numeric_limits<double>::infinity()) {
  using Surface = Sphere_like_surface_2<Embedding, Differentiated>;
  return internal::cut_locus_of_geodesics(internal::Geodesics_2<Surface>(surface), surface.domain(),
                                          spacing, step, longest_distance);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_CUT_LOCI_2_CUT_LOCUS_2_H
