// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SAVED_ARRAYS_H
#define DSC_SAVED_ARRAYS_H

#include <CGAL/Mesh_files/Mesh_arrays.h>

#include <string>

namespace dsc {

/// Appends arrays to the metadata of a checkpoint, a line of JSON text, as binary data.
std::string with_arrays(const std::string& metadata,
                        const CGAL::Deformable_simplicial_complexes::Mesh_arrays& arrays);

/// Removes the arrays from the metadata of a checkpoint and returns them; none if there are none.
CGAL::Deformable_simplicial_complexes::Mesh_arrays take_arrays(std::string& metadata);

} // namespace dsc

#endif // DSC_SAVED_ARRAYS_H
