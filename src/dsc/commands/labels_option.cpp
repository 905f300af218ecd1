// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/labels_option.h"

#include "input/files.h"
#include "input/translations.h"
#include "programs/errors.h"

namespace dsc {

CLI::Option* add_labels_option(CLI::App& command, std::string& labels) {
  return command.add_option(
      "--labels", labels,
      "Name of the cell array of a .vtu file with the labels; 'none' gives label 1 to all cells, "
      "and reads named parts of a surface as one (default: label, medit:ref, gmsh:physical or "
      "MaterialIDs)");
}

void add_threshold_option(CLI::App& command, std::string& thresholds) {
  command.add_option("--threshold", thresholds,
                     "Labels of a gray image: thresholds like 100 or 80,160, or otsu, or otsu:2");
}

void require_file_with_arrays(const std::string& path, const std::string& labels) {
  const std::string file = with_user_names(path), format = extension(file);
  const bool has_parts = labels == "none" && (format == "stl" || format == "obj");
  if (!labels.empty() && format != "vtu" && !is_foreign(file) && !has_parts)
    throw Usage_error("--labels applies only to .vtu files and grids of other programs, and none "
                      "to .stl and .obj files; leave it out");
}

} // namespace dsc
