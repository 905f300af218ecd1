// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ADAPTATION_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ADAPTATION_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Curvature_sizing_field.h>
#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/improve_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/interface/Curvature_lengths.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

// Tolerance to the smooth surface, feature angle, and what else a flow asks for.
struct Adaptation_options
{
  double tolerance;         // of the distance between edges and surface, in mean edges; 0 for none
  double feature_angle;     // between the normals of facets that meet in a sharp edge, in degrees
  bool only_if_worn = true; // the interface stays as it is while most edges have their length
  bool splits_junctions = false; // of more than three phases
};

// By which sizes an interface is adapted, and when.
template <int dimension> struct Adaptation_rule
{
  // Bounds on sizes, in mean edges of the input. Rims of thin sheets would ask for ever smaller
  // ones. Facets carry the motion of a surface also where it is flat; curves have few of them, and
  // a thread is long.
  static constexpr double shortest = .2, longest = dimension == 2 ? 4 : 1;
  // Between neighbors, by the length of the edge between them: facets keep their angles.
  static constexpr double gradation = .5;
  // An edge is split and collapsed by these units of its size. They are a factor of three apart, so
  // that halves are not collapsed again.
  static constexpr double split = 1.5, collapse = .5;
  // In squares or cubes of the size: a curve feels each collapse, a surface has thousands.
  static constexpr double swept_volume = dimension == 2 ? .01 : .1;

  // An interface is worn if more than these parts of its edges are, by the sizes at their ends, to
  // be split, where flat parts may have edges of `longest_if_flat`, as what is stretched without
  // being bent is as good as before; or to be collapsed. A few do no harm, and all that is changed
  // has another volume than it had.
  static constexpr double many_long_ones = .015, many_short_ones = .003;
  static constexpr double longest_if_flat = 3 * longest;
};

// Whether a motion changes lengths: not if it is rigid.
template <class Complex, class Points>
bool is_stretched(const Interface_snapshot<Complex>& interface_, const Points& from,
                  const Points& to) {
  // Of the square of a length: far above rounding and what a step of Runge and Kutta leaves of a
  // rotation, far below what a step does that leads anywhere.
  static constexpr double rigid = 1e-6;
  bool result = false;
  internal::for_each_edge_of(interface_.facets(), [&](std::size_t a, std::size_t b) {
    const auto squared_length = [&](const Points& p) {
      return (interface_.domain.near(p[a], p[b]) - p[a]).squared_length();
    };
    const double before = squared_length(from);
    result = result || std::abs(squared_length(to) - before) > rigid * before;
  });
  return result;
}

// Keeps edges as long as the curvature of an interface asks for.
template <class Complex> class Interface_adaptation
{
public:
  Interface_adaptation(const Complex& complex, const Interface_snapshot<Complex>& interface_,
                       const Adaptation_options& options)
      : m_interface(interface_), m_positions(interface_.positions(complex)),
        m_edge(complex.mean_interface_edge()), m_options(options),
        m_lengths(interface_, m_positions, options.tolerance * m_edge, Rule::shortest * m_edge,
                  options.feature_angle),
        m_sizes(sizes(Rule::longest)) {}

  // Whether too many edges are far longer than the curvature allows, or short.
  bool is_worn() const {
    const std::vector<double> sizes_if_flat = sizes(Rule::longest_if_flat);
    std::size_t edges = 0, short_ones = 0, long_ones = 0;
    internal::for_each_edge_of(m_interface.facets(), [&](std::size_t a, std::size_t b) {
      const double length =
          std::sqrt((m_interface.domain.near(m_positions[a], m_positions[b]) - m_positions[a])
                        .squared_length());
      ++edges;
      short_ones += length < Rule::collapse * (std::min)(m_sizes[a], m_sizes[b]);
      long_ones += length > Rule::split * (std::min)(sizes_if_flat[a], sizes_if_flat[b]);
    });
    return double(long_ones) > Rule::many_long_ones * double(edges) ||
           double(short_ones) > Rule::many_short_ones * double(edges);
  }

  // Splits on the smooth surface, and collapses; no vertex is moved that does not have to. The
  // complex is still that of the beginning.
  template <class Visitor>
  Improvement_report apply(Complex& complex, const Visitor& visitor) const {
    const Curvature_sizing_field<Complex::dimension> field(m_interface, m_positions, m_sizes,
                                                           Rule::longest * m_edge);
    return improve_interface(complex, parameters::sizing_field(std::cref(field))
                                          .interface_split_length(Rule::split)
                                          .interface_collapse_length(Rule::collapse)
                                          .swept_volume(Rule::swept_volume)
                                          .curved_splits(true)
                                          .aggressiveness(0.)
                                          .feature_angle(m_options.feature_angle)
                                          .split_junctions(m_options.splits_junctions)
                                          .quality_threshold(0.) // left to the motion
                                          .visitor(visitor));
  }

private:
  using Rule = Adaptation_rule<Complex::dimension>;

  // Of vertices. The longest one is in mean edges.
  std::vector<double> sizes(double longest) const {
    return m_lengths.graded(longest * m_edge, Rule::gradation);
  }

  const Interface_snapshot<Complex>& m_interface;
  std::vector<typename Complex::Approximate_point> m_positions;
  double m_edge;
  Adaptation_options m_options;
  internal::Curvature_lengths<Complex> m_lengths;
  std::vector<double> m_sizes;
};

// The recipe by which all flows keep an interface fit: adapts it if the tolerance is not 0, it is
// worn, and the step stretches it, as `is_stretching(interface)` says.
template <class Complex, class IsStretching, class Visitor>
Improvement_report keep_interface_fit(Complex& complex, const Adaptation_options& options,
                                      const IsStretching& is_stretching, const Visitor& visitor) {
  if (!(options.tolerance > 0))
    return {};
  const Interface_snapshot<Complex> interface_(complex);
  const Interface_adaptation<Complex> adaptation(complex, interface_, options);
  if (options.only_if_worn && !(adaptation.is_worn() && is_stretching(interface_)))
    return {};
  return adaptation.apply(complex, visitor);
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERFACE_ADAPTATION_H
