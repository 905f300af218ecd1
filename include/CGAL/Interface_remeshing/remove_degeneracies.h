// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_INTERFACE_REMESHING_REMOVE_DEGENERACIES_H
#define CGAL_INTERFACE_REMESHING_REMOVE_DEGENERACIES_H

#include <CGAL/Deformable_simplicial_complexes/Cavity.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_options.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_report.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/destinations/Interface_tolerance.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_operations.h>
#include <CGAL/Deformable_simplicial_complexes/internal/traversal/Work_list.h>
#include <CGAL/Deformable_simplicial_complexes/mesh_operations.h>
#include <CGAL/Interface_remeshing/Edge_unit.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgInterfaceRemeshingRef

Options of `remove_degeneracies()`. The named parameters of that function have the same names. The
numbers are those of the paper by Misztal and B&aelig;rentzen \cgalCite{cgal:mb-taitd-12}.

\tparam Complex a deformable simplicial complex
*/
template <class Complex> struct Degeneracy_options
{
  /// Cells of lower quality are removed, in [0, 1]; in space only.
  double degenerate_quality = .005;
  /// Facets, in the plane triangles, with an angle of larger cosine are removed, in [0.5, 1].
  double degenerate_cosine = .999;
  /// Shorter edges are removed, in units of the target edge length, at least 0.
  double degenerate_length = .5;
  /// Target edge length, a positive function of position in the coordinates of the complex,
  /// evaluated at midpoints of edges. If empty, it is `dsc.minimum_interface_edge()` everywhere.
  typename Edge_unit<Complex>::Sizing_field sizing_field;
  /// Largest number of rounds. Each round processes the cells created by the previous one.
  unsigned number_of_iterations = 10;
  /// Visitor of the changes; it must outlive the call. None if null.
  Deformation_visitor<Complex>* visitor = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    require_quality(degenerate_quality);
    if (!(degenerate_cosine >= .5 && degenerate_cosine <= 1))
      throw Error("the cosine of the minimum facet angle is out of range: use 0.5 to 1");
    if (!(degenerate_length >= 0))
      throw Error("the length of a degenerate edge is out of range: use 0 or more");
  }
};

namespace internal {

// Implements `remove_degeneracies()`.
template <class Complex>
Improvement_report remove_degenerate_simplices(Complex& dsc,
                                               const Degeneracy_options<Complex>& options) {
  using Cell_handle = typename Complex::Cell_handle;

  options.check();
  Deformation_visitor<Complex> no_visitor;
  Deformation_visitor<Complex>& visitor = options.visitor ? *options.visitor : no_visitor;
  const auto unit = shortest_target_edge_length(dsc, options.sizing_field);

  Improvement_report report;
  Cavity<Complex> cavity(dsc);
  internal::Interface_tolerance<Complex> tolerance(dsc);
  const auto propose = [&](Cell_handle c) {
    if (internal::Mesh_operations<Complex>::propose_degenerate_cell_removal(
            dsc, c, options.degenerate_quality, options.degenerate_cosine, cavity) &&
        tolerance.allows(cavity))
      return true;
    for (int i = 0; i < Complex::corners; ++i)
      for (int j = i + 1; j < Complex::corners; ++j) {
        const auto middle =
            dsc.position(c->vertex(i)) + .5 * dsc.displacement(c->vertex(i), c->vertex(j));
        if (propose_degenerate_edge_removal(dsc, c, i, j, options.degenerate_length * unit(middle),
                                            c->quality(), cavity) &&
            tolerance.allows(cavity))
          return true;
      }
    return false;
  };

  internal::Work_list<Cell_handle> cells;
  for (Cell_handle c : dsc.finite_cells())
    cells.push(c);
  internal::work_in_rounds(dsc, std::move(cells), options.number_of_iterations,
                           [&](Cell_handle c, internal::Work_list<Cell_handle>& touched) {
                             if (!propose(c))
                               return;
                             commit_proposal(dsc, cavity, visitor, report);
                             internal::push_finite(dsc, cavity.created(), touched);
                           });
  return report;
}

} // namespace internal

/*!
\ingroup PkgInterfaceRemeshingRef

Removes degenerate simplices where possible, also those of the interface. In 3D, these are nearly
flat tetrahedra, facets with small angles, and short edges ("degeneracy removal", section 3.2.1 of
the paper). They are removed with `propose_degenerate_tetrahedron_removal()`,
`propose_degenerate_facet_removal()` and `propose_degenerate_edge_removal()`. In 2D, these are
nearly flat triangles (section 3.1), removed with `propose_degenerate_triangle_removal()`, and short
edges. The topology of the interface stays; the interface moves by the volume of the removed cells.
A pass over the cells, then n log n in the number of changed cells.

\param dsc the complex
\param np a `Degeneracy_options`, or named parameters with the names of its members. Function objects
       and a visitor, a `Deformation_visitor`, are given by value or by
       `std::reference_wrapper`.

\return the numbers of changes
\throws Error if a parameter is out of its range; the complex is then unchanged
\throws Error if the sizing field has a value that is not positive. After this exception, or one of
        the sizing field or of the visitor, the complex is valid.

*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report remove_degeneracies(Complex& dsc,
                                       const NamedParameters& np = NamedParameters()) {
  return internal::call_with_parameters(
      dsc, np, Degeneracy_options<Complex>(),
      [&](const auto& options) { return internal::remove_degenerate_simplices(dsc, options); });
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_INTERFACE_REMESHING_REMOVE_DEGENERACIES_H
