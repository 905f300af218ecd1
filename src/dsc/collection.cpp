// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

namespace dsc {

std::vector<Moment> moments_of_collection(const std::string& collection) {
  namespace fs = std::filesystem;
  static const std::regex entry("timestep=\"([^\"]*)\".* file=\"([^\"]*)\"");
  std::vector<Moment> moments;
  std::ifstream in(collection);
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, entry))
      moments.emplace_back(std::strtod(match.str(1).c_str(), nullptr),
                           (fs::path(collection).parent_path() / match.str(2)).string());
  return moments;
}

} // namespace dsc
