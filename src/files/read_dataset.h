// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_DATASET_H
#define DSC_FILES_READ_DATASET_H

#include "Translation.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace dsc_files {

/// A dataset of VTK and what its reader knows about it.
struct Dataset
{
  vtkSmartPointer<vtkDataSet> data;
  Translation translation; ///< the unused contents so far
  double slice_order = 1;  ///< -1 if the file stores the slices of a NIfTI image in reverse
};

/// Reads a file. Images have their direction matrix, and scaled values.
/// \param folder folder for copies, which exists
/// \throws Failure if the format is unknown, the file cannot be read or is damaged
Dataset read_dataset(const std::string& path, const std::string& folder);

/// Returns the extension in lower case, without the dot; of compressed NIfTI files `nii.gz`.
std::string format_of(const std::string& path);

} // namespace dsc_files

#endif // DSC_FILES_READ_DATASET_H
