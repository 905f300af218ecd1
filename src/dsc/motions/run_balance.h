// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_RUN_BALANCE_H
#define DSC_RUN_BALANCE_H

#include "output/statistics.h"

#include <CGAL/Mesh_files/Label_names.h>

namespace dsc {

/// The balance of the volumes of a run: the sums over its steps.
class Run_balance
{
public:
  /// Adds the balances of a step.
  void add(unsigned step, const std::vector<Label_balance>& balances);

  /// Returns the balance of each label that occurred, by increasing label.
  std::vector<Label_balance> labels() const;

  /// Returns the lines to be printed: the labels that vanished, and the labels with an unexplained
  /// change of more than a thousandth of their volume.
  std::vector<std::string> messages(const DSC::Label_names& names) const;

private:
  struct Entry
  {
    Label_balance sum;
    unsigned vanished = 0; // step; 0 if the label did not vanish
    double most = 0;       // volume
  };

  std::map<int, Entry> m_labels;
};

} // namespace dsc

#endif // DSC_RUN_BALANCE_H
