// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>
#include <CGAL/Solid_reconstruction_3/Reconstruction_report_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Collected_points.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/// \ingroup PkgSolidReconstruction3Ref
///
/// An observer of a reconstruction that does nothing.
///
/// \cgalModels{ReconstructionObserver_3}
struct Reconstruction_observer_3
{
  /// Returns `true`, so that the reconstruction continues.
  template <class Complex> bool operator()(const Complex& /*complex*/, std::size_t /*step*/) const {
    return true;
  }
};

/*!
\ingroup PkgSolidReconstruction3Ref

Options of `reconstruct_point_set_3()`. The named parameters of that function have the same names.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
*/
template <class Complex> struct Reconstruction_options_3
{
  /// Tolerance of the fit, in spacings, greater than 0 and finite. A facet is divided if the root
  /// mean square of the distances of its points exceeds the tolerance, which is at least 1.3 times
  /// the noise. The target edge length is at least 2 spacings plus 14 times the noise, at sharp
  /// edges at least 3 spacings plus 24 times the noise.
  double fit_tolerance = .03;
  /// Largest number of steps. Long narrow tunnels take many steps.
  unsigned number_of_iterations = 80;
  /// Number of threads if linked with TBB. The result does not depend on it.
  unsigned number_of_threads = 1;
  /// Called before the first step and after each step. If it returns `false`, the reconstruction
  /// ends with the present result. If empty, no function is called.
  std::function<bool(const Complex&, std::size_t)> observer;
  /// Report that is filled; none if null. Handles in it belong to the result.
  Reconstruction_report_3<Complex>* report = nullptr;

  /// Throws an exception unless all values are in their ranges.
  /// \throws Error if a value is out of its range
  void check() const {
    if (!(fit_tolerance > 0 && std::isfinite(fit_tolerance)))
      throw Error("the tolerance of the fit is not positive and finite: use 0.03, for example");
  }
};

namespace internal {

// Implements `reconstruct_point_set_3()` for points that are collected already.
template <class Complex>
Complex reconstruct_collected(const Collected_points& points,
                              const Reconstruction_options_3<Complex>& options);

// Implements `reconstruct_point_set_3()`.
template <class Complex, class PointRange, class NamedParameters>
Complex reconstruct(const PointRange& range, const NamedParameters& maps,
                    const Reconstruction_options_3<Complex>& options) {
  options.check();
  const Progress_phase phase("reconstructing a surface");
  return reconstruct_collected(collect_points(range, maps), options);
}

} // namespace internal

/*!
\ingroup PkgSolidReconstruction3Ref

Reconstructs a solid from points on its surface (section 4.3 of the paper). The result is closed and
has label 1 inside the solid. Its interface is a manifold. Sharp edges and corners stay sharp.

The sides are determined first: the largest empty Delaunay balls at the points are labeled inside
or outside \cgalCite{cgal:kso-ssrnp-04}. The interface therefore does not leak through holes of the
points that are narrow compared with the solid behind them, and cavities are found. A hole is closed
by facets without points. The report lists these facets.

The interface begins in an octree around the points and the solid. In each step, it moves inwards to
the planes of the points near its facets. When most facets have points, all vertices move to
positions that minimize the squared distances of all points to their nearest facets. Facets with
large distances are divided. The topology of the interface changes during this motion.

Two lengths are used as units. The *spacing* is the mean distance of the points from their six
nearest neighbors. The *noise* is the median of the residuals of quadrics that are fitted to the
neighbors of each point.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam ConcurrencyTag gives the default of `number_of_threads`: 1, or all threads if it is
        `Parallel_tag`
\tparam PointRange a range whose value type is the key type of the point map, or a `Point_set_3`. By
        default, the points and normals of a `Point_set_3` are used.

\param points the points, in any order
\param np a `Reconstruction_options_3`, or named parameters with the names of its members, where
       `observer` is a model of `ReconstructionObserver_3`, by value or
       `std::reference_wrapper`, and `report` a `std::reference_wrapper`. Also `point_map` and
       `normal_map`, models of `ReadablePropertyMap` whose value types have `x()`, `y()` and `z()`:
       the position of a point, by default by `Identity_property_map`, and the normal at a point, of
       any length and sign. By default, and where it is 0 or not finite, it is estimated from the 16
       nearest points.

\return the complex. It has label 1 inside the solid, and label 0 between the solid and a box around
        it.
\throws Invalid_points_error if coordinates are not finite, the extent of the points is not between
        1e-30 and 1e30, there are fewer than four different points, all points lie in a plane, or
        the points enclose no volume or a volume that is too thin. Also if the points sample an
        open sheet: more than a quarter of the boundary of the enclosed volume has no points.
\throws Error if a named parameter is out of its range.
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`.

If an exception is thrown, also by the observer or a map, the report is unchanged.

If the Delaunay triangulation of the points has linear size, its construction takes n log n time in
the number n of points. Each step takes one query for each point and one deformation of the
interface.

\sa `reconstruct_sheet_3()`
*/
template <class Complex, class ConcurrencyTag = Sequential_tag, class PointRange,
          class NP = parameters::Default_named_parameters>
Complex reconstruct_point_set_3(const PointRange& points,
                                const NP& np = parameters::default_values()) {
  using Options = Reconstruction_options_3<Complex>;
  if constexpr (std::is_same<NP, Options>::value)
    return internal::reconstruct(points, parameters::default_values(), np);
  else {
    Options options;
    options.number_of_threads = default_number_of_threads<ConcurrencyTag>();
    read_parameters<CGAL::internal_np::point_t, CGAL::internal_np::normal_t>(np, options);
    return internal::reconstruct(points, np, options);
  }
}

} // namespace CGAL::Deformable_simplicial_complexes

// The header of the component Compiled only declares the function.
#ifndef CGAL_DSC_RECONSTRUCTION_IS_COMPILED
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/reconstruct_collected_impl.h>
#endif

#endif // CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H
