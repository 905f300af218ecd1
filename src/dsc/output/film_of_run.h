// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILM_OF_RUN_H
#define DSC_FILM_OF_RUN_H

#include <string>
#include <vector>

namespace dsc {

struct Film_options
{
  std::string run;                  ///< folder of a run, collection (.pvd) or mesh (.vtu)
  std::string report;               ///< report of the run (.json); none if empty
  unsigned every = 1;               ///< only every N-th state, and the last one
  std::vector<std::string> without; ///< labels, or their names, whose cells are left out
  bool is_surface = false;          ///< whether only the interface is shown
};

/// Returns a film of the states of a run as an HTML file.
/// \throws Input_error if the run has no states or a label to be left out does not occur, or the
///         report is not one of this program
/// \throws Usage_error if a name of a label to be left out is unknown
/// \throws CGAL::Deformable_simplicial_complexes::File_error if a file cannot be read
std::string film_of_run(const Film_options& options);

} // namespace dsc

#endif // DSC_FILM_OF_RUN_H
