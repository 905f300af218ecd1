// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_COMPLEX_H
#define DSC_START_COMPLEX_H

#include "input/surface.h"
#include "motions/run.h"
#include "motions/run_position.h"
#include "motions/tracked_complex.h"
#include "programs/errors.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>
#include <CGAL/Deformable_simplicial_complexes/domains.h>
#include <CGAL/Triangle_soup_repair/Invalid_surface_error.h>

namespace dsc {

// All functions throw std::runtime_error if an input cannot be read, or does not define a complex.

/// Returns the initial complex of a run in space: of inequalities, or of surfaces that bound
/// solids.
std::unique_ptr<Tracked_complex> track_in_space(const Run_options& options);

/// Returns the complex of a labeled image (.inr, .inr.gz).
std::unique_ptr<Tracked_complex> track_image(const std::string& path, const Run_options& options);

/// Returns the complex of a mesh of labeled tetrahedra (.mesh, .vtu). If there is no room around
/// its interface, the complex is built from the boundary of the tetrahedra.
std::unique_ptr<Tracked_complex> track_tetrahedra(const std::string& path,
                                                  const Run_options& options);

/// Largest number of triangles to which surfaces are refined. TetGen would take minutes for more.
/// The complex is refined instead.
inline constexpr std::size_t most_triangles_to_fill = 300'000;

/// Builds a complex from surfaces and the space around them. Surfaces may share walls. A surface
/// with walls inside gets a label for each of its regions, which is printed. The interface is
/// refined if it has fewer triangles than the run asks for.
std::unique_ptr<Tracked_complex> track_surfaces(const Surfaces& surfaces,
                                                const Run_options& options);

/// Returns whether TetGen ran out of memory. Then another surface of the same size fails, too.
bool is_out_of_memory(const DSC::Tetrahedralization_error& error);

/// Returns the complex of repaired surfaces. If TetGen fails, they are repaired further.
/// \param repairs receives the repairs
std::unique_ptr<Tracked_complex> track_repaired_surfaces(const Run_options& options,
                                                         Repairs& repairs);

/// Returns the message of an error without the number of the surface, which has no meaning for
/// users.
std::string message_of(const DSC::Invalid_surface_error& error);

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
  } catch (const DSC::Invalid_cells_error& error) {
    throw Input_error(path + ": " + error.what());
  }
  metadata = std::move(checkpoint.metadata);
  tracked->label_names = label_names_of(metadata);
  return tracked;
}

} // namespace dsc

#endif // DSC_START_COMPLEX_H
