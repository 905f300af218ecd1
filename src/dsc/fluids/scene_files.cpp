// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluids/fluid_scene_parts.h"

#include <filesystem>
#include <system_error>

namespace dsc {
namespace fs = std::filesystem;
namespace {

/// Returns the folders of scenes, the preferred folder first.
std::vector<fs::path> scene_folders() {
  std::vector<fs::path> result;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error)
    result.push_back((program.parent_path() / DSC_INSTALLED_SCENES).lexically_normal());
  result.emplace_back(DSC_SOURCE_SCENES);
  return result;
}

} // namespace

std::map<std::string, std::string> scene_files() {
  std::map<std::string, std::string> result;
  for (const fs::path& folder : scene_folders()) {
    std::error_code error;
    fs::directory_iterator files(folder, error);
    if (error)
      continue;
    for (const fs::directory_entry& file : files)
      if (file.path().extension() == ".json")
        result[file.path().stem().string()] = file.path().string();
    break;
  }
  return result;
}

std::string searched_scene_folders() {
  std::string result;
  for (const fs::path& folder : scene_folders())
    result += (result.empty() ? "" : " and ") + folder.string();
  return result;
}

} // namespace dsc
