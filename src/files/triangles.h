// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_TRIANGLES_H
#define DSC_FILES_TRIANGLES_H

#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <vector>

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

} // namespace dsc_files

#endif // DSC_FILES_TRIANGLES_H
