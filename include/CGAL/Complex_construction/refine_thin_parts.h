// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_REFINE_THIN_PARTS_H
#define CGAL_COMPLEX_CONSTRUCTION_REFINE_THIN_PARTS_H

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/Thin_part_options.h>
#include <CGAL/Complex_construction/internal/thin_parts/Thickness.h>
#include <CGAL/Deformable_simplicial_complexes/Deformation_visitor.h>
#include <CGAL/Deformable_simplicial_complexes/internal/improvement/Mesh_improver.h>
#include <CGAL/Interface_remeshing/refine_cells.h>
#include <CGAL/Mesh_support/For_each_index.h>
#include <CGAL/Mesh_support/Progress_scope.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef
Report of `refine_thin_parts()`.
*/
struct Thin_part_report
{
  std::size_t new_facets = 0; ///< of the interface
  bool is_complete = true;    ///< whether all thin parts are resolved, see `missing_facets()`
};

namespace internal {

// Bisects the cells of facets, in their order, until each facet is divided, or `most` edges are
// split. Returns the number of splits.
template <class Complex>
std::size_t bisect(Complex& complex, const std::vector<Coarse_facet<Complex>>& facets,
                   std::size_t most) {
  Deformation_visitor<Complex> none;
  Cavity<Complex> cavity(complex);
  Improvement_report report;
  std::vector<std::size_t> time_stamps;
  for (const auto& coarse : facets)
    time_stamps.push_back(coarse.facet.first->time_stamp());
  for (std::size_t i = 0; i < facets.size() && report.split < most; ++i) {
    static constexpr std::size_t splits_per_facet = 64; // around it; few are needed
    const std::size_t last = report.split + splits_per_facet;
    const auto cell = facets[i].facet.first;
    while (complex.is_alive(cell, time_stamps[i]) && report.split < last)
      if (!split_terminal_edge(complex, cell, cavity, none, report))
        break;
  }
  return report.split;
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Estimates the number of further facets of the interface that `refine_thin_parts()` would need to
resolve all thin parts. Linear in the number of cells within the thickness of the interface.

\param complex the complex
\param edge_per_thickness see `Thin_part_options`
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`
*/
template <class Complex>
std::size_t missing_facets(const Complex& complex, double edge_per_thickness) {
  static constexpr double largest = 1e15; // of a number that is printed
  return edge_per_thickness == 0
             ? 0
             : std::size_t((std::min)(internal::coarse_facets(complex, edge_per_thickness, 1).parts,
                                      largest));
}

/*!
\ingroup PkgComplexConstructionRef

Bisects the facets of the interface, in the plane segments, that are large beside the thickness of
the phase or of the gap on one of their sides. So plates, shells and rods that are given by few
large triangles get cells that can follow a motion. The interface moves only by the rounding of
midpoints. Builders from surfaces divide the triangles in the same way before they fill space.

The thickness at a facet is the distance to the next facet of the interface along the inner normal.
It counts where it varies by at most a factor of three over the facet: a wedge has no thickness at
its edge. Cells at large facets are bisected as by `refine_cells()`. Longest facets come first, so
that the mesh is even if the bound on the number of facets is reached.

Linear in the number of cells within the thickness of the interface, in each of a few rounds, plus
the splits.

\param complex the complex
\param options options
\return the number of new facets, and whether they suffice
\throws Error if an option is out of its range
\throws Interrupted_error if the callback of a `Progress_scope` returned `false`; the complex is
        valid.

Source of the bisection: see `refine_cells()`.
*/
template <class Complex>
Thin_part_report refine_thin_parts(Complex& complex,
                                   const Thin_part_options& options = Thin_part_options()) {
  options.check();
  if (options.edge_per_thickness == 0)
    return {};
  const Progress_phase phase("resolving thin parts");
  Thin_part_report report;
  const std::size_t before = complex.interface_facets().size();
  // Near the bound, each round splits fewer edges. The last round is the first one that adds less
  // than this fraction of all splits.
  static constexpr double smallest_fraction = .02;
  std::size_t splits = 0;
  for (bool is_worthwhile = true; is_worthwhile;) {
    const std::size_t most = options.most_new_facets -
                             (std::min<std::size_t>)(report.new_facets, options.most_new_facets);
    const auto coarse = internal::coarse_facets(complex, options.edge_per_thickness, most);
    report.is_complete = coarse.parts == 0;
    if (coarse.facets.empty())
      break;
    const std::size_t done = internal::bisect(complex, coarse.facets, most);
    splits += done;
    report.new_facets = complex.interface_facets().size() - before;
    is_worthwhile = done > 0 && (coarse.parts <= double(most) ||
                                 double(done) >= smallest_fraction * double(splits));
  }
  if (report.new_facets > 0)
    complex.measure_interface_edges();
  return report;
}

namespace internal {

// Resolves thin parts of a mesh that was just made, improves it, and sorts its storage.
template <class Complex>
void improve_new_mesh(Complex& dsc, const Construction_options<Complex::dimension>& options) {
  if constexpr (Complex::Domain::has_outside)
    refine_thin_parts(dsc, options.thin_parts);
  const Progress_phase phase("improving the mesh");
  if (options.improve) {
    Deformation_visitor<Complex> visitor;
    const For_each_index sequential;
    Mesh_improver<Complex> improver(dsc, visitor, options.quality_threshold, sequential);
    improver.improve_all(options.quality_threshold, options.number_of_iterations, 0);
  }
  dsc.sort_storage();
}

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_REFINE_THIN_PARTS_H
