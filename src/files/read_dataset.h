// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_DATASET_H
#define DSC_FILES_READ_DATASET_H

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace dsc_files {

/// A dataset of VTK and what its reader knows about it.
struct Dataset
{
  vtkSmartPointer<vtkDataSet> data;
  bool has_oblique_axes = false; ///< whether the axes of an image are rotated in space
  double slice_order = 1;        ///< -1 if the file stores the slices of a NIfTI image in reverse
};

/// Reads a file, or a folder of DICOM images.
/// \throws Failure if the format is unknown, the file cannot be read or is damaged
Dataset read_dataset(const std::string& path);

/// Returns the extension in lower case, without the dot; of compressed NIfTI files `nii.gz`.
std::string format_of(const std::string& path);

} // namespace dsc_files

#endif // DSC_FILES_READ_DATASET_H
