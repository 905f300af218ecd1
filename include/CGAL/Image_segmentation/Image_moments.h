// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_IMAGE_MOMENTS_H
#define CGAL_IMAGE_SEGMENTATION_IMAGE_MOMENTS_H

#include <CGAL/Image_segmentation/Gray_image.h>
#include <CGAL/Image_segmentation/internal/moments/Pixel_sums_2.h>
#include <CGAL/Image_segmentation/internal/moments/Voxel_lines_3.h>

#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgImageSegmentationRef

Integrals of an image over cells and facets. They count pixels: a pixel has the measure 1. Values
outside the image are 0. In the plane, integrals over cells are exact up to rounding. In space, they
are exact along lines in the direction of the first axis, with up to 8 lines for each side of a
voxel. A cell that no line crosses has the value at its centroid.

Any number of threads may use an object. In the plane, it takes 8 bytes for each pixel and field.

\tparam d the dimension, 2 or 3
*/
template <int d> class Image_moments
{
public:
  using Place = std::array<double, d>; ///< coordinates in pixels; pixel 0 is the box from 0 to 1

  /// Integrals over a cell.
  struct Moments
  {
    double pixels = 0;        ///< the measure of the part of the cell in pixels with values
    double squares = 0;       ///< integral of the sum of the squares of all channels
    std::vector<double> sums; ///< integral of each channel
  };

  /// Prepares the integrals of an image. Linear.
  /// \param image the image, which must outlive the object
  /// \throws Error if the image cannot be used, see `Gray_image::check()`
  explicit Image_moments(const Gray_image<d>& image)
      : m_image(image), m_integrals(checked(image)) {}

  /// Returns the image.
  const Gray_image<d>& image() const { return m_image; }

  /// Returns the coordinates in pixels of a point in user coordinates.
  template <class Point> Place place(const Point& p) const {
    Place result;
    for (int axis = 0; axis < d; ++axis)
      result[axis] = (p[axis] - m_image.grid.origin[axis]) / m_image.grid.spacing[axis] + .5;
    return result;
  }

  /// Returns the moments of a finite cell of a complex. Linear in the number of rows of pixels, or
  /// of lines, that cross the cell.
  template <class Complex>
  Moments operator()(const Complex& complex, typename Complex::Cell_handle cell) const {
    std::array<Place, d + 1> corners;
    for (int i = 0; i <= d; ++i)
      corners[i] = place(complex.user_position(cell->vertex(i)));
    std::vector<double> fields(number_of_fields(), 0.);
    add(corners, fields.data());
    return {fields[0], fields[1], std::vector<double>(fields.begin() + 2, fields.end())};
  }

  /// Returns the number of integrals of `add()`.
  std::size_t number_of_fields() const { return m_image.channels.size() + 2; }

  /// Adds the moments of a cell to numbers, in the order of the members of `Moments`.
  /// \param corners the corners of the cell, positively oriented
  /// \param fields `number_of_fields()` numbers
  void add(const std::array<Place, d + 1>& corners, double* fields) const {
    m_integrals.add(corners, fields);
  }

  /// Divides a facet into pieces, and visits those in pixels with values. In the plane, each piece
  /// is the part in one pixel; in space, it is a triangle, shorter than a voxel if the facet is
  /// shorter than a thousand voxels.
  /// \param corners the corners of the facet
  /// \param visit `visit(weights, share, pixel)` gets the barycentric coordinates of the middle of
  ///        the piece, an `std::array<double, d>`, its part of the measure of the facet, and the
  ///        index of the pixel
  template <class Visit>
  void for_each_piece(const std::array<Place, d>& corners, const Visit& visit) const {
    const auto visit_at = [&](const std::array<double, d>& weights, double share) {
      static constexpr double rounding = 1e-9; // of vertices on the sides of the image
      std::size_t pixel = 0;
      for (int axis = d; axis-- > 0;) {
        double x = 0;
        for (int i = 0; i < d; ++i)
          x += weights[i] * corners[i][axis];
        const double size = double(m_image.grid.size[axis]);
        if (!(x >= -rounding && x <= size + rounding))
          return;
        pixel =
            pixel * m_image.grid.size[axis] + std::size_t(std::clamp(std::floor(x), 0., size - 1));
      }
      if (m_image.has_value(pixel))
        visit(weights, share, pixel);
    };
    if constexpr (d == 2) {
      internal::Segment_part part;
      for (std::size_t axis = 0; axis < 2; ++axis)
        part = internal::clip(part, corners[0][axis], corners[1][axis],
                              double(m_image.grid.size[axis]));
      internal::for_each_pixel_piece(corners[0], corners[1], part, [&](double from, double to) {
        const double middle = (from + to) / 2;
        visit_at({1 - middle, middle}, to - from);
      });
    } else
      for_each_triangle(corners, visit_at);
  }

private:
  using Integrals = std::conditional_t<d == 2, internal::Pixel_sums_2, internal::Voxel_lines_3>;

  static const Gray_image<d>& checked(const Gray_image<d>& image) {
    image.check();
    return image;
  }

  // Divides a triangle into n * n equal ones.
  template <class Visit>
  static void for_each_triangle(const std::array<Place, d>& corners, const Visit& visit) {
    double longest = 0;
    for (int i = 0; i < d; ++i) {
      double squared = 0;
      for (int axis = 0; axis < d; ++axis) {
        const double x = corners[(i + 1) % d][axis] - corners[i][axis];
        squared += x * x;
      }
      longest = (std::max)(longest, squared);
    }
    static constexpr double most = 1000; // pieces along a side, for facets far larger than an image
    const int n = int(std::clamp(std::ceil(std::sqrt(longest)), 1., most));
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (int up = 1; up <= (i + j + 1 < n ? 2 : 1); ++up) {
          const double a = (i + up / 3.) / n, b = (j + up / 3.) / n;
          visit({1 - a - b, a, b}, 1. / (n * n));
        }
  }

  const Gray_image<d>& m_image;
  Integrals m_integrals;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_IMAGE_MOMENTS_H
