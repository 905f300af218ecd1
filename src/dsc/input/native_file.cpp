// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/translations.h"

#include "input/files.h"
#include "input/labeled_tetrahedra.h"
#include "programs/errors.h"

#include <CGAL/Mesh_files/File_error.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace dsc {
namespace {

/// Returns whether the program reads the encoding and the cells of a grid.
bool is_native_grid(const std::string& path, const std::string& labels) {
  try {
    read_tetrahedra(path, labels);
    return true;
  } catch (const DSC::File_error&) {
    return false;
  }
}

/// Returns whether the header of a VTK file names a compressor.
bool is_compressed(const std::string& path) {
  char header[512] = {};
  std::ifstream(path, std::ios::binary).read(header, sizeof header - 1);
  return std::string(header).find("compressor=") != std::string::npos;
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
  std::error_code error;
  if (!is_foreign(path) && !std::filesystem::is_regular_file(path, error))
    return path; // an inequality, or what the reader of this program refuses
  if (!thresholds.empty() || is_foreign(path) || (format == "png" && has_colors(path)))
    return translate(path, labels, thresholds);
  if (format != "vtu" || is_native_grid(path, labels))
    return path;
  if (is_compressed(path)) // the reader of this program only says that it is compressed
    return translate(path, labels, thresholds);
  // Other errors than unknown encodings and cells are best explained by the reader of this program.
  try {
    return translate(path, labels, thresholds, [&](const std::string& translation) {
      return extension(translation) != "vtu" || is_native_grid(translation, labels);
    });
  } catch (const Input_error&) {
    return path;
  }
}

} // namespace dsc
