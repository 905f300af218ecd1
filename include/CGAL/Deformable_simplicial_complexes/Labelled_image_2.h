// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_IMAGE_2_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_IMAGE_2_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

is an image of labels, to make a complex from by `make_deformable_simplicial_complex_2()`: pixels
are squares of side 1, the lower left corner of the image being the origin.
*/
struct Labelled_image_2
{
  std::size_t width = 0, height = 0;
  std::vector<int> labels; ///< row by row from above, each from left to right

  /// The rectangle of all pixels.
  Bbox_2 bbox() const { return {0, 0, double(width), double(height)}; }

  /// The label of the pixel that p is in; of the nearest if it is outside. \pre there is a pixel,
  /// each has a label, and p has no NaN
  template <class Point> int operator()(const Point& p) const {
    const auto index = [](double x, std::size_t n) {
      return std::size_t((std::min)((std::max)(std::floor(x), 0.), double(n - 1)));
    };
    return labels[(height - 1 - index(p.y(), height)) * width + index(p.x(), width)];
  }
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_LABELLED_IMAGE_2_H
