// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_BLOCKS_H
#define DSC_FILES_READ_BLOCKS_H

#include "Translation.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace dsc_files {

/// Reads the blocks of a multi-block file of VTK (.vtm) as one grid. The labels of the cells are
/// the numbers of their blocks, beginning with 1, in the order of the file; blocks with the same
/// name have the same label.
/// \throws Failure if the file contains no blocks, or blocks that are images
vtkSmartPointer<vtkDataSet> read_blocks(const std::string& path, Translation& translation);

} // namespace dsc_files

#endif // DSC_FILES_READ_BLOCKS_H
