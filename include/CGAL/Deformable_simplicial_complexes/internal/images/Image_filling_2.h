// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMAGES_IMAGE_FILLING_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMAGES_IMAGE_FILLING_2_H

#include <CGAL/Deformable_simplicial_complexes/Labelled_image_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/building/Curve_soup_2.h>

#include <CGAL/Bbox_2.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Labelled triangles that fill the rectangle of an image, or a box around it.
struct Image_filling_2
{
  std::vector<Planar_kernel::Point_2> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> labels;
};

// Triangulates an image. `edge` is the target edge length, in pixels. Throws `Error` if the image,
// the edge length or the box is invalid, or if there are too many pixel edges between labels.
// Complexity: linear in the number of pixels, and O(n log n) in the number n of pixel edges between
// labels.
#ifdef CGAL_DSC_EXTERN // see the component Compiled
Image_filling_2 fill_image(const Labelled_image_2& image, double edge,
                           const std::optional<Bbox_2>& box);
#else
inline Image_filling_2 fill_image(const Labelled_image_2& image, double edge,
                                  const std::optional<Bbox_2>& box);
#endif

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#ifndef CGAL_DSC_EXTERN
#include <CGAL/Deformable_simplicial_complexes/internal/images/Image_filling_2_impl.h>
#endif

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_IMAGES_IMAGE_FILLING_2_H
