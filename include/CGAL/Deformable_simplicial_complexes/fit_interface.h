// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#include <CGAL/Origin.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Deformable_simplicial_complexes {
namespace internal {

// Where a function that tells labels changes, on the way from a point of a label: by bisection.
template <class Complex, class LabelAt>
typename Complex::Approximate_point change_of_label(const Complex& complex, const LabelAt& label_at,
                                                    typename Complex::Approximate_point from,
                                                    typename Complex::Approximate_point to,
                                                    typename Complex::Label label) {
  static constexpr int halvings = 40; // to a billionth of a thousandth of the way
  for (int i = 0; i < halvings; ++i) {
    const auto middle = from + (to - from) / 2;
    (label_at(complex.domain().canonical(middle)) == label ? from : to) = middle;
  }
  return from;
}

// The barycenter of a cell, as seen from its vertex 0.
template <class Complex>
typename Complex::Approximate_point barycenter(const Complex& complex,
                                               typename Complex::Cell_handle c) {
  typename Complex::Approximate_vector sum(NULL_VECTOR);
  for (int i = 0; i < Complex::corners; ++i)
    sum = sum + (complex.corner(c, i) - ORIGIN);
  return ORIGIN + sum / Complex::corners;
}

// How far the facets of an interface are from where the labels change that a function tells.
template <class Complex> class Interface_misfit
{
public:
  using Point = typename Complex::Approximate_point;
  using Vector = typename Complex::Approximate_vector;

  template <class LabelAt>
  Interface_misfit(const Complex& complex, const LabelAt& label_at,
                   const Interface_snapshot<Complex>& interface_)
      : m_positions(interface_.positions(complex)), m_to_places(m_positions.size(), NULL_VECTOR),
        m_ways_of_facets(m_positions.size(), NULL_VECTOR), m_numbers(m_positions.size(), 0) {
    const auto facets = complex.interface_facets();
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const auto behind = facets[i].first, in_front = behind->neighbor(facets[i].second);
      const Point from = barycenter(complex, behind);
      const Point to = complex.domain().near(from, barycenter(complex, in_front));
      if (label_at(complex.domain().canonical(from)) != behind->label() ||
          label_at(complex.domain().canonical(to)) != in_front->label())
        continue;
      const Point place = change_of_label(complex, label_at, from, to, behind->label());
      const auto& vertices = interface_.facets()[i].vertices;
      std::array<Point, Complex::dimension> corners;
      for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = complex.domain().near(place, m_positions[vertices[k]]);
      const Vector normal = Complex::Space::facet_normal(corners);
      const double squared_length = normal.squared_length();
      const Vector way = squared_length > 0
                             ? ((place - corners[0]) * normal / squared_length) * normal
                             : Vector(NULL_VECTOR);
      for (std::size_t v : vertices) {
        m_to_places[v] =
            m_to_places[v] + (complex.domain().near(m_positions[v], place) - m_positions[v]);
        m_ways_of_facets[v] = m_ways_of_facets[v] + way;
        ++m_numbers[v];
      }
    }
  }

  // Vertices in the middle of the places around them: straightens stairs, but cuts corners and
  // curvature off.
  std::vector<Point> smoothed() const { return moved_by(m_to_places); }

  // Vertices moved as far as the facets around them have to go in the mean: then as much of these
  // is on either side, as volumes want it.
  std::vector<Point> balanced() const { return moved_by(m_ways_of_facets); }

private:
  std::vector<Point> moved_by(const std::vector<Vector>& sums) const {
    std::vector<Point> result = m_positions;
    for (std::size_t v = 0; v < result.size(); ++v)
      if (m_numbers[v] > 0)
        result[v] = result[v] + sums[v] / double(m_numbers[v]);
    return result;
  }

  std::vector<Point> m_positions;
  std::vector<Vector> m_to_places, m_ways_of_facets; // sums over the facets of a vertex
  std::vector<std::size_t> m_numbers;                // of those at which a place is known
};

} // namespace internal
} // namespace Deformable_simplicial_complexes

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Moves the interface to where the labels change that a function tells: after `relabel()`, which only
chooses among the facets that are there. Vertices go to the mean of the places around them where it
changes, found by bisection, which straightens stairs; then to where as much of the facets around
them is on either side of these places. Both is done several times. So a smooth interface is met up
to its curvature times the square of the edges, its volumes better than that, and lines where labels
meet up to a part of an edge.

\param dsc the complex
\param label_at `label_at(p)` tells the label at an `Approximate_point` of the domain
\param np the named parameters of `deform_interface()`
\return what the last deformation did
\throws whatever `deform_interface()` throws

About 240 calls of `label_at` for each facet, and the deformations.
*/
template <
    class Complex, class LabelAt,
    class NamedParameters = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Deformation_report<Complex> fit_interface(Complex& dsc, const LabelAt& label_at,
                                          const NamedParameters& np = NamedParameters()) {
  static constexpr int rounds_of_smoothing = 3, rounds = 6; // more change little
  namespace internal = Deformable_simplicial_complexes::internal;
  Deformation_report<Complex> report;
  for (int i = 0; i < rounds && !report.stopped; ++i) {
    const Deformable_simplicial_complexes::Interface_snapshot<Complex> interface_(dsc);
    const internal::Interface_misfit<Complex> misfit(dsc, label_at, interface_);
    report = deform_interface_to(
        dsc, interface_, i < rounds_of_smoothing ? misfit.smoothed() : misfit.balanced(), np);
  }
  return report;
}

} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H
