// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FRAME_OF_VTU_H
#define DSC_FRAME_OF_VTU_H

#include "film.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/Label_names.h>

#include <vector>

namespace dsc {

/// Frame of a VTU file, with its form.
struct Read_frame
{
  int dimension;
  Film::Content content;
  Film_frame frame; ///< without step and time
  DSC::Label_names label_names;
};

/// Reads the cells of a complex or the facets of its interface, with arrays of numbers that are
/// scalars or vectors.
/// \throws DSC::File_error if the file cannot be read, or is not of
///         the form that this program writes
Read_frame frame_of_vtu(const std::string& path);

/// Removes the cells of given labels, and the facets between such labels. Removes the points that
/// are not used any more.
void leave_out(const std::vector<int>& labels, Read_frame& read);

} // namespace dsc

#endif // DSC_FRAME_OF_VTU_H
