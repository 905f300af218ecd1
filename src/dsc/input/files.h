// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_H
#define DSC_FILES_H

#include <string>
#include <vector>

namespace dsc {

/// Returns the extension of `path` in lower case and without the dot; empty if there is none.
std::string extension(const std::string& path);

/// Returns whether there is a file or folder with this path. Any text may be given, such as an
/// expression that is too long for a name.
bool exists(const std::string& path);

/// Checks whether a result can be written, before a long computation. An existing file is not
/// changed.
/// \throws Input_error if a regular file cannot be created at `path`
void require_writable(const std::string& path);

/// Creates a folder if necessary.
/// \throws Input_error if it cannot be created
void create_folder(const std::string& path);

/// Returns whether two paths name the same file, which need not exist.
bool is_same_file(const std::string& a, const std::string& b);

/// Checks whether the output file of an option can be written, before a long computation. An empty
/// path stands for an option that is not given.
/// \param others inputs and other outputs of the computation; empty names are ignored
/// \throws Usage_error if the file would replace one of the `others`
/// \throws Input_error as require_writable() does
void require_place(const std::string& option, const std::string& path,
                   const std::vector<std::string>& others);

/// Creates an empty file in the working directory. Returns its name: `stem` + `extension`, with a
/// number inserted if a file of this name exists.
/// \throws Input_error if no file can be created
std::string new_file(const std::string& stem, const std::string& extension);

/// Removes a file if there is one.
void remove_file(const std::string& path);

} // namespace dsc

#endif // DSC_FILES_H
