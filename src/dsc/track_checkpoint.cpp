// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"
#include "tracked_complex_2.h"
#include "tracked_complex_3.h"

#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint_2.h>
#include <CGAL/Deformable_simplicial_complexes/IO/checkpoint_3.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>

#include <utility>

namespace dsc {
namespace {

template <class Tracked, class Checkpoint>
std::unique_ptr<Tracked_complex> restore(const std::string& path, Checkpoint&& checkpoint,
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

} // namespace

std::unique_ptr<Tracked_complex> track_checkpoint(const std::string& path, std::string& metadata) {
  if (CGAL::IO::checkpoint_dimension(path) == 2)
    return restore<Tracked_complex_2>(path, CGAL::IO::read_checkpoint_2(path), metadata);
  return restore<Tracked_complex_3>(path, CGAL::IO::read_checkpoint(path), metadata);
}

} // namespace dsc
