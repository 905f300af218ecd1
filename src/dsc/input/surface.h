// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_SURFACE_H
#define DSC_SURFACE_H

#include "input/run_start.h"

#include <CGAL/Mesh_files/Label_names.h>
#include <CGAL/Mesh_files/Surface_parts.h>
#include <CGAL/Triangle_soup_repair/Labeled_surface_3.h>
#include <CGAL/Triangle_soup_repair/Surface_repair_report_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <limits>

namespace dsc {

using Surface_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = DSC::Labeled_surface_3<Surface_point>;

/// Surfaces with different labels.
struct Surfaces
{
  std::vector<Surface> all;
  std::vector<std::string> titles; ///< of the surfaces, for messages: file and name of the part
  DSC::Label_names names;          ///< of the labels, from the files
};

/// Reads the surfaces of the files of a run. They get the labels 1, 2 and so on. The named parts of
/// a file, such as the solids of an STL file, are separate surfaces, unless they bound solids only
/// together, or the labels are `none`.
/// \throws std::runtime_error if a file cannot be read
Surfaces read_surfaces(const Run_start& start);

/// Reads a file as one surface with label 1.
/// \param parts receives the named parts, unless it is null
/// \throws std::runtime_error if the file cannot be read
Surface read_surface(const std::string& path, DSC::Surface_parts* parts = nullptr);

/// Reads the part of a file with a name as a surface with label 1; without a name, the whole file.
/// \throws std::runtime_error as read_surface() does; Input_error if no such part bounds a solid
Surface read_part(const std::string& path, const std::string& name);

/// The repair of a surface.
struct Repair
{
  std::string surface; ///< its title
  DSC::Surface_repair_report_3 report;
};

/// The repairs of each surface of a run; empty if surfaces are not repaired.
using Repairs = std::vector<Repair>;

/// Reads the surfaces of a run and repairs them, so that they bound solids.
/// \param repairs receives the repairs, unless it is null
/// \throws Input_error if a surface cannot be repaired; std::runtime_error if it cannot be read
Surfaces read_and_repair(const Run_start& start, Repairs* repairs);

/// Returns the initial surfaces of a run: the surfaces of its files or, without files, its ball.
/// \param most_triangles surfaces of files are not refined to more triangles
/// \throws std::runtime_error if a surface cannot be read or resampled
Surfaces start_surfaces(const Run_start& start,
                        std::size_t most_triangles = (std::numeric_limits<std::size_t>::max)());

/// The same if the surfaces of the files have been read, and perhaps repaired.
Surfaces start_surfaces(const Run_start& start, Surfaces surfaces,
                        std::size_t most_triangles = (std::numeric_limits<std::size_t>::max)());

/// Decimates or refines surfaces to about `triangles` triangles in total, by a common factor.
/// Refinement keeps the shape. Decimation collapses the edges with the smallest cost.
/// \throws Input_error if a surface is open, intersects itself afterwards, or must be refined and
/// has edges in common with another surface
void resample(Surfaces& surfaces, std::size_t triangles);

} // namespace dsc

#endif // DSC_SURFACE_H
