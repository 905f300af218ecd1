// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_FIT_INTERFACE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

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

// Returns a point where the label given by a function changes between `from`, a point of the label,
// and `to`; by bisection.
template <class Complex, class LabelAt>
typename Complex::Approximate_point change_of_label(const Complex& complex, const LabelAt& label_at,
                                                    typename Complex::Approximate_point from,
                                                    typename Complex::Approximate_point to,
                                                    typename Complex::Label label) {
  static constexpr int halvings = 40; // reduces the interval to a trillionth
  for (int i = 0; i < halvings; ++i) {
    const auto middle = from + (to - from) / 2;
    (label_at(complex.domain().canonical(middle)) == label ? from : to) = middle;
  }
  return from;
}

// Returns the barycenter of a cell, as seen from its vertex 0.
template <class Complex>
typename Complex::Approximate_point barycenter(const Complex& complex,
                                               typename Complex::Cell_handle c) {
  typename Complex::Approximate_vector sum(NULL_VECTOR);
  for (int i = 0; i < Complex::corners; ++i)
    sum = sum + (complex.corner(c, i) - ORIGIN);
  return ORIGIN + sum / Complex::corners;
}

// Returns positions of the interface vertices where the labels given by a function change. A
// position is the mean of the points of change between the cells on both sides of the incident
// facets. Vertices without such a point stay.
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

Moves the interface to the places where a function of labels changes its value. Use it after
`relabel()`, which can only choose among existing facets. Each vertex moves to the mean of the
nearby points of change, which are found by bisection. This is repeated several times. The distance
from a smooth interface is then of the order of its curvature times the square of the edge length.
Lines where labels meet are approximated up to a fraction of the edge length.

About 40 calls of `label_at` for each facet in each repetition, plus the deformations.

\param dsc the complex
\param label_at `label_at(p)` returns the label at an `Approximate_point` of the domain
\param np the named parameters of `deform_interface()`
\return the report of the last deformation
\throws Error as `deform_interface()` does
*/
template <class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> fit_interface(Complex& dsc, const LabelAt& label_at,
                                          const NamedParameters& np = NamedParameters()) {
  const Progress_phase phase("fitting the interface");
  static constexpr int rounds = 3; // the first one removes steps; more than three change little
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
