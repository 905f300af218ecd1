// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/deform.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>
#include <CGAL/Deformable_simplicial_complexes/topology_control.h>

#include <vector>

namespace CGAL::Deformable_simplicial_complexes {
/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the interface as `deform_interface()` with named parameters does.

\throws Error if an option is out of its range, see `Deformation_options::check()`
*/
template <class Complex, class Destination>
Deformation_report<Complex> deform_interface(Complex& dsc, const Destination& destination,
                                             const Deformation_options<Complex>& options) {
  const std::vector<typename Complex::Vertex_handle> vertices = dsc.interface_vertices();
  std::vector<typename Complex::Approximate_point> destinations;
  destinations.reserve(vertices.size());
  for (auto v : vertices)
    destinations.push_back(dsc.approximate(destination(v)));
  return internal::deform(dsc, vertices, destinations, options);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the vertices of the interface to destinations (Algorithm 1 of the paper). No cell is ever
inverted, and the mesh is improved during the motion. Components of phases may merge or split where
parts of the interface meet.

Each pass does the following:
- it moves all vertices at once as far as no cell inverts; free vertices follow the harmonic
  extension of the displacement;
- it moves the vertices that did not arrive one by one (Algorithm 2);
- it relabels cells that were flattened between two parts of the interface;
- it removes cells and facets that keep vertices from their destinations, and facets whose angles
  became small;
- it improves cells whose quality became low.

\param dsc the complex
\param destination function object `Point destination(Vertex_handle v)`, called once for each vertex
       of the interface, in the coordinates of the complex. A vertex on a side of the domain moves
       to the nearest point of that side. A destination outside the domain, a box, is replaced by
       the nearest point of the box: the interface stops there, and the report counts it.
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{maximum_number_of_passes}
    \cgalParamDescription{largest number of passes; two passes without progress end the deformation
                          earlier}
    \cgalParamType{`unsigned int`} \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{moved cells of lower quality are improved, in [0, 1]}
    \cgalParamType{`double`} \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{relabeling_threshold}
    \cgalParamDescription{a cell of lower quality that is trapped by the interface may join the
                          other phase, if its quality is not higher with the interface at its
                          destinations; in [0, 1]. Around vertices that make no progress, only the
                          quality at the destinations counts. With 0, no cell is relabeled.}
    \cgalParamType{`double`} \cgalParamDefault{0.01, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_angle}
    \cgalParamDescription{cells with a dihedral angle, in degrees, below this bound or above its
                          supplement are removed at the end if they are below the quality threshold.
                          Cells at parts of the interface that stayed or moved rigidly are not
                          removed. Trapped cells may join another phase, as with
                          `relabeling_threshold`. In all other cases, the topology stays. The
                          interface then moves by the cell, or by a volume of at most a tenth of the
                          cube of the mean edge length there. Or one of its vertices that moved is
                          displaced by at most a twentieth of that length. If this is not
                          sufficient, the bounds are up to five times as large. In 2D, triangles
                          with a smaller angle are removed, and the interface does not change. In
                          [0, 30]; with 0, vertices that have arrived stay in place.}
    \cgalParamType{`double`} \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_facet_angle}
    \cgalParamDescription{facets of the interface whose smallest angle falls below this bound, in
                          degrees, are removed where this improves the mesh around them; in [0, 30].
                          With 0, no facet is removed because of its angles. Facets that keep
                          vertices from their destinations are then removed only from the third pass
                          on. The bound has no effect on `minimum_angle` and
                          `relabeling_threshold`.}
    \cgalParamType{`double`} \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{flow}
    \cgalParamDescription{flow of space: the destination of a point or of a vertex. Free vertices
                          follow the flow. If the whole interface follows the flow, but the boundary
                          of a box would move, the flow fades to zero towards the boundary. If the
                          interface or the boundary deviates from the flow, the harmonic extension
                          of the deviation is added. The flow is used in the first pass only, in
                          which most deformations end. Where it is not finite, or its displacement
                          is more than 100 times as long as the longest displacement of the
                          interface, it is unknown. Free vertices then follow the harmonic extension
                          of the known displacements.}
    \cgalParamType{function object `Approximate_point flow(Approximate_point p)` or
                   `Approximate_point flow(Vertex_handle v)`, in the coordinates of the complex}
    \cgalParamDefault{none: free vertices follow the extension of the displacement}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{number of threads if linked with TBB; the result does not depend on it}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{topology_control}
    \cgalParamDescription{called before each change of the topology of a phase and of the interface;
                          it permits or forbids the change}
    \cgalParamType{model of `TopologyControl`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Allow_topology_changes`}
  \cgalParamNEnd
  \cgalParamNBegin{interface_energy}
    \cgalParamDescription{the energy that decides which label a trapped cell gets, and whether
                          neighbors are exchanged; energy densities have no effect}
    \cgalParamType{`Interface_energy`} \cgalParamDefault{the measure of the interface}
  \cgalParamNEnd
  \cgalParamNBegin{manifold_interface}
    \cgalParamDescription{whether the boundary of each phase stays a manifold. If relabeling a cell
                          would make it non-manifold, other cells are relabeled, too, or the cell
                          keeps its label, see `propose_manifold_relabeling()`. If the boundary is
                          non-manifold at the beginning, the number of non-manifold vertices does
                          not increase.}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{domain_rule}
    \cgalParamDescription{what happens if a destination is outside the domain, a box, and the
                          interface does not touch its sides}
    \cgalParamType{`Domain_rule`}
    \cgalParamDefault{`Domain_rule::stop`; `Domain_rule::refuse` for `advect_interface()`}
  \cgalParamNEnd
  \cgalParamNBegin{collision_order}
    \cgalParamDescription{order of the vertices that are moved one by one: if true, by the time at
                          which their stars would first have a flat cell; otherwise, the order of
                          storage. The rational arithmetic takes some microseconds for each cell
                          around these vertices.}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{visitor that is called at each change of the mesh and may end the
                          deformation}
    \cgalParamType{model of `DeformationVisitor`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Deformation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the vertices that did not arrive with their remaining distances, and the changes of labels
        and mesh
\throws Invalid_destination_error if a destination is not finite, or not permitted by the rule of
        the domain; the complex is then unchanged
\throws Error if a parameter is out of its range, or there is an interface, but no
        `dsc.mean_interface_edge()`; the complex is then unchanged

After an exception of the visitor or of `interface_energy`, the complex is valid.
*/
template <class Complex, class Destination,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> deform_interface(Complex& dsc, const Destination& destination,
                                             const NamedParameters& np = NamedParameters()) {
  auto visitor = visitor_parameter<Complex>(np);
  Deformation_options<Complex> options;
  options.visitor = &visitor.any();
  read_parameters(dsc, np, options);
  return deform_interface(dsc, destination, options);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the interface as `deform_interface_to()` with named parameters does.

\throws Error if an option is out of its range, see `Deformation_options::check()`
*/
template <class Complex>
Deformation_report<Complex>
deform_interface_to(Complex& dsc, const Interface_vertices<Complex>& interface_,
                    const std::vector<typename Complex::Approximate_point>& destinations,
                    const Deformation_options<Complex>& options) {
  if (destinations.size() != interface_.vertices.size())
    throw Invalid_destination_error("the number of destinations differs from the number of "
                                    "interface vertices: give one destination for each vertex",
                                    {});
  return internal::deform(dsc, interface_.vertices, destinations, options);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the interface as `deform_interface()` does, with destinations in the order of a snapshot.

\param dsc the complex
\param interface_ the interface of the complex, or its vertices
\param destinations one for each vertex of the snapshot, in the coordinates of the complex
\param np the named parameters of `deform_interface()`
\return the report of `deform_interface()`
\pre the complex has not changed since the snapshot was taken
\throws Invalid_destination_error if a destination is not finite or their number is wrong
\throws Error as `deform_interface()` does
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex>
deform_interface_to(Complex& dsc, const Interface_vertices<Complex>& interface_,
                    const std::vector<typename Complex::Approximate_point>& destinations,
                    const NamedParameters& np = NamedParameters()) {
  auto visitor = visitor_parameter<Complex>(np);
  Deformation_options<Complex> options;
  options.visitor = &visitor.any();
  read_parameters(dsc, np, options);
  return deform_interface_to(dsc, interface_, destinations, options);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
