// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_INTERFACE_ADAPTATION_H
#define CGAL_INTERFACE_REMESHING_INTERFACE_ADAPTATION_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_energy.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Interface_remeshing/Curvature_sizing_field.h>
#include <CGAL/Interface_remeshing/Interface_improvement_options.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/internal/interface/Curvature_lengths.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Options of the adaptation of an interface by its curvature.
*/
struct Adaptation_options
{
  /// Bound on the distance between an edge and the smooth surface, in mean edges of the initial
  /// interface; 0 for no adaptation.
  double tolerance;
  /// Edges are sharp if the normals of their facets differ by more, in degrees, in [0, 180].
  double feature_angle;
  /// Whether the interface stays unchanged while most edges have suitable lengths, and while the
  /// motion is rigid.
  bool only_if_worn = true;
  /// Whether junctions of more than three phases are split, in the plane.
  bool splits_junctions = false;
  /// The energy that splits of junctions decrease.
  Interface_energy interface_energy = {};
};

/*!
\ingroup PkgInterfaceRemeshingRef

Constants of the adaptation of an interface.

\tparam dimension dimension of the complex, 2 or 3
*/
template <int dimension> struct Adaptation_rule
{
  /// \name Target edge lengths
  /// Bounds on target edge lengths, in mean edges of the initial interface. The lower bound limits
  /// the refinement at the rims of thin sheets. The upper bound applies to flat parts; curves have
  /// few segments, so it is greater in the plane.
  /// @{
  static constexpr double shortest = .2, ///< lower bound
      longest = dimension == 2 ? 4 : 1;  ///< upper bound
  /// Bound on the difference of the target edge lengths of two neighbors, relative to their
  /// distance, so that facets keep good angles.
  static constexpr double gradation = .5;
  /// @}

  /// \name Operations
  /// Edges that are longer or shorter than these multiples of their target edge length are split or
  /// collapsed. The halves of a split edge are long enough not to be collapsed.
  /// @{
  static constexpr double split = 1.5, ///< longer edges are split
      collapse = .5;                   ///< shorter edges are collapsed
  /// Bound on the volume that one operation sweeps, in cubes of the target edge length, in the
  /// plane in squares. A curve has few segments, so each collapse has a greater effect.
  static constexpr double swept_volume = dimension == 2 ? .01 : .1;
  /// @}

  /// \name Worn interfaces
  /// An interface is worn if the part of its edges that are too long or too short exceeds one of
  /// these bounds. Below the bounds, it stays unchanged, because each operation changes volumes.
  /// @{
  static constexpr double many_long_ones = .015, ///< bound on the part of the long edges
      many_short_ones = .003;                    ///< bound on the part of the short edges
  /// Upper bound on target edge lengths for this test of long edges, as a multiple of the other
  /// upper bound. A flat part that was only stretched does not need more vertices.
  static constexpr double longest_if_flat = 3;
  /// @}
};

/*!
\ingroup PkgInterfaceRemeshingRef

The edges of an interface that are much longer or shorter than their target edge length.

\tparam dimension dimension of the complex, 2 or 3
*/
template <int dimension> struct Interface_wear
{
  std::int64_t edges = 0, ///< number of all edges
      short_ones = 0,     ///< number of edges that are too short
      long_ones = 0;      ///< number of edges that are too long

  /// Counts an edge.
  /// \param length the length of the edge
  /// \param target, target_if_flat the target edge length, with both upper bounds of
  ///        `Adaptation_rule`
  void add(double length, double target, double target_if_flat) {
    ++edges;
    short_ones += length < Adaptation_rule<dimension>::collapse * target;
    long_ones += length > Adaptation_rule<dimension>::split * target_if_flat;
  }

  /// Returns whether there are so many of these edges that the interface is worn.
  bool is_large() const {
    using Rule = Adaptation_rule<dimension>;
    return double(long_ones) > Rule::many_long_ones * double(edges) ||
           double(short_ones) > Rule::many_short_ones * double(edges);
  }
};

/*!
\ingroup PkgInterfaceRemeshingRef

Returns the options of `improve_interface()` that adapt an interface to target edge lengths.
Vertices are not smoothed, and the cells are not optimized; the next deformation does this.

\param field the target edge lengths; it must outlive the options
\param options the options of the adaptation
*/
template <class Complex>
Interface_improvement_options<Complex>
remeshing_options(const Curvature_sizing_field<Complex::dimension>& field,
                  const Adaptation_options& options) {
  using Rule = Adaptation_rule<Complex::dimension>;
  Interface_improvement_options<Complex> result;
  result.sizing_field = std::cref(field);
  result.interface_split_length = Rule::split;
  result.interface_collapse_length = Rule::collapse;
  result.swept_volume = Rule::swept_volume;
  result.curved_splits = true;
  result.aggressiveness = 0;
  result.feature_angle = options.feature_angle;
  result.split_junctions = options.splits_junctions;
  result.interface_energy = options.interface_energy;
  result.quality_threshold = 0; // the deformation optimizes cells
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Returns whether a motion of the vertices changes the length of an edge of the interface. A rigid
motion does not, up to rounding and the errors of time integration. Linear in the size of the
interface.

\param interface_ the snapshot
\param from, to positions of the vertices before and after, in the order of the snapshot
*/
template <class Complex, class Points>
bool is_stretched(const Interface_snapshot<Complex>& interface_, const Points& from,
                  const Points& to) {
  // Relative change of a squared length. It is far above the error of a Runge-Kutta step of a
  // rotation, and far below the effect of a time step that deforms the interface.
  static constexpr double rigid = 1e-6;
  bool result = false;
  internal::for_each_edge_of(interface_.facets(), [&](std::size_t a, std::size_t b) {
    const auto squared_length = [&](const Points& p) {
      return (interface_.domain.nearest_image(p[a], p[b]) - p[a]).squared_length();
    };
    const double before = squared_length(from);
    result = result || std::abs(squared_length(to) - before) > rigid * before;
  });
  return result;
}

/*!
\ingroup PkgInterfaceRemeshingRef

Adaptation of the edges of an interface to its curvature. The target edge length of a vertex keeps
edges within the tolerance of the smooth surface, see `Curvature_sizing_field`.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> class Interface_adaptation
{
public:
  /// Computes the target edge lengths of the vertices. n log n in the size of the interface.
  /// \param complex the complex
  /// \param interface_ its snapshot, which must outlive the object
  /// \param options the options; `only_if_worn` is not used
  /// \pre `options.tolerance` and `complex.mean_interface_edge()` are positive.
  Interface_adaptation(const Complex& complex, const Interface_snapshot<Complex>& interface_,
                       const Adaptation_options& options)
      : m_interface(interface_), m_positions(interface_.positions(complex)),
        m_edge(complex.mean_interface_edge()), m_options(options),
        m_lengths(interface_, m_positions,
                  internal::Smooth_normals<Complex>(interface_, m_positions, options.feature_angle),
                  options.tolerance * m_edge, Rule::shortest * m_edge),
        m_sizes(sizes(Rule::longest)) {}

  /// Returns whether the interface is worn: too many of its edges are much longer than their target
  /// edge length, or much shorter. n log n in the size of the interface.
  bool is_worn() const {
    const std::vector<double> sizes_if_flat = sizes(Rule::longest_if_flat * Rule::longest);
    Interface_wear<Complex::dimension> wear;
    internal::for_each_edge_of(m_interface.facets(), [&](std::size_t a, std::size_t b) {
      wear.add(std::sqrt((m_interface.domain.nearest_image(m_positions[a], m_positions[b]) -
                          m_positions[a])
                             .squared_length()),
               (std::min)(m_sizes[a], m_sizes[b]), (std::min)(sizes_if_flat[a], sizes_if_flat[b]));
    });
    return wear.is_large();
  }

  /// Splits long edges at points of the smooth surface and collapses short edges, by
  /// `improve_interface()`. Vertices are not smoothed, and the cells are not optimized; the next
  /// deformation does this.
  /// \param complex the complex
  /// \param visitor visitor of the changes; none if null
  /// \return the numbers of operations
  /// \pre The complex has not changed since the snapshot.
  /// \throws Error if `improve_interface()` throws it, for example if `options.feature_angle` is
  ///         out of its range; the complex is then unchanged. An exception of the visitor and
  ///         `Interrupted_error` leave a valid complex.
  Improvement_report apply(Complex& complex, Deformation_visitor<Complex>* visitor) const {
    const Curvature_sizing_field<Complex::dimension> field(
        m_positions, m_sizes, Rule::longest * m_edge,
        m_interface.domain.template periods<Complex::dimension>());
    auto options = remeshing_options<Complex>(field, m_options);
    options.visitor = visitor;
    return improve_interface(complex, options);
  }

private:
  using Rule = Adaptation_rule<Complex::dimension>;

  // Returns the target edge lengths of the vertices. `longest` is in mean edges.
  std::vector<double> sizes(double longest) const {
    return m_lengths.graded(longest * m_edge, Rule::gradation);
  }

  const Interface_snapshot<Complex>& m_interface;
  std::vector<typename Complex::Point> m_positions;
  double m_edge;
  Adaptation_options m_options;
  internal::Curvature_lengths<Complex> m_lengths;
  std::vector<double> m_sizes;
};

/*!
\ingroup PkgInterfaceRemeshingRef

Adapts the edges of the interface to its curvature before a time step of a flow. Does nothing if
`options.tolerance` is not positive. With `options.only_if_worn`, also does nothing unless the
interface is worn and the time step stretches it. n log n in the size of the interface, plus a pass
over the cells.

\param complex the complex
\param options the options
\param is_stretching function object that takes the `Interface_snapshot` and returns whether the
       time step changes lengths, for example by `is_stretched()`; called only if the interface is
       worn
\param visitor visitor of the changes; none if null
\return the numbers of operations
\pre `complex.mean_interface_edge()` is positive if there is an interface.
\throws Error if `improve_interface()` throws it; the complex is then unchanged. An exception of
        `visitor` or `Interrupted_error` leaves a valid complex.
*/
template <class Complex, class IsStretching>
Improvement_report
keep_interface_fit(Complex& complex, const Adaptation_options& options,
                   const IsStretching& is_stretching,
                   std::common_type_t<Deformation_visitor<Complex>*> visitor = nullptr) {
  if (!(options.tolerance > 0))
    return {};
  const Interface_snapshot<Complex> interface_(complex);
  const Interface_adaptation<Complex> adaptation(complex, interface_, options);
  if (options.only_if_worn && !(adaptation.is_worn() && is_stretching(interface_)))
    return {};
  return adaptation.apply(complex, visitor);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_INTERFACE_ADAPTATION_H
