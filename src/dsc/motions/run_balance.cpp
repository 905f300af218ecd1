// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/run_balance.h"

#include "programs/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dsc {
namespace {

constexpr std::size_t most_names = 5; // labels that a message names

// Returns a list like "3, 5, 8 and 2 others".
std::string names(const std::vector<std::string>& items) {
  std::string result;
  for (std::size_t i = 0; i < items.size() && i < most_names; ++i)
    result += (i > 0 ? ", " : "") + items[i];
  if (items.size() > most_names)
    result += " and " + std::to_string(items.size() - most_names) + " others";
  return result;
}

std::string text_of(const char* format, double a, int b) {
  char text[64];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

} // namespace

void Run_balance::add(unsigned step, const std::vector<Label_balance>& balances) {
  for (const Label_balance& balance : balances) {
    const auto [found, is_new] = m_labels.try_emplace(balance.label, Entry{balance});
    Entry& entry = found->second;
    if (!is_new) {
      entry.sum.components_after = balance.components_after;
      entry.sum.after = balance.after;
      entry.sum.swept += balance.swept;
      entry.sum.overlaps += balance.overlaps;
      entry.sum.unexplained += balance.unexplained;
    }
    entry.most = std::max({entry.most, balance.before, balance.after});
    entry.vanished = balance.components_after > 0 ? 0 : step;
  }
}

std::vector<Label_balance> Run_balance::labels() const {
  std::vector<Label_balance> result;
  for (const auto& [label, entry] : m_labels)
    result.push_back(entry.sum);
  return result;
}

std::vector<std::string> Run_balance::messages() const {
  static constexpr double part = 1e-3; // of the volume of a label
  std::vector<std::string> vanished, unexplained;
  for (const auto& [label, entry] : m_labels) {
    if (entry.vanished > 0)
      vanished.push_back(std::to_string(label) + " (step " + std::to_string(entry.vanished) + ")");
    if (std::abs(entry.sum.unexplained) > part * entry.most)
      unexplained.push_back(
          text_of("%+.2g %% of label %d", 100 * entry.sum.unexplained / entry.most, label));
  }
  std::vector<std::string> result;
  if (!vanished.empty())
    result.push_back(std::string(noun(vanished.size(), "label", "labels")) + " " + names(vanished) +
                     " vanished");
  if (!unexplained.empty())
    result.push_back("the motion and changes of topology do not explain a change of the volume: " +
                     names(unexplained) +
                     "; use smaller steps, or a surface with more triangles (--triangles)");
  return result;
}

} // namespace dsc
