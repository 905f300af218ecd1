// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H
#define CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H

#include <CGAL/license/Complex_construction.h>

#include <CGAL/Complex_construction/Construction_options.h>
#include <CGAL/Complex_construction/internal/conversion/Labeled_voxels_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_components_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_frame_3.h>
#include <CGAL/Complex_construction/internal/conversion/Voxel_interface_3.h>
#include <CGAL/Complex_construction/internal/thin_parts/improve_new_mesh.h>
#include <CGAL/Complex_construction/make_deformable_simplicial_complex_3.h>
#include <CGAL/Interface_remeshing/control_detail.h>
#include <CGAL/Interface_remeshing/improve_interface.h>
#include <CGAL/Interface_remeshing/restore_volumes.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/named_parameters.h>
#include <CGAL/Mesh_support/parameter_values.h>

#include <CGAL/Image_3.h>

#include <cmath>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

Makes a complex from a labeled image, such as a segmented scan. The values of voxels are the
labels; 0 is the outside. A voxel is the box centered at its image point; its sides are the spacings
of the image.

Each connected component of a label, connected through common faces of voxels, becomes a component
of the complex with the volume of its voxels. Components whose voxels share only edges or vertices
remain different components, which have these edges or vertices in common. The interface is smooth.
Its distance from the faces of voxels is at most of the order of `edge`.

n log n in the number of voxels at the interface, linear in the number of the others. Memory: up to
6 kB for each voxel of noise, less than 70 bytes for each voxel of large smooth objects.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam NP a sequence of named parameters

\param image image of integers from 0 to 2^31 - 1
\param edge approximate length of interface edges, in the unit of the image, positive; or 0 for 2.5
       times the longest side of a voxel. Edges are shorter where components are small.
\param np a `Construction_options<3>`, or named parameters `normalize`, `enclosing_box`, `improve`, `quality_threshold`,
       `number_of_iterations` of `make_deformable_simplicial_complex_3()` from surfaces. The default
       box is a cube about the bounding box of the voxels with labels other than 0. Both have the
       same center, and the half side of the cube is 2.5 times half the diagonal of the bounding
       box. If `enclosing_box` is the box of all voxels, they fill the domain. The interface then
       ends on the boundary of the domain and can move along it, and 0 is a label like others.

\throws Error if the image has no voxels, has several values for a voxel, holds a value that is not
        a label, or holds label 0 only; if the sides of voxels are not positive and finite; if more
        than 2^20 voxels are in a row; if voxels with labels other than 0 reach the boundary of a
        box that is not the box of all voxels; if `edge` is negative or not finite; or if `edge` is
        so long that the volume of a component differs from that of its voxels by more than a
        thousandth
\throws Interrupted_error if the callback of a `Progress_scope` returns `false`
*/
template <class Complex, class NP = parameters::Default_named_parameters>
Complex make_complex_from_labeled_image_3(const Image_3& image, double edge,
                                          const NP& np = parameters::default_values()) {
  static constexpr double voxels_of_edge = 2.5; // shorter edges would follow steps
  if (!(edge >= 0) || !std::isfinite(edge))
    throw Error(
        "the edge length is negative or not finite: use a positive length, or 0 for the default");
  const auto options = construction_options<3>(np);
  const auto& domain = options.enclosing_box;
  const internal::Labeled_voxels_3 voxels =
      internal::labeled_voxels(image, domain && internal::is_box_of_voxels(image, *domain));
  const internal::Voxel_components_3 components(voxels);
  const internal::Voxel_frame_3 frame(voxels, options.normalize, domain);
  const internal::Voxel_interface_3<Complex> interface_(
      components, frame,
      (edge > 0 ? edge : voxels_of_edge * voxels.largest_spacing()) / frame.scale);
  Complex dsc = interface_.build();
  interface_.smooth(dsc);
  interface_.coarsen(dsc);
  interface_.restore(dsc);
  internal::label_by_components(dsc, components);
  internal::improve_new_mesh(dsc, options);
  dsc.measure_interface_edges();
  dsc.take_component_events();
  return dsc;
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_CONVERT_LABELED_IMAGE_3_H
