// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Deformable_simplicial_complexes, written for CGAL
// (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABEL_CHANGES_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABEL_CHANGES_H

#include <CGAL/Deformable_simplicial_complexes/Component_event.h>

#include <algorithm>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// In these functions, a Label_change is that of `Deformation_report`. Lists are ordered by label.

// Returns the change of a label, which is inserted if it is not there.
template <class Label_change>
Label_change& change_of_label(std::vector<Label_change>& changes, int label) {
  const auto it =
      std::lower_bound(changes.begin(), changes.end(), label,
                       [](const Label_change& change, int bound) { return change.label < bound; });
  if (it != changes.end() && it->label == label)
    return *it;
  Label_change change;
  change.label = label;
  return *changes.insert(it, change);
}

// Adds the volumes that explain a change.
template <class Label_change> void add_explained(const Label_change& from, Label_change& to) {
  to.volume_swept += from.volume_swept;
  to.volume_of_overlaps += from.volume_of_overlaps;
}

// Counts an event.
template <class Label_change>
void count_event(const Component_event& event, std::vector<Label_change>& changes) {
  Label_change& change = change_of_label(changes, event.label);
  switch (event.kind) {
  case Component_event::Kind::merged:
    change.merged += event.before.size() - 1;
    break;
  case Component_event::Kind::split:
    change.split += event.after.size() - 1;
    break;
  case Component_event::Kind::vanished:
    ++change.vanished;
    break;
  case Component_event::Kind::appeared:
    ++change.appeared;
    break;
  }
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_TOPOLOGY_LABEL_CHANGES_H
