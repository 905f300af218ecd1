// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Complex_construction, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_COMPONENTS_3_H
#define CGAL_COMPLEX_CONSTRUCTION_INTERNAL_CONVERSION_VOXEL_COMPONENTS_3_H

#include <CGAL/Complex_construction/internal/conversion/Labeled_voxels_3.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

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
    static constexpr int no_label = -1;
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
