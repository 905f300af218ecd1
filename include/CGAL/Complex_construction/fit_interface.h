// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_FIT_INTERFACE_H
#define CGAL_COMPLEX_CONSTRUCTION_FIT_INTERFACE_H

#include <CGAL/Complex_construction/internal/fitting/Missed_volumes.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_snapshot.h>
#include <CGAL/Deformable_simplicial_complexes/deform_interface.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/cell_corners.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Facets of the interface whose cells have their labels at their barycenters. Each facet has a
// point where the label changes.
template <class Complex> struct Changes_of_label
{
  std::vector<std::size_t> facets; // indices of facets of the interface
  std::vector<typename Complex::Point> places;
};

// Finds points where the label given by a function changes, by bisection between the barycenters of
// the cells on both sides of the facets of the interface. Leaves out facets whose cells have other
// labels at their barycenters.
template <class Complex, class LabelAt>
Changes_of_label<Complex> changes_of_label(const Complex& complex, const LabelAt& label_at) {
  static constexpr int halvings = 40; // reduces the interval to a trillionth
  std::vector<typename Complex::Point> behind, in_front;
  const auto facets = complex.interface_facets();
  for (const auto& facet : facets) {
    behind.push_back(barycenter(complex, facet.first));
    in_front.push_back(complex.domain().nearest_image(
        behind.back(), barycenter(complex, facet.first->neighbor(facet.second))));
  }
  const auto labels_behind = labels_at(complex, label_at, behind),
             labels_in_front = labels_at(complex, label_at, in_front);
  Changes_of_label<Complex> result;
  std::vector<typename Complex::Point> to;
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (labels_behind[i] == facets[i].first->subdomain_index() &&
        labels_in_front[i] == facets[i].first->neighbor(facets[i].second)->subdomain_index()) {
      result.facets.push_back(i);
      result.places.push_back(behind[i]);
      to.push_back(in_front[i]);
    }
  for (int k = 0; k < halvings; ++k) {
    std::vector<typename Complex::Point> middle;
    for (std::size_t i = 0; i < to.size(); ++i)
      middle.push_back(result.places[i] + (to[i] - result.places[i]) / 2);
    const auto labels = labels_at(complex, label_at, middle);
    for (std::size_t i = 0; i < to.size(); ++i)
      (labels[i] == labels_behind[result.facets[i]] ? result.places : to)[i] = middle[i];
  }
  return result;
}

// Returns positions of the interface vertices where the labels given by a function change. A
// position is the mean of the points of change at the incident facets. Vertices without such a
// point stay.
template <class Complex, class LabelAt>
std::vector<typename Complex::Point>
changes_of_labels(const Complex& complex, const LabelAt& label_at,
                  const Interface_snapshot<Complex>& interface_) {
  const auto positions = interface_.positions(complex);
  std::vector<typename Complex::Vector> sums(positions.size(), NULL_VECTOR);
  std::vector<std::size_t> numbers(positions.size(), 0);
  const Changes_of_label<Complex> changes = changes_of_label(complex, label_at);
  for (std::size_t i = 0; i < changes.facets.size(); ++i)
    for (std::size_t v : interface_.facets()[changes.facets[i]].vertices) {
      sums[v] = sums[v] +
                (complex.domain().nearest_image(positions[v], changes.places[i]) - positions[v]);
      ++numbers[v];
    }
  std::vector<typename Complex::Point> result = positions;
  for (std::size_t v = 0; v < result.size(); ++v)
    if (numbers[v] > 0)
      result[v] = result[v] + sums[v] / double(numbers[v]);
  return result;
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Moves the interface to the places where a function of labels changes its value. Use it after
`relabel()`, which can only choose among existing facets. Each vertex moves to the mean of the
nearby points of change, which are found by bisection. This is repeated several times. The distance
from a smooth interface is then of the order of its curvature times the square of the edge length.
Lines where labels meet are approximated up to a fraction of the edge length.

At the end, vertices move along their normals so that facets no longer cut off volume of round
phases: the volume of a ball with a radius of three edges is correct to a thousandth.

The function calls `label_at` about 40 times for each facet in each of three repetitions, then 100
times in space, 50 times in the plane, in each of at most five more.

\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\param dsc the complex
\param label_at `label_at(p)` returns the label at a `Point` of the domain; or
       `label_at(points)` returns the labels at a vector of them
\param np the named parameters of `deform_interface()`
\return the report of the last deformation
\throws Error as `deform_interface()` does, or if the number of labels at points is wrong
*/
template <class ConcurrencyTag = Sequential_tag, class Complex, class LabelAt,
          class NamedParameters = parameters::Default_named_parameters>
Deformation_report<Complex> fit_interface(Complex& dsc, const LabelAt& label_at,
                                          const NamedParameters& np = NamedParameters()) {
  const Progress_phase phase("fitting the interface");
  static constexpr int rounds = 3; // the first one removes steps; more than three change little
  Deformation_report<Complex> report;
  for (int i = 0; i < rounds && !report.stopped; ++i) {
    const Interface_snapshot<Complex> interface_(dsc);
    report = deform_interface_to<ConcurrencyTag>(
        dsc, interface_, internal::changes_of_labels(dsc, label_at, interface_), np);
  }
  // Usually two rounds; lines where labels meet need more, because each sheet moves them.
  static constexpr int most_volume_rounds = 5;
  static constexpr double shortest = 1e-3; // displacement, in mean edges
  for (int i = 0; i < most_volume_rounds && !report.stopped; ++i) {
    const Interface_snapshot<Complex> interface_(dsc);
    const internal::Missed_volumes<Complex> missed(dsc, label_at, interface_);
    if (!(missed.longest_displacement() > shortest * dsc.mean_interface_edge()))
      break;
    report = deform_interface_to<ConcurrencyTag>(dsc, interface_, missed.destinations(), np);
  }
  return report;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_FIT_INTERFACE_H
