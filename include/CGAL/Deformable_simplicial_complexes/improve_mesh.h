// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_MESH_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_MESH_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/improve_whole_mesh.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Improves the cells of a complex, triangles or tetrahedra, by reconnection, smoothing, collapses and
insertion of vertices, each done only if it raises the worst quality where it acts, and by splits of
long edges (Algorithm 3 of the paper; insertion: Klingner and Shewchuk 2007). Where cells stay bad,
those around are improved beyond the threshold, to give them room. The interface stays as it is, bit
for bit, unless its vertices may be smoothed.

What is improved is the measure of the complex. In space, where dihedral angles count,
`Biased_minimum_sine_3` is the one to choose.

\param dsc the complex.
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{only cells of lower quality are improved, in [0, 1];
                          the higher it is, the more vertices are inserted}
    \cgalParamType{`double`} \cgalParamDefault{0.25; 0.46 if `aggressive`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how many rounds at the most: each round works on what the last one made.
                          Six times as many where neighbors are improved, too, and that for each
                          threshold if `aggressive`}
    \cgalParamType{`unsigned int`} \cgalParamDefault{10}
  \cgalParamNEnd
  \cgalParamNBegin{aggressive}
    \cgalParamDescription{whether to raise the threshold in steps, and then to disturb and improve
                          the surroundings of bad cells again and again, which in space takes
                          minutes instead of seconds}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{smooth_interface}
    \cgalParamDescription{whether vertices of the interface may move where it is flat, within their
                          plane, or straight, on their line: see `propose_optimal_position()`; in
                          space only}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{threads to use if `aggressive`, where linked with TBB; the result does not
                          depend on it}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told of each change of the mesh}
    \cgalParamType{model of `DeformationVisitor`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Deformation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was done.
\throws Error if a parameter is out of its range; the complex is
       then unchanged. An exception of the visitor leaves a valid complex.

Some passes over the cells, then n log n in the number of cells below the threshold. Random numbers
are drawn from generators of its own, with fixed seeds.
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_mesh(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  namespace defaults = defaults;
  using Threshold = defaults::Quality_threshold;

  auto visitor = visitor_parameter<Complex>(np);
  const bool aggressive = parameter_or(np, tags::aggressive, false);
  const double threshold =
      quality_parameter(np, tags::quality_threshold,
                        aggressive ? Threshold::of_mesh_if_aggressive : Threshold::of_mesh);
  const unsigned rounds =
      internal::count_parameter(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                                defaults::Number_of_iterations::over_mesh);
  const bool smooth_interface = parameter_or(np, tags::smooth_interface, false);

  const unsigned number_of_threads = internal::count_parameter(
      np, tags::number_of_threads, "number_of_threads", defaults::number_of_threads);

  return internal::improve_whole_mesh(
      dsc, {threshold, rounds, aggressive, smooth_interface, number_of_threads}, visitor.any());
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_MESH_H
