// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/run_balance.h"

#include "output/label_titles.h"
#include "programs/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace dsc {
namespace {

std::string percentage(double part) {
  char text[64];
  std::snprintf(text, sizeof text, "%+.2g %%", 100 * part);
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
    entry.most = (std::max)({entry.most, balance.before, balance.after});
    entry.vanished = balance.components_after > 0 ? 0 : step;
  }
}

std::vector<Label_balance> Run_balance::labels() const {
  std::vector<Label_balance> result;
  for (const auto& [label, entry] : m_labels)
    result.push_back(entry.sum);
  return result;
}

std::vector<std::string> Run_balance::messages(const Label_names& names) const {
  static constexpr double part = 1e-3; // of the volume of a label
  std::vector<std::string> vanished, unexplained;
  for (const auto& [label, entry] : m_labels) {
    if (entry.vanished > 0)
      vanished.push_back(label_title(label, names) + " (step " + std::to_string(entry.vanished) +
                         ")");
    if (std::abs(entry.sum.unexplained) > part * entry.most)
      unexplained.push_back(percentage(entry.sum.unexplained / entry.most) + " of label " +
                            label_title(label, names));
  }
  std::vector<std::string> result;
  if (!vanished.empty())
    result.push_back(std::string(noun(vanished.size(), "label", "labels")) + " " +
                     listed(vanished) + " vanished");
  if (!unexplained.empty())
    result.push_back("the motion and changes of topology do not explain a change of the volume: " +
                     listed(unexplained) +
                     "; use smaller steps, or a surface with more triangles (--triangles)");
  return result;
}

} // namespace dsc
