// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_WRITE_CELLS_H
#define DSC_FILES_WRITE_CELLS_H

#include "Translation.h"

#include <vtkDataSet.h>

#include <map>
#include <string>

namespace dsc_files {

/// Writes the cells of highest dimension of a dataset: tetrahedra (`cells.vtu`), a triangulated
/// surface (`surface.off`, with names of labels `surface.obj`), regions of labeled triangles in a
/// plane z = const (`regions.poly`) or points (`points.xyz`, with normals `points.pwn`). Other
/// cells in space are divided into tetrahedra. \param names of labels
/// \throws Failure if there are no such cells
Translation write_cells(vtkDataSet* data, const std::map<int, std::string>& names,
                        const Options& options);

} // namespace dsc_files

#endif // DSC_FILES_WRITE_CELLS_H
