// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "unused.h"

#include <iostream>
#include <set>

namespace dsc {
namespace {

bool is_silent = false;

} // namespace

void print_unused(const std::string& path, const Unused_content& unused) {
  static std::set<std::string> printed;
  const std::string line = path + ": not used: " + unused.text();
  if (!is_silent && !unused.empty() && printed.insert(line).second)
    std::cerr << "dsc: " << line << '\n';
}

void keep_silent_about_unused() { is_silent = true; }

} // namespace dsc
