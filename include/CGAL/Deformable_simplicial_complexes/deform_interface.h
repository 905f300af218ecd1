// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Edge_unit.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/deform.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>
#include <CGAL/Deformable_simplicial_complexes/require_finite.h>
#include <CGAL/Deformable_simplicial_complexes/topology_control.h>

#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// What `deform_interface()` reads from its named parameters, checked.
template <class Complex, class NamedParameters>
Deformation_options<Complex> deformation_options(const Complex& dsc, const NamedParameters& np) {
  namespace tags = internal_np;
  return {quality_parameter(np, tags::quality_threshold, defaults::Quality_threshold::in_motion),
          quality_parameter(np, tags::relabeling_threshold, defaults::relabeling_threshold),
          angle_parameter(np, tags::minimum_angle, defaults::minimum_angle, 30, "smallest angle"),
          angle_parameter(np, tags::minimum_facet_angle, defaults::Minimum_facet_angle::in_motion,
                          30, "smallest angle of a facet"),
          parameter_or(np, tags::manifold_interface, false),
          parameter_or(np, tags::collision_order, false),
          parameter_or(np, tags::topology_control, Allow_topology_changes()),
          space_motion(dsc, CGAL::parameters::get_parameter(np, tags::flow))};
}

// Moves the vertices of the interface, all of them by increasing time stamp, by the named
// parameters of `deform_interface()`.
template <class Complex, class NamedParameters>
Deformation_report<Complex>
deform_by_parameters(Complex& dsc, const std::vector<typename Complex::Vertex_handle>& vertices,
                     const std::vector<typename Complex::Point>& destinations,
                     const NamedParameters& np) {
  namespace tags = internal_np;
  auto visitor = visitor_parameter<Complex>(np);
  const unsigned maximum_number_of_passes =
      count_parameter(np, tags::maximum_number_of_passes, "maximum_number_of_passes",
                      defaults::maximum_number_of_passes);
  const auto options = deformation_options(dsc, np);
  const unsigned number_of_threads = count_parameter(
      np, tags::number_of_threads, "number_of_threads", defaults::number_of_threads);
  require_interface_edge(dsc);
  return deform(dsc, vertices, destinations, options, maximum_number_of_passes, number_of_threads,
                visitor.any(),
                [&](unsigned pass) { return bool(visitor.visitor().go_further(pass)); });
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the vertices of the interface to destinations, without ever inverting a cell, and keeps the
mesh good on the way (Algorithm 1 of the paper). Parts of the interface that meet may merge or
split.

Each pass moves all vertices at once as far as no cell inverts, carrying the free vertices around
along with a harmonic extension of the motion; then the vertices that were held back, one by one
(Algorithm 2); then relabels cells flattened between two parts of the interface, removes what is in
the way of vertices that have not arrived and facets whose angles became small, and improves what
became bad.

\param dsc the complex
\param destination a function object: `Point destination(Vertex_handle v)`, asked once for each
       vertex of the interface, in the coordinates of the complex. A vertex on a side of the domain
       goes to the nearest point of that side. A destination outside the domain, a box, is replaced
       by the nearest point of the box: the interface stops there, and the report counts it.
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{maximum_number_of_passes}
    \cgalParamDescription{bound on the passes; two passes without progress end the deformation earlier}
    \cgalParamType{`unsigned int`} \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{cells that moved and are of lower quality are improved, in [0, 1]}
    \cgalParamType{`double`} \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{relabeling_threshold}
    \cgalParamDescription{quality below which a cell trapped by the interface may join the other
                          phase, if it is no better with the interface at its destinations, in
                          [0, 1]; around vertices that do not get on, only the latter counts. 0
                          relabels nothing.}
    \cgalParamType{`double`} \cgalParamDefault{0.01, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_angle}
    \cgalParamDescription{cells with a dihedral angle, in degrees, below it or above its supplement
                          are removed in the end if they are below the quality threshold, but for
                          those at parts of the interface that stayed or moved as a whole. If
                          trapped, they may join another phase as with `relabeling_threshold`.
                          Else the topology stays; the interface moves by the cell or by a tenth of
                          the cube of the mean edge there at most, or one of its vertices that moved
                          by a twentieth of that edge; by up to five times as much where nothing
                          less helps. In the plane, triangles with a smaller angle; only the mesh
                          beside the interface changes for them. In [0, 30]; 0 leaves what has
                          arrived in place.}
    \cgalParamType{`double`} \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_facet_angle}
    \cgalParamDescription{facets of the interface whose smallest angle shrinks below it, in degrees,
                          are removed where that makes the mesh around them better; in [0, 30]. With
                          0, none is removed for its angles, and those that keep vertices from their
                          destinations only from the third pass on. What `minimum_angle` and
                          `relabeling_threshold` ask for is done none the less.}
    \cgalParamType{`double`} \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{flow}
    \cgalParamDescription{where what is at a point, or a vertex, goes in the deformation: free
                          vertices go there, too. Where the whole interface does, the flow fades
                          towards a boundary of the domain, a box, that it would move; else
                          vertices deviate from it by a harmonic function, as the interface or the
                          boundary do. For the first pass only, in which most deformations end.
                          Where it is not finite, or more than 100 times as long as the longest way
                          of the interface, it counts as unknown: free vertices follow the interface
                          there, and those whose flow is known.}
    \cgalParamType{function object `Approximate_point flow(Approximate_point p)` or
                   `Approximate_point flow(Vertex_handle v)`, in the coordinates of the complex}
    \cgalParamDefault{none: free vertices follow the interface}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{threads to use where linked with TBB; the result does not depend on it}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{topology_control}
    \cgalParamDescription{is asked before a change that alters the topology of a phase and of the
                          interface}
    \cgalParamType{model of `TopologyControl`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Allow_topology_changes`}
  \cgalParamNEnd
  \cgalParamNBegin{manifold_interface}
    \cgalParamDescription{whether the boundary of each phase stays a 2-manifold: cells whose new
                          label would pinch it take others along or keep theirs, see
                          `propose_manifold_relabeling()`. Where it is pinched to begin with, it may
                          stay so, at no more vertices.}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{collision_order}
    \cgalParamDescription{whether vertices that are held back move in the order in which their stars
                          would first have a flat cell, instead of the order of storage. Rational
                          arithmetic takes some microseconds for each cell around them.}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told of each change of the mesh and may end the deformation}
    \cgalParamType{model of `DeformationVisitor`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Deformation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return which vertices did not arrive and how far they stayed, what happened to labels and mesh.
\throws Invalid_destination_error if a destination is not finite;
       the complex is then unchanged. An exception of the visitor leaves a valid complex.
\throws Error if a parameter is out of its range, or there is an
       interface, but no `dsc.mean_interface_edge()`; the complex is then unchanged.
*/
template <class Complex, class Destination,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> deform_interface(Complex& dsc, const Destination& destination,
                                             const NamedParameters& np = NamedParameters()) {
  const std::vector<typename Complex::Vertex_handle> vertices = dsc.interface_vertices();
  std::vector<typename Complex::Point> destinations;
  destinations.reserve(vertices.size());
  for (auto v : vertices)
    destinations.push_back(destination(v));
  return internal::deform_by_parameters(dsc, vertices, destinations, np);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Deforms the interface as `deform_interface()` does, with destinations in the order of a snapshot.

\param dsc the complex
\param interface_ its interface, or the vertices of it. \pre the complex has not changed since
\param destinations one for each vertex of the snapshot, in the coordinates of the complex
\param np the named parameters of `deform_interface()`
\return what that returns
\throws Invalid_destination_error if a destination is not finite
       or their number is wrong; and whatever that throws
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex>
deform_interface_to(Complex& dsc, const Interface_vertices<Complex>& interface_,
                    const std::vector<typename Complex::Approximate_point>& destinations,
                    const NamedParameters& np = NamedParameters()) {
  if (destinations.size() != interface_.vertices.size())
    throw Invalid_destination_error(
        "a destination must be given for each vertex of the interface, no more and no fewer", {});
  require_finite(destinations, "a destination"); // exact numbers could not express it
  std::vector<typename Complex::Point> points;
  points.reserve(destinations.size());
  for (const auto& p : destinations)
    points.push_back(dsc.exact(p));
  return internal::deform_by_parameters(dsc, interface_.vertices, points, np);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
