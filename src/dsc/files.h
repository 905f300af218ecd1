// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_H
#define DSC_FILES_H

#include <string>
#include <vector>

namespace dsc {

/// The extension of `path` in lower case and without the dot; empty if there is none.
std::string extension(const std::string& path);

/// Finds out before a long computation whether its result can be written; leaves an existing file
/// alone. \throws Input_error if a regular file cannot be created at `path`.
void require_writable(const std::string& path);

/// Returns whether two paths name one file, which need not exist.
bool is_same_file(const std::string& a, const std::string& b);

/// Checks before a long computation whether the file of an option can be written; an empty path
/// stands for an option that is not given. \throws Usage_error if it would replace one of the
/// `others`, inputs and outputs of the same computation; empty names stand for none. \throws
/// Input_error as require_writable() does
void require_place(const std::string& option, const std::string& path,
                   const std::vector<std::string>& others);

/// `stem` + `extension`, with a number between if there is a file of that name.
std::string unused_name(const std::string& stem, const std::string& extension);

} // namespace dsc

#endif // DSC_FILES_H
