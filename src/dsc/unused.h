// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_UNUSED_H
#define DSC_UNUSED_H

#include <CGAL/Deformable_simplicial_complexes/Unused_content.h>

#include <string>

namespace dsc {

using CGAL::Deformable_simplicial_complexes::Unused_content;

/// Prints the content of a file that was not used to the standard error, in one line, unless there
/// is none. A line that was printed before is not repeated: a run may read a file more than once.
void print_unused(const std::string& path, const Unused_content& unused);

/// Lets print_unused() print nothing from now on, as --quiet demands.
void keep_silent_about_unused();

} // namespace dsc

#endif // DSC_UNUSED_H
