// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_PLANAR_REGIONS_H
#define DSC_FILES_PLANAR_REGIONS_H

#include "Translation.h"

#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dsc_files {

/// The vertices of a triangle.
using Triangle = std::array<vtkIdType, 3>;

/// Returns the vertices of the triangles of a surface.
inline std::vector<Triangle> triangles_of(vtkPolyData* surface) {
  std::vector<Triangle> result;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i) {
    surface->GetCellPoints(i, corners);
    if (corners->GetNumberOfIds() == 3)
      result.push_back({corners->GetId(0), corners->GetId(1), corners->GetId(2)});
  }
  return result;
}

/// Returns a point of a dataset.
inline std::array<double, 3> point(vtkDataSet* data, vtkIdType i) {
  std::array<double, 3> result;
  data->GetPoint(i, result.data());
  return result;
}

/// The regions of labeled triangles: segments between different labels, and one point of each
/// connected component.
class Planar_regions
{
public:
  Planar_regions(vtkPolyData* data, const std::vector<int>& labels)
      : m_data(data), m_triangles(triangles_of(data)), m_labels(labels) {
    for (std::size_t i = 0; i < m_triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        m_triangles_at[side(i, k)].push_back(i);
  }

  /// Returns whether label 0 reaches the boundary of the triangles.
  bool has_label_0_outside() const {
    return std::any_of(m_triangles_at.begin(), m_triangles_at.end(), [&](const auto& side) {
      return side.second.size() == 1 && m_labels[side.second.front()] == 0;
    });
  }

  /// Writes the regions in the format of Triangle (.poly).
  void write(const std::string& path) const {
    Output_file out(path);
    out << m_data->GetNumberOfPoints() << " 2 0 0\n";
    for (vtkIdType i = 0; i < m_data->GetNumberOfPoints(); ++i) {
      const auto [x, y, z] = point(m_data, i);
      out << i << ' ' << x << ' ' << y << '\n';
    }
    std::vector<Side> segments;
    for (const auto& [side, triangles] : m_triangles_at)
      if (label_across(triangles, 0) != label_across(triangles, 1))
        segments.push_back(side);
    out << segments.size() << " 0\n";
    for (std::size_t i = 0; i < segments.size(); ++i)
      out << i << ' ' << segments[i].first << ' ' << segments[i].second << '\n';
    const std::vector<std::size_t> seeds = largest_of_components();
    out << "0\n" << seeds.size() << '\n';
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      std::array<double, 2> middle = {};
      for (const vtkIdType corner : m_triangles[seeds[i]])
        for (std::size_t axis = 0; axis < 2; ++axis)
          middle[axis] += point(m_data, corner)[axis] / 3;
      out << i << ' ' << middle[0] << ' ' << middle[1] << ' ' << m_labels[seeds[i]] << " 0\n";
    }
    out.close();
  }

private:
  using Side = std::pair<vtkIdType, vtkIdType>;

  Side side(std::size_t i, std::size_t k) const {
    return std::minmax(m_triangles[i][(k + 1) % 3], m_triangles[i][(k + 2) % 3]);
  }

  /// Outside of all triangles is label 0.
  int label_across(const std::vector<std::size_t>& triangles, std::size_t which) const {
    return which < triangles.size() ? m_labels[triangles[which]] : 0;
  }

  double area(std::size_t i) const {
    const auto [a, b, c] = m_triangles[i];
    const auto p = point(m_data, a), q = point(m_data, b), r = point(m_data, c);
    return std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }

  std::vector<std::size_t> largest_of_components() const {
    std::vector<std::size_t> result;
    std::vector<bool> found(m_triangles.size(), false);
    for (std::size_t first = 0; first < m_triangles.size(); ++first) {
      if (found[first] || m_labels[first] == 0)
        continue;
      result.push_back(first);
      found[first] = true;
      for (std::vector<std::size_t> rest = {first}; !rest.empty();) {
        const std::size_t i = rest.back();
        rest.pop_back();
        if (area(i) > area(result.back()))
          result.back() = i;
        for (std::size_t k = 0; k < 3; ++k)
          for (const std::size_t next : m_triangles_at.at(side(i, k)))
            if (!found[next] && m_labels[next] == m_labels[first]) {
              found[next] = true;
              rest.push_back(next);
            }
      }
    }
    return result;
  }

  vtkPolyData* m_data;
  std::vector<Triangle> m_triangles;
  std::vector<int> m_labels;
  std::map<Side, std::vector<std::size_t>> m_triangles_at;
};

} // namespace dsc_files

#endif // DSC_FILES_PLANAR_REGIONS_H
