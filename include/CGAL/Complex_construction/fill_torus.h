// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H
#define CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H

#include <CGAL/Complex_construction/fit_interface.h>
#include <CGAL/Complex_construction/internal/building/grids.h>
#include <CGAL/Complex_construction/internal/fitting/Missed_volumes.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/coordinates.h>
#include <CGAL/Mesh_support/named_parameters.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Returns the complex of the cells of a grid, with labels given by a function. `result` is an empty
// complex in the domain.
template <class Complex, class LabelAt, class NamedParameters>
Complex fill_grid(Complex result, const Grid<Complex::dimension>& grid, const LabelAt& label_at,
                  const NamedParameters& np) {
  std::vector<typename Complex::Point> points;
  for (const auto& p : grid.points)
    points.push_back(point_at<Complex>(p));
  result.assign(points, grid.cells, std::vector<typename Complex::Label>(grid.cells.size(), 0));
  const auto cells = result.cells();
  std::vector<typename Complex::Point> barycenters;
  for (auto c : cells)
    barycenters.push_back(barycenter(result, c));
  const auto labels = labels_at(result, label_at, std::move(barycenters));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Progress_scope::check();
    result.relabel(cells[i], labels[i]);
  }
  result.measure_interface_edges();
  fit_interface(result, label_at, np);
  result.measure_interface_edges();
  result.take_component_events();
  return result;
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex on a flat torus from a function of labels. Almost regular cells get the labels of
their barycenters. Then `fit_interface()` moves the interface to the places where labels change.
Linear in the number of cells.

\tparam Complex a complex with the domain `Torus_domain`
\param domain the torus
\param edge approximate edge length, positive; there are at least three edges in each direction
\param label_at `label_at(p)` returns the label at a `Point` in the box of the torus; or
       `label_at(points)` returns the labels at a vector of such points
\param np named parameters or `Deformation_options` of `deform_interface()`, for `fit_interface()`
\throws Error if `edge` is not positive, or is less than a millionth of a period
*/
template <class Complex, class LabelAt, class NP = parameters::Default_named_parameters>
Complex fill_torus(const Torus_domain<Complex::dimension>& domain, double edge,
                   const LabelAt& label_at, const NP& np = parameters::default_values()) {
  static_assert(
      internal::labels_points<Complex, LabelAt>,
      "the function of labels: int operator()(Point) const, or a function of a vector of points");
  if constexpr (internal::labels_points<Complex, LabelAt>)
    return internal::fill_grid(Complex(domain), internal::torus_grid(domain.periods(), edge),
                               label_at, np);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_FILL_TORUS_H
