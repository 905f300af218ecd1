// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/default_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Interface_improver.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Improves the facets of the interface without changing its shape by much (section 3.2.2 of the
paper): splits long edges, collapses short ones, and moves vertices along the interface (null-space
smoothing); in space, it also flips edges that do not fulfill the Delaunay criterion and removes
facets with small angles. The cells around are improved where that made them bad.

The topology stays, and so do lines and points where more than two labels meet, except where edges
or, on request, junctions are split.
Sharp edges, corners and their shape stay: vertices move and collapse only along edges, and these
are not flipped; in the plane, corners stay. Smoothing keeps the volumes of labels up to rounding;
flips, collapses and curved splits change them slightly.

\param dsc the complex.
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{how often all of that is done}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{aggressiveness}
    \cgalParamDescription{up to which ratio of the eigenvalues of its quadric a vertex may move in a
                          direction, see `propose_null_space_position()`; in [0, 1), 0 for no
                          smoothing}
    \cgalParamType{`double`} \cgalParamDefault{0.025, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{flip_angle}
    \cgalParamDescription{edges that do not fulfill the Delaunay criterion are flipped if the
                          normals of their facets differ by less, in degrees, in [0, 90], and the
                          worst cell around gets better or stays above the threshold; in space}
    \cgalParamType{`double`} \cgalParamDefault{5, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{feature_angle}
    \cgalParamDescription{edges where the normals of the facets differ by more are features, in
                          degrees, in [0, 180]: never flipped, and their vertices move and collapse
                          only along lines that bend by less; in the plane, vertices where edges
                          differ by more are corners}
    \cgalParamType{`double`} \cgalParamDefault{60}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{the wanted length of edges, a positive function of position:
                          `double sizing_field(Approximate_point p)`, callable as `const`, asked
                          at midpoints of edges, in the coordinates of the complex; for example
                          `Curvature_sizing_field`}
    \cgalParamType{function object, by value or `std::reference_wrapper`}
    \cgalParamDefault{`dsc.mean_interface_edge()` everywhere}
  \cgalParamNEnd
  \cgalParamNBegin{interface_split_length}
    \cgalParamDescription{longer edges are split, in units of the wanted length, positive}
    \cgalParamType{`double`} \cgalParamDefault{2, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{curved_splits}
    \cgalParamDescription{whether new vertices are put on the smooth surface or curve that the neighbors of
                          the edge suggest, where the interface is smooth, and not on the edge}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{split_junctions}
    \cgalParamDescription{whether vertices where more than three phases meet are split into two
                          junctions where that shortens the interface, see
                          `propose_junction_split()`; in the plane}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{interface_collapse_length}
    \cgalParamDescription{shorter edges are collapsed, in units of the wanted length, not negative}
    \cgalParamType{`double`} \cgalParamDefault{0.25}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_facet_angle}
    \cgalParamDescription{an edge of a facet with a smaller angle is flipped or collapsed, whichever
                          changes the shape less, in degrees, in [0, 30]; in space}
    \cgalParamType{`double`} \cgalParamDefault{15}
  \cgalParamNEnd
  \cgalParamNBegin{swept_volume}
    \cgalParamDescription{how much volume may lie between the interface before and after a collapse,
                          or a flip for the sake of a small angle, in cubes of the wanted length,
                          in the plane squares, not negative}
    \cgalParamType{`double`} \cgalParamDefault{0.1}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{cells that changed and are of lower quality are improved, in [0, 1]}
    \cgalParamType{`double`} \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told of each change of the mesh}
    \cgalParamType{model of `DeformationVisitor`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Deformation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what was done.
\throws Error if a parameter is out of its range, or there is an
       interface, but neither a size field nor `dsc.mean_interface_edge()`, the complex then being
       unchanged, or if the size field has a value that is not positive. An exception of the size
       field or of the visitor leaves a valid complex.

A pass over the cells and the stars of the vertices of the interface for each iteration.
*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_interface(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  namespace defaults = defaults;

  auto visitor = visitor_parameter<Complex>(np);
  static constexpr double degree = CGAL_PI / 180;
  const internal::Interface_thresholds thresholds = {
      number_parameter(np, tags::aggressiveness, defaults::aggressiveness),
      number_parameter(np, tags::interface_split_length, defaults::interface_split_length),
      number_parameter(np, tags::interface_collapse_length,
                       defaults::Interface_collapse_length::in_wanted_lengths),
      number_parameter(np, tags::swept_volume, defaults::swept_volume),
      angle_parameter(np, tags::flip_angle, defaults::flip_angle, 90,
                      "angle up to which edges are flipped") *
          degree,
      angle_parameter(np, tags::feature_angle, defaults::feature_angle, 180, "angle of features") *
          degree,
      angle_parameter(np, tags::minimum_facet_angle, defaults::Minimum_facet_angle::of_interface,
                      30, "smallest angle of a facet") *
          degree,
      quality_parameter(np, tags::quality_threshold, defaults::Quality_threshold::beside_interface),
      parameter_or(np, tags::curved_splits, false),
      parameter_or(np, tags::split_junctions, false)};
  internal::check_interface_thresholds(thresholds);
  const unsigned iterations =
      internal::count_parameter(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                                defaults::Number_of_iterations::over_interface);
  const auto unit = wanted_length(dsc, np);

  return internal::remesh_interface(dsc, thresholds, unit, iterations, visitor.any());
}

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H
