// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <algorithm>
#include <utility>
#include <vector>

/// \file
/// Models of `TopologyControl`: values of the parameter `topology_control()`, which permit or
/// forbid changes of the topology of the interface.

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that permits all changes: components of a phase may merge, split, appear and
/// vanish. This is the default.
/// \cgalModels{TopologyControl}
struct Allow_topology_changes
{
  /// Returns true.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle /*cell*/,
                  typename Complex::Label /*label*/) const {
    return true;
  }
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that forbids all changes: the Betti numbers of each phase and of the interface
/// stay the same. Vertices that would have to pass through another part of the interface do not
/// reach their destinations.
/// \cgalModels{TopologyControl}
struct Forbid_topology_changes
{
  /// Returns false.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle /*cell*/,
                  typename Complex::Label /*label*/) const {
    return false;
  }
};

/// \ingroup PkgDeformableSimplicialComplexesRef
/// Topology control that permits changes only where space passes from one label of a given pair to
/// the other, in either direction.
/// \cgalModels{TopologyControl}
class Allow_topology_changes_between
{
public:
  /// Constructs the control.
  /// \param pairs pairs of labels; the order in a pair does not matter
  explicit Allow_topology_changes_between(std::vector<std::pair<int, int>> pairs)
      : m_pairs(std::move(pairs)) {}

  /// Returns whether the label of the cell and the new label are one of the pairs.
  template <class Complex>
  bool operator()(const Complex& /*complex*/, typename Complex::Cell_handle cell,
                  typename Complex::Label label) const {
    const auto is_pair = [&](const std::pair<int, int>& pair) {
      return pair == std::pair<int, int>(cell->subdomain_index(), label) ||
             pair == std::pair<int, int>(label, cell->subdomain_index());
    };
    return std::any_of(m_pairs.begin(), m_pairs.end(), is_pair);
  }

private:
  std::vector<std::pair<int, int>> m_pairs;
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

What happens if a destination of the interface is outside the domain, a box. The sides of the box
are walls for an interface that touches them: its vertices stop there, whatever the rule is.
*/
enum class Domain_rule {
  refuse, ///< an `Invalid_destination_error` is thrown before anything changes
  grow, ///< the box is enlarged by `grow_domain()`, so handles are invalidated; a deformation whose
        ///< destinations are given cannot do this and refuses
  stop  ///< vertices stop at the sides
};

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Options of `deform_interface()`. The named parameters of that function have the same names. "The
paper" is the one by Misztal and B&aelig;rentzen \cgalCite{cgal:mb-taitd-12}.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Deformation_options
{
  using Vertex_handle = typename Complex::Vertex_handle; ///< a vertex
  using Cell_handle = typename Complex::Cell_handle;     ///< a cell
  using Label = typename Complex::Label;                 ///< a label
  using Point = typename Complex::Point;                 ///< a position
  /// a function that permits or forbids a change of topology, see `TopologyControl`
  using Topology_control = std::function<bool(const Complex&, Cell_handle, Label)>;

  /// Largest number of passes. Two passes without progress end the deformation earlier.
  unsigned maximum_number_of_passes = 20;
  /// Moved cells of lower quality are improved, in [0, 1]. The mesh must only permit the motion of
  /// the interface; a greater value costs time and remeshes more cells.
  double quality_threshold = .2;
  /// A cell of lower quality that is trapped by the interface may join the other phase, if its
  /// quality is not higher with the interface at its destinations; in [0, 1]. Around vertices that
  /// make no progress, only the quality at the destinations counts. With 0, no cell is relabeled.
  /// The value of the paper.
  double relabeling_threshold = .01;
  /// Cells with a dihedral angle, in degrees, below this bound or above its supplement are removed
  /// at the end if they are below the quality threshold; in [0, 30]. Cells at parts of the
  /// interface that stayed or moved rigidly are not removed. Trapped cells may join another phase,
  /// as with `relabeling_threshold`. In all other cases, the topology stays. The interface then
  /// moves by the cell, or by a volume of at most a tenth of the cube of the mean edge length
  /// there. Or one of its vertices that moved is displaced by at most a twentieth of that length.
  /// If this is not sufficient, the bounds are up to five times as large. In the plane, triangles
  /// with a smaller angle are removed, and the interface does not change. With 0, vertices that
  /// have arrived stay in place.
  double minimum_angle = 5;
  /// Facets of the interface whose smallest angle falls below this bound, in degrees, are removed
  /// where this improves the mesh around them; in [0, 30]. Each removal changes the interface, so
  /// only facets that would soon block the motion are removed. With 0, no facet is removed because
  /// of its angles. Facets that keep vertices from their destinations are then removed only from
  /// the third pass on. The bound has no effect on `minimum_angle` and `relabeling_threshold`.
  double minimum_facet_angle = 5;
  /// Whether the boundary of each phase stays a manifold. If relabeling a cell would make it
  /// non-manifold, other cells are relabeled, too, or the cell keeps its label, see
  /// `propose_manifold_relabeling()`. If the boundary is non-manifold at the beginning, the number
  /// of non-manifold vertices does not increase.
  bool manifold_interface = false;
  /// What happens if a destination is outside the domain, a box, and the interface does not touch
  /// its sides.
  Domain_rule domain_rule = Domain_rule::stop;
  /// Order of the vertices that are moved one by one: if true, by the time at which their stars
  /// would first have a flat cell; otherwise, the order of storage. The rational arithmetic takes
  /// some microseconds for each cell around these vertices.
  bool collision_order = false;
  /// Called before each change of the topology of a phase and of the interface; it permits or
  /// forbids the change. As a named parameter, a model of `TopologyControl`, by default
  /// `Allow_topology_changes`. If empty, all are permitted.
  Topology_control topology_control;
  /// The energy that decides which label a trapped cell gets, and whether neighbors are exchanged.
  /// Energy densities have no effect. The default is the measure of the interface.
  Interface_energy interface_energy;
  /// Flow of space: the destinations of vertices, in their order. As a named parameter, it is
  /// `Point flow(Point p)` or `Point flow(Vertex_handle v)`, in
  /// the coordinates of the complex. Free vertices follow the flow. If the whole interface follows
  /// it, but the boundary of a box would move, the flow fades to zero towards the boundary. If the
  /// interface or the boundary deviates from the flow, the harmonic extension of the deviation is
  /// added. The flow is used in the first pass only, in which most deformations end. Where it is
  /// not finite, or its displacement is more than 100 times as long as the longest displacement of
  /// the interface, it is unknown. Free vertices then follow the harmonic extension of the known
  /// displacements. If empty, it is unknown everywhere.
  std::function<std::vector<Point>(const std::vector<Vertex_handle>&)> flow;
  /// Whether all free vertices with a finite destination follow the flow in the first pass, however
  /// far they move. No named parameter. No effect without `flow`.
  bool flow_moves_all = false;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;
  /// Visitor of the changes; it must outlive the deformation. None if
  /// null.
  Deformation_visitor<Complex>* visitor = nullptr;

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
  using Point = typename Complex::Point;
  using Vertex_handle = typename Complex::Vertex_handle;
  static constexpr bool is_of_points = std::is_invocable_r<Point, const Flow&, Point>::value,
                        is_of_vertices =
                            std::is_invocable_r<Point, const Flow&, Vertex_handle>::value;
  static_assert(is_of_points || is_of_vertices,
                "a flow is a function of points or of vertices: Point flow(Point p) const");
  return [&complex, flow](const std::vector<Vertex_handle>& vertices) {
    static_cast<void>(complex); // flows of vertices do not use it
    std::vector<Point> result;
    result.reserve(vertices.size());
    for (Vertex_handle v : vertices)
      if constexpr (is_of_points)
        result.push_back(flow(complex.position(v)));
      else if constexpr (is_of_vertices)
        result.push_back(flow(v));
    return result;
  };
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Replaces the options that are given as named parameters, as `read_parameters()` without a complex
does, and the flow. The visitor is not replaced, because an object must own it.

\param complex the complex, which must outlive the options
\param np the named parameters
\param options a `Deformation_options`, or options of another function of complexes
\throws Error if a count is negative. Other ranges are not checked.
*/
template <class Complex, class NamedParameters, class Options>
void read_parameters(const Complex& complex, const NamedParameters& np, Options& options) {
  using internal_np::flow_t;
  internal::Named_parameter_check<decltype(internal::find_untaken<Options>(np)), Options>();
  read_parameters<flow_t, internal_np::visitor_t>(np, options);
  if constexpr (is_given<NamedParameters, flow_t> && internal::is_option<flow_t, Options>())
    internal::visit_option<flow_t>(options, [&](const char*, auto& flow) {
      flow = internal::flow_of_vertices(complex, parameter(np, flow_t()));
    });
}

namespace internal {

// Converts to any type, so that an error is followed by no others.
struct Any_result
{
  template <class T> operator T() const;
};

// Calls a function with the options and the visitor that named parameters give, or with given
// options.
// \tparam ConcurrencyTag determines the default number of threads
// \param np named parameters, or options
// \param defaults the options, with the default values
template <class ConcurrencyTag = Sequential_tag, class Complex, class NamedParameters,
          class Options, class Call>
auto call_with_parameters(Complex& complex, const NamedParameters& np, Options defaults,
                          const Call& call) {
  if constexpr (std::is_const<Complex>::value) {
    static_assert(!std::is_const<Complex>::value,
                  "the function changes the complex, which is const");
    return Any_result();
  } else if constexpr (std::is_same<NamedParameters, Options>::value)
    return call(np);
  else if constexpr (!is_chain<NamedParameters>) {
    static_assert(is_chain<NamedParameters>, "the last argument is neither a chain of named "
                                             "parameters nor the options of this function");
    return call(std::as_const(defaults));
  } else {
    using internal_np::visitor_t;
    Named_parameter_check<decltype(find_untaken<Options>(np)), Options>();
    Named_parameter_type_check<decltype(find_mistyped<Options, visitor_t, internal_np::flow_t>(np)),
                               Options>();
    visit_option<internal_np::number_of_threads_t>(defaults, [](const char*, unsigned& number) {
      number = default_number_of_threads<ConcurrencyTag>();
    });
    read_parameters(complex, np, defaults);
    if constexpr (is_given<NamedParameters, visitor_t>) {
      auto given = parameter(np, visitor_t());
      auto& visitor = unwrap(given);
      static constexpr bool is_visitor =
          std::is_base_of<Deformation_visitor<Complex>,
                          std::remove_reference_t<decltype(visitor)>>::value;
      static_assert(is_visitor,
                    "a visitor derives from Deformation_visitor<Complex>, and is passed "
                    "by std::ref()");
      if constexpr (is_visitor)
        visit_option<visitor_t>(defaults, [&](const char*, auto& pointer) { pointer = &visitor; });
      return call(std::as_const(defaults));
    } else
      return call(std::as_const(defaults));
  }
}

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_DEFORMATION_OPTIONS_H
