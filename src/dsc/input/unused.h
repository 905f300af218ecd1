// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_UNUSED_H
#define DSC_UNUSED_H

#include <CGAL/Mesh_files/Unused_content.h>

#include <string>

namespace dsc {

using CGAL::Deformable_simplicial_complexes::Unused_content;

/// Prints the unused content of a file to the standard error, in one line, if there is any. The
/// same line is printed only once, because a run may read a file several times.
void print_unused(const std::string& path, const Unused_content& unused);

/// Suppresses the output of print_unused() from now on, as required by --quiet.
void keep_silent_about_unused();

/// Prints a choice that was made for a file, to standard error, once.
void print_note(const std::string& path, const std::string& text);

} // namespace dsc

#endif // DSC_UNUSED_H
