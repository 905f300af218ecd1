// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONVERT_LABELLED_IMAGE_3_H
#define CGAL_CONVERT_LABELLED_IMAGE_3_H

#include <CGAL/Deformable_simplicial_complex_3/internal/conversion/Labelled_voxels_3.h>
#include <CGAL/Deformable_simplicial_complex_3/internal/conversion/mesh_of_image_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/named_parameters.h>
#include <CGAL/convert_mesh_complex_3.h>
#include <CGAL/restore_volumes_3.h>

#include <CGAL/Image_3.h>

#include <cmath>
#include <string>

namespace CGAL {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Makes a complex of a labelled image, such as a segmented scan: the values of voxels are the labels,
0 is the outside. Mesh_3 finds the interface halfway between the centers of voxels, tetrahedra fill
the box around, then `restore_volumes()` gives each label the volume of its voxels. So small parts
and thin ones are found, but the interface is smoother than the voxels.

\tparam Complex an instance of `Deformable_simplicial_complex_3`
\tparam Tetrahedralizer model of `ConstrainedTetrahedralizer_3`, such as `Tetgen_tetrahedralizer_3`
\tparam NP a sequence of named parameters

\param image holds whole numbers from 0 to 2^24
\param edge about how long interface edges are to be, in the unit of the image, more than 0; or 0 for
       two and a half times the longest side of a voxel
\param tetrahedralizer fills the space around
\param np named parameters of `make_deformable_simplicial_complex_3()` from surfaces

\throws Deformable_simplicial_complexes::Error if the image has no voxels, holds other values, or all
        of them are 0, or `edge` is negative, or so long that a label would be lost; or as
`make_deformable_simplicial_complex_3()` from tetrahedra in a box

Linear in the number of voxels, plus the meshing.
*/
template <class Complex, class Tetrahedralizer,
          class NP = Deformable_simplicial_complexes::parameters::Default_named_parameters>
Complex make_complex_from_labelled_image_3(
    const Image_3& image, double edge, const Tetrahedralizer& tetrahedralizer,
    const NP& np = Deformable_simplicial_complexes::parameters::default_values()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  static constexpr double voxels_of_edge = 2.5; // shorter ones would follow the stairs
  if (!(edge >= 0) || !std::isfinite(edge))
    throw Deformable_simplicial_complexes::Error(
        "the length of edges is negative or not finite: use more than 0, or 0 for the default");
  const internal::Labelled_voxels_3 voxels(image);
  auto volumes = voxels.volumes();
  if (volumes.empty())
    throw Deformable_simplicial_complexes::Error("the image holds no label but 0: there is nothing "
                                                 "to be found in it");
  const internal::Mesh_of_image_3 meshed(
      voxels, edge > 0 ? edge : voxels_of_edge * voxels.largest_spacing());
  auto dsc = make_complex_from_mesh_complex_3<Complex>(meshed.mesh(), tetrahedralizer, np);
  for (auto& [label, volume] : volumes) {
    if (dsc.number_of_cells(label) == 0)
      throw Deformable_simplicial_complexes::Error(
          "label " + std::to_string(label) +
          " of the image is in parts too small for these edges: use shorter ones");
    volume /= std::pow(dsc.normalization().scale, 3);
  }
  restore_volumes(dsc, volumes);
  dsc.measure_interface_edges();
  dsc.take_component_events();
  return dsc;
}

} // namespace CGAL

#endif // CGAL_CONVERT_LABELLED_IMAGE_3_H
