// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_GMSH_H
#define DSC_FILES_READ_GMSH_H

#include "Translation.h"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

namespace dsc_files {

/// Reads a mesh of Gmsh (.msh). The cell array `gmsh:physical` contains the physical group of each
/// cell, and 0 for cells without a group; without groups, the tags of the entities.
/// \param folder new folder
/// \param translation receives the unused contents
/// \throws Failure if it cannot be read, or the program was built without Gmsh
vtkSmartPointer<vtkUnstructuredGrid> read_gmsh(const std::string& path, const std::string& folder,
                                               Translation& translation);

} // namespace dsc_files

#endif // DSC_FILES_READ_GMSH_H
