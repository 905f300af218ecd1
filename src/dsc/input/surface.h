// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_H
#define DSC_SURFACE_H

#include "input/run_start.h"

#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_report_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace DSC = CGAL::Deformable_simplicial_complexes;

namespace dsc {

using Surface_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = DSC::Labeled_surface_3<Surface_point>;

/// Reads surfaces. They get the labels 1, 2 and so on.
/// \throws std::runtime_error if a surface cannot be read
std::vector<Surface> read_surfaces(const std::vector<std::string>& paths);

/// The repairs of each surface of a run; empty if surfaces are not repaired.
using Repairs = std::vector<DSC::Surface_repair_report_3>;

/// Reads the surfaces of a run and repairs them, so that they bound solids.
/// \param repairs receives the repairs, unless it is null
/// \throws Input_error if a surface cannot be repaired; std::runtime_error if it cannot be read
std::vector<Surface> read_and_repair(const Run_start& start, Repairs* repairs);

/// Returns a description of the repairs, in one line.
std::string what_was_repaired(const DSC::Surface_repair_report_3& report);

/// Returns the initial surfaces of a run: the surfaces of its files or, without files, its ball.
/// \param most_triangles surfaces of files are not refined to more triangles
/// \throws std::runtime_error if a surface cannot be read or resampled
std::vector<Surface>
start_surfaces(const Run_start& start,
               std::size_t most_triangles = std::numeric_limits<std::size_t>::max());

/// The same if the surfaces of the files have been read, and perhaps repaired.
std::vector<Surface>
start_surfaces(const Run_start& start, std::vector<Surface> surfaces,
               std::size_t most_triangles = std::numeric_limits<std::size_t>::max());

/// Decimates or refines surfaces to about `triangles` triangles in total, by a common factor.
/// Refinement keeps the shape. Decimation collapses the edges with the smallest cost.
/// \param names names of the surfaces, for messages
/// \throws Input_error if a surface is open, intersects itself afterwards, or must be refined and
/// has edges in common with another surface
void resample(std::vector<Surface>& surfaces, const std::vector<std::string>& names,
              std::size_t triangles);

} // namespace dsc

#endif // DSC_SURFACE_H
