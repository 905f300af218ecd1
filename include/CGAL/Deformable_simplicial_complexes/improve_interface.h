// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H

#include <CGAL/license/Deformable_simplicial_complexes.h>

#include <CGAL/Deformable_simplicial_complexes/Improvement_report.h>
#include <CGAL/Deformable_simplicial_complexes/Interface_improvement_options.h>
#include <CGAL/Deformable_simplicial_complexes/internal/remeshing/Interface_improver.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/Deformable_simplicial_complexes/parameter_values.h>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Does the same as `improve_interface()` with named parameters.

\throws Error as that function does, see also `Interface_improvement_options::check()`
*/
template <class Complex>
Improvement_report improve_interface(Complex& dsc,
                                     const Interface_improvement_options<Complex>& options) {
  return internal::remesh_interface(dsc, options);
}

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Improves the facets of the interface, with small changes of its shape (section 3.2.2 of the paper).
The function splits long edges, collapses short edges, and moves vertices along the interface
(null-space smoothing). In 3D, it also flips edges that do not fulfill the Delaunay criterion, and
removes facets with small angles. Cells around that become badly shaped are improved. A pass over
the cells and the stars of the vertices of the interface for each iteration.

The topology stays. Lines and points where more than two labels meet stay, except where edges or, on
request, junctions are split. Sharp edges and corners keep their shape: sharp edges are not flipped,
and their vertices move and collapse only along them. In 2D, corners stay. Smoothing keeps the
volumes of labels up to rounding; flips, collapses and curved splits change them slightly.

\param dsc the complex
\param np named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{number of repetitions of all operations}
    \cgalParamType{`unsigned int`} \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{aggressiveness}
    \cgalParamDescription{largest ratio of the eigenvalues of the quadric of a vertex for which it
                          may move in a direction, see `propose_null_space_position()`; in [0, 1); 0
                          for no smoothing}
    \cgalParamType{`double`} \cgalParamDefault{0.025, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{flip_angle}
    \cgalParamDescription{an edge that does not fulfill the Delaunay criterion is flipped if the
                          normals of its facets differ by a smaller angle, in degrees, in [0, 90].
                          The worst cell around must improve or stay above the threshold. In 3D
                          only.}
    \cgalParamType{`double`} \cgalParamDefault{5, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{feature_angle}
    \cgalParamDescription{edges where the normals of the facets differ by a larger angle, in
                          degrees, in [0, 180], are features. They are never flipped, and their
                          vertices move and collapse only along feature lines that bend by a smaller
                          angle. In 2D, vertices where the edges differ by a larger angle are
                          corners.}
    \cgalParamType{`double`} \cgalParamDefault{60}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{target edge length, a positive function of position in the coordinates of
                          the complex: `double sizing_field(Approximate_point p)`, callable as
                          `const`, evaluated at midpoints of edges; for example
                          `Curvature_sizing_field`}
    \cgalParamType{function object, by value or `std::reference_wrapper`}
    \cgalParamDefault{`dsc.mean_interface_edge()` everywhere}
  \cgalParamNEnd
  \cgalParamNBegin{interface_split_length}
    \cgalParamDescription{longer edges are split; in units of the target edge length, positive}
    \cgalParamType{`double`} \cgalParamDefault{2, the paper's}
  \cgalParamNEnd
  \cgalParamNBegin{curved_splits}
    \cgalParamDescription{whether new vertices are placed on a smooth surface or curve interpolated
                          from the neighbors of the edge, instead of on the edge; only where the
                          interface is smooth}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{split_junctions}
    \cgalParamDescription{whether vertices where more than three phases meet are split into two
                          junctions if this decreases the energy, see `propose_junction_split()`; in
                          2D only}
    \cgalParamType{`bool`} \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{interface_energy}
    \cgalParamDescription{the energy that splits of junctions decrease; energy densities have no
                          effect}
    \cgalParamType{`Interface_energy`} \cgalParamDefault{the length of the interface}
  \cgalParamNEnd
  \cgalParamNBegin{interface_collapse_length}
    \cgalParamDescription{shorter edges are collapsed; in units of the target edge length, at least
                          0}
    \cgalParamType{`double`} \cgalParamDefault{0.25}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_facet_angle}
    \cgalParamDescription{an edge of a facet with a smaller angle is flipped or collapsed, whichever
                          changes the shape less; in degrees, in [0, 30]; in 3D only}
    \cgalParamType{`double`} \cgalParamDefault{15}
  \cgalParamNEnd
  \cgalParamNBegin{swept_volume}
    \cgalParamDescription{largest volume between the interface before and after a collapse, or after
                          a flip that removes a small angle; in cubes (in 2D, squares) of the target
                          edge length, at least 0}
    \cgalParamType{`double`} \cgalParamDefault{0.1}
  \cgalParamNEnd
  \cgalParamNBegin{quality_threshold}
    \cgalParamDescription{changed cells of lower quality are improved, in [0, 1]}
    \cgalParamType{`double`} \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{visitor that is called at each change of the mesh}
    \cgalParamType{model of `DeformationVisitor`, by value or `std::reference_wrapper`}
    \cgalParamDefault{`Deformation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the numbers of changes
\throws Error if a parameter is out of its range, or there is an interface, but neither a sizing
        field nor `dsc.mean_interface_edge()`. The complex is then unchanged.
\throws Error if the sizing field has a value that is not positive. After this exception, or one of
        the sizing field, of `interface_energy` or of the visitor, the complex is valid.

*/
template <class Complex, class NamedParameters = parameters::Default_named_parameters>
Improvement_report improve_interface(Complex& dsc, const NamedParameters& np = NamedParameters()) {
  namespace tags = internal_np;
  auto visitor = visitor_parameter<Complex>(np);
  Interface_improvement_options<Complex> options;
  options.visitor = &visitor.any();
  replace_count(np, CGAL::internal_np::number_of_iterations, "number_of_iterations",
                options.number_of_iterations);
  replace_value(np, tags::aggressiveness, options.aggressiveness);
  replace_value(np, tags::sizing_field, options.sizing_field);
  replace_value(np, tags::interface_split_length, options.interface_split_length);
  replace_value(np, tags::interface_collapse_length, options.interface_collapse_length);
  replace_value(np, tags::swept_volume, options.swept_volume);
  replace_value(np, tags::flip_angle, options.flip_angle);
  replace_value(np, tags::feature_angle, options.feature_angle);
  replace_value(np, tags::minimum_facet_angle, options.minimum_facet_angle);
  replace_value(np, tags::quality_threshold, options.quality_threshold);
  replace_value(np, tags::curved_splits, options.curved_splits);
  replace_value(np, tags::split_junctions, options.split_junctions);
  replace_value(np, tags::interface_energy, options.interface_energy);
  return improve_interface(dsc, options);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_IMPROVE_INTERFACE_H
