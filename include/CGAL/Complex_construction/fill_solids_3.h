// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_FILL_SOLIDS_3_H
#define CGAL_COMPLEX_CONSTRUCTION_FILL_SOLIDS_3_H

#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>
#include <CGAL/Triangle_soup_repair/make_patches_3.h>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Returns whether surfaces that are refused for a reason may bound solids nevertheless: they may
// have walls, overlap, or have vertices on edges.
inline bool may_have_walls(Invalid_surface_error::Reason reason) {
  using Reason = Invalid_surface_error::Reason;
  return reason != Reason::empty && reason != Reason::not_finite && reason != Reason::bad_index &&
         reason != Reason::outside_enclosing_box;
}

// Returns the largest distance of features that may be welded because a tetrahedralizer fails.
template <class Point>
double largest_weld_distance(const std::vector<Labeled_surface_3<Point>>& surfaces) {
  static constexpr double of_extent = 1e-6;
  Bbox_3 box;
  for (const auto& surface : surfaces)
    for (const Point& p : surface.points)
      box += p.bbox();
  return of_extent *
         (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

} // namespace internal

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from solids bounded by any closed surfaces: they may share walls, be nested, touch
and overlap. Where surfaces nearly meet or `make_deformable_simplicial_complex_3()` fails for them,
`make_patches_3()` divides them first; otherwise, the result is that of
`make_deformable_simplicial_complex_3()`. Takes the time of both functions.

Surfaces that cross at random have features of any size. If the tetrahedralizer fails, patches are
made again with a hundredfold weld distance, up to a millionth of the largest extent, unless the
weld distance is given.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param surfaces surfaces with the labels of the solids that they bound; coordinates are rounded to
       `double`
\param tetrahedralizer tetrahedralizer that fills the box
\param patches receives the patches if the surfaces were divided, also if an exception is thrown then
\param np named parameters of `make_deformable_simplicial_complex_3()`
\param patch_options options of `make_patches_3()`

\throws Invalid_surface_error if surfaces are not closed or intersect themselves, or reach the box. If
        `patches` has a value, numbers of surfaces in the error are those of patches.
\throws Tetrahedralization_error if the tetrahedralizer fails
\throws Error if the box is not finite, an option is out of range, or surfaces cannot be divided
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`
*/
template <class Complex, class Tetrahedralizer, class NP = parameters::Default_named_parameters>
Complex fill_solids_3(const std::vector<Labeled_surface_3<typename Complex::Point_3>>& surfaces,
                      const Tetrahedralizer& tetrahedralizer,
                      std::optional<Patches_of_surfaces_3<typename Complex::Point_3>>& patches,
                      const NP& np = parameters::default_values(),
                      const Patch_options_3& patch_options = {}) {
  patches.reset();
  std::exception_ptr failure; // the first one, which tells more than a failure of a division
  if (!have_contacts_3(surfaces, patch_options))
    try {
      return make_deformable_simplicial_complex_3<Complex>(surfaces, tetrahedralizer, np);
    } catch (const Invalid_surface_error& error) {
      if (!internal::may_have_walls(error.reason()))
        throw;
      failure = std::current_exception();
    } catch (const Tetrahedralization_error&) {
      if (patch_options.weld_distance)
        throw;
      failure = std::current_exception();
    }
  static constexpr double factor = 100;
  const double largest = internal::largest_weld_distance(surfaces);
  for (Patch_options_3 options = patch_options;;
       options.weld_distance = factor * patches->weld_distance) {
    try {
      patches = make_patches_3(surfaces, options);
    } catch (const Invalid_surface_error&) {
      if (patches)
        std::rethrow_exception(failure);
      throw;
    } catch (const Error&) {
      if (failure)
        std::rethrow_exception(failure);
      throw;
    }
    if (patches->patches.empty())
      throw Error(
          "nothing is left of the surfaces, because they are thinner than the weld distance "
          "of " +
          std::to_string(patches->weld_distance) +
          ": give coordinates with more digits, or another weld distance");
    try {
      return make_deformable_simplicial_complex_3<Complex>(patches->patches, tetrahedralizer, np);
    } catch (const Tetrahedralization_error&) {
      if (patch_options.weld_distance || factor * patches->weld_distance > largest)
        throw;
      failure = std::current_exception();
    }
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_FILL_SOLIDS_3_H
