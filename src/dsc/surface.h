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

/// Reads surfaces. They get the labels 1, 2 and so on.
/// \throws std::runtime_error if a surface cannot be read
std::vector<Surface> read_surfaces(const std::vector<std::string>& paths);

/// The repairs of each surface of a run; empty if surfaces are not repaired.
using Repairs = std::vector<DSC::Surface_repair_report_3>;

/// Repairs surfaces so that they bound solids.
/// \param names names of the surfaces, for messages
/// \param largest_hole length of the boundary of the largest hole to be filled; the default of the
/// library if not set
/// \throws Input_error if a surface cannot be repaired
Repairs repair(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
               const std::optional<Distance>& largest_hole);

/// Merges vertices that nearly coincide, repairs the resulting defects, and adds both to the
/// repairs.
/// \return whether vertices were merged or defects repaired
/// \throws Input_error if a surface cannot be repaired
bool merge_near_vertices(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
                         Repairs& repairs);

/// Replaces surfaces by wraps around them, and adds this to the repairs.
/// \throws Input_error if a surface cannot be wrapped
void wrap(std::vector<Surface>& surfaces, const std::vector<std::string>& names, Repairs& repairs);

/// Returns a description of the repairs, in one line.
std::string what_was_repaired(const DSC::Surface_repair_report_3& report);

/// Returns the initial surfaces of a run: the surfaces of its files or, without files, its ball.
/// \param repairs receives the repairs, unless it is null
/// \throws std::runtime_error if a surface cannot be read, repaired or resampled
std::vector<Surface> start_surfaces(const Run_start& start, Repairs* repairs = nullptr);

/// Decimates or refines surfaces to about `triangles` triangles in total, by a common factor.
/// Refinement keeps the shape. Decimation collapses the edges with the smallest cost.
/// \param names names of the surfaces, for messages
/// \throws Input_error if a surface is open, intersects itself afterwards, or must be refined and
/// has edges in common with another surface
void resample(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
              std::size_t triangles);

} // namespace dsc

#endif // DSC_SURFACE_H
