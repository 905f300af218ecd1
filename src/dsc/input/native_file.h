// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_NATIVE_FILE_H
#define DSC_NATIVE_FILE_H

#include <string>

namespace dsc {

/// Returns a file in a format that this program reads, with the content of an input: the input
/// itself, or a translation if another program has written it in a format or an encoding that only
/// `dsc-files` reads. Inequalities are returned as they are.
/// \param labels name of the cell array with the labels; empty for the default
/// \param thresholds of a gray image; empty for labels
/// \throws Input_error if the file cannot be translated
std::string native_file(const std::string& path, const std::string& labels = "",
                        const std::string& thresholds = "");

} // namespace dsc

#endif // DSC_NATIVE_FILE_H
