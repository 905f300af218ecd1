// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Any_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Domain_rule.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `deform_interface()`. The named parameters of that function have the same names, and
their documentation describes the effects.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Deformation_options
{
  using Vertex_handle = typename Complex::Vertex_handle;         ///< a vertex
  using Cell_handle = typename Complex::Cell_handle;             ///< a cell
  using Label = typename Complex::Label;                         ///< a label
  using Approximate_point = typename Complex::Approximate_point; ///< a position
  /// a function that permits or forbids a change of topology, see `TopologyControl`
  using Topology_control = std::function<bool(const Complex&, Cell_handle, Label)>;

  /// Largest number of passes.
  unsigned maximum_number_of_passes = defaults::maximum_number_of_passes;
  /// Moved cells of lower quality are improved, in [0, 1].
  double quality_threshold = defaults::Quality_threshold::in_motion;
  /// Trapped cells of lower quality may be relabeled, in [0, 1].
  double relabeling_threshold = defaults::relabeling_threshold;
  /// Moved cells with a smaller angle are removed, in degrees, in [0, 30].
  double minimum_angle = defaults::minimum_angle;
  /// Facets of the interface with a smaller angle are removed, in degrees, in [0, 30].
  double minimum_facet_angle = defaults::Minimum_facet_angle::in_motion;
  /// Whether the boundary of each phase stays a manifold.
  bool manifold_interface = false;
  /// What happens if a destination is outside the domain.
  Domain_rule domain_rule = Domain_rule::stop;
  /// Whether vertices that are moved one by one are sorted by the time of their first collision.
  bool collision_order = false;
  /// Permits or forbids changes of topology. If empty, all are permitted.
  Topology_control topology_control;
  /// The energy that changes of topology decrease. Energy densities have no effect. The default is
  /// the measure of the interface.
  Interface_energy interface_energy;
  /// Returns the destinations of vertices by the flow of space, in the order of the vertices. If
  /// empty, free vertices follow the extension of the displacement.
  std::function<std::vector<Approximate_point>(const std::vector<Vertex_handle>&)> flow;
  /// Whether all free vertices with a finite destination follow the flow in the first pass, however
  /// far they move. Otherwise, only vertices near the moving interface do, and displacements that
  /// are much longer than those of the interface are ignored. No effect without `flow`.
  bool flow_moves_all = false;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = defaults::number_of_threads;
  /// Visitor of the changes, such as a `Visitor_adaptor`; it must outlive the deformation. None if
  /// null.
  Any_visitor<Complex>* visitor = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    require_quality(quality_threshold);
    require_quality(relabeling_threshold);
    require_angle(minimum_angle, 30, "minimum angle");
    require_angle(minimum_facet_angle, 30, "minimum facet angle");
  }

  /// Forbids all changes of topology, and relabeling.
  void forbid_topology_changes() {
    topology_control = [](const Complex&, Cell_handle, Label) { return false; };
    relabeling_threshold = 0;
  }

  /// Turns off relabeling, and all remeshing that is not necessary for the motion.
  void preserve_mesh() {
    quality_threshold = relabeling_threshold = minimum_angle = minimum_facet_angle = 0;
  }
};

namespace internal {

// Returns the flow of a named parameter as a function of vertices. The given flow is a function of
// points or of vertices.
template <class Complex, class Flow>
auto flow_of_vertices(const Complex& complex, const Flow& flow) {
  using Point = typename Complex::Approximate_point;
  using Vertex_handle = typename Complex::Vertex_handle;
  return [&complex, flow](const std::vector<Vertex_handle>& vertices) {
    std::vector<Point> result;
    result.reserve(vertices.size());
    for (Vertex_handle v : vertices)
      if constexpr (std::is_invocable<const Flow&, Point>::value)
        result.push_back(flow(complex.position(v)));
      else
        result.push_back(flow(v));
    return result;
  };
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Replaces the options that are given as named parameters. The visitor is not replaced, because an
object must own it, see `visitor_parameter()`.

\param complex the complex, which must outlive the options
\param np named parameters of `deform_interface()`
\param options the options, with the default values
\throws Error if a count is negative. Other ranges are not checked.
*/
template <class Complex, class NamedParameters>
void read_parameters(const Complex& complex, const NamedParameters& np,
                     Deformation_options<Complex>& options) {
  namespace tags = internal_np;
  replace_count(np, tags::maximum_number_of_passes, "maximum_number_of_passes",
                options.maximum_number_of_passes);
  replace_value(np, tags::quality_threshold, options.quality_threshold);
  replace_value(np, tags::relabeling_threshold, options.relabeling_threshold);
  replace_value(np, tags::minimum_angle, options.minimum_angle);
  replace_value(np, tags::minimum_facet_angle, options.minimum_facet_angle);
  replace_value(np, tags::manifold_interface, options.manifold_interface);
  replace_value(np, tags::domain_rule, options.domain_rule);
  replace_value(np, tags::collision_order, options.collision_order);
  replace_value(np, tags::topology_control, options.topology_control);
  replace_value(np, tags::interface_energy, options.interface_energy);
  replace_count(np, tags::number_of_threads, "number_of_threads", options.number_of_threads);
  if constexpr (is_given<NamedParameters, tags::flow_t>)
    options.flow = internal::flow_of_vertices(complex, parameter(np, tags::flow));
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H
