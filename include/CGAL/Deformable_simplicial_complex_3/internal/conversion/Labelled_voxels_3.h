// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_LABELLED_VOXELS_3_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_LABELLED_VOXELS_3_H

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <CGAL/Image_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// The voxels of an image and their labels; voxels are numbered with x running fastest.
class Labelled_voxels_3
{
public:
  // Throws Error if there are no voxels, or values are no labels.
  explicit Labelled_voxels_3(const Image_3& image) {
    if (!image.is_valid() || image.size() == 0)
      throw Error("the image has no voxels: read one");
    m_size = {image.xdim(), image.ydim(), image.zdim()};
    m_spacing = {image.vx(), image.vy(), image.vz()};
    m_origin = {image.tx(), image.ty(), image.tz()};
    for (const double spacing : m_spacing)
      if (!(spacing > 0) || !std::isfinite(spacing))
        throw Error("the voxels of the image have no volume: their sides have to be longer than 0");
    m_labels.reserve(image.size());
    for (std::size_t k = 0; k < m_size[2]; ++k)
      for (std::size_t j = 0; j < m_size[1]; ++j)
        for (std::size_t i = 0; i < m_size[0]; ++i) {
          // All integers up to that are numbers of type float, which images return.
          static constexpr float largest_label = 1 << 24;
          const float value = image.value(i, j, k);
          if (!(value >= 0 && value <= largest_label) || value != std::floor(value))
            throw Error("the image holds values that are no labels: use whole numbers from 0 on");
          m_labels.push_back(int(value));
        }
  }

  // The image with a layer of voxels of label 0 around: at its border, too, the interface is then
  // halfway between the centers of voxels.
  Image_3 padded_image() const {
    std::array<std::size_t, 3> size;
    for (int axis = 0; axis < 3; ++axis)
      size[axis] = m_size[axis] + 2;
    _image* image =
        _createImage(unsigned(size[0]), unsigned(size[1]), unsigned(size[2]), 1, m_spacing[0],
                   m_spacing[1], m_spacing[2], sizeof(std::uint32_t), WK_FIXED, SGN_UNSIGNED);
    image->tx = float(m_origin[0] - m_spacing[0]);
    image->ty = float(m_origin[1] - m_spacing[1]);
    image->tz = float(m_origin[2] - m_spacing[2]);
    std::uint32_t* const values = static_cast<std::uint32_t*>(image->data);
    std::fill_n(values, size[0] * size[1] * size[2], 0);
    for (std::size_t v = 0; v < m_labels.size(); ++v) {
      const auto at = place(v);
      values[((at[2] + 1) * size[1] + at[1] + 1) * size[0] + at[0] + 1] =
          std::uint32_t(m_labels[v]);
    }
    return Image_3(image);
  }

  double largest_spacing() const { return *std::max_element(m_spacing.begin(), m_spacing.end()); }

  std::array<double, 3> center(std::size_t voxel) const {
    const auto at = place(voxel);
    std::array<double, 3> result;
    for (int axis = 0; axis < 3; ++axis)
      result[axis] = m_origin[axis] + double(at[axis]) * m_spacing[axis];
    return result;
  }

  // The length of the diagonal of the image.
  double diameter() const {
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis)
      squared += std::pow(double(m_size[axis]) * m_spacing[axis], 2);
    return std::sqrt(squared);
  }

  // Of labels other than 0.
  std::map<int, double> volumes() const {
    std::map<int, double> result;
    const double unit = m_spacing[0] * m_spacing[1] * m_spacing[2];
    for (const int label : m_labels)
      if (label != 0)
        result[label] += unit;
    return result;
  }

  // For each connected part with a label other than 0, a voxel that is farthest from others.
  std::vector<std::size_t> deepest_voxels() const {
    std::vector<std::size_t> component = components();
    // Rings of voxels, from the borders inwards: the last one of a component is deepest.
    std::vector<char> is_reached(m_labels.size(), 0);
    std::vector<std::size_t> reached, deepest;
    for (std::size_t v = 0; v < m_labels.size(); ++v) {
      if (m_labels[v] == 0)
        continue;
      std::size_t same = 0;
      for_each_neighbor(v, [&](std::size_t w) { same += m_labels[w] == m_labels[v]; });
      if (same < 6) {
        is_reached[v] = 1;
        reached.push_back(v);
      }
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const std::size_t v = reached[i];
      if (deepest.size() <= component[v])
        deepest.resize(component[v] + 1);
      deepest[component[v]] = v;
      for_each_neighbor(v, [&](std::size_t w) {
        if (m_labels[w] == m_labels[v] && !is_reached[w]) {
          is_reached[w] = 1;
          reached.push_back(w);
        }
      });
    }
    return deepest;
  }

private:
  std::array<std::size_t, 3> place(std::size_t voxel) const {
    return {voxel % m_size[0], voxel / m_size[0] % m_size[1], voxel / (m_size[0] * m_size[1])};
  }

  template <class F> void for_each_neighbor(std::size_t voxel, const F& f) const {
    const auto at = place(voxel);
    std::size_t stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] > 0)
        f(voxel - stride);
      if (at[axis] + 1 < m_size[axis])
        f(voxel + stride);
      stride *= m_size[axis];
    }
  }

  // The number of its component for each voxel with a label other than 0.
  std::vector<std::size_t> components() const {
    static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> result(m_labels.size(), none), part;
    std::size_t number = 0;
    for (std::size_t first = 0; first < m_labels.size(); ++first) {
      if (m_labels[first] == 0 || result[first] != none)
        continue;
      result[first] = number;
      part = {first};
      while (!part.empty()) {
        const std::size_t v = part.back();
        part.pop_back();
        for_each_neighbor(v, [&](std::size_t w) {
          if (result[w] == none && m_labels[w] == m_labels[v]) {
            result[w] = number;
            part.push_back(w);
          }
        });
      }
      ++number;
    }
    return result;
  }

  std::array<std::size_t, 3> m_size;
  std::array<double, 3> m_spacing, m_origin;
  std::vector<int> m_labels;
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEX_3_INTERNAL_CONVERSION_LABELLED_VOXELS_3_H
