// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/unused.h"

#include "input/translations.h"

#include <iostream>
#include <set>

namespace dsc {
namespace {

bool is_silent = false;

} // namespace

void print_note(const std::string& path, const std::string& text) {
  static std::set<std::string> printed;
  const std::string line = with_user_names(path + ": " + text);
  if (!is_silent && printed.insert(line).second)
    std::cerr << "dsc: " << line << '\n';
}

void print_unused(const std::string& path, const Unused_content& unused) {
  if (!unused.empty())
    print_note(path, "not used: " + unused.text());
}

void keep_silent_about_unused() { is_silent = true; }

} // namespace dsc
