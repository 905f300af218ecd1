// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RECONSTRUCT_SHEET_H
#define DSC_RECONSTRUCT_SHEET_H

#include "programs/threads_option.h"

#include <CGAL/Mesh_files/point_set_3.h>

#include <string>
#include <vector>

namespace dsc {

/// Options of the command `reconstruct`.
struct Reconstruct_options
{
  std::string input;      ///< point file
  std::string output;     ///< file of a surface or of tetrahedra
  double tolerance = .03; ///< in units of the point spacing
  bool is_open = false;   ///< whether the points sample an open sheet
  unsigned steps = 80;    ///< maximum number
  unsigned threads = default_number_of_threads();
  std::string folder;  ///< output folder of the steps; empty for none
  std::string report;  ///< file; empty for none
  std::string picture; ///< file; empty for none
  bool quiet = false;
};

/// Reconstructs an open sheet from points, and writes it. Returns the exit code.
int reconstruct_open_sheet(const Reconstruct_options& options,
                           const std::vector<CGAL::IO::Point_and_normal_3>& points);

} // namespace dsc

#endif // DSC_RECONSTRUCT_SHEET_H
