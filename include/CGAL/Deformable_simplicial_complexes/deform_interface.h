// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/internal/deformation/Interface_deformer.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/local_edge_length.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Does passes of Algorithm 1 until the vertices have arrived and the given cells are improved, the
// maximum number of passes is reached, or `go_further(pass)` returns false. Returns the report.
template <class Complex>
Deformation_report<Complex> do_passes(Interface_deformer<Complex>& deformer,
                                      Deformation_visitor<Complex>& visitor, unsigned maximum) {
  using Seconds = typename Deformation_report<Complex>::Seconds;
  unsigned pass = 0;
  bool is_stopped = false;
  deformer.lap(&Seconds::rest);
  while (deformer.has_work(pass + 1) && deformer.is_progressing() && pass < maximum &&
         !(is_stopped = !visitor.go_further(pass + 1))) {
    ++pass;
    Progress_scope::check();
    deformer.begin_pass(pass);
    deformer.move_together(pass);
    deformer.move_one_by_one();
    deformer.lap(&Seconds::motion);
    deformer.relabel_degenerate_cells(pass);
    deformer.lap(&Seconds::relabeling);
    deformer.remove_obstacles(pass);
    deformer.remove_degenerating_facets();
    deformer.lap(&Seconds::obstacles);
    deformer.improve();
    deformer.lap(&Seconds::improvement);
  }
  if (pass > 0 && !is_stopped) {
    deformer.remove_small_angles(pass);
    deformer.exchange_neighbors();
    deformer.lap(&Seconds::small_angles);
  }
  if (pass > 0)
    deformer.measure_new_spacings();
  Deformation_report<Complex> report = deformer.report(pass);
  report.stopped = is_stopped;
  return report;
}

// Moves interface vertices to their destinations in passes (Algorithm 1). Returns the report.
template <class Complex>
Deformation_report<Complex> deform(Complex& dsc,
                                   const std::vector<typename Complex::Vertex_handle>& vertices,
                                   const std::vector<typename Complex::Point>& destinations,
                                   const Deformation_options<Complex>& options) {
  options.check();
  require_interface_edge(dsc);
  Deformation_visitor<Complex> no_visitor;
  Deformation_visitor<Complex>& visitor = options.visitor ? *options.visitor : no_visitor;
  const Progress_phase phase("moving the interface");
  const For_each_index for_each_index(options.number_of_threads);
  Interface_deformer<Complex> deformer(dsc, visitor, options, for_each_index);
  deformer.set_destinations(vertices, destinations);
  return do_passes(deformer, visitor, options.maximum_number_of_passes);
}

} // namespace internal
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

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param destination function object `Point destination(Vertex_handle v)`, called once for each vertex
       of the interface, in the coordinates of the complex. A vertex on a side of the domain moves
       to the nearest point of that side. A destination outside the domain, a box, is replaced by
       the nearest point of the box: the interface stops there, and the report counts it.
\param np a `Deformation_options`, or named parameters with the names of its members. The parameter
       `visitor` is a `Deformation_visitor`, which may also end the deformation. Function
       objects, a model of `TopologyControl` and a visitor are given by value or by
       `std::reference_wrapper`.

\return the vertices that did not arrive with their remaining distances, and the changes of labels
        and mesh
\throws Invalid_destination_error if a destination is not finite, or not permitted by the rule of
        the domain; the complex is then unchanged
\throws Error if a parameter is out of its range, or there is an interface, but no
        `dsc.mean_interface_edge()`; the complex is then unchanged

After an exception of the visitor or of `interface_energy`, the complex is valid.
*/
template <class ConcurrencyTag = Sequential_tag, class Complex, class Destination,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> deform_interface(Complex& dsc, const Destination& destination,
                                             const NamedParameters& np = NamedParameters()) {
  using Point = typename Complex::Point;
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr bool is_destination =
      std::is_invocable_r_v<Point, const Destination&, Vertex_handle>;
  static_assert(is_destination, "the destination is a function of vertices: "
                                "Point destination(Vertex_handle v) const");
  if constexpr (is_destination)
    return internal::call_with_parameters<ConcurrencyTag>(
        dsc, np, Deformation_options<Complex>(), [&](const auto& options) {
          const std::vector<Vertex_handle> vertices = dsc.interface_vertices();
          std::vector<Point> destinations;
          destinations.reserve(vertices.size());
          for (Vertex_handle v : vertices)
            destinations.push_back(destination(v));
          return internal::deform(dsc, vertices, destinations, options);
        });
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the interface as `deform_interface()` does, with destinations in the order of a snapshot.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param interface_ the interface of the complex, or its vertices
\param destinations one for each vertex of the snapshot, in the coordinates of the complex
\param np a `Deformation_options`, or the named parameters of `deform_interface()`
\return the report of `deform_interface()`
\pre the complex has not changed since the snapshot was taken
\throws Invalid_destination_error if a destination is not finite or their number is wrong
\throws Error as `deform_interface()` does
*/
template <class ConcurrencyTag = Sequential_tag, class Complex,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex>
deform_interface_to(Complex& dsc, const Interface_vertices<Complex>& interface_,
                    const std::vector<typename Complex::Point>& destinations,
                    const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters<ConcurrencyTag>(
      dsc, np, Deformation_options<Complex>(), [&](const auto& options) {
        if (destinations.size() != interface_.vertices.size())
          throw Invalid_destination_error(
              "the number of destinations differs from the number of "
              "interface vertices: give one destination for each vertex",
              {});
        return internal::deform(dsc, interface_.vertices, destinations, options);
      });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORM_INTERFACE_H
