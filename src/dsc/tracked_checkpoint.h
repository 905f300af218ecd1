// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_CHECKPOINT_H
#define DSC_TRACKED_CHECKPOINT_H

#include "errors.h"
#include "tracked_complex.h"

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <memory>
#include <string>
#include <utility>

namespace dsc {

/// Returns the complex of a checkpoint that was read, and stores its metadata.
template <class Tracked, class Checkpoint>
std::unique_ptr<Tracked_complex> restored(const std::string& path, Checkpoint&& checkpoint,
                                          std::string& metadata) {
  auto tracked = std::make_unique<Tracked>();
  try {
    tracked->complex.restore(checkpoint.state);
  } catch (const CGAL::Deformable_simplicial_complexes::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what());
  }
  metadata = std::move(checkpoint.metadata);
  return tracked;
}

} // namespace dsc

#endif // DSC_TRACKED_CHECKPOINT_H
