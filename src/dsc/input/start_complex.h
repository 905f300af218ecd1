// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_START_COMPLEX_H
#define DSC_START_COMPLEX_H

#include "input/surface.h"
#include "motions/run.h"
#include "motions/tracked_complex.h"

#include <CGAL/Complex_construction/Tetrahedralization_3.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
bool is_out_of_memory(const CGAL::Deformable_simplicial_complexes::Tetrahedralization_error& error);

/// Returns the complex of repaired surfaces. If TetGen fails, they are repaired further.
/// \param repairs receives the repairs
std::unique_ptr<Tracked_complex> track_repaired_surfaces(const Run_options& options,
                                                         Repairs& repairs);

} // namespace dsc

#endif // DSC_START_COMPLEX_H
