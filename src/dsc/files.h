// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_H
#define DSC_FILES_H

#include <string>

namespace dsc {

/// The extension of `path` in lower case and without the dot; empty if there is none.
std::string extension(const std::string& path);

/// Finds out before a long computation whether its result can be written; leaves an existing file
/// alone. \throws Input_error if a regular file cannot be created at `path`.
void require_writable(const std::string& path);

/// `stem` + `extension`, with a number between if there is a file of that name.
std::string unused_name(const std::string& stem, const std::string& extension);

/// Whether two names stand for one file, which need not exist.
bool same_file(const std::string& a, const std::string& b);

} // namespace dsc

#endif // DSC_FILES_H
