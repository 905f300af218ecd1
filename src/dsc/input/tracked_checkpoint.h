// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRACKED_CHECKPOINT_H
#define DSC_TRACKED_CHECKPOINT_H

#include "motions/run_position.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"

#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <memory>
#include <string>
#include <utility>

namespace dsc {

/// Returns the dimension of the complex in a checkpoint; 0 if the file is none.
/// \throws Input_error if several processes wrote it
int checkpoint_dimension(const std::string& path);

/// Reads the complex and the metadata of a checkpoint in space.
std::unique_ptr<Tracked_complex> track_checkpoint_3(const std::string& path, std::string& metadata);

/// Returns the complex of a checkpoint that was read, with the names of its labels, and stores its
/// metadata.
template <class Tracked, class Checkpoint>
std::unique_ptr<Tracked> restored(const std::string& path, Checkpoint&& checkpoint,
                                  std::string& metadata) {
  auto tracked = std::make_unique<Tracked>();
  try {
    tracked->complex.restore(checkpoint.state);
  } catch (const CGAL::Deformable_simplicial_complexes::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what());
  }
  metadata = std::move(checkpoint.metadata);
  tracked->label_names = label_names_of(metadata);
  return tracked;
}

} // namespace dsc

#endif // DSC_TRACKED_CHECKPOINT_H
