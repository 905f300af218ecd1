// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_MESHB_H
#define DSC_FILES_READ_MESHB_H

#include "Translation.h"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

namespace dsc_files {

/// Reads a binary mesh in the Gamma Mesh Format (.meshb): vertices, edges, triangles and
/// tetrahedra. The cell array `medit:ref` contains their references.
/// \param translation receives the unused contents
/// \throws Failure if it cannot be read
vtkSmartPointer<vtkUnstructuredGrid> read_meshb(const std::string& path, Translation& translation);

} // namespace dsc_files

#endif // DSC_FILES_READ_MESHB_H
