// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H
#define CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H

#include <CGAL/Deformable_simplicial_complexes/Progress_scope.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>
#include <CGAL/Solid_reconstruction_3/Reconstruction_report_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/Sampled_surface_3.h>
#include <CGAL/Solid_reconstruction_3/internal/clouds/collect_points.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Cloud_shell_3.h>
#include <CGAL/Solid_reconstruction_3/internal/reconstruction/Reconstructor_3.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/// \ingroup PkgSolidReconstruction3Ref
/// The observer of a reconstruction that does nothing.
/// \cgalModels `ReconstructionObserver_3`
struct Reconstruction_observer_3
{
  /// Asked before the first step and after each one; false ends the reconstruction.
  template <class Complex> bool operator()(const Complex& /*complex*/, std::size_t /*step*/) const {
    return true;
  }
};

/*!
\ingroup PkgSolidReconstruction3Ref

Reconstructs the solid whose surface points sample (section 4.3 of the paper): the interface begins
in an octree, around the points and the solid, and moves inwards, to the planes of the points that
its facets touch; then all of its vertices go to where the facets are nearest to all points, by
least squares, and facets that do not fit are divided. Parts separate, tunnels open, and the result
is closed, with label 1 inside. Sharp edges stay sharp.

The sides are determined first: the largest empty Delaunay balls at the points are labelled inside
or outside (R. Kolluri, J. R. Shewchuk and J. F. O'Brien, "Spectral surface reconstruction from
noisy point clouds", SGP 2004). The interface does not leak through holes of the cloud that are
narrow compared with the solid behind them, and voids are found. A hole is closed by facets without
points, which the report lists.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam PointRange a range whose value type is the key type of the point map, or a `Point_set_3`, of
        which its points and normals are taken

\param points the points, in any order
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{where the points are}
    \cgalParamType{a model of `ReadablePropertyMap` whose value type has `x()`, `y()` and `z()`}
    \cgalParamDefault{`Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{normals of the surface, of any length and sign; those that are 0 or not
                          finite are estimated}
    \cgalParamType{a model of `ReadablePropertyMap` whose value type has `x()`, `y()` and `z()`}
    \cgalParamDefault{estimated from the 16 nearest points}
  \cgalParamNEnd
  \cgalParamNBegin{fit_tolerance}
    \cgalParamDescription{facets are divided where the root of the mean square of the distances of
                          their points is more, in units of the mean distance of points from their
                          six nearest ones, or twice the noise; positive, finite. No edges are asked
                          for that are shorter than two of these distances and 12 times the noise.}
    \cgalParamType{`double`} \cgalParamDefault{0.03}
  \cgalParamNEnd
  \cgalParamNBegin{keep_open}
    \cgalParamDescription{whether points that sample an open sheet are accepted. The result is closed
                          all the same; the sheet is its interface without
                          `Reconstruction_report_3::facets_without_points`.}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how many steps the interface makes at the most; 1 or more}
    \cgalParamType{`unsigned int`} \cgalParamDefault{80}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{threads to use where linked with TBB; the result does not depend on it}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{observer}
    \cgalParamDescription{`observer(complex, step)` is asked before the first step and after each one;
                          if it returns false, the reconstruction ends with what there is}
    \cgalParamType{model of `ReconstructionObserver_3`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Reconstruction_observer_3`}
  \cgalParamNEnd
  \cgalParamNBegin{report}
    \cgalParamDescription{filled with what was found; handles in it are those of the result}
    \cgalParamType{`std::reference_wrapper` of a `Reconstruction_report_3<Complex>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the complex: label 1 inside, 0 between that and a box around it. Its interface is manifold.
\throws Invalid_points_error if coordinates are not finite, the extent
        of the points is not between 1e-30 and 1e30, there are fewer than four different points, all
        lie in a plane, what they enclose is nothing or too thin, or they sample an open sheet: more
        than a quarter of the boundary of what they enclose has no points, and `keep_open` is
`false`
\throws Error if a parameter is out of its range. The report stays
        what it was if anything is thrown, by the observer or a map, too.
\throws Interrupted_error if the callback of a
        `Progress_scope` returns `false`

n log n in the number of points, if their Delaunay triangulation is linear, and for each of some
tens of steps a query for each point and the deformation of the interface. A cloud of 20 000 points
takes 3 to 5 seconds, and of an open scan about half a millisecond a point.
*/
template <class Complex, class PointRange, class NP = parameters::Default_named_parameters>
Complex reconstruct_point_set_3(const PointRange& points,
                                const NP& np = parameters::default_values()) {
  namespace tags = internal_np;

  const double tolerance = number_parameter(np, tags::fit_tolerance, defaults::fit_tolerance);
  if (!(tolerance > 0 && tolerance <= (std::numeric_limits<double>::max)()))
    throw Error("the tolerance of the fit is not positive and finite: use 0.03, for example");
  const unsigned steps =
      internal::count_parameter(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                                defaults::Number_of_iterations::of_reconstruction);
  const unsigned threads = internal::count_parameter(
      np, tags::number_of_threads, "number_of_threads", defaults::number_of_threads);
  auto observer = parameter_or(np, tags::observer, Reconstruction_observer_3());
  Reconstruction_report_3<Complex> unwanted;
  auto report = parameter_or(np, tags::report, std::ref(unwanted));

  const Progress_phase phase("reconstructing a surface");
  const auto given = internal::collect_points(points, np);
  const bool keeps_open = parameter_or(np, tags::keep_open, false);
  const internal::Sampled_surface_3 surface(given.points, given.normals, keeps_open, threads);
  const internal::Cloud_shell_3 shell(surface);
  Complex complex = internal::complex_of_shell<Complex>(shell);
  internal::Reconstructor_3<Complex> reconstructor(complex, surface, shell.edge(), tolerance,
                                                   threads);
  report.get() = reconstructor.run(steps, internal::unwrap(observer));
  return complex;
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_SOLID_RECONSTRUCTION_3_RECONSTRUCT_POINT_SET_3_H
