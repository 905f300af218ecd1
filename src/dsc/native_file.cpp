// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "native_file.h"

#include "errors.h"
#include "files.h"
#include "labelled_tetrahedra.h"
#include "translations.h"

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <filesystem>
#include <fstream>

namespace dsc {
namespace {

/// Returns whether the program reads the encoding and the cells of a grid.
bool is_native_grid(const std::string& path, const std::string& labels) {
  try {
    read_tetrahedra(path, labels);
    return true;
  } catch (const CGAL::Deformable_simplicial_complexes::File_error&) {
    return false;
  }
}

/// Returns whether a picture has colors, and neither gray values nor a palette.
bool has_colors(const std::string& path) {
  static constexpr int place_of_type = 25, gray = 0, palette = 3; // of the PNG header
  std::ifstream file(path, std::ios::binary);
  file.seekg(place_of_type);
  const int type = file.get();
  return file && type != gray && type != palette;
}

} // namespace

std::string native_file(const std::string& path, const std::string& labels,
                        const std::string& thresholds) {
  const std::string format = extension(path);
  if (!is_foreign(path) && !std::filesystem::exists(path))
    return path;
  if (!thresholds.empty() || is_foreign(path) || (format == "png" && has_colors(path)))
    return translate(path, labels, thresholds);
  if (format != "vtu" || is_native_grid(path, labels))
    return path;
  try {
    return translate(path, labels, thresholds);
  } catch (const Input_error&) {
    return path; // the own reader says what is wrong
  }
}

void require_all_readers() {}

} // namespace dsc
