// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_LABELED_IMAGE_2_H
#define CGAL_COMPLEX_CONSTRUCTION_LABELED_IMAGE_2_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgComplexConstructionRef

An image of labels, input of `make_deformable_simplicial_complex_2()`. Pixels are squares of side 1.
The lower left corner of the image is the origin.
*/
struct Labeled_image_2
{
  /// \var width
  /// number of pixels in a row
  /// \var height
  /// number of rows of pixels
  std::size_t width = 0, height = 0;
  std::vector<int> labels; ///< row by row from top to bottom, each from left to right

  /// Returns the rectangle of all pixels.
  Bbox_2 bbox() const { return {0, 0, double(width), double(height)}; }

  /// Returns the label of the pixel that contains p; if p is outside the image, of the nearest
  /// pixel.
  /// \pre there is at least one pixel, each pixel has a label, and no coordinate of p is NaN
  template <class Point> int operator()(const Point& p) const {
    const auto index = [](double x, std::size_t n) {
      return std::size_t((std::min)((std::max)(std::floor(x), 0.), double(n - 1)));
    };
    return labels[(height - 1 - index(p.y(), height)) * width + index(p.x(), width)];
  }
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_COMPLEX_CONSTRUCTION_LABELED_IMAGE_2_H
