// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>

#include <CGAL/Origin.h>

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

// Where the labels that a function tells change, for the vertices of the interface: the mean of the
// places between the cells on both sides of their facets. Vertices without one stay.
template <class Complex, class LabelAt>
std::vector<typename Complex::Approximate_point>
changes_of_labels(const Complex& complex, const LabelAt& label_at,
                  const Interface_snapshot<Complex>& interface_) {
  const auto positions = interface_.positions(complex);
  std::vector<typename Complex::Approximate_vector> sums(positions.size(), NULL_VECTOR);
  std::vector<std::size_t> numbers(positions.size(), 0);
  const auto facets = complex.interface_facets();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    Progress_scope::check();
    const auto behind = facets[i].first, in_front = behind->neighbor(facets[i].second);
    const auto from = barycenter(complex, behind);
    const auto to = complex.domain().near(from, barycenter(complex, in_front));
    if (label_at(complex.domain().canonical(from)) != behind->label() ||
        label_at(complex.domain().canonical(to)) != in_front->label())
      continue;
    const auto place = change_of_label(complex, label_at, from, to, behind->label());
    for (std::size_t v : interface_.facets()[i].vertices) {
      sums[v] = sums[v] + (complex.domain().near(positions[v], place) - positions[v]);
      ++numbers[v];
    }
  }
  std::vector<typename Complex::Approximate_point> result = positions;
  for (std::size_t v = 0; v < result.size(); ++v)
    if (numbers[v] > 0)
      result[v] = result[v] + sums[v] / double(numbers[v]);
  return result;
}

} // namespace internal

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves the interface to where the labels change that a function tells: after `relabel()`, which only
chooses among the facets that are there. Vertices go to the mean of the places around them where it
changes, found by bisection; that is done several times. So a smooth interface is met up to its
curvature times the square of the edges, and lines where labels meet up to a part of an edge.

\param dsc the complex
\param label_at `label_at(p)` tells the label at an `Approximate_point` of the domain
\param np the named parameters of `deform_interface()`
\return what the last deformation did
\throws whatever `deform_interface()` throws

About 40 calls of `label_at` for each facet, and the deformations.
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> fit_interface(Complex& dsc, const LabelAt& label_at,
                                          const NamedParameters& np = NamedParameters()) {
  const Progress_phase phase("fitting the interface");
  static constexpr int rounds = 3; // the first straightens stairs; more change little
  Deformation_report<Complex> report;
  for (int i = 0; i < rounds && !report.stopped; ++i) {
    const Interface_snapshot<Complex> interface_(dsc);
    report = deform_interface_to(dsc, interface_,
                                 internal::changes_of_labels(dsc, label_at, interface_), np);
  }
  return report;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H
