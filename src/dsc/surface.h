// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_H
#define DSC_SURFACE_H

#include "distance.h"
#include "run_start.h"

#include <CGAL/Deformable_simplicial_complexes/Labelled_surface_3.h>
#include <CGAL/Deformable_simplicial_complexes/Surface_repair_report_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

using Surface_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = DSC::Labelled_surface_3<Surface_point>;

/// Reads surfaces, which get the labels 1, 2 and so on.
/// \throws std::runtime_error if one cannot be read
std::vector<Surface> read_surfaces(const std::vector<std::string>& paths);

/// What was done to each surface of a run; none if surfaces are not to be repaired.
using Repairs = std::vector<DSC::Surface_repair_report_3>;

/// Makes surfaces bound solids.
/// \param names of the surfaces, for messages
/// \param largest_hole length of borders of holes that are filled; the library's bound if not set
/// \throws Input_error if one cannot be repaired
Repairs repair(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
               const std::optional<Distance>& largest_hole);

/// Merges vertices that nearly coincide, and repairs what that breaks; tells so in what was done.
/// \return whether there were any
/// \throws Input_error if a surface cannot be repaired
bool merge_near_vertices(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
                         Repairs& repairs);

/// Replaces surfaces by wraps around them, and tells so in what was done to them.
/// \throws Input_error if one cannot be wrapped
void wrap(std::vector<Surface>& surfaces, const std::vector<std::string>& names, Repairs& repairs);

/// In one line.
std::string what_was_repaired(const DSC::Surface_repair_report_3& report);

/// The surfaces that a run starts from: those of its files or, without any, its ball.
/// \param repairs what was done to them is written there, unless it is null
/// \throws std::runtime_error if one cannot be read, repaired or resampled
std::vector<Surface> start_surfaces(const Run_start& start, Repairs* repairs = nullptr);

/// Decimates or refines surfaces to about `triangles` triangles in total, all by the same factor.
/// Refining keeps the shape; decimating collapses the edges that matter least.
/// \param names of the surfaces, for messages
/// \throws Input_error if a surface is open, intersects itself afterwards, or is to be
/// refined and has edges in common with another one
void resample(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
              std::size_t triangles);

} // namespace dsc

#endif // DSC_SURFACE_H
