// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_COMPONENTS_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_COMPONENTS_3_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Image_3.h>
#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// The labels of the voxels in a box of an image, with x as the fastest index, and the location of
// this box.
struct Labeled_voxels_3
{
  std::array<std::size_t, 3> size; // number of voxels along each axis
  std::array<double, 3> spacing;   // side lengths of a voxel, in the unit of the image
  std::array<double, 3> center;    // of the box, in the coordinates of the image
  std::vector<int> labels;
  bool fills_domain = false; // whether the box contains all voxels and is the domain

  double largest_spacing() const { return *std::max_element(spacing.begin(), spacing.end()); }
};

// Calls a function with a pointer to the values of an image, in their type. Throws `Error` if the
// type is not supported.
template <class Function> void with_values(const _image& image, const Function& function) {
  const void* const data = image.data;
  const bool is_signed = image.sign == SGN_SIGNED;
  const auto as = [&](auto signed_value, auto unsigned_value) {
    if (is_signed)
      function(static_cast<const decltype(signed_value)*>(data));
    else
      function(static_cast<const decltype(unsigned_value)*>(data));
  };
  if (image.wordKind == WK_FLOAT && image.wdim == sizeof(float))
    function(static_cast<const float*>(data));
  else if (image.wordKind == WK_FLOAT && image.wdim == sizeof(double))
    function(static_cast<const double*>(data));
  else if (image.wordKind == WK_FIXED && image.wdim == 1)
    as(std::int8_t(), std::uint8_t());
  else if (image.wordKind == WK_FIXED && image.wdim == 2)
    as(std::int16_t(), std::uint16_t());
  else if (image.wordKind == WK_FIXED && image.wdim == 4)
    as(std::int32_t(), std::uint32_t());
  else if (image.wordKind == WK_FIXED && image.wdim == 8)
    as(std::int64_t(), std::uint64_t());
  else
    throw Error("the values of the image have an unsupported type: use integers of 1, 2, 4 or 8 "
                "bytes, or floating-point numbers of 4 or 8 bytes");
}

// Returns the label given by a value. Throws `Error` if the value is not a label.
template <class Value> int label_of(Value value) {
  static constexpr int largest_label = (std::numeric_limits<int>::max)();
  // Conversion is exact up to 2^53, which is far above the largest label.
  const double number = double(value);
  if (!(std::abs(number) <= largest_label) || number != std::floor(number))
    throw Error("the image has values that are not labels: use integers from -" +
                std::to_string(largest_label) + " to " + std::to_string(largest_label));
  return int(number);
}

// Returns whether a domain equals the box of all voxels of an image, up to rounding.
inline bool is_box_of_voxels(const Image_3& image, const Bbox_3& box) {
  static constexpr double rounding = 1e-6; // in side lengths of a voxel; origins have type `float`
  const std::array<double, 3> spacing = {image.vx(), image.vy(), image.vz()},
                              origin = {image.tx(), image.ty(), image.tz()},
                              size = {double(image.xdim()), double(image.ydim()),
                                      double(image.zdim())};
  bool result = true;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = origin[axis] - .5 * spacing[axis], high = low + size[axis] * spacing[axis],
                 tolerance = rounding * spacing[axis];
    result = result && std::abs(box.min(axis) - low) <= tolerance &&
             std::abs(box.max(axis) - high) <= tolerance;
  }
  return result;
}

// Returns the box of all voxels if they fill the domain, or else the smallest box of voxels that
// contains all labels other than 0. Throws `Error` if there are no voxels, if values are not
// labels, or if there is no such box.
inline Labeled_voxels_3 labeled_voxels(const Image_3& image, bool fills_domain) {
  if (!image.is_valid() || image.size() == 0)
    throw Error("the image has no voxels: read an image with voxels");
  if (image.image()->vdim != 1)
    throw Error(
        "the voxels of the image have several values: use an image with one label for each voxel");
  using Place = std::array<std::size_t, 3>;
  const Place all = {image.xdim(), image.ydim(), image.zdim()};
  const std::array<double, 3> origin = {image.tx(), image.ty(), image.tz()};
  Labeled_voxels_3 result;
  result.fills_domain = fills_domain;
  result.spacing = {image.vx(), image.vy(), image.vz()};
  for (int axis = 0; axis < 3; ++axis)
    if (!(result.spacing[axis] > 0) || !std::isfinite(result.spacing[axis]) ||
        !std::isfinite(origin[axis]))
      throw Error("the origin or the spacing of the image is invalid: use a finite origin and a "
                  "positive, finite spacing");
  const auto index = [&](const Place& p) { return (p[2] * all[1] + p[1]) * all[0] + p[0]; };
  const auto for_each_row = [](const Place& first, const Place& end, const auto& visit) {
    for (Place p = first; p[2] < end[2]; ++p[2])
      for (p[1] = first[1]; p[1] < end[1]; ++p[1]) {
        Progress_scope::check();
        visit(p);
      }
  };
  with_values(*image.image(), [&](const auto* values) {
    Place first = all, end = {0, 0, 0};
    for_each_row({0, 0, 0}, all, [&](Place p) {
      for (; p[0] < all[0]; ++p[0])
        if (label_of(values[index(p)]) != 0 || fills_domain)
          for (int axis = 0; axis < 3; ++axis) {
            first[axis] = (std::min)(first[axis], p[axis]);
            end[axis] = (std::max)(end[axis], p[axis] + 1);
          }
    });
    if (end[0] == 0)
      throw Error("all labels of the image are 0: use an image with at least one other label");
    for (int axis = 0; axis < 3; ++axis) {
      result.size[axis] = end[axis] - first[axis];
      // Points of the image are the centers of voxels.
      result.center[axis] =
          origin[axis] + .5 * double(first[axis] + end[axis] - 1) * result.spacing[axis];
    }
    result.labels.reserve(result.size[0] * result.size[1] * result.size[2]);
    for_each_row(first, end, [&](Place p) {
      for (; p[0] < end[0]; ++p[0])
        result.labels.push_back(label_of(values[index(p)]));
    });
  });
  return result;
}

// The connected components of the labels of voxels; voxels are connected through common faces.
// Component 0 is the outside. It contains the space around the box and the voxels of label 0
// connected with it. If the voxels fill the domain, it contains only the space around the box.
class Voxel_components_3
{
public:
  using Place = std::array<std::size_t, 3>;

  explicit Voxel_components_3(const Labeled_voxels_3& voxels) : m_fill_domain(voxels.fills_domain) {
    for (int axis = 0; axis < 3; ++axis)
      m_size[axis] = voxels.size[axis] + 2;
    const std::vector<int> labels = padded(voxels);
    m_components.assign(labels.size(), none);
    std::vector<std::size_t> front;
    for (std::size_t first = 0; first < labels.size(); ++first)
      if (m_components[first] == none)
        fill(labels, first, front);
  }

  // Returns the size of the box of labels, in voxels.
  Place size() const { return {m_size[0] - 2, m_size[1] - 2, m_size[2] - 2}; }
  int operator()(const Place& p) const {
    return m_components[((p[2] + 1) * m_size[1] + p[1] + 1) * m_size[0] + p[0] + 1];
  }
  // Returns whether component 0 lies outside the domain.
  bool fill_domain() const { return m_fill_domain; }
  std::size_t number() const { return m_labels.size(); }
  int label(std::size_t component) const { return m_labels[component]; }
  // Returns the number of voxels of a component; undefined for component 0.
  std::size_t number_of_voxels(std::size_t component) const { return m_voxels[component]; }

private:
  static constexpr int none = -1;

  std::vector<int> padded(const Labeled_voxels_3& voxels) const {
    static constexpr int no_label = (std::numeric_limits<int>::min)(); // see label_of()
    std::vector<int> result(m_size[0] * m_size[1] * m_size[2], m_fill_domain ? no_label : 0);
    for (std::size_t z = 0, row = 0; z < voxels.size[2]; ++z)
      for (std::size_t y = 0; y < voxels.size[1]; ++y, row += voxels.size[0])
        std::copy_n(voxels.labels.begin() + std::ptrdiff_t(row), voxels.size[0],
                    result.begin() + std::ptrdiff_t(((z + 1) * m_size[1] + y + 1) * m_size[0] + 1));
    return result;
  }

  void fill(const std::vector<int>& labels, std::size_t first, std::vector<std::size_t>& front) {
    const int component = int(m_labels.size());
    m_labels.push_back(labels[first]);
    m_voxels.push_back(1);
    m_components[first] = component;
    front = {first};
    while (!front.empty()) {
      Progress_scope::check();
      const std::size_t v = front.back();
      front.pop_back();
      std::size_t stride = 1;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at = v / stride % m_size[axis];
        const auto visit = [&](std::size_t w) {
          if (m_components[w] == none && labels[w] == labels[first]) {
            m_components[w] = component;
            ++m_voxels[component];
            front.push_back(w);
          }
        };
        if (at > 0)
          visit(v - stride);
        if (at + 1 < m_size[axis])
          visit(v + stride);
        stride *= m_size[axis];
      }
    }
  }

  bool m_fill_domain;
  Place m_size;                  // including a layer of outside voxels around the box
  std::vector<int> m_components; // by voxel
  std::vector<int> m_labels;     // by component
  std::vector<std::size_t> m_voxels;
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_COMPONENTS_3_H
