// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_LABELS_OPTION_H
#define DSC_LABELS_OPTION_H

#include <CLI/CLI.hpp>

#include <string>

namespace dsc {

/// Adds the option for the array of a .vtu file that contains the labels.
CLI::Option* add_labels_option(CLI::App& command, std::string& labels);

/// Adds the option for the labels of a gray image.
void add_threshold_option(CLI::App& command, std::string& thresholds);

/// Checks that `--labels` is given only for files with arrays.
/// \throws Usage_error
void require_file_with_arrays(const std::string& path, const std::string& labels);

} // namespace dsc

#endif // DSC_LABELS_OPTION_H
