// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_READ_3MF_H
#define DSC_FILES_READ_3MF_H

#include "Translation.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

namespace dsc_files {

/// Reads the objects of a 3MF file as one surface, at the places of the items that are to be built.
/// The labels of the triangles are the numbers of their objects, beginning with 1, in the order of
/// the items; objects with the same name have the same label.
/// \throws Failure if the file cannot be read, or the program was built without lib3mf
vtkSmartPointer<vtkDataSet> read_3mf(const std::string& path, Translation& translation);

} // namespace dsc_files

#endif // DSC_FILES_READ_3MF_H
