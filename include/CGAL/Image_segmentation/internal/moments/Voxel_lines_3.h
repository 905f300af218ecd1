// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_VOXEL_LINES_3_H
#define CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_VOXEL_LINES_3_H

#include <CGAL/Image_segmentation/Gray_image.h>

#include <boost/container/small_vector.hpp>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// Integrals of an image over tetrahedra, with the same fields as `Pixel_sums_2`. The integrals
// along lines in the direction of the first axis are exact; the lines are at the middles of squares
// of a regular subdivision of the voxels. The results are scaled to the exact volume. Coordinates
// are in voxels.
class Voxel_lines_3
{
public:
  using Point = std::array<double, 3>;

  explicit Voxel_lines_3(const Gray_image<3>& image) : m_image(image) {}

  // Adds the integrals over a tetrahedron to `result`, an entry for each field.
  void add(const std::array<Point, 4>& corners, double* result) const {
    const Planes planes(corners);
    if (!(planes.volume > 0))
      return;
    // Few lines suffice in large cells, in which errors cancel.
    static constexpr double lines_across = 6; // least number of lines across a cell
    static constexpr double most = 8;         // lines along a side of a voxel
    const double n = std::clamp(std::ceil(lines_across / std::cbrt(6 * planes.volume)), 1., most);
    Fields sums(m_image.channels.size() + 2, 0.);
    bool is_inside = true;
    const double lengths = add_lines(corners, planes, n, sums, is_inside);
    if (lengths > 0) {
      const double area = is_inside ? planes.volume / lengths : 1 / (n * n); // of a line
      for (std::size_t f = 0; f < sums.size(); ++f)
        result[f] += sums[f] * area;
      return;
    }
    Point center = {};
    for (const Point& p : corners)
      for (int axis = 0; axis < 3; ++axis)
        center[axis] += p[axis] / 4;
    add_run(center[0], center[0], row_at(center[1], center[2]), planes.volume, sums);
    for (std::size_t f = 0; f < sums.size(); ++f)
      result[f] += sums[f];
  }

private:
  using Fields = boost::container::small_vector<double, 6>; // a value for each field

  // The barycentric coordinates as linear functions.
  struct Planes
  {
    explicit Planes(const std::array<Point, 4>& p) {
      std::array<Point, 3> e;
      for (int i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
          e[i][axis] = p[i + 1][axis] - p[0][axis];
      const auto cross = [](const Point& a, const Point& b) {
        return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
      };
      const Point n = cross(e[1], e[2]);
      const double determinant = e[0][0] * n[0] + e[0][1] * n[1] + e[0][2] * n[2];
      volume = determinant / 6;
      gradients[1] = n;
      gradients[2] = cross(e[2], e[0]);
      gradients[3] = cross(e[0], e[1]);
      gradients[0] = {};
      for (int i = 1; i < 4; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          gradients[i][axis] /= determinant;
          gradients[0][axis] -= gradients[i][axis];
        }
      for (int i = 0; i < 4; ++i) {
        constants[i] = i == 0 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis)
          constants[i] -= gradients[i][axis] * p[0][axis];
      }
    }

    double volume;
    std::array<Point, 4> gradients;
    std::array<double, 4> constants;
  };

  // Adds the integrals along the lines in the image; returns the sum of their lengths. Sets
  // `is_inside` to false if lines outside the image cross the cell.
  double add_lines(const std::array<Point, 4>& corners, const Planes& planes, double n,
                   Fields& sums, bool& is_inside) const {
    std::array<double, 2> least, largest;
    for (int k = 0; k < 2; ++k) {
      least[k] = std::numeric_limits<double>::infinity();
      largest[k] = -least[k];
      for (const Point& p : corners) {
        least[k] = (std::min)(least[k], p[k + 1]);
        largest[k] = (std::max)(largest[k], p[k + 1]);
      }
    }
    static constexpr double rounding = 1e-9; // of vertices on the sides of the image
    for (int k = 0; k < 2; ++k) {
      const double size = double(m_image.grid.size[k + 1]);
      is_inside = is_inside && least[k] >= -rounding && largest[k] <= size + rounding;
      least[k] = (std::max)(least[k], 0.);
      largest[k] = (std::min)(largest[k], size);
    }
    const auto first = [&](int k) { return std::ceil(least[k] * n - .5); };
    const auto last = [&](int k) { return std::floor(largest[k] * n - .5); };
    double lengths = 0;
    for (double j = first(1); j <= last(1); ++j)
      for (double i = first(0); i <= last(0); ++i) {
        const double y = (i + .5) / n, z = (j + .5) / n;
        double from = -std::numeric_limits<double>::infinity(), to = -from;
        for (int k = 0; k < 4; ++k) {
          const double slope = planes.gradients[k][0], rest = planes.constants[k] +
                                                              planes.gradients[k][1] * y +
                                                              planes.gradients[k][2] * z;
          if (slope > 0)
            from = (std::max)(from, -rest / slope);
          else if (slope < 0)
            to = (std::min)(to, -rest / slope);
          else if (rest < 0)
            to = from;
        }
        if (!(to > from))
          continue;
        lengths += to - from;
        add_run(from, to, row_at(y, z), 1, sums);
      }
    return lengths;
  }

  // Returns the index of the first voxel of a row; the number of voxels if the row is outside.
  std::size_t row_at(double y, double z) const {
    const auto& size = m_image.grid.size;
    if (!(y >= 0 && z >= 0 && y < double(size[1]) && z < double(size[2])))
      return size[0] * size[1] * size[2];
    return (std::size_t(z) * size[1] + std::size_t(y)) * size[0];
  }

  // Adds a factor times the integrals along a part of a row; the value at a point if the part is a
  // point.
  void add_run(double from, double to, std::size_t row, double factor, Fields& sums) const {
    const auto& size = m_image.grid.size;
    if (row == size[0] * size[1] * size[2])
      return;
    const bool is_point = from == to;
    from = (std::max)(from, 0.);
    to = (std::min)(to, double(size[0]));
    if (is_point ? !(from < double(size[0]) && to >= 0) : !(to > from))
      return;
    if (is_point) {
      add_voxel(row + std::size_t(from), factor, sums);
      return;
    }
    const auto first = std::size_t(from), last = (std::min)(std::size_t(to), size[0] - 1);
    if (first == last) {
      add_voxel(row + first, factor * (to - from), sums);
      return;
    }
    add_voxel(row + first, factor * (double(first + 1) - from), sums);
    for (std::size_t i = first + 1; i < last; ++i)
      add_voxel(row + i, factor, sums);
    add_voxel(row + last, factor * (to - double(last)), sums);
  }

  void add_voxel(std::size_t voxel, double part, Fields& sums) const {
    if (!m_image.has_value(voxel))
      return;
    sums[0] += part;
    for (std::size_t k = 0; k < m_image.channels.size(); ++k) {
      const double value = m_image.channels[k][voxel];
      sums[k + 2] += part * value;
      sums[1] += part * value * value;
    }
  }

  const Gray_image<3>& m_image;
};

} // namespace internal

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_IMAGE_SEGMENTATION_INTERNAL_MOMENTS_VOXEL_LINES_3_H
