// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_WRITE_FOREIGN_H
#define DSC_FILES_WRITE_FOREIGN_H

#include <string>

namespace dsc_files {

/// Writes a grid (.vtu), a surface (.ply) or an image of labels (.vti) in a format of another
/// program: .vtk for all, .vtp for surfaces, .vti, .nii, .nii.gz, .mha, .tif or .inr for
/// images. The folder of the output must be empty.
/// \param like image whose axes, and position in space, the new image gets; its voxels have the same
///        centers. If empty, the axes of the new image are the ones of space.
/// \throws Failure if the file cannot be written, or the format does not fit
void write_foreign(const std::string& input, const std::string& output, const std::string& like);

} // namespace dsc_files

#endif // DSC_FILES_WRITE_FOREIGN_H
